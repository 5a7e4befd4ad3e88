#include "calculators/link/member.hpp"

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/methods.hpp"
#include "calculators/section/shapes/torsion.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::link {

namespace {

using Input = Member::Input;
using Result = Member::Result;
using column::AxisName;

/// Shear area of a section with known plates; unset for others.
Area web_area(const Input& in, Area A) {
  const bool two = in.kind == SectionKind::hot_hollow || in.kind == SectionKind::cold_hollow ||
                   in.kind == SectionKind::welded_box || column::is_walled(in);
  const bool one =
      in.kind == SectionKind::rolled_I || in.kind == SectionKind::welded_I || in.kind == SectionKind::channel;
  if (is_set(in.d)) return two ? 0.5 * A : unset<Area>;
  const Length t_f = column::flange_of(in);
  if (one || two) return (two ? 2.0 : 1.0) * (in.h - 2.0 * t_f) * in.t_w;
  return unset<Area>;
}

/// The largest shear stress over the mean one times the area, by the section; unset where it is not known.
template <class Tracer>
Stress shear_stress(const Input& in, Area A, Tracer& trace) {
  const auto V = trace.value("V", abs(in.V), "magnitude");
  if (is_set(in.A_v)) return NAMED_STEP("tau", V / in.A_v, "uniform over the area that carries it");
  const bool is_massive = in.kind == SectionKind::solid && (is_set(in.d) || (is_set(in.h) && is_set(in.b)));
  const bool is_box = column::is_walled(in) && !is_set(in.d);
  if ((is_set(in.A) || is_box) && !is_massive) {
    const auto A_w = trace.value("A_w", web_area(in, A), "of the webs, between the flanges; of a thin tube half of A");
    if (!is_set(A_w)) return unset<Stress>;
    return NAMED_STEP("tau", V / A_w, "the webs carry the shear");
  }
  if (!is_set(in.d)) return NAMED_STEP("tau", 1.5 * V / A, "neutral axis of a rectangle");
  const Length bore = column::bore_of(in);
  const auto d_i = trace.value("d_i", is_set(bore) ? bore : 0.0 * mm, "bore");
  return NAMED_STEP("tau", 4.0 / 3.0 * V / A * (pow<2>(in.d) + in.d * d_i + pow<2>(d_i)) / (pow<2>(in.d) + pow<2>(d_i)),
                    "neutral axis of a ring or circle");
}

template <class Tracer>
void stresses(const Input& in, Result& r, Tracer& trace) {
  const auto A = r.A;
  const auto N = trace.value("N", is_set(in.P) ? -in.P : in.N, "tension positive");
  const auto i_y = trace.value("i_y", r.axes[0].i, "radius of gyration about y");
  const auto c_y = trace.value("c_y", column::extreme_fibre(in, AxisName::y), "extreme fibre from y");
  STEP(W_y, A * pow<2>(i_y) / c_y, "section modulus");
  STEP_TO(r, sigma_N, N / A, "uniform over the section");
  STEP(sigma_b, in.M_b / W_y, "extreme fibre, with the sign of the moment");
  STEP_TO(r, sigma_M, abs(sigma_b), "magnitude");
  STEP_TO(r, sigma_o, sigma_N + sigma_b, "stress at the fibre in tension under a positive moment");
  STEP_TO(r, sigma_u, sigma_N - sigma_b, "stress at the fibre in compression under a positive moment");
  r.tau = shear_stress(in, A, trace);
  r.cycle = {Stresses::normal, abs(r.sigma_N) + r.sigma_M, in.E};
}

/// The link as a beam under even inertia forces, along and across.
template <class Tracer>
void own_inertia(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.a_m) || !(in.a_m > 0.0 * m_per_s2)) return;
  const auto A = r.A;
  const auto rho = trace.value("rho", is_set(in.rho) ? in.rho : 7850.0 * kg_per_m3, "density, of steel if not known");
  const auto W_y =
      trace.value("W_y", A * pow<2>(r.axes[0].i) / column::extreme_fibre(in, AxisName::y), "section modulus");
  const double S_m = trace.value("S_m", is_set(in.S) ? in.S : 1.0, "required safety factor");
  STEP(q_m, rho * A * in.a_m, "inertia force per length, at most");
  STEP(sigma_m, q_m * in.l / A + q_m * pow<2>(in.l) / 8.0 / W_y, "along the link, and across it as a beam");
  STEP_TO(r, x_m, S_m * sigma_m / in.R_e, "inertia that N, V and M_b do not include");
}

