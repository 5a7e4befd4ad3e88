#include "calculators/gear/rating/rating.hpp"

#include "calculators/gear/rating/contact.hpp"
#include "calculators/gear/rating/damage.hpp"
#include "calculators/gear/rating/iso_load.hpp"
#include "calculators/gear/rating/root.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::gear {

using namespace rating;

namespace {

bool is_typed(Stress sigma_Hlim, Stress sigma_Flim) { return is_set(sigma_Hlim) && is_set(sigma_Flim); }

bool is_named(Quality quality, double H) { return quality != Quality::untold && is_set(H); }

/// Of the line of its material unless it is given.
Stress contact_number(const Wheel& wheel) {
  if (is_set(wheel.sigma_Hlim)) return wheel.sigma_Hlim;
  const StrengthLine* const line = strength_line(wheel.material, wheel.quality, wheel.H);
  return line == nullptr ? unset<Stress> : (line->A_H * wheel.H + line->B_H) * MPa.one;
}
Stress bending_number(const Wheel& wheel) {
  if (is_set(wheel.sigma_Flim)) return wheel.sigma_Flim;
  const StrengthLine* const line = strength_line(wheel.material, wheel.quality, wheel.H);
  return line == nullptr ? unset<Stress> : (line->A_F * wheel.H + line->B_F) * MPa.one;
}

/// Load cycles of a gear in its life; unset for endurance.
double cycles_of(const RatingTypes::Input& in, const Wheel& wheel) {
  if (!is_set(in.L_h)) return unset<double>;
  const double turns = std::abs(in_si(in.n_1)) / (2.0 * pi) * in_si(in.L_h);
  return wheel.cycles * turns;
}

template <class Tracer>
void nominal_load(const RatingTypes::Input& in, const PairResult& g, RatingTypes::Result& r, Tracer& trace) {
  const Length d_1 = trace.value("d_1", g.d_1, "reference circle of gear 1");
  STEP_TO(r, F_t, 2.0 * abs(in.T_1) / d_1, "at the reference circle");
  STEP_TO(r, v, abs(in.n_1) * d_1 / 2.0, "at the reference circle");
}

template <class Tracer>
void nominal_contact(const RatingTypes::Input& in, const PairResult& g, RatingTypes::Result& r, Tracer& trace) {
  const Length d_1 = g.d_1;
  const double u = g.u;
  const double E_1 = modulus_of(in.material_1) / 1e6, E_2 = modulus_of(in.material_2) / 1e6;
  r.Z_E = trace.value("Z_E", std::sqrt(1.0 / (pi * (1.0 - poisson * poisson) * (1.0 / E_1 + 1.0 / E_2))),
                      "elasticity factor, sqrt(MPa): 189.8 of steel on steel");
  const double Z_H = r.Z_H, Z_E = r.Z_E, Z_eps = r.Z_eps, Z_beta = r.Z_beta;
  const Force F_t = r.F_t;
  STEP_TO(r, sigma_H0, Z_H * Z_E * Z_eps * Z_beta * sqrt(F_t / (d_1 * in.b) / MPa * (u + 1.0) / u) * MPa,
          is_iso(in) ? "at the pitch point, [ISO6336-2] 2006, 5.3" : "at the pitch point, [DIN3990-2]");
}

template <class Tracer>
void load_over_width(const RatingTypes::Input& in, const PairResult& g, const Runners& runners, RatingTypes::Result& r,
                     Tracer& trace) {
  if (is_iso(in)) {
    dynamic_factor_iso(in, g, runners, r, trace);
    face_load_factor_iso(in, g, runners, r, trace);
  } else {
    dynamic_factor(in, g, r, trace);
    face_load_factor(in, g, runners.one, runners.two, runners.lim_1, runners.lim_2, r, trace);
  }
}

template <class Tracer>
void load_among_teeth(const RatingTypes::Input& in, const PairResult& g, const Runners& runners, RatingTypes::Result& r,
                      Tracer& trace) {
  if (is_iso(in)) return transverse_factors_iso(in, g, r, trace);
  transverse_factors(in, g, is_hardened(runners.one.material) && is_hardened(runners.two.material), r, trace);
}

template <class Tracer>
void face_load_of_roots(const RatingTypes::Input& in, const Runners& runners, RatingTypes::Result& r, Tracer& trace) {
  if (is_iso(in)) return face_load_of_roots_iso(in, runners.one, runners.two, r, trace);
  r.K_Fbeta1 = face_load_of_root(in, runners.one, r, trace);
  r.K_Fbeta2 = face_load_of_root(in, runners.two, r, trace);
}

void keep_forms(const RatingTypes::Input& in, const Form& one, const Form& two, RatingTypes::Result& r) {
  (is_iso(in) ? r.Y_F1 : r.Y_Fa1) = one.Y_F, (is_iso(in) ? r.Y_S1 : r.Y_Sa1) = one.Y_S;
  r.f_eps = one.f_eps;
  (is_iso(in) ? r.Y_F2 : r.Y_Fa2) = two.Y_F, (is_iso(in) ? r.Y_S2 : r.Y_Sa2) = two.Y_S;
}

}  // namespace

