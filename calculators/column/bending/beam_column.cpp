#include "calculators/column/bending/beam_column.hpp"

#include "calculators/column/bending/aisc_bending.hpp"
#include "calculators/column/member/methods.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::column {

namespace {

using Input = BeamColumn::Input;
using Result = BeamColumn::Result;

template <class Quantity>
Quantity or_zero(Quantity q) {
  return is_set(q) ? q : from_si<Quantity>(0.0);
}

bool is_any(Moment uniform, Moment M_1, Moment M_2, Stiffness q, Force F) {
  const auto acts = [](auto load) { return abs(in_si(load)) > 0.0; };
  return acts(uniform) || acts(M_1) || acts(M_2) || acts(q) || acts(F);
}

bool bends_about_y(const Input& in) { return is_any(in.M_y, in.M_y_1, in.M_y_2, in.q_z, in.F_z); }
bool bends_about_z(const Input& in) { return is_any(in.M_z, in.M_z_1, in.M_z_2, in.q_y, in.F_y); }

/// Factors on the loads: of the actions by EN 1993-1-1; AISC compares loads in service.
template <class Tracer>
double factor_of_actions(const Input& in, Method by, Tracer& trace) {
  if (by == Method::aisc) return trace.value("gamma_F", 1.0, "allowable strength: loads in service");
  return trace.value("gamma_F", is_set(in.gamma_F) ? in.gamma_F : 1.0,
                     is_set(in.gamma_F) ? "as given" : "assumed: the loads are design values");
}

template <class Tracer>
void take_actions(const Input& in, Method by, Bending& at, Result& r, Tracer& trace) {
  const double gamma_F = factor_of_actions(in, by, trace);
  const auto P = trace.value("P", is_set(in.P) ? in.P : -in.N, "compression positive");
  at.y = moments_about_y(in), at.z = moments_about_z(in);
  const auto M_y = trace.value("M_y", at.y.largest(), "largest moment about y along the bar");
  const auto M_z = trace.value("M_z", at.z.largest(), "largest moment about z along the bar");
  at.gamma_F = gamma_F;
  at.N = NAMED_STEP("N_Ed", gamma_F * P, "with the factor of the actions");
  STEP_TO(r, M_yEd, gamma_F * M_y, "with the factor of the actions");
  STEP_TO(r, M_zEd, gamma_F * M_z, "with the factor of the actions");
  at.M_y = M_yEd, at.M_z = M_zEd;
}

/// Class of the section, and its ratio in place of that for even compression.
template <class Tracer>
void classify(const Input& in, Bending& at, Result& r, Tracer& trace) {
  Plates plates = plates_of(in);
  plates.kind = at.kind;
  const Length web_edge = is_I(at.kind) ? in.h / 2.0 - in.t_f - or_zero(in.r) : 0.0 * mm;
  const auto [number, ratio] = section_class(
      plates, in.R_e,
      {max(at.N, 0.0 * kN), at.M_y, at.s.W_pl_y * in.R_e, max(at.N, 0.0 * kN) / at.s.A, at.M_y / at.s.I_y * web_edge});
  at.section_class = number;
  r.section_class = trace.value("section_class", static_cast<double>(number),
                                "EN 1993-1-1, table 5.2, loads growing in proportion, [EN1993-1-1-buckling]");
  if (is_I(at.kind) && is_set(r.r_class))
    r.r_class = trace.value("r_class", ratio, "EN 1993-1-1, table 5.2, the web under N and M_y, [EN1993-1-1-buckling]");
}

template <class Tracer>
void by_eurocode(const Input& in, Bending& at, Result& r, Tracer& trace) {
  classify(in, at, r, trace);
  const bool is_plastic = at.section_class <= 2;
  const auto W_y = trace.value("W_y", is_plastic ? at.s.W_pl_y : at.s.W_y, "of the class about y");
  const auto W_z = trace.value("W_z", is_plastic ? at.s.W_pl_z : at.s.W_z, "of the class about z");
  const auto A = trace.value("A", at.s.A, "area");
  const double gamma_M1 =
      trace.value("gamma_M1", is_set(in.gamma_M1) ? in.gamma_M1 : 1.0, "partial factor of buckling");
  const auto N = trace.value("N", max(at.N, 0.0 * kN), "compression; tension does not buckle the bar");
  STEP(n_s, abs(at.N) * in.gamma_M0 / (A * in.R_e), "axial part of the section");
  STEP(m_y, r.M_yEd * in.gamma_M0 / (W_y * in.R_e), "bending of the section about y");
  STEP(m_z, r.M_zEd * in.gamma_M0 / (W_z * in.R_e), "bending of the section about z");
  r.u_s = trace.value("u_s", section_utilisation(in, at, n_s, m_y, m_z), "6.2.9, [EN1993-1-1-bending]");
  turn_over(in, at, W_y, r, trace);
  STEP_TO(r, M_cy, r.chi_LT * W_y * in.R_e / gamma_M1, "with lateral-torsional buckling");
  STEP_TO(r, M_cz, W_z * in.R_e / gamma_M1, "about z");
  if (r.M_yEd > 0.0 * N_m) {
    STEP_TO(r, u_LT, r.M_yEd / r.M_cy, "EN 1993-1-1 (6.54), [EN1993-1-1-LTB]");
  }
  twist(in, at, gamma_M1, r, trace);
  const double chi_y = trace.value("chi_y", r.axes[0].chi, "buckling about y");
  const double chi_z =
      trace.value("chi_z", std::min(r.axes[1].chi, r.chi_T), "buckling about z, or torsional buckling");
  STEP(n_y, N * gamma_M1 / (chi_y * A * in.R_e), "over the resistance to buckling about y");
  STEP(n_z, N * gamma_M1 / (chi_z * A * in.R_e), "over the resistance to buckling about z");
  annex_B(in, at, n_y, n_z, r, trace);
  STEP_TO(r, u_y, n_y + r.k_yy * r.M_yEd / r.M_cy + r.k_yz * r.M_zEd / r.M_cz,
          "EN 1993-1-1 (6.61), [EN1993-1-1-bending]");
  STEP_TO(r, u_z, n_z + r.k_zy * r.M_yEd / r.M_cy + r.k_zz * r.M_zEd / r.M_cz,
          "EN 1993-1-1 (6.62), [EN1993-1-1-bending]");
}

/// Torsional buckling of an I section by chapter E: with its stress the formula of the column.
template <class Tracer>
void twist_by_aisc(const Input& in, const Bending& at, Result& r, Tracer& trace) {
  if (!is_I(at.kind) || !(at.N > 0.0 * kN)) return;
  const Length L = lateral_length(in);
  const auto F_T =
      trace.value("F_T", (pi * pi * in.E * at.s.I_w / (L * L) + in.E / 2.6 * at.s.I_t) / (at.s.I_y + at.s.I_z),
                  "elastic stress of torsional buckling, (E4-2), [AISC360-bending]");
  NoTrace none;
  STEP(lambda_T, pi * sqrt(in.E / F_T), "slenderness of the same elastic stress");
  const auto sigma_T = trace.value("sigma_T", aisc_stress(lambda_T, material_of(static_cast<const Member&>(in)), none),
                                   "AISC 360 (E3-2), (E3-3), [AISC360]");
  const auto P_T = trace.value("P_T", sigma_T * at.s.A / in.Omega_c, "allowable force of torsional buckling");
  const auto N = trace.value("N", at.N, "compression");
  STEP_TO(r, u_T, N / P_T, "over the allowable force of torsional buckling");
}

/// Of a moment of unknown distribution that of end moments which bend the bar to an S.
Force shear_of(const Moments& m, bool is_unknown) { return is_unknown ? 2.0 * m.largest() / m.l : m.shear(); }

template <class Tracer>
void take_shear(const Input& in, const Bending& at, Result& r, Tracer& trace) {
  if (!bends_about_y(in) && !bends_about_z(in)) return;
  const auto V_z = trace.value("V_z", at.gamma_F * shear_of(at.y, is_set(in.M_y)), "largest shear force along z");
  const auto V_y = trace.value("V_y", at.gamma_F * shear_of(at.z, is_set(in.M_z)), "largest shear force along y");
  const auto A_z = trace.value("A_z", at.s.A_vz, "shear area along z, between the flanges, 6.2.6");
  const auto A_y = trace.value("A_y", at.s.A_vy, "shear area along y, of the flanges, 6.2.6");
  STEP_TO(r, x_V, max(V_z / A_z, V_y / A_y) * sqrt(3.0) * in.gamma_M0 / in.R_e, "over the plastic shear resistance");
}

}  // namespace

