#include "calculators/vessel/external/external.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/drive_units.hpp"

#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = External::Input;
using Result = External::Result;
using Shape = External::Shape;

template <class Tracer>
void buckling_stress_of_cylinder(const Input& in, Result& r, Tracer& trace) {
  const Length e = r.e;
  STEP_TO(r, M_x, in.L / sqrt(in.D_a / 2.0 * e), "length in terms of the decay of bending, [VIII-2-4.4], 4.4.5");
  const double x_D = r.x_D;
  STEP(M_long, 2.0 * pow(x_D, 0.94), "long cylinders from here on, [VIII-2-4.4], 4.4.5");
  if (M_x >= M_long) {
    STEP_TO(r, C_h, 0.55 / x_D, "long cylinder, [VIII-2-4.4], 4.4.5");
  } else if (M_x > 13.0) {
    STEP_TO(r, C_h, 1.12 * pow(M_x, -1.058), "M_x above 13, [VIII-2-4.4], 4.4.5");
  } else if (M_x > 1.5) {
    STEP_TO(r, C_h, 0.92 / (M_x - 0.579), "M_x of 1.5 to 13, [VIII-2-4.4], 4.4.5");
  } else {
    r.C_h = trace.value("C_h", 1.0, "M_x up to 1.5, [VIII-2-4.4], 4.4.5");
  }
  STEP_TO(r, F_he, 1.6 * r.C_h * in.E / x_D, "elastic, [VIII-2-4.4], 4.4.5");
  STEP(y, F_he / in.R_e, "elastic over yield");
  if (y >= 2.439) {
    STEP_TO(r, F_ic, in.R_e, "yield, [VIII-2-4.4], 4.4.5");
  } else if (y > 0.552) {
    STEP_TO(r, F_ic, 0.7 * in.R_e * pow(y, 0.4), "inelastic, [VIII-2-4.4], 4.4.5");
  } else {
    STEP_TO(r, F_ic, F_he, "elastic, [VIII-2-4.4], 4.4.5");
  }
}

template <class Tracer>
void buckling_stress_of_sphere(const Input& in, Result& r, Tracer& trace) {
  const Length e = r.e;
  STEP(x_R, in.D_a / 2.0 / e, "outside radius over thickness");
  STEP_TO(r, F_he, 0.075 * in.E / x_R, "elastic, [VIII-2-4.4], 4.4.7");
  STEP(y, F_he / in.R_e, "elastic over yield");
  if (y >= 6.25) {
    STEP_TO(r, F_ic, in.R_e, "yield, [VIII-2-4.4], 4.4.7");
  } else if (y > 1.6) {
    STEP_TO(r, F_ic, 1.31 * in.R_e / (1.15 + 1.0 / y), "inelastic, [VIII-2-4.4], 4.4.7");
  } else if (y > 0.55) {
    STEP_TO(r, F_ic, 0.18 * F_he + 0.45 * in.R_e, "inelastic, [VIII-2-4.4], 4.4.7");
  } else {
    STEP_TO(r, F_ic, F_he, "elastic, [VIII-2-4.4], 4.4.7");
  }
}

template <class Tracer>
double design_factor(const Input& in, const Result& r, Tracer& trace) {
  STEP(x_F, r.F_ic / in.R_e, "buckling limit over yield");
  if (x_F <= 0.55) return trace.value("FS", 2.0, "elastic buckling, [VIII-2-4.4], 4.4.2");
  if (x_F < 1.0) return NAMED_STEP("FS", 2.407 - 0.741 * x_F, "inelastic buckling, [VIII-2-4.4], 4.4.2");
  return trace.value("FS", 1.667, "yielding, [VIII-2-4.4], 4.4.2");
}

/// Critical pressure of the perfect cylinder with this number of lobes, over the modulus.
template <class Tracer>
double critical_with(double lobes, double Z, double t_R, double nu, Tracer& trace) {
  const double n = trace.value("n", lobes, "lobes around the circumference, of the lowest pressure");
  STEP(k_n, pow<2>(n) - 1.0 + pow<2>(Z) / 2.0, "work of the pressure");
  STEP(k_m, 1.0 / pow<2>(pow<2>(n) / pow<2>(Z) + 1.0), "membrane");
  STEP(k_b, pow<2>(t_R) / (12.0 * (1.0 - pow<2>(nu))) * pow<2>(pow<2>(n) - 1.0 + pow<2>(Z)), "bending");
  return NAMED_STEP("x_cr", t_R * (k_m + k_b) / k_n, "critical pressure over E, [Mises-tube]");
}