bool Rating::has_strengths(const Input& in) {
  return (is_typed(in.sigma_Hlim_1, in.sigma_Flim_1) || is_named(in.quality_1, in.H_1)) &&
         (is_typed(in.sigma_Hlim_2, in.sigma_Flim_2) || is_named(in.quality_2, in.H_2));
}

FieldFault Rating::missing_strength(const Input& in) {
  const bool first = is_typed(in.sigma_Hlim_1, in.sigma_Flim_1) || is_named(in.quality_1, in.H_1);
  return {first ? "quality_2" : "quality_1", say("gear {1} has no allowable stress numbers", first ? "2" : "1"),
          say("quality_{1} = \"MQ\" with the hardness H_{1}; or sigma_Hlim_{1} and sigma_Flim_{1}", first ? "2" : "1")};
}

bool Rating::has_line(const Input& in) {
  const auto has = [](GearMaterial material, Quality quality, double H, Stress h, Stress f) {
    return is_typed(h, f) || !is_named(quality, H) || strength_line(material, quality, H) != nullptr;
  };
  return has(in.material_1, in.quality_1, in.H_1, in.sigma_Hlim_1, in.sigma_Flim_1) &&
         has(in.material_2, in.quality_2, in.H_2, in.sigma_Hlim_2, in.sigma_Flim_2);
}

FieldFault Rating::missing_line(const Input& in) {
  const bool first = is_typed(in.sigma_Hlim_1, in.sigma_Flim_1) || !is_named(in.quality_1, in.H_1) ||
                     strength_line(in.material_1, in.quality_1, in.H_1) != nullptr;
  const GearMaterial material = first ? in.material_2 : in.material_1;
  const Quality quality = first ? in.quality_2 : in.quality_1;
  for (const StrengthLine& line : strength_lines) {
    if (line.material != material || line.quality != quality) continue;
    return {first ? "H_2" : "H_1", say("the hardness is outside the range of ISO 6336-5"),
            say("{1} to {2}, or give sigma_Hlim and sigma_Flim", format_number(line.low), format_number(line.high))};
  }
  return {first ? "quality_2" : "quality_1", say("ISO 6336-5 has no data of this quality for the material"),
          say("another quality, or sigma_Hlim and sigma_Flim")};
}

bool Rating::is_laid_out(const Input& in) {
  const double angle = geometry_of(in).alpha_wt;
  return angle > 0.0 && angle < pi / 3.0;
}

bool Rating::is_in_place(const Input& in) {
  if (!leaves_middle(in) || !is_set(in.l) || !is_set(in.s) || !is_set(in.d_sh)) return true;
  const bool overhung = in.place == Place::c;
  const bool stands = overhung ? in.s > in.l / 2.0 : in.s < in.l / 2.0;
  return stands && in.l > in.b && !(in.d_sh > geometry_of(in).d_f1);
}

bool Rating::is_stiffened(const Input& in) {
  if (in.stiffening == Stiffening::none || !is_set(in.d_sh)) return true;
  return geometry_of(in).d_1 >= 1.15 * in.d_sh;
}

bool Rating::has_rims(const Input& in) {
  if (!is_set(in.s_R1) && !is_set(in.s_R2)) return true;
  const PairResult g = geometry_of(in);
  const auto is_rim = [](Length s_R, Length d_a, Length d_f) {
    return !is_set(s_R) || (s_R > (d_a - d_f) / 4.0 && s_R < d_f / 2.0);
  };
  return is_rim(in.s_R1, g.d_a1, g.d_f1) && is_rim(in.s_R2, g.d_a2, g.d_f2);
}

/// The tool of a protuberance, between the centres of its tip roundings.
bool Rating::has_wide_tip(const Input& in) {
  NoTrace quiet;
  return !is_set(in.s_pr) || rating::rounding_centre(in, quiet) >= 0.0;
}

/// Under F_t K_A, as f_sh_1 is.
double Rating::deflection_midway(const Input& in) {
  const Length d_1 = geometry_of(in).d_1;
  const double w = 2.0 * abs(in.T_1) / d_1 * in.K_A / in.b / N_per_mm;
  return w * 0.023 * (in.b / d_1) * (in.b / d_1) * 1e-6;
}

double Rating::least_deviation(const Input& in) {
  const PairResult g = geometry_of(in);
  return is_iso(in) ? tolerances_of(in, g, in.grade).f_ma() * 1e-6 : in_si(helix_tolerance(in, g));
}