bool BeamColumn::force_given(const Input& in) { return is_set(in.N) || is_set(in.P); }

bool BeamColumn::plastic_fits(const Input& in) { return plastic_beyond_plates(in).path.empty(); }
FieldFault BeamColumn::other_plastic(const Input& in) { return plastic_beyond_plates(in); }

bool BeamColumn::fits_shape(const Input& in) {
  const SectionKind kind = kind_of(in);
  const bool sides = is_set(in.h) && is_set(in.b);
  if (is_I(kind)) {
    const bool is_plated = sides && is_set(in.t_f) && is_set(in.t_w) && is_set(in.A);
    return is_plated && !(in.method == Method::aisc && kind == SectionKind::welded_I);
  }
  if (is_hollow(kind)) {
    const bool walled = is_set(in.t_w) || is_set(in.d_bore);
    return walled && (is_set(in.d) || (sides && (is_set(in.A) || is_walled(in))));
  }
  return kind == SectionKind::solid && in.method != Method::aisc && (is_set(in.d) || sides);
}

bool BeamColumn::by_a_code(const Input& in) {
  const Method by = method_of(in);
  return by == Method::ec3 || by == Method::aisc || !is_set(in.R_e);
}

FieldFault BeamColumn::not_of_code(const Input& in) {
  if (in.method == Method::unsaid)
    return {"method", say("bending with compression is assessed by method = \"ec3\" or \"aisc\""), {}};
  return {"method", say("the method '{1}' does not cover bending with compression", word_of(in.method)),
          say("take ec3 or aisc")};
}