/// Lobes from two on; more of them bend more and stretch less, so there is one minimum.
template <class Tracer>
void critical_of_cylinder(const Input& in, Result& r, Tracer& trace) {
  constexpr int most = 400;
  const Length e = r.e;
  STEP(R_m, (in.D_a - e) / 2.0, "middle of the wall");
  STEP(Z, pi * R_m / in.L, "half a wave along the length");
  STEP(t_R, e / R_m, "thickness over mean radius");
  NoTrace off;
  double best = 2.0, least = critical_with(2.0, Z, t_R, in.nu, off);
  for (int i = 3; i <= most; ++i) {
    const double next = critical_with(i, Z, t_R, in.nu, off);
    if (!(next < least)) break;
    best = i, least = next;
  }
  const double nu = trace.value("nu", in.nu, "Poisson's ratio");
  const double x_cr = critical_with(best, Z, t_R, nu, trace);
  r.n = best;
  STEP_TO(r, p_cr, in.E * x_cr, "elastic critical pressure of the perfect cylinder, ends held round");
  STEP(t_D, e / (2.0 * R_m), "thickness over mean diameter");
  STEP(L_D, in.L / (2.0 * R_m) - 0.45 * sqrt(t_D), "length over mean diameter, reduced");
  STEP(p_long, 2.0 * in.E / (1.0 - pow<2>(nu)) * pow<3>(t_D), "ring of an endless tube, two lobes");
  const bool is_between = L_D > 0.0 && 2.42 * pow(1.0 - pow<2>(nu), 0.25) > 2.0 * L_D * sqrt(t_D);  // above p_long
  if (!is_between) return;
  STEP_TO(r, p_WT, 2.42 * in.E / pow(1.0 - pow<2>(nu), 0.75) * pow(t_D, 2.5) / L_D, "[Windenburg]");
}

template <class Tracer>
void critical_of_sphere(const Input& in, Result& r, Tracer& trace) {
  const Length e = r.e;
  STEP(R_m, (in.D_a - e) / 2.0, "middle of the wall");
  STEP_TO(r, p_cr, 2.0 * in.E / sqrt(3.0 * (1.0 - pow<2>(in.nu))) * pow<2>(e / R_m), "perfect sphere, [Zoelly]");
}

}  // namespace

template <class Tracer>
External::Result External::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Length delta = trace.value("delta", in.delta, "nominal");
  STEP_TO(r, e, delta * (1.0 - in.f_t) - in.c - in.c_t, "less corrosion and under-tolerance");
  STEP_TO(r, x_D, in.D_a / e, "up to 2000, [VIII-2-4.4], 4.4.1; thin walls from 20 on");
  const bool is_round_all_over = in.shape == Shape::sphere;
  if (is_round_all_over) {
    buckling_stress_of_sphere(in, r, trace);
  } else {
    buckling_stress_of_cylinder(in, r, trace);
  }
  r.FS = design_factor(in, r, trace);
  if (is_round_all_over) {
    STEP_TO(r, p_k, 4.0 * r.F_ic * e / in.D_a, "hoop stress of a sphere at the limit");
  } else {
    STEP_TO(r, p_k, 2.0 * r.F_ic * e / in.D_a, "hoop stress of a cylinder at the limit");
  }
  STEP_TO(r, p_a, r.p_k / r.FS, "allowable external pressure, [VIII-2-4.4]");
  STEP_TO(r, u_e, in.p_e / p_a, "buckling");
  if (is_round_all_over) {
    critical_of_sphere(in, r, trace);
  } else {
    critical_of_cylinder(in, r, trace);
  }
  return r;
}

template External::Result External::evaluate(const Input&, NoTrace&);
template External::Result External::evaluate(const Input&, Trace&);

std::vector<figure::Figure> External::figures(const Input& in, const Result& r) {
  if (in.shape != Shape::cylinder || !is_set(r.p_cr)) return {};
  NoTrace off;
  figure::Plot plot;
  plot.x = {"L", "length between lines of support", "mm"};
  plot.y = {"p", "external pressure", "MPa"};
  figure::Curve perfect{"p_cr", {}, {}}, allowable{"p_a", {}, {}};
  constexpr int count = 48;
  for (int i = 0; i <= count; ++i) {
    Input at = in;
    at.L = in.L * std::pow(2.0, 2.0 * i / count - 1.0);
    const Result there = evaluate(at, off);
    for (figure::Curve* curve : {&perfect, &allowable}) curve->x.push_back(in_si(at.L));
    perfect.y.push_back(in_si(there.p_cr));
    allowable.y.push_back(in_si(there.p_a));
  }
  plot.curves = {std::move(perfect), std::move(allowable)};
  return {{"pressures", "Critical pressure of the perfect cylinder and allowable pressure", std::move(plot)}};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::External>();