namespace {

/// One block by load factors and stresses of its own; without torque it only turns.
void add_block(const RatingTypes::Input& in, const LoadBlock& block, const PairResult& g, const Runners& runners,
               const Form& f_1, const Form& f_2, RatingTypes::Result& r, Spectra& spectra) {
  NoTrace quiet;
  const RatingTypes::Input at = input_of_block(in, block);
  const double N_1 = cycles_of_block(at, runners.one, block.q), N_2 = cycles_of_block(at, runners.two, block.q);
  BlockDamage row{block.name, block.q, abs(at.T_1), abs(at.n_1), N_1, N_2};
  if (!(row.T > 0.0 * N_m.one)) {
    spectra.flank_1.push_back({}), spectra.flank_2.push_back({});
    spectra.root_1.push_back({}), spectra.root_2.push_back({});
    r.blocks.push_back(row);
    return;
  }
  const RatingTypes::Result of = Rating::evaluate(at, quiet);
  row.K_V = of.K_V, row.K_Hbeta = of.K_Hbeta;
  r.blocks.push_back(row);
  const Wheel &one = runners.one, &two = runners.two;
  spectra.flank_1.push_back(flank_stress(at, g, one, two, runners.lim_1, of.sigma_H1, N_1, of));
  spectra.flank_2.push_back(flank_stress(at, g, two, one, runners.lim_2, of.sigma_H2, N_2, of));
  spectra.root_1.push_back(root_stress(at, one, f_1, bending_number(one), of.sigma_F1, N_1));
  spectra.root_2.push_back(root_stress(at, two, f_2, bending_number(two), of.sigma_F2, N_2));
}

template <class Tracer>
void load_spectrum(const RatingTypes::Input& in, const PairResult& g, const Runners& runners, const Form& f_1,
                   const Form& f_2, RatingTypes::Result& r, Tracer& trace) {
  Spectra spectra;
  for (const LoadBlock& block : in.blocks) add_block(in, block, g, runners, f_1, f_2, r, spectra);
  safety_by_damage(in, spectra, r, trace);
  equivalent_torques(in, r, trace);
}

}  // namespace

template <class Tracer>
Rating::Result Rating::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const PairResult g = geometry_of(in);
  const Wheel one = first_of(in, g), two = second_of(in, g);
  nominal_load(in, g, r, trace);
  const Stress lim_1 = contact_number(one), lim_2 = contact_number(two);
  const Runners runners{one, two, lim_1, lim_2};
  load_over_width(in, g, runners, r, trace);
  contact_factors(in, g, r, trace);
  root_factors(in, g, r, trace);
  load_among_teeth(in, g, runners, r, trace);
  single_contact(in, g, r, trace);
  if (is_iso(in)) {
    lubricant_film(in, g, lim_1 < lim_2 ? lim_1 : lim_2, r, trace);
  } else {
    flank_factor(in, g, r, trace);
  }
  nominal_contact(in, g, r, trace);
  const Contact c_1 = contact_of(in, g, one, two, r.Z_B, lim_1, cycles_of(in, one), r, trace);
  const Contact c_2 = contact_of(in, g, two, one, r.Z_D, lim_2, cycles_of(in, two), r, trace);
  r.sigma_H1 = c_1.sigma, r.sigma_HG1 = c_1.limit, r.S_H1 = c_1.S, r.u_H1 = c_1.u;
  r.sigma_H2 = c_2.sigma, r.sigma_HG2 = c_2.limit, r.S_H2 = c_2.S, r.u_H2 = c_2.u;
  r.Z_NT1 = c_1.Z_NT, r.Z_NT2 = c_2.Z_NT;
  face_load_of_roots(in, runners, r, trace);
  const Form f_1 = form_of(in, g, one, trace), f_2 = form_of(in, g, two, trace);
  keep_forms(in, f_1, f_2, r);
  const Root t_1 = root_of(in, one, f_1, r.K_Fbeta1, bending_number(one), cycles_of(in, one), r, trace);
  const Root t_2 = root_of(in, two, f_2, r.K_Fbeta2, bending_number(two), cycles_of(in, two), r, trace);
  r.sigma_F01 = t_1.sigma_0, r.sigma_F1 = t_1.sigma, r.sigma_FG1 = t_1.limit, r.S_F1 = t_1.S, r.u_F1 = t_1.u;
  r.sigma_F02 = t_2.sigma_0, r.sigma_F2 = t_2.sigma, r.sigma_FG2 = t_2.limit, r.S_F2 = t_2.S, r.u_F2 = t_2.u;
  r.Y_B1 = t_1.Y_B, r.Y_B2 = t_2.Y_B, r.Y_NT1 = t_1.Y_NT, r.Y_NT2 = t_2.Y_NT;
  if (!in.blocks.empty()) load_spectrum(in, g, runners, f_1, f_2, r, trace);
  r.x_eps = g.eps_alpha;
  r.x_free = g.x_free, r.s_a = g.s_a;
  if (!is_set(in.s_pr)) r.f_int = g.f_int;  // the fillet of a protuberance tool begins higher
  r.c_n = std::min(g.c_1, g.c_2), r.j_bn = g.j_bn;
  return r;
}

template Rating::Result Rating::evaluate(const Input&, NoTrace&);
template Rating::Result Rating::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Rating>();
