#include "calculators/vessel/thick/sphere.hpp"

#include "calculators/vessel/thick/carrying.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::vessel {

namespace {

using Input = ThickWalledSphere::Input;
using Result = ThickWalledSphere::Result;

/// Lamé's constants of a sphere: the radial stress is A - 2 B/r^3, that in the wall A + B/r^3.
struct SphereConstants {
  Stress A = unset<Stress>;
  Moment B = unset<Moment>;

  [[nodiscard]] Stress hoop(Length r) const { return A + B / pow<3>(r); }
  [[nodiscard]] Stress radial(Length r) const { return A - 2.0 * B / pow<3>(r); }
};

template <class Tracer>
SphereConstants sphere_constants(const Input& in, const Result& r, Tracer& trace) {
  STEP(A, (in.p * pow<3>(r.R_i) - in.p_e * pow<3>(r.R_a)) / (pow<3>(r.R_a) - pow<3>(r.R_i)),
       "mean stress, the same at every radius, [Lame]");
  STEP(B, (in.p - in.p_e) * pow<3>(r.R_i * r.R_a) / (2.0 * (pow<3>(r.R_a) - pow<3>(r.R_i))),
       "a third of the difference of the stresses, times the cube of the radius, [Lame]");
  return {A, B};
}

/// The least thickness: with x = 1/(k^3 - 1), k the ratio of the radii, every stress of both surfaces is linear in x.
template <class Tracer>
Length least(const Input& in, const Strength& strength, Tracer& trace) {
  const double p = in_si(in.p), p_e = in_si(in.p_e), more = p - p_e;
  const auto growing_stresses = [&](double at, double by, double pressure) {
    return GrowingStresses{{at / in.z_l, by / in.z_l}, {at / in.z_c, by / in.z_c}, {-pressure, 0.0}};
  };
  const double x = std::min(largest_load(growing_stresses(0.5 * p - 1.5 * p_e, 1.5 * more, p), strength),
                            largest_load(growing_stresses(-p_e, 1.5 * more, p_e), strength));
  const auto mean = [&](Length delta_c) { return in.R + offset(in, delta_c); };
  return ordered("delta_min", thickness_of_ratio(wall_over_mean<3>(x), mean), in, trace);
}

/// The difference of the stresses falls with the cube of the radius: a surface governs.
template <class Tracer>
void stresses(const Input& in, const SphereConstants& constants, Result& r, Tracer& trace) {
  const Strength strength = strength_of(in, r.sigma_all);
  const Stress A = constants.A;
  const Moment B = constants.B;
  STEP_TO(r, sigma_ti, A + B / pow<3>(r.R_i), "in the wall at the inner surface, [Lame]");
  STEP_TO(r, sigma_ta, A + B / pow<3>(r.R_a), "in the wall at the outer surface, [Lame]");
  const Stress inner = at_surface("inner", in, r.sigma_ti, r.sigma_ti, in.p, strength, trace);
  const Stress outer = at_surface("outer", in, r.sigma_ta, r.sigma_ta, in.p_e, strength, trace);
  governing_surface(inner, outer, r, trace);
  if (!is_set(in.r) || in.r < r.R_i || in.r > r.R_a) return;
  STEP_TO(r, sigma_tr, A + B / pow<3>(in.r), "in the wall at r, [Lame]");
  STEP_TO(r, sigma_rr, A - 2.0 * B / pow<3>(in.r), "radial stress at r, [Lame]");
}

template <class Tracer>
void displacements(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.E)) return;
  STEP_TO(r, w_i, r.R_i / in.E * ((1.0 - in.nu) * r.sigma_ti + in.nu * in.p), "Hooke, at the inner surface");
  STEP_TO(r, w_a, r.R_a / in.E * ((1.0 - in.nu) * r.sigma_ta + in.nu * in.p_e), "Hooke, at the outer surface");
}

template <class Tracer>
void plastic(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.R_e)) return;
  if (!(r.sigma_v > 0.0 * MPa)) return;  // the same pressure all round: nothing yields
  STEP_TO(r, S_F, in.R_e / r.sigma_v, "first yield at the governing surface");
  STEP_TO(r, p_pl, 2.0 * in.R_e * log(r.R_a / r.R_i), "all of the wall yields, without hardening, [Plastic-cylinder]");
  if (in.p == in.p_e) return;
  STEP_TO(r, S_pl, r.p_pl / abs(in.p - in.p_e), "safety against full plasticity");
}

}  // namespace

template <class Tracer>
ThickWalledSphere::Result ThickWalledSphere::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.sigma_all = allowable(in, trace);
  carrying_radii(in, least(in, strength_of(in, r.sigma_all), trace), r, trace);
  const SphereConstants constants = sphere_constants(in, r, trace);
  stresses(in, constants, r, trace);
  displacements(in, r, trace);
  plastic(in, r, trace);
  return r;
}

template ThickWalledSphere::Result ThickWalledSphere::evaluate(const Input&, NoTrace&);
template ThickWalledSphere::Result ThickWalledSphere::evaluate(const Input&, Trace&);

std::vector<figure::Figure> ThickWalledSphere::figures(const Input& in, const Result& r) {
  if (!is_set(r.sigma_v)) return {};
  constexpr int count = 60;
  NoTrace off;
  const SphereConstants constants = sphere_constants(in, r, off);
  figure::Plot plot;
  plot.x = {"r", "radius", "mm"};
  plot.y = {"sigma", "stress", "MPa"};
  figure::Curve hoop{"sigma_t", {}, {}}, radial{"sigma_r", {}, {}};
  for (int i = 0; i <= count; ++i) {
    const Length at = r.R_i + (r.R_a - r.R_i) * (static_cast<double>(i) / count);
    for (figure::Curve* curve : {&hoop, &radial}) curve->x.push_back(in_si(at));
    hoop.y.push_back(in_si(constants.hoop(at)));
    radial.y.push_back(in_si(constants.radial(at)));
  }
  plot.curves = {std::move(hoop), std::move(radial)};
  return {{"stresses", "Stress in the wall and radial stress", std::move(plot)}};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::ThickWalledSphere>();