template <class Tracer>
void yielding(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.S)) return;
  const auto sigma_N = r.sigma_N, sigma_M = r.sigma_M, tau = r.tau;
  STEP_TO(r, u_y, in.S * (abs(sigma_N) + sigma_M) / in.R_e, "extreme fibre over the yield strength");
  if (!is_set(tau)) return;
  STEP_TO(r, u_Q, in.S * sqrt(pow<2>(sigma_N) + 3.0 * pow<2>(tau)) / in.R_e, "neutral axis, [Mises]");
}

/// That of yield, so that a link hardly pressed is judged as one that is not; else that of buckling.
template <class Tracer>
double moment_safety(const Input& in, double n, Tracer& trace) {
  return trace.value("S_M", is_set(in.S) ? in.S : n,
                     is_set(in.S) ? "required safety factor of the moment" : "no S given: that of N");
}

/// In the plane of motion by the secant formula; across it by a sum that is on the safe side.
template <class Tracer>
void buckling_with_bending(const Input& in, Result& r, Tracer& trace) {
  if (r.loading == column::Loading::tension) r.u_p = r.u_i = 0.0, r.k = 1.0;
  const double n = column::safety(in, column::method_of(in), true, trace);
  if (!is_set(n)) return;
  r.u_p = r.u_i = 0.0, r.k = 1.0;
  if (!(r.F > 0.0 * kN)) return;
  const auto sigma_M = r.sigma_M;
  STEP(sigma_c, max(r.F / r.A, 1e-9 * in.R_e), "stress of the compression");
  const double S_M = moment_safety(in, n, trace);
  STEP(eta, S_M / n * sigma_M / sigma_c, "eccentricity ratio, M_b/|N| over W_y/A, each load with its safety");
  const auto sigma_s =
      trace.value("sigma_s", column::secant_stress(r.axes[0].lambda, eta, in.E, in.R_e),
                  "mean stress at which the extreme fibre yields, or the link buckles in its plane, [Gere]");
  STEP_TO(r, u_p, n * sigma_c / sigma_s, "force and moment over those that the secant formula allows");
  const auto N_cy = trace.value("N_cy", r.axes[0].N_cr, "critical force in the plane");
  STEP(x, n * r.F / N_cy, "required safety factor times force, over the critical force in the plane");
  STEP_TO(r, k, x < 1.0 ? 1.0 / cos(pi / 2.0 * sqrt(x)) : 1.0,
          "amplification of a uniform moment at mid-length, [Gere]; beyond the critical force buckling governs");
  const double u = r.u;
  STEP_TO(r, u_i, u + S_M * k * sigma_M / in.R_e, "buckling about the weaker axis and bending, added on the safe side");
}

/// Lateral-torsional buckling of a rectangle on edge: fork ends, uniform moment, warping free.
template <class Tracer>
void tilting(const Input& in, Result& r, Tracer& trace) {
  if (!Member::is_on_edge(in)) return;
  const double n = column::safety(in, column::method_of(in), true, trace);
  if (!is_set(in.S) && !is_set(n)) return;
  const auto sigma_M = r.sigma_M;
  const double c_t = trace.value("c_t", section::rectangle_factors(in.h / in.b).k_1, "of h/b, in torsion");
  const auto l_t = trace.value("l_t", max(in.l, max(r.axes[0].s, r.axes[1].s)), "the longest of l and s");
  STEP(G, in.E / 2.6, "shear modulus of a metal, ν = 0.3");
  STEP(I_z, in.h * pow<3>(in.b) / 12.0, "bending across");
  STEP(I_t, c_t * in.h * pow<3>(in.b), "torsion");
  STEP(M_cr, pi / l_t * sqrt(in.E * I_z * G * I_t), "critical moment of fork ends, Prandtl and Michell, [Narrow-beam]");
  STEP(lambda_t, sqrt(in.b * pow<2>(in.h) / 6.0 * in.R_e / M_cr), "slenderness, EN 1993-1-1 6.3.2.2, [EN1993-1-1-LTB]");
  STEP(Phi, 0.5 * (1.0 + 0.76 * (lambda_t - 0.2) + pow<2>(lambda_t)), "curve d, EN 1993-1-1 6.3.2.2, [EN1993-1-1-LTB]");
  STEP_TO(r, chi_t, lambda_t <= 0.2 ? 1.0 : 1.0 / (Phi + sqrt(pow<2>(Phi) - pow<2>(lambda_t))), "EN 1993-1-1 (6.56)");
  const double S_M = moment_safety(in, n, trace), k = trace.value("k", is_set(r.k) ? r.k : 1.0, "of the moment");
  const double u = trace.value("u", is_set(r.u) ? r.u : 0.0, "buckling about the weaker axis");
  STEP_TO(r, u_t, u + S_M * k * sigma_M / (chi_t * in.R_e), "with buckling, summed on the safe side");
}

}  // namespace