bool BeamColumn::free_end_is_unloaded(const Input& in) {
  const bool loaded = abs(in_si(or_zero(in.q_z))) > 0.0 || abs(in_si(or_zero(in.F_z))) > 0.0;
  return !loaded || is_one_segment(in) || (is_set(in.z_g) && in.z_g <= 0.0 * mm.one);
}

double BeamColumn::full_length(const Input& in) {
  Input between_ends = in;
  between_ends.l_LT = unset<Length>;
  return in_si(lateral_length(between_ends));
}

double BeamColumn::factor_of_moments(const Input& in) {
  if (!is_one_segment(in)) return 1.0;
  const Moments moments = moments_about_y(in);
  if (!fits_shape(in) || !is_set(in.E) || !(in_si(moments.largest()) > 0.0)) return unset<double>;
  if (in.method == Method::aisc) return moment_gradient_factor(moments);
  const Geometry s = geometry_of(completed(in));
  return critical_moment(in, s) / critical_uniform_moment(lateral_of(in, s), lateral_length(in));
}

Applies BeamColumn::loaded(const Input& in) {
  const bool forced = is_set(in.P) ? in.P > 0.0 * kN.one : abs(in_si(in.N)) > 0.0;
  return where(forced || bends_about_y(in) || bends_about_z(in));
}

Applies BeamColumn::bent(const Input& in) { return where(bends_about_y(in) || bends_about_z(in)); }

Applies BeamColumn::turning_over(const Input& in) { return where(bends_about_y(in)); }

Applies BeamColumn::twisting(const Input& in) { return is_I(kind_of(in)) ? compressed(in) : Applies::no; }

Applies BeamColumn::walls_pressed(const Input& in) {
  return kind_of(in) == SectionKind::solid ? Applies::no : loaded(in);
}

template <class Tracer>
Result BeamColumn::evaluate(const Input& given, Tracer& trace) {
  const Input in = completed(given);
  Result r;
  const bool is_bent = bends_about_y(in) || bends_about_z(in);
  static_cast<MemberResult&>(r) = Buckling::judge(in, is_bent, trace);
  const Method by = method_of(in);
  Bending at;
  at.kind = in.kind, at.s = geometry_of(in);
  take_actions(in, by, at, r, trace);
  if (by == Method::aisc) {
    twist_by_aisc(in, at, r, trace);
    interact_by_aisc(in, at, r, trace);
    if (is_bent) r.r_class = std::max(r.r_class, slender_in_bending(in, in.kind));
  } else {
    by_eurocode(in, at, r, trace);
  }
  take_shear(in, at, r, trace);
  return r;
}

template Result BeamColumn::evaluate(const Input&, NoTrace&);
template Result BeamColumn::evaluate(const Input&, Trace&);

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::BeamColumn>();
