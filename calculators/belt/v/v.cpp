#include "calculators/belt/v/v.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "calculators/belt/v/pulleys.hpp"
#include "calculators/belt/v/rating.hpp"
#include "calculators/belt/v/tension.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::belt {

namespace {

Pulleys pulleys_of(const V::Input& in) {
  return {in.d_1, with_driven_pulley(in, v_pulleys(in.basis)).d_2, in.a, in.L, Arrangement::open};
}

bool duty_is_whole(const V::Input& in) {
  return in.duty != V::Duty::unstated && in.motor != V::Motor::unstated && is_set(in.h_day);
}

std::string_view service_row(V::Duty duty, V::Motor motor) {
  const bool high = motor == V::Motor::high;
  switch (duty) {
    case V::Duty::light:
      return high ? "light, high torque" : "light, normal torque";
    case V::Duty::medium:
      return high ? "medium, high torque" : "medium, normal torque";
    case V::Duty::heavy:
      return high ? "heavy, high torque" : "heavy, normal torque";
    default:
      return high ? "very heavy, high torque" : "very heavy, normal torque";
  }
}

template <class Tracer>
void move(const V::Input& in, V::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.d_2 / in.d_1 / (1.0 - in.epsilon), "transmission ratio with slip, [B40]");
  STEP_TO(r, n_2, in.n_1 / i, "speed of the driven pulley");
  STEP_TO(r, v, in.n_1 * in.d_1 / 2.0, "belt speed");
  lay(pulleys_of(in), r, trace);
  STEP_TO(r, alpha, min(r.alpha_1, r.alpha_2), "the smaller wrap governs");
}

template <class Tracer>
void serve(const V::Input& in, V::Result& r, Tracer& trace) {
  r.K_A = is_set(in.K_A) ? in.K_A : optibelt_service_factor(service_row(in.duty, in.motor), in_si(in.h_day) / 3600.0);
  trace.value("K_A", r.K_A, is_set(in.K_A) ? "as given" : "c_2 by load, motor and use, [Optibelt-V] 17");
  STEP_TO(r, P_B, r.K_A * in.P, "design power");
}

template <class Tracer>
void carry(const VSection& section, const V::Input& in, V::Result& r, Tracer& trace) {
  STEP(d_k, min(in.d_1, in.d_2), "the smaller pulley");
  STEP(i_g, max(in.d_1, in.d_2) / d_k, "ratio of the diameters, at least 1");
  STEP_TO(r, n_k, in.n_1 * in.d_1 / d_k, "speed of the smaller pulley, without slip");
  rate(section, d_k, n_k, i_g, r, trace);
  r.c_alpha = wrap_factor(in.basis, r.alpha, trace);
  r.c_L =
      trace.value("c_L", v_length_factor(section, r.L),
                  in.basis == Basis::iso ? "length factor, [GOST1284.3] 19" : "length factor c_3, [Optibelt-V] 18, 20");
  count(in, r, trace);
  limit_rating(section, d_k, n_k, r, trace);
}

}  // namespace

bool V::section_is_known(const Input& in) {
  return in.basis == Basis::unstated || find_v_section(in.basis, in.section) != nullptr;
}
FieldFault V::unknown_section(const Input& in) {
  const char* const basis = in.basis == Basis::iso ? "iso" : "optibelt";
  return {"section", say("the basis {1} does not rate a section '{2}'", basis, in.section.view()),
          say("available: {1}", names_of_v_sections(in.basis))};
}

bool V::class_fits(const Input& in) {
  const bool rated = in.belt_class == BeltClass::III || in.belt_class == BeltClass::IV;
  if (in.basis == Basis::iso) return rated;
  return in.basis == Basis::unstated || in.belt_class == BeltClass::unstated;
}
FieldFault V::wrong_class(const Input& in) {
  if (in.basis == Basis::optibelt) {
    return {"belt_class", say("the belt class requires the basis iso"), say("leave it out, or state basis = \"iso\"")};
  }
  if (in.belt_class == BeltClass::classes_0_II) {
    return {"belt_class", say("the ratings are those of classes III and IV; classes 0 to II carry about 20 % less"),
            say("choose belts of class III or IV; lower classes are not covered")};
  }
  return {"belt_class", say("the basis iso rates belts by class"), say("give belt_class = \"III\" or \"IV\"")};
}

bool V::service_is_given(const Input& in) {
  const bool by_duty = in.basis == Basis::optibelt && duty_is_whole(in);
  const bool asked = in.motor != Motor::unstated || is_set(in.h_day);
  return in.basis == Basis::unstated || (is_set(in.K_A) ? !asked : by_duty);
}

bool V::clear_of_each_other(const Input& in) {
  const bool open = !is_set(in.d_2) && !is_set(in.n_2_set) && !is_set(in.i_set);
  return open || is_set(in.a) == is_set(in.L) || stand_clear(pulleys_of(in));  // other rules speak of d_2, a and L
}
FieldFault V::touching(const Input& in) { return overlap(pulleys_of(in)); }

namespace {

/// Results of a drive whose pulleys are known.
template <class Tracer>
V::Result drive(const V::Input& in, Tracer& trace) {
  V::Result r;
  r.rating = in.basis, r.d_2 = in.d_2;
  const VSection* const section = find_v_section(in.basis, in.section);
  if (section == nullptr) return r;
  move(in, r, trace);
  serve(in, r, trace);
  carry(*section, in, r, trace);
  build_pulleys(*section, in, r, trace);
  buy(*section, in, r, trace);
  if (r.z == 0) return r;
  tension(*section, in, r, trace);
  measure(*section, r, trace);
  load_shafts(r, trace);
  hand_over(r.P_B / in.n_1, r.P_B / r.n_2, largest_pull(r, max(r.R_0, r.R_new)), in.d_1, in.d_2, in.n_1, r);
  r.shaft_1.d_f = in.d_1 - 2.0 * section->row.h_b, r.shaft_2.d_f = in.d_2 - 2.0 * section->row.h_b;
  r.shaft_1.b_r = r.shaft_2.b_r = r.B;
  return r;
}

}  // namespace

template <class Tracer>
V::Result V::evaluate(const Input& in, Tracer& trace) {
  if (is_set(in.d_2)) return drive(in, trace);
  const Input whole = with_driven_pulley(in, v_pulleys(in.basis), trace);
  Result r = drive(whole, trace);
  compare_ratio(in, r, trace);
  return r;
}

template V::Result V::evaluate(const Input&, NoTrace&);
template V::Result V::evaluate(const Input&, Trace&);

std::vector<figure::Figure> V::figures(const Input& in, const Result& r) {
  TwoWheels w;
  w.d_1 = in_si(in.d_1), w.d_2 = in_si(r.d_2), w.a = in_si(r.a);
  w.d_a1 = in_si(r.d_a1), w.d_a2 = in_si(r.d_a2);
  w.alpha_1 = r.alpha_1, w.alpha_2 = r.alpha_2;
  w.n_1 = in_si(in.n_1), w.n_2 = in_si(r.n_2);
  w.farther = in_si(r.Delta_1), w.nearer = in_si(r.Delta_2);
  Pulls pulls;
  pulls.tight = in_si(r.S_1), pulls.slack = in_si(r.S_2), pulls.of_one_belt = true;
  pulls.R = in_si(r.R), pulls.R_x = in_si(r.R_x), pulls.R_y = in_si(r.R_y);
  return {drive_figure(w, pulls)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::V>();
