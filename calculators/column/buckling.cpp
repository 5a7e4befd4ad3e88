#include "calculators/column/buckling.hpp"

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/methods.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::column {

namespace {

using Axis = AxisResult;
using Input = Buckling::Input;
using Result = Buckling::Result;

template <class Tracer>
void take_load(const Input& in, Result& r, Tracer& trace) {
  const auto P = in.P, N = in.N;
  if (is_set(P)) {
    STEP(F, P, "the compressive force as given");
    r.F = F, r.loading = Loading::compression;
  } else if (is_set(N)) {
    STEP(F, N < 0.0 * kN ? -N : 0.0 * kN, "the compression in the bar; tension does not buckle it");
    r.F = F, r.loading = N < 0.0 * kN.one ? Loading::compression : Loading::tension;
  }
}

/// The area, and the thickness that the strength of the material depends on.
template <class Tracer>
void take_section(const Input& in, Result& r, Tracer& trace) {
  const auto d = in.d, h = in.h, b = in.b;
  if (is_set(in.A)) {
    r.A = in.A, r.t = in.t_f;
    return;
  }
  if (!is_set(d)) {
    STEP(A, b * h, "rectangle");
    r.A = A, r.t = min(b, h);
    return;
  }
  const auto d_bore = is_set(in.d_bore) ? in.d_bore : 0.0 * mm;
  if (!is_set(in.d_bore)) trace.value("d_bore", d_bore, "no bore");
  STEP(A, pi / 4.0 * (pow<2>(d) - pow<2>(d_bore)), "ring or circle");
  r.A = A, r.t = is_set(in.d_bore) ? 0.5 * (d - d_bore) : d;
}

/// What holds a bar in tension: its plain stress alone.
template <class Tracer>
void take_tension(const Input& in, Result& r, Tracer& trace) {
  const auto N = in.N;
  const auto A = r.A;
  const auto R_e = in.R_e;
  r.x_t = 0.0;
  if (!(N > 0.0 * kN)) return;
  if (!is_set(R_e)) {
    r.x_t = unset<double>;
    trace.value("x_t", r.x_t, "the yield strength is not known");
    return;
  }
  STEP(sigma_t, N / A, "plain stress of the bar in tension");
  STEP(x_t, sigma_t / R_e, "over the yield strength");
  r.x_t = x_t;
}

template <class Tracer>
Length radius_of_gyration(const Input& in, Area A, AxisName axis, Tracer& trace) {
  const auto I_y = in.I_y, I_z = in.I_z, I_min = in.I_min;
  const bool about_y = axis == AxisName::y;
  if (is_set(in.A)) {
    if (about_y && is_set(I_y)) return NAMED_STEP("i", sqrt(I_y / A), "radius of gyration about y, [B25]");
    if (!about_y && I_min < I_z) return NAMED_STEP("i", sqrt(I_min / A), "about the weak principal axis in place of z");
    if (!about_y && is_set(I_z)) return NAMED_STEP("i", sqrt(I_z / A), "radius of gyration about z, [B25]");
    trace.value("i", about_y ? in.i_y : in.i_z, "as given");
    return about_y ? in.i_y : in.i_z;
  }
  const auto d = in.d, h = in.h, b = in.b;
  if (!is_set(d)) {
    if (about_y) return NAMED_STEP("i", h / sqrt(12.0), "rectangle about y");
    return NAMED_STEP("i", b / sqrt(12.0), "rectangle about z");
  }
  const auto d_bore = is_set(in.d_bore) ? in.d_bore : 0.0 * mm;
  return NAMED_STEP("i", sqrt(pow<2>(d) + pow<2>(d_bore)) / 4.0, "ring or circle");
}

template <class Tracer>
double factor_of_length(const Input& in, AxisName axis, Tracer& trace) {
  const double given = axis == AxisName::y ? in.beta_y : in.beta_z;
  if (is_set(given)) {
    trace.value("beta", given, "as given");
    return given;
  }
  const Ends ends = ends_of(in, axis);
  if (supports_of(in, axis).empty()) {
    const double beta = length_factor(ends, in.beta_basis);
    trace.value("beta", beta, length_factor_reason(in.beta_basis));
    return beta;
  }
  const double u = buckling_parameter(bar_of(in, axis));
  trace.value("u", u, "l sqrt(N_cr/(E I)) of the bar with its supports, by its exact stiffness, [Wittrick]");
  STEP(beta, pi / u, "the hinged bar that buckles at the same force");
  return beta;
}

template <class Tracer>
void slenderness(const Input& in, AxisName axis, Result& r, Tracer& trace) {
  const auto E = in.E;
  const auto l = in.l;
  const auto A = r.A;
  static constexpr Name y{"y"}, z{"z"};  // a name that is made here and copied at once would cost as much as the rest
  Axis a{axis == AxisName::y ? y : z};
  const Length i = a.i = radius_of_gyration(in, A, axis, trace);
  const double beta = a.beta = factor_of_length(in, axis, trace);
  STEP(s, beta * l, "effective length, [B25]");
  STEP(lambda, s / i, "slenderness, [B25]");
  STEP(N_cr, pow<2>(pi) * E * A / pow<2>(lambda), "critical force of the elastic bar, [B25]");
  a.s = s, a.lambda = lambda, a.N_cr = N_cr;
  r.axes.push_back(a);
}

template <class Tracer>
void take_limits(const Input& in, const Material& material, Result& r, Tracer& trace) {
  const auto &E = in.E, &sigma_P = in.sigma_P, &a_T = in.a_T, &b_T = in.b_T;
  const auto& c_T = material.c_T;
  const auto lambda_1 = in.lambda_1;
  const auto lambda = r.lambda, lambda_T = r.lambda_T = material.lambda_T;
  if (is_set(a_T)) {
    if (!is_set(in.c_T)) trace.value("c_T", c_T, "a line");
    trace.value("lambda_T", lambda_T,
                in.transition == Transition::published ? "as published with the set"
                                                       : "where Tetmajer's formula meets Euler's");
    if (is_set(lambda_1)) {
      STEP(gap, (a_T - b_T * lambda_1 + c_T * pow<2>(lambda_1)) / (pow<2>(pi) * E / pow<2>(lambda_1)) - 1.0,
           "how far the set misses Euler at its own limit");
      r.gap = gap;
    }
  }
  if (is_set(sigma_P)) {
    STEP(lambda_lim, pi * sqrt(E / sigma_P), "where Euler's stress is the proportional limit, [B25]");
    r.lambda_lim = lambda_lim;
  } else if (is_set(lambda_T)) {
    STEP(lambda_lim, lambda_T, "no proportional limit is given: from here Euler's hyperbola holds");
    r.lambda_lim = lambda_lim;
  }
  if (in.method == Method::euler) {
    const auto lambda_lim = r.lambda_lim;
    STEP(r_1, lambda_lim / lambda, "Euler's formula holds above the limit slenderness, [B25]");
    r.r_1 = r_1;
  }
  if (in.method == Method::tetmajer && !is_set(in.R_e)) {
    const auto lambda_0 = material.lambda_0;
    STEP(r_0, lambda_0 / lambda, "below lambda_0 the bar yields first");
    r.r_0 = r_0;
  }
}

/// What EN 1993-1-1 and the secant formula need of each axis.
template <class Tracer>
void take_curves(const Input& in, const Material& material, AxisName axis, Axis& a, Tracer& trace) {
  if (!is_set(in.R_e)) return;
  const double lambda = a.lambda;
  const Curve curve = curve_of(in, axis);
  if (is_steel(in) && curve != Curve::by_kind) {
    a.alpha = imperfection(curve);
    trace.value("alpha", a.alpha, imperfection_reason(curve));
    a.chi = ec3_reduction(lambda, a.alpha, material, trace);
    a.lambda_bar = lambda / (pi * std::sqrt(in.E / in.R_e));
  }
  if (!is_set(in.e_y) && !is_set(in.e_z)) return;
  const bool about_y = axis == AxisName::y;
  const auto E = in.E;
  const auto i = a.i;
  const Length given = about_y ? in.e_y : in.e_z;
  const auto e = is_set(given) ? given : 0.0 * mm;
  const Length depth = extreme_fibre(in, axis);
  const auto c = is_set(depth) ? depth : 0.0 * mm;
  trace.value("e", e, "eccentricity in the plane of bending");
  trace.value("c", c, "extreme fibre from the axis");
  STEP(eta, e * c / pow<2>(i), "eccentricity ratio, [Gere]");
  a.eta = eta;
  const auto sigma_s = a.sigma_s = secant_stress(lambda, eta, E, in.R_e);
  trace.value("sigma_s", sigma_s, "found so that the extreme fibre yields, or the bar buckles by Euler without e");
  STEP(sigma_max, sigma_s * (1.0 + eta / cos(0.5 * lambda * sqrt(sigma_s / E))),
       "extreme fibre, secant formula, [Gere]");
  static_cast<void>(sigma_max);
}

template <class Tracer>
void conclude(const Input& in, Result& r, Tracer& trace) {
  const auto lambda = r.lambda, lambda_max = in.lambda_max;
  r.spread = spread_of(r);
  trace.value("spread", r.spread, "largest critical stress over the least, less 1");
  STEP(r_lambda, lambda / lambda_max, "slenderness over the largest that is allowed");
  r.r_lambda = r_lambda;
  r.r_class = is_set(in.R_e) ? class_ratio(plates_of(in), in.R_e) : unset<double>;
  if (is_set(r.r_class))
    trace.value("r_class", r.r_class, "EN 1993-1-1, table 5.2, with eps = sqrt(235 MPa/R_e), [EN1993-1-1-buckling]");
  if (!is_set(r.sigma_cr)) return;
  trace.value("sigma_cr", r.sigma_cr, "of the method that decides");
  if (!is_set(r.u)) return;
  const auto F = r.F, P_all = r.P_all;
  trace.value("P_all", P_all, "of the method that decides");
  STEP(u, F / P_all, "force over the allowable force, which holds the safety");
  r.u = u;
}

}  // namespace

template <class Tracer>
Result Buckling::evaluate(const Input& in, Tracer& trace) {
  Result r;
  take_load(in, r, trace);
  take_section(in, r, trace);
  take_tension(in, r, trace);
  const Material material = material_of(in);
  for (const AxisName axis : {AxisName::y, AxisName::z}) {
    [[maybe_unused]] const auto here = trace.scope("axes", r.axes.size());
    slenderness(in, axis, r, trace);
    take_curves(in, material, axis, r.axes.back(), trace);
  }
  r.axis = r.axes[1].lambda >= r.axes[0].lambda ? AxisName::z : AxisName::y;
  const double lambda = r.lambda = std::max(r.axes[0].lambda, r.axes[1].lambda);
  const auto& E = in.E;
  const auto A = r.A;
  trace.value("lambda", lambda, "the larger of both axes governs, [B25]");
  STEP(sigma_E, pow<2>(pi) * E / pow<2>(lambda), "Euler's stress, whether it holds or not");
  STEP(N_cr, sigma_E * A, "least critical force of the elastic bar");
  r.sigma_E = sigma_E, r.N_cr = N_cr;
  take_limits(in, material, r, trace);
  for (const auto& name : choices_of(Method{})) {
    if (has_method(in, material, r, name.value)) add_method(in, material, name.value, r, trace);
  }
  conclude(in, r, trace);
  return r;
}

template Result Buckling::evaluate(const Input&, NoTrace&);
template Result Buckling::evaluate(const Input&, Trace&);

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::Buckling>();