bool Member::force_given(const Input& in) { return is_set(in.N) || is_set(in.P); }

bool Member::fibre_known(const Input& in) { return is_set(column::extreme_fibre(in, AxisName::y)); }

bool Member::shear_inside(const Input& in) {
  constexpr double rounding = 1.01;
  return !(in.A_v > rounding * column::area_of(in));
}

/// Bound: web with its fillets, webs of a box, a tube; otherwise only the full section.
double Member::most_shear_area(const Input& in) {
  constexpr double rounding = 1.01;
  const Area A = column::area_of(in);
  const Length r = is_set(in.r) ? in.r : 0.0 * mm;
  switch (in.kind) {
    case SectionKind::rolled_I:
    case SectionKind::welded_I:
      return rounding * in_si(A - 2.0 * in.b * in.t_f + (in.t_w + 2.0 * r) * in.t_f);
    case SectionKind::channel:
      return rounding * in_si(A - 2.0 * in.b * in.t_f + (in.t_w + r) * in.t_f);
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
    case SectionKind::welded_box:
      return rounding * (is_set(in.d) ? in_si(A) * 2.0 / pi : in_si(A * in.h / (in.b + in.h)));
    default:
      return unset<double>;
  }
}

/// Bound: a load evenly distributed over the length; one in the middle, or at the free end, bends more.
double Member::least_moment(const Input& in) {
  const bool is_free = column::ends_of(in, AxisName::y) == column::Ends::fixed_free;
  return in_si(abs(in.V) * in.l) / (is_free ? 2.0 : 4.0);
}

Applies Member::without_mass(const Input& in) { return where(in.a_m > 0.0 * m_per_s2); }

/// Those for which an even moment bounds the others.
bool Member::ends_in_plane(const Input& in) {
  if (!column::supports_of(in, AxisName::y).empty()) return false;
  if (is_set(in.beta_y)) return in.beta_y >= 1.0;
  const column::Ends ends = column::ends_of(in, AxisName::y);
  return ends == column::Ends::pinned_pinned || ends == column::Ends::fixed_free || ends == column::Ends::unsaid;
}

Applies Member::loaded(const Input& in) {
  const bool forced = is_set(in.P) ? in.P > 0.0 * kN.one : abs(in.N) > 0.0 * kN.one;
  return where(forced || abs(in.M_b) > 0.0 * N_m.one);
}

Applies Member::sheared(const Input& in) { return where(abs(in.V) > 0.0 * kN.one); }

Applies Member::compressed_and_bent(const Input& in) {
  return std::min(column::compressed(in), where(abs(in.M_b) > 0.0 * N_m.one));
}

/// By the force, or on one side by the moment.
Applies Member::walls_pressed(const Input& in) {
  if (column::Buckling::outline_of(in) == column::Outline::solid) return Applies::no;
  return std::max(column::compressed(in), where(abs(in.M_b) > 0.0 * N_m.one));
}

bool Member::is_on_edge(const Input& in) {
  const bool rectangle = !is_set(in.A) && !is_set(in.d) && column::Buckling::outline_of(in) == column::Outline::solid;
  return rectangle && in.h > in.b;
}

/// Second moments of a section without row or outline, as different as those of a rectangle of h = 2 b: it bends
/// about its stronger axis, and may buckle laterally.
bool Member::is_lean(const Input& in) {
  constexpr double lean = 4.0;
  const bool is_bare = column::Buckling::outline_of(in) != column::Outline::closed && !is_set(in.d) && !is_set(in.h);
  return is_bare && is_set(in.I_y) && in.I_y > lean * in.I_z;
}

Applies Member::twisting_when_bent(const Input& in) {
  const column::Outline outline = column::Buckling::outline_of(in);
  if (is_on_edge(in) || is_lean(in)) return where(abs(in.M_b) > 0.0 * N_m.one);
  if (outline == column::Outline::solid && is_set(in.A) && !is_set(in.d)) return Applies::unseen;
  if (outline <= column::Outline::closed) return Applies::no;
  return where(abs(in.M_b) > 0.0 * N_m.one);
}

template <class Tracer>
Result Member::evaluate(const Input& in, Tracer& trace) {
  Result r;
  static_cast<column::MemberResult&>(r) = column::Buckling::judge(in, abs(in.M_b) > 0.0 * N_m, trace);
  stresses(in, r, trace);
  yielding(in, r, trace);
  buckling_with_bending(in, r, trace);
  tilting(in, r, trace);
  own_inertia(in, r, trace);
  return r;
}

template Member::Result Member::evaluate(const Input&, NoTrace&);
template Member::Result Member::evaluate(const Input&, Trace&);

}  // namespace loadpath::link

template const loadpath::Calculator& loadpath::erased<loadpath::link::Member>();
