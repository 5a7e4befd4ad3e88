#include "calculators/column/buckling.hpp"

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/codes/aisc.hpp"
#include "calculators/column/eccentric.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/methods.hpp"
#include "calculators/column/torsional.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/calculator/strength_bounds.hpp"

#include <algorithm>

namespace loadpath::column {

namespace {

using Axis = AxisResult;
using Input = Buckling::Input;
using Result = Buckling::Result;

template <class Tracer>
void take_load(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.P)) {
    STEP_TO(r, F, in.P, "the compressive force as given");
    r.loading = Loading::compression;
  } else if (is_set(in.N)) {
    STEP_TO(r, F, in.N < 0.0 * kN ? -in.N : 0.0 * kN, "compressive force in the bar; tension causes no buckling");
    r.loading = in.N < 0.0 * kN.one ? Loading::compression : Loading::tension;
  }
}

/// The area, and the thickness that the strength of the material depends on.
template <class Tracer>
void take_section(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.A)) {
    r.A = in.A, r.t = in.t_f;
    return;
  }
  if (!is_set(in.d) && is_walled(in)) {
    const auto t_f = trace.value("t_f", flange_of(in), "wall across the height");
    STEP_TO(r, A, in.b * in.h - (in.b - 2.0 * in.t_w) * (in.h - 2.0 * t_f), "hollow rectangle, sharp corners");
    r.t = max(in.t_w, t_f);
    return;
  }
  if (!is_set(in.d)) {
    STEP_TO(r, A, in.b * in.h, "rectangle");
    r.t = min(in.b, in.h);
    return;
  }
  const Length bore = bore_of(in);
  const auto d_bore = is_set(bore) ? bore : 0.0 * mm;
  if (!is_set(in.d_bore)) trace.value("d_bore", d_bore, is_set(bore) ? "within the wall" : "no bore");
  STEP_TO(r, A, pi / 4.0 * (pow<2>(in.d) - pow<2>(d_bore)), "ring or circle");
  r.t = is_set(bore) ? 0.5 * (in.d - d_bore) : in.d;
}

template <class Tracer>
double tension_safety(const Input& in, Tracer& trace) {
  if (method_of(in) != Method::ec3) return NAMED_STEP("n", in.n_t, "safety in tension");
  const double gamma_F = partial_factor("gamma_F", in.gamma_F, true, "assumed: the force is a design value", trace);
  return NAMED_STEP("n", gamma_F * in.n_t, "partial factors on the load and on the resistance");
}

/// Check of a bar in tension: its plain stress only.
template <class Tracer>
void take_tension(const Input& in, Result& r, Tracer& trace) {
  r.x_t = 0.0;
  if (is_set(in.n_t) && is_set(in.N)) r.u_t = 0.0;
  if (!(in.N > 0.0 * kN)) return;
  if (!is_set(in.R_e)) {
    r.x_t = r.u_t = trace.value("x_t", unset<double>, "the yield strength is not known");
    return;
  }
  STEP(sigma_t, in.N / r.A, "plain stress of the bar in tension");
  STEP_TO(r, x_t, sigma_t / in.R_e, "over the yield strength");
  if (!is_set(in.n_t)) return;
  const double n = tension_safety(in, trace);
  STEP_TO(r, u_t, n * x_t, "compared with the yield strength, with the safety factor n");
}

