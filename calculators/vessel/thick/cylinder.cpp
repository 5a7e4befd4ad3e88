#include "calculators/vessel/thick/cylinder.hpp"

#include "calculators/vessel/thick/carrying.hpp"
#include "calculators/vessel/thick/lame_constants.hpp"
#include "calculators/vessel/thick/plastic.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = Thick::Input;
using Ends = Thick::Ends;
using Result = Thick::Result;

template <class Tracer>
Stress axial(const Input& in, const Lame& lame, Tracer& trace) {
  const Stress A = lame.A;
  if (in.ends == Ends::closed) return NAMED_STEP("sigma_z", A, "force on the ends over the section of the wall");
  if (in.ends == Ends::open) return trace.value("sigma_z", 0.0 * MPa, "no ends, no axial force");
  return NAMED_STEP("sigma_z", 2.0 * in.nu * A, "no axial strain, Hooke");
}

/// The least thickness: with x = 1/(k^2 - 1), k the ratio of the radii, every stress of both surfaces is linear in x.
template <class Tracer>
Length least(const Input& in, const Strength& strength, Tracer& trace) {
  const double p = in_si(in.p), p_e = in_si(in.p_e), more = p - p_e;
  const double share = in.ends == Ends::closed ? 1.0 : in.ends == Ends::open ? 0.0 : 2.0 * in.nu;
  const Growing along{-share * p_e / in.z_c, share * more / in.z_c};
  const GrowingStresses inner{{(more - p_e) / in.z_l, 2.0 * more / in.z_l}, along, {-p, 0.0}};
  const GrowingStresses outer{{-p_e / in.z_l, 2.0 * more / in.z_l}, along, {-p_e, 0.0}};
  const double x = std::min(largest_load(inner, strength), largest_load(outer, strength));
  const auto mean = [&](Length delta_c) { return in.R + offset(in, delta_c); };
  return ordered("delta_min", thickness_of_ratio(wall_over_mean<2>(x), mean), in, trace);
}

/// Both differences of principal stresses and their squares are convex in 1/r^2: a surface governs.
template <class Tracer>
void stresses(const Input& in, const Lame& lame, Result& r, Tracer& trace) {
  const Strength strength = strength_of(in, r.sigma_all);
  const Stress A = lame.A;
  const Force B = lame.B;
  r.sigma_z = axial(in, lame, trace);
  STEP_TO(r, sigma_ti, A + B / pow<2>(r.R_i), "hoop stress at the inner surface, [Lame]");
  STEP_TO(r, sigma_ta, A + B / pow<2>(r.R_a), "hoop stress at the outer surface, [Lame]");
  const Stress inner = at_surface("inner", in, r.sigma_ti, r.sigma_z, in.p, strength, trace);
  const Stress outer = at_surface("outer", in, r.sigma_ta, r.sigma_z, in.p_e, strength, trace);
  governing_surface(inner, outer, r, trace);
}

template <class Tracer>
void at_radius(const Input& in, const Lame& lame, Result& r, Tracer& trace) {
  if (!is_set(in.r) || in.r < r.R_i || in.r > r.R_a) return;
  const Stress A = lame.A;
  const Force B = lame.B;
  STEP_TO(r, sigma_tr, A + B / pow<2>(in.r), "hoop stress at r, [Lame]");
  STEP_TO(r, sigma_rr, A - B / pow<2>(in.r), "radial stress at r, [Lame]");
}

template <class Tracer>
void displacements(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.E)) return;
  STEP_TO(r, w_i, r.R_i / in.E * (r.sigma_ti - in.nu * (r.sigma_z - in.p)), "Hooke, at the inner surface");
  STEP_TO(r, w_a, r.R_a / in.E * (r.sigma_ta - in.nu * (r.sigma_z - in.p_e)), "Hooke, at the outer surface");
}

/// Whether the axial stress lies between hoop and radial stress as the wall becomes plastic. Open ends: as long as the
/// hoop stress is tensile throughout.
bool is_middle_axial(const Input& in, const Result& r) {
  return in.ends != Ends::open || (in.p_e == 0.0 * MPa && in.p <= in.R_e && r.R_a < std::exp(1.0) * r.R_i);
}

template <class Tracer>
void plastic(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.R_e)) return;
  if (!(r.sigma_v > 0.0 * MPa)) return;  // the same pressure all round: nothing yields
  STEP_TO(r, S_F, in.R_e / r.sigma_v, "first yield at the governing surface");
  if (!is_middle_axial(in, r)) return;
  const Stress Y = yield_difference(in.R_e, in.ends == Ends::open ? Hypothesis::tresca : in.hypothesis, trace);
  r.p_pl = plastic_pressure(Y, r.R_i, r.R_a, trace);
  if (in.p == in.p_e) return;
  STEP_TO(r, S_pl, r.p_pl / abs(in.p - in.p_e), "safety against full plasticity");
}

}  // namespace

template <class Tracer>
Thick::Result Thick::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.sigma_all = allowable(in, trace);
  carrying_radii(in, least(in, strength_of(in, r.sigma_all), trace), r, trace);
  const Lame lame = lame_constants(in.p, in.p_e, r.R_i, r.R_a, trace);
  stresses(in, lame, r, trace);
  at_radius(in, lame, r, trace);
  displacements(in, r, trace);
  plastic(in, r, trace);
  return r;
}

template Thick::Result Thick::evaluate(const Input&, NoTrace&);
template Thick::Result Thick::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Thick::figures(const Input& in, const Result& r) {
  if (!is_set(r.sigma_v)) return {};
  constexpr int count = 60;
  NoTrace off;
  const Lame lame = lame_constants(in.p, in.p_e, r.R_i, r.R_a, off);
  figure::Plot plot;
  plot.x = {"r", "radius", "mm"};
  plot.y = {"sigma", "stress", "MPa"};
  figure::Curve hoop{"sigma_t", {}, {}}, radial{"sigma_r", {}, {}}, along{"sigma_z", {}, {}};
  for (int i = 0; i <= count; ++i) {
    const Length at = r.R_i + (r.R_a - r.R_i) * (static_cast<double>(i) / count);
    for (figure::Curve* curve : {&hoop, &radial, &along}) curve->x.push_back(in_si(at));
    hoop.y.push_back(in_si(lame.hoop(at)));
    radial.y.push_back(in_si(lame.radial(at)));
    along.y.push_back(in_si(r.sigma_z));
  }
  plot.curves = {std::move(hoop), std::move(radial), std::move(along)};
  return {{"stresses", "Hoop, radial and axial stress through the wall", std::move(plot)}};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Thick>();
