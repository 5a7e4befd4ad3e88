#include "calculators/column/stepped/stepped.hpp"

#include "calculators/column/codes/curves.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/motion_units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::column {

namespace {

using Input = Stepped::Input;
using Result = Stepped::Result;
using Part = Stepped::Part;
using Member = Stepped::MemberOfColumn;

End foot_of(const Input& in) { return {held, in.foot == Stepped::Foot::fixed ? held : 0.0}; }

End top_of(const Input& in) {
  using Top = Stepped::Top;
  const bool holds = in.top == Top::pinned || in.top == Top::fixed;
  const bool turns = in.top == Top::free || in.top == Top::pinned;
  return {holds ? held : 0.0, turns ? 0.0 : held};
}

template <class Quantity>
Quantity or_nothing(Quantity q) {
  return is_set(q) ? q : from_si<Quantity>(0.0);
}

/// Section and forces of a part that carries the part above.
template <class Tracer>
void load_part(const Input& in, const Part& part, Force above, Member& of, Tracer& trace) {
  if (is_set(part.d)) {
    const auto d = trace.value("d", part.d, "as given");
    STEP_TO(of, A, pi / 4.0 * pow<2>(d), "round bar");
    STEP_TO(of, I, pi / 64.0 * pow<4>(d), "round bar");
  } else {
    of.A = trace.value("A", part.A, "as given");
    of.I = trace.value("I", part.I, "as given");
  }
  const auto N_a = trace.value("N_a", above, "force in the part above at its lower end; nothing above the last");
  const auto P = trace.value("P", or_nothing(part.P), "applied at the upper end");
  STEP_TO(of, N_u, N_a + P, "equilibrium at the upper end");
  const auto l = trace.value("l", part.l, "as given");
  const auto q = trace.value("q", or_nothing(part.q), "along the part, without its weight");
  if (!is_set(in.rho) || in.orientation == Stepped::Orientation::horizontal) {
    STEP_TO(of, N_l, N_u + q * l, "equilibrium of the part");
    return;
  }
  const auto g = trace.value("g", usual_gravity, "gravity");
  STEP(q_g, in.rho * g * of.A, "weight per length");
  STEP_TO(of, N_l, N_u + (q + q_g) * l, "equilibrium of the part with its weight");
}

Pieces pieces_of(const Input& in, const Result& r) {
  Pieces pieces;
  for (std::size_t i = 0; i < in.parts.size(); ++i) {
    const Member& of = r.members[i];
    pieces.push_back({in_si(in.E) * in_si(of.I), in_si(in.parts[i].l), in_si(of.N_l), in_si(of.N_u)});
  }
  return pieces;
}

/// The part under its share of the critical load, as a hinged bar that buckles at the same force.
template <class Tracer>
void judge_part(const Input& in, const Part& part, double alpha_cr, Result& r, Member& of, Tracer& trace) {
  if (!(of.N_l > 0.0 * kN)) {
    of.u = is_set(in.n_st) ? 0.0 : unset<double>;
    return;
  }
  const auto A = of.A;
  const auto I = of.I;
  STEP_TO(of, N_cr, alpha_cr * of.N_l, "its share of the elastic critical load");
  STEP_TO(of, s, pi * sqrt(in.E * I / N_cr), "the hinged bar that buckles at this force, [Anderson-Woodward]");
  const auto l = trace.value("l", part.l, "as given");
  STEP_TO(of, beta, s / l, "over the length of the part");
  STEP_TO(of, lambda, s / sqrt(I / A), "slenderness, [B25]");
  STEP_TO(of, sigma, of.N_l / A, "at its lower end");
  if (is_set(in.sigma_P)) {
    STEP_TO(of, sigma_cr, N_cr / A, "Euler, [B25]");
    const double ratio_P =
        NAMED_STEP("r_P", sigma_cr / in.sigma_P, "Euler's formula holds up to the proportional limit");
    r.r_P = is_set(r.r_P) ? std::max(r.r_P, ratio_P) : ratio_P;
  } else if (is_set(in.R_e)) {
    Material material;
    material.E = in.E, material.R_e = in.R_e;
    of.sigma_cr = johnson_stress(lambda, material, trace);
  }
  if (!is_set(in.n_st)) return;
  const auto sigma_cr = of.sigma_cr;
  STEP_TO(of, u, in.n_st * sigma / sigma_cr, "stress times the required safety factor / critical stress");
}

}  // namespace

bool Stepped::sections_given(const Input& in) {
  return std::all_of(in.parts.begin(), in.parts.end(), [](const Part& part) {
    const bool plain = is_set(part.A) && is_set(part.I), any = is_set(part.A) || is_set(part.I);
    return is_set(part.d) ? !any : plain;
  });
}