template <class Tracer>
Length radius_of_gyration(const Input& in, Area A, AxisName axis, Tracer& trace) {
  const bool about_y = axis == AxisName::y;
  if (is_set(in.A)) {
    if (about_y && is_set(in.I_y)) return NAMED_STEP("i", sqrt(in.I_y / A), "radius of gyration about y, [B25]");
    if (!about_y && in.I_min < in.I_z)
      return NAMED_STEP("i", sqrt(in.I_min / A), "about the weak principal axis in place of z");
    if (!about_y && is_set(in.I_z)) return NAMED_STEP("i", sqrt(in.I_z / A), "radius of gyration about z, [B25]");
    // without their names, so that the axes go through the same lines and fold into a table
    return trace.value("i", about_y ? in.i_y : in.i_z, "as given");
  }
  if (!is_set(in.d) && is_walled(in)) {
    const auto t_f = trace.value("t_f", flange_of(in), "wall across the height");
    if (about_y) {
      return NAMED_STEP("i",
                        sqrt((in.b * pow<3>(in.h) - (in.b - 2.0 * in.t_w) * pow<3>(in.h - 2.0 * t_f)) / (12.0 * A)),
                        "hollow rectangle about y");
    }
    return NAMED_STEP("i", sqrt((in.h * pow<3>(in.b) - (in.h - 2.0 * t_f) * pow<3>(in.b - 2.0 * in.t_w)) / (12.0 * A)),
                      "hollow rectangle about z");
  }
  if (!is_set(in.d)) {
    if (about_y) return NAMED_STEP("i", in.h / sqrt(12.0), "rectangle about y");
    return NAMED_STEP("i", in.b / sqrt(12.0), "rectangle about z");
  }
  const Length bore = bore_of(in);
  const auto d_bore = is_set(bore) ? bore : 0.0 * mm;
  return NAMED_STEP("i", sqrt(pow<2>(in.d) + pow<2>(d_bore)) / 4.0, "ring or circle");
}

template <class Tracer>
double factor_of_length(const Input& in, AxisName axis, Tracer& trace) {
  const bool about_y = axis == AxisName::y;
  const double given = about_y ? in.beta_y : in.beta_z;
  if (is_set(given)) return trace.value("beta", given, "as given");
  if (supports_of(in, axis).empty())
    return trace.value("beta", length_factor(ends_of(in, axis), in.beta_basis), length_factor_reason(in.beta_basis));
  const double u = buckling_parameter(bar_of(in, axis));
  trace.value("u", u, "l sqrt(N_cr/(E I)) of the bar with its supports, by its exact stiffness, [Wittrick]");
  return NAMED_STEP("beta", pi / u, "the hinged bar that buckles at the same force");
}

template <class Tracer>
void slenderness(const Input& in, AxisName axis, Result& r, Tracer& trace) {
  static constexpr Name y{"y"}, z{"z"};  // a name that is made here and copied at once would cost as much as the rest
  Axis a{axis == AxisName::y ? y : z};
  const Length i = a.i = radius_of_gyration(in, r.A, axis, trace);
  const double beta = a.beta = factor_of_length(in, axis, trace);
  STEP_TO(a, s, beta * in.l, "effective length, [B25]");
  STEP_TO(a, lambda, s / i, "slenderness, [B25]");
  if (is_set(in.E)) {
    STEP_TO(a, N_cr, pow<2>(pi) * in.E * r.A / pow<2>(lambda), "elastic critical (Euler) load, [B25]");
  }
  r.axes.push_back(a);
}

template <class Tracer>
void take_limits(const Input& in, const Material& material, Method by, Result& r, Tracer& trace) {
  const auto lambda_T = r.lambda_T = material.lambda_T;
  if (is_set(in.a_T)) {
    if (!is_set(in.c_T)) trace.value("c_T", material.c_T, "a line");
    trace.value("lambda_T", lambda_T,
                in.transition == Transition::published ? "as published with the set"
                                                       : "intersection of Tetmajer's and Euler's curves");
    if (is_set(in.lambda_1)) {
      STEP_TO(r, gap,
              (in.a_T - in.b_T * in.lambda_1 + material.c_T * pow<2>(in.lambda_1)) /
                      (pow<2>(pi) * in.E / pow<2>(in.lambda_1)) -
                  1.0,
              "deviation of the coefficients from Euler at their limit");
    }
  }
  if (is_set(in.sigma_P)) {
    STEP_TO(r, lambda_lim, pi * sqrt(in.E / in.sigma_P),
            "slenderness at which Euler's stress equals the proportional limit, [B25]");
  } else if (is_set(lambda_T)) {
    STEP_TO(r, lambda_lim, lambda_T, "no proportional limit is given: from here Euler's hyperbola holds");
  }
  if (r.loading == Loading::tension) {  // no formula of buckling ends where nothing buckles
    if (by == Method::euler) r.r_1 = 0.0;
    if (by == Method::tetmajer && !is_set(in.R_e)) r.r_0 = 0.0;
    return;
  }
  if (by == Method::euler) {
    STEP_TO(r, r_1, r.lambda_lim / r.lambda, "Euler's formula holds above the limit slenderness, [B25]");
  }
  if (by == Method::tetmajer && !is_set(in.R_e)) {
    STEP_TO(r, r_0, material.lambda_0 / r.lambda, "below lambda_0 the bar yields first");
  }
}

