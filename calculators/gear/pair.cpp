#include "calculators/gear/pair.hpp"

#include "calculators/gear/involute.hpp"
#include "calculators/gear/pair_layout.hpp"
#include "calculators/gear/pair_load.hpp"
#include "calculators/gear/pair_mesh.hpp"
#include "calculators/gear/pair_teeth.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::gear {

namespace {

/// Sum of the base radii of two wheels, difference of ring and wheel.
Length base_distance(const Pair::Input& in) {
  const double alpha_t = atan(tan(in.alpha_n) / cos(in.beta));
  return in.m_n * (in.z_2 + sign_of(in.mesh) * in.z_1) / 2.0 * cos(alpha_t) / cos(in.beta);
}

/// Involute function of the working pressure angle that the profile shifts require.
double working_involute(const Pair::Input& in) {
  const double g = sign_of(in.mesh), x_2 = is_set(in.x_2) ? in.x_2 : 0.0;
  const double alpha_t = atan(tan(in.alpha_n) / cos(in.beta));
  return involute(alpha_t) + 2.0 * (in.x_1 + x_2) * tan(in.alpha_n) * g / (in.z_2 + g * in.z_1);
}

/// Rim between the root circle and the bore, over the keyway. From 1.2 tooth depths on a rim does not bend with the
/// tooth (AGMA 2001; recalled).
template <class Tracer>
void rims(const Pair::Input& in, PairResult& r, Tracer& trace) {
  const auto d_f1 = r.d_f1, d_a1 = r.d_a1, d_f2 = r.d_f2, d_a2 = r.d_a2;
  if (is_set(in.bore_1)) {
    STEP_TO(r, s_R1, (d_f1 - in.bore_1) / 2.0 - in.t_k1, "rim between root circle and bore, over the keyway");
    STEP_TO(r, m_R1, 2.0 * s_R1 / (d_a1 - d_f1), "over the height of a tooth");
  }
  if (is_set(in.bore_2)) {
    STEP_TO(r, s_R2, (d_f2 - in.bore_2) / 2.0 - in.t_k2, "rim between root circle and bore, over the keyway");
    STEP_TO(r, m_R2, 2.0 * s_R2 / (d_a2 - d_f2), "over the height of a tooth");
  }
}

}  // namespace

bool Pair::bases_meet(const Input& in) {
  return in.mesh == Mesh::rack || !is_set(in.a_w) || !is_set(in.m_n) || in.z_2 == 0 || base_distance(in) < in.a_w;
}

FieldFault Pair::bases_apart(const Input& in) {
  return {"a_w",
          say("at {1} the line of action does not touch both base circles", format_quantity(in_si(in.a_w), mm.symbol)),
          say("give more than {1}, or another module or number of teeth",
              format_quantity(in_si(base_distance(in)), mm.symbol))};
}

bool Pair::working_angle_exists(const Input& in) {
  return in.mesh == Mesh::rack || is_set(in.a_w) || in.z_2 == 0 || working_involute(in) > 0.0;
}

FieldFault Pair::no_working_angle(const Input& in) {
  return {in.mesh == Mesh::internal ? "x_1" : "x_2",
          say("with these profile shifts the wheels would mesh closer than their base circles allow"),
          in.mesh == Mesh::internal
              ? say("the sum x_1 + x_2 is too large: a positive shift thickens the tooth of a ring too")
              : say("the sum x_1 + x_2 is too small")};
}

namespace {

/// Results with the form factors of the tooth forms.
PairResult with_own_forms(const Pair::Input& in) {
  Pair::Input untyped = in;
  untyped.Y_1 = untyped.Y_2 = unset<double>;
  NoTrace quiet;
  return Pair::evaluate(untyped, quiet);
}

constexpr double most_over_form = 1.2;

}  // namespace

double Pair::most_form_factor_1(const Input& in) { return most_over_form * with_own_forms(in).Y_1; }
double Pair::most_form_factor_2(const Input& in) { return most_over_form * with_own_forms(in).Y_2; }

template <class Tracer>
Pair::Result Pair::evaluate(const Input& in, Tracer& trace) {
  Result r;
  lay_out(in, r, trace);
  bring_to_mesh(in, r, trace);
  measure_teeth(in, r, trace);
  load_teeth(in, r, trace);
  rims(in, r, trace);
  return r;
}

template Pair::Result Pair::evaluate(const Input&, NoTrace&);
template Pair::Result Pair::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Pair>();