FieldFault Stepped::section_missing(const Input& in) {
  for (std::size_t i = 0; i < in.parts.size(); ++i) {
    Input one;
    one.parts.push_back(in.parts[i]);
    if (sections_given(one)) continue;
    const std::string path = "parts[" + std::to_string(i + 1) + "]." + (is_set(in.parts[i].d) ? "d" : "A");
    return {path, say("each part needs its section: d of a round bar, or A and I"),
            say("give d, or A and I, not both")};
  }
  return {};
}

/// I = A i^2 with a radius of gyration that is less than the length: beyond that a unit is wrong.
bool Stepped::sections_fit(const Input& in) {
  return std::all_of(in.parts.begin(), in.parts.end(), [](const Part& part) {
    return !is_set(part.A) || !is_set(part.I) || in_si(part.I) < in_si(part.A) * in_si(part.l) * in_si(part.l);
  });
}

bool Stepped::is_kinematically_stable(const Input& in) { return in.foot == Foot::fixed || in.top != Top::free; }

Applies Stepped::loaded(const Input& in) {
  const bool forced = std::any_of(in.parts.begin(), in.parts.end(), [](const Part& part) {
    return part.P > 0.0 * kN.one || part.q > 0.0 * N_per_mm.one;
  });
  return where(forced || (is_set(in.rho) && in.orientation == Orientation::vertical));
}

/// Sections whose outline is not given may have thin walls, or twist.
Applies Stepped::of_walls(const Input& in) {
  const bool unknown = std::any_of(in.parts.begin(), in.parts.end(), [](const Part& part) { return !is_set(part.d); });
  return std::min(where(unknown), loaded(in));
}

Applies Stepped::about_other_axis(const Input& in) {
  return of_walls(in) == Applies::yes ? Applies::unseen : Applies::no;
}

Applies Stepped::weighs(const Input& in) {
  return is_set(in.rho) && in.orientation == Orientation::vertical ? Applies::no : Applies::unseen;
}

template <class Tracer>
Result Stepped::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const std::size_t count = in.parts.size();
  r.members.resize(count);
  Force above = 0.0 * kN;
  bool is_round = true;
  Length largest = 0.0 * mm;
  for (std::size_t i = count; i-- > 0;) {
    [[maybe_unused]] const auto inside = trace.scope("members", i);
    r.members[i].name = in.parts[i].name;
    load_part(in, in.parts[i], above, r.members[i], trace);
    above = r.members[i].N_l;
    is_round = is_round && is_set(in.parts[i].d);
    if (is_round) largest = max(largest, in.parts[i].d);
  }
  if (is_round) r.t = trace.value("t", largest, "largest diameter");
  r.F = trace.value("F", above, "at the lower end of the first part");
  if (!(r.F > 0.0 * kN)) {
    if (is_set(in.n_st)) r.u = trace.value("u", 0.0, "nothing compresses it");
    if (is_set(in.sigma_P)) r.r_P = 0.0;
    return r;
  }
  const auto alpha_cr = r.alpha_cr = trace.value("alpha_cr", critical_factor(pieces_of(in, r), foot_of(in), top_of(in)),
                                                 "smallest root of the characteristic equation, by the exact stiffness "
                                                 "of the parts, [Timoshenko-Gere], [Wittrick]");
  STEP_TO(r, F_cr, alpha_cr * r.F, "all loads increase in proportion");
  for (std::size_t i = 0; i < count; ++i) {
    [[maybe_unused]] const auto inside = trace.scope("members", i);
    judge_part(in, in.parts[i], alpha_cr, r, r.members[i], trace);
  }
  if (!is_set(in.n_st)) return r;
  double u = 0.0;
  for (const Member& of : r.members) u = of.u <= u ? u : of.u;
  r.u = trace.value("u", u, "maximum of the parts");
  return r;
}

template Result Stepped::evaluate(const Input&, NoTrace&);
template Result Stepped::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Stepped::figures(const Input& in, const Result& r) {
  if (!is_set(r.alpha_cr)) return {};
  Shape shape = critical_shape(pieces_of(in, r), foot_of(in), top_of(in), r.alpha_cr);
  figure::Plot plot;
  plot.x = {"x", "height above the foot", "mm"};
  plot.y = {"w", "deflection / maximum deflection", "-"};
  plot.curves.push_back({"w", std::move(shape.x), std::move(shape.w), false});
  return {{"buckled-shape", "Buckling mode shape", std::move(plot)}};
}

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::Stepped>();