/// Data of each axis for EN 1993-1-1.
template <class Tracer>
void take_curves(const Input& in, const Material& material, AxisName axis, Axis& a, Tracer& trace) {
  if (!is_set(in.R_e)) return;
  const Curve curve = curve_of(in, axis);
  if (is_steel(in) && curve != Curve::by_kind) {
    a.alpha = trace.value("alpha", imperfection(curve), imperfection_reason(curve));
    a.chi = ec3_reduction(a.lambda, a.alpha, material, trace);
    a.lambda_bar = a.lambda / (pi * std::sqrt(in.E / in.R_e));
  }
}

/// Where the critical stress of the bar comes from.
const char* source_of(const Input& in, Method by) {
  if (in.method != Method::unsaid) return "governing method";
  if (by == Method::ec3) return "by EN 1993-1-1, as no method is named";
  if (by == Method::johnson) return "by Johnson's parabola up to lambda_J, by Euler above, as no method is named";
  return "by the method that the constants given belong to, as none is named";
}

/// The wall of a tube of another metal buckles by its modulus, as [EN1993-1-4] has it for stainless steels; that of
/// aluminium is stricter than class B of [EN1999-1-1], 6 sqrt(250 MPa/R_e) for sqrt(D/t). Plastics and timber are not
/// covered.
template <class Tracer>
void judge_tube(const Input& in, double of_steel, Result& r, Tracer& trace) {
  const double r_steel = trace.value("r_steel", of_steel, "d/t_w over 90 x 235 MPa/R_e, class 3");
  STEP_TO(r, r_class, r_steel * (210.0 * GPa) / in.E, "eps^2 = 235 MPa/R_e x E/210 GPa, [EN1993-1-4]");
}

bool is_tube_of_metal(const Input& in) {
  return is_set(plates_of(in).d) && !is_solid(in) && in_si(in.E) >= 1e9 * least_E && in_si(in.E) <= 1e9 * most_E;
}

/// The walls of a box of aluminium, all of them supported at both edges: the limit of welded parts of material class B,
/// the lowest of table 6.2 of [EN1999-1-1].
template <class Tracer>
void judge_box(double of_steel, Result& r, Tracer& trace) {
  const double r_steel =
      trace.value("r_steel", of_steel, "width/thickness over 42 sqrt(235 MPa/R_e), class 3 of steel");
  STEP_TO(r, r_class, r_steel * 42.0 * sqrt(235.0) / (15.0 * sqrt(250.0)),
          "width/thickness over 15 sqrt(250 MPa/R_e), class 3 of welded internal parts, [EN1999-1-1]");
}

bool is_box_of_aluminium(const Input& in) {
  const Plates plates = plates_of(in);
  const bool is_box = plates.kind == SectionKind::welded_box || plates.kind == SectionKind::hot_hollow ||
                      plates.kind == SectionKind::cold_hollow;
  return is_box && !is_set(plates.d) && in.E >= 65.0 * GPa && in.E <= 75.0 * GPa;
}

/// The limits of class 3 are those of steel: of open sections of another material none is known. In tension no wall
/// buckles.
template <class Tracer>
void judge_class(const Input& in, bool is_pressed, Result& r, Tracer& trace) {
  const double ratio = is_set(in.R_e) ? class_ratio(plates_of(in), in.R_e) : unset<double>;
  if (!is_set(ratio)) return;
  if (!is_pressed) {
    r.r_class = 0.0;
    if (ratio > 0.0) r.x_E = 1.0;
    return;
  }
  if (!is_steel(in) && has_modulus_of_steel(in)) return;
  if (ratio > 0.0 && !has_modulus_of_steel(in) && is_tube_of_metal(in)) return judge_tube(in, ratio, r, trace);
  if (ratio > 0.0 && is_box_of_aluminium(in)) return judge_box(ratio, r, trace);
  if (ratio > 0.0) {
    STEP_TO(r, x_E, in.E / (210.0 * GPa), "the limits of the walls are those of steel");
  }
  if (!has_modulus_of_steel(in)) return;
  if (in.method == Method::aisc) {
    r.r_class = trace.value("r_class", slender_ratio(plates_of(in), in.E, in.R_e, r.sigma_cr),
                            "AISC 360, E7: up to 1 the full area is effective at this critical stress, [AISC360]");
    return;
  }
  r.r_class =
      trace.value("r_class", ratio, "EN 1993-1-1, table 5.2, with eps = sqrt(235 MPa/R_e), [EN1993-1-1-buckling]");
}

template <class Tracer>
void conclude(const Input& in, Method by, bool is_bent, Result& r, Tracer& trace) {
  if (!r.methods.empty()) r.spread = trace.value("spread", spread_of(r), "maximum / minimum critical stress, less 1");
  const bool is_pulled = r.loading == Loading::tension;
  if (is_pulled) {
    r.r_lambda = 0.0;
  } else {
    STEP_TO(r, r_lambda, r.lambda / in.lambda_max, "slenderness / allowable slenderness");
  }
  judge_class(in, !is_pulled || is_bent, r, trace);
  if (!is_set(r.P_all) && !(r.F > 0.0 * kN) && is_set(r.F)) {
    r.u = trace.value("u", 0.0, "tension does not buckle it");
    return;
  }
  if (!is_set(r.sigma_cr)) return;
  trace.value("sigma_cr", r.sigma_cr, source_of(in, by));
  if (!is_set(r.u)) return;
  trace.value("P_all", r.P_all, "governing method");
  STEP_TO(r, u, r.F / r.P_all, "force / allowable force");
  if (in.method == Method::secant) r.u_e = r.u;
}

}  // namespace

template <class Tracer>
Result Buckling::evaluate(const Input& in, Tracer& trace) {
  return judge(in, false, trace);
}

template <class Tracer>
Result Buckling::judge(const Input& in, bool is_bent, Tracer& trace) {
  Result r;
  take_load(in, r, trace);
  take_section(in, r, trace);
  take_tension(in, r, trace);
  const Material material = material_of(in);
  const auto about = [&](AxisName axis) {
    [[maybe_unused]] const auto here = trace.scope("axes", r.axes.size());
    slenderness(in, axis, r, trace);
    take_curves(in, material, axis, r.axes.back(), trace);
    take_offset(in, axis, r, trace);
  };
  about(AxisName::y);
  about(AxisName::z);
  r.axis = r.axes[1].lambda >= r.axes[0].lambda ? AxisName::z : AxisName::y;
  const double lambda = r.lambda = std::max(r.axes[0].lambda, r.axes[1].lambda);
  trace.value("lambda", lambda, "the larger of the two axes governs, [B25]");
  if (is_set(in.E)) {
    STEP_TO(r, sigma_E, pow<2>(pi) * in.E / pow<2>(lambda), "Euler stress, shown even where Euler does not apply");
    STEP_TO(r, N_cr, sigma_E * r.A, "lowest elastic critical (Euler) load");
  }
  const Method by = method_of(in);
  take_limits(in, material, by, r, trace);
  sum_up_offset(in, r, trace);
  add_methods(in, material, by, r, trace, std::make_index_sequence<most_methods>{});
  buckle_twisting(in, r, trace);
  judge_twisting(in, material, by, r, trace);
  conclude(in, by, is_bent, r, trace);
  return r;
}

template Result Buckling::evaluate(const Input&, NoTrace&);
template Result Buckling::evaluate(const Input&, Trace&);
template Result Buckling::judge(const Input&, bool, NoTrace&);
template Result Buckling::judge(const Input&, bool, Trace&);

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::Buckling>();
