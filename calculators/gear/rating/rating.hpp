// Load capacity of cylindrical gears with outer teeth: pitting and tooth breakage by DIN 3990-11 or ISO 6336.
//
// Decides the dynamic factor, the load over the face width and among the teeth, the contact stress and the root stress
// of both gears, their limits for endurance or at their cycles, and both safety factors. DIN 3990-11:1989, the form of
// ISO 6336 for machinery, with the helix factor of DIN 3990-2; or ISO 6336-1, -2 and -3:2006, method B, the load over
// the face width by method C or from the elastic lines of both shafts. Allowable stress numbers by ISO 6336-5 or as
// given. Loads nominal, with the application factor K_A; T_1 is the torque of gear 1. Load spectra by ISO 6336-6, with
// damage sums. Not covered: inner teeth, DIN 3990 beyond its dynamic constants, webs, scuffing, micropitting, case
// crushing; ISO 6336 of 2019 except Y_F and Y_beta, form circles of protuberance tools, grinding notches. From memory:
// moduli of irons, f_ma of DIN 3990 where it is not given, F_betaxmin, Y_A of idlers, numbers of ISO clauses.
#pragma once

#include "calculators/gear/rating/deflection.hpp"
#include "calculators/gear/rating/materials.hpp"
#include "calculators/gear/rating/types.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace loadpath::gear {

struct Rating : RatingTypes {
  static constexpr auto id = "gear.rating";
  static constexpr auto title = "Load capacity of cylindrical gears (DIN 3990-11, ISO 6336)";
  static constexpr auto scope =
      "Pitting and tooth breakage of external spur and helical gears by DIN 3990-11 (machinery), with the load "
      "factors, endurance and finite life; materials by ISO 6336-5. With standard = \"iso6336\" all factors are those "
      "of ISO 6336-1, -2 and -3:2006, load spectra those of ISO 6336-6.";
  static constexpr auto source = "[DIN3990-11], [ISO6336-1], [ISO6336-2], [ISO6336-3], [ISO6336-5], [ISO6336-6]";
  static constexpr auto headline = "S_H {S_H1}/{S_H2}";
  static constexpr auto synonyms =
      "gear rating, pitting, tooth breakage, load capacity, ISO 6336, DIN 3990, contact stress, "
      "load spectrum, equivalent torque, Lastkollektiv, Hertzian pressure, rim thickness, tooth flank, safety against "
      "pitting, root safety, "
      "Tragfähigkeit, Grübchen, Zahnfuß, Flankentragfähigkeit, выкрашивание, питтинг, контактные напряжения, прочность "
      "зубьев";
  static constexpr auto example = R"([project]
title = "Rating of a reducer stage"

[teeth]
calculator = "gear.rating"
z_1 = 19
z_2 = 104
m_n = "4 mm"
x_1 = 0.5
x_2 = 0.15
rho_fP = 0.25
b = "48 mm"
T_1 = "400 N*m"
n_1 = "980 rpm"
K_A = 1.25
grade = 6
finish = "ground"
R_z1 = "5 um"
R_z2 = "5 um"
material_1 = "case"
material_2 = "case"
quality_1 = "MQ"
quality_2 = "MQ"
H_1 = 720
H_2 = 720
place = "middle"
S_Hmin = 1.1
S_Fmin = 1.4
)";

  /// Volume of both gears as solid cylinders, in m^3: what module and width that are searched for together minimise.
  /// Pairs out of proportion come last: discs thinner than 6 modules, gears wider than 1.2 d_1 (from general
  /// knowledge).
  static double amount(const Input& in) {
    const double z_1 = in.z_1, z_2 = in.z_2, m_t = in_si(in.m_n) / std::cos(in.beta), b = in_si(in.b);
    const bool is_usual = b >= 6.0 * in_si(in.m_n) && b <= 1.2 * z_1 * m_t;
    return pi / 4.0 * (z_1 * z_1 + z_2 * z_2) * m_t * m_t * b * (is_usual ? 1.0 : 1e9);
  }
  static bool has_strengths(const Input& in);
  static FieldFault missing_strength(const Input& in);
  static bool has_line(const Input& in);
  static FieldFault missing_line(const Input& in);
  static bool is_laid_out(const Input& in);
  static bool leaves_middle(const Input& in) { return is_away_from_middle(in); }
  static bool is_in_place(const Input& in);
  static bool is_stiffened(const Input& in);
  static bool has_rims(const Input& in);
  static bool has_wide_tip(const Input& in);
  static double least_deviation(const Input& in);
  static double deflection_midway(const Input& in);

  static constexpr Fields inputs_of_teeth{
      RecordField<Input>{"mesh", "gear pair: mesh = \"=stage.mesh\""},
      Choice{&Input::standard, "standard", "standard of the rating"}.may_be_missing(),
      Choice{&Input::root_edition, "root_edition", "edition of ISO 6336-3"}.may_be_missing(),
      Count{&Input::z_1, "z_1", 5, 2000, "number of teeth, gear 1"},
      Count{&Input::z_2, "z_2", 5, 2000, "number of teeth, gear 2"},
      Field{&Input::m_n, "m_n", mm, "normal module"}.positive().usually(0.5, 50).findable("module"),
      Field{&Input::alpha_n, "alpha_n", deg, "normal pressure angle"}.within(15, 25).usually(17.5, 25),
      Field{&Input::beta, "beta", deg, "helix angle at the reference diameter"}.within(0, 45).usually(0, 30),
      Field{&Input::x_1, "x_1", ratio, "profile shift coefficient, gear 1"}.within(-1.5, 1.5).usually(-0.8, 1.2),
      Field{&Input::x_2, "x_2", ratio, "profile shift coefficient, gear 2; omitted: from a_w, else zero"}
          .within(-1.5, 1.5)
          .usually(-0.8, 1.2)
          .may_be_missing(),
      Field{&Input::a_w, "a_w", mm, "working centre distance"}.positive().may_be_missing(),
      Field{&Input::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"}.within(0.3, 2).usually(0.8, 1.2),
      Field{&Input::h_fP, "h_fP", ratio, "dedendum of the basic rack, in modules"}.within(0.4, 2.5).usually(1, 1.4),
      Field{&Input::rho_fP, "rho_fP", ratio, "root fillet radius of the basic rack, in modules"}.within(0, 0.6),
      Field{&Input::s_pr, "s_pr", ratio,
            "residual undercut by a protuberance tool after finishing, in modules (interference not assessed)"}
          .within(0, 0.2)
          .usually(0, 0.08)
          .may_be_missing(),
      Choice{&Input::shortening, "shortening", "tip shortening of a pair with profile shift"}.may_be_missing(),
      Field{&Input::b, "b", mm, "common face width"}.positive().findable("R20"),
      Field{&Input::T_1, "T_1", N_m, "torque of gear 1, nominal"}.load().at_least_that_of_source("T_1"),
      Field{&Input::n_1, "n_1", rpm, "speed of gear 1"}.near_that_of_source("n_1"),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Choice{&Input::idler, "idler", "idler gear (reversed tooth bending)"}.may_be_missing()};
  static constexpr Fields inputs_of_capacity{
      Count{&Input::grade, "grade", 5, 12, "accuracy grade of the teeth: DIN 3961, or ISO 1328-1:1995"},
      Choice{&Input::finish, "finish", "finish of the flanks"}.may_be_missing(),
      Field{&Input::R_z1, "R_z1", um, "flank roughness, gear 1"}.positive().usually(0.5, 40).may_be_missing(),
      Field{&Input::R_z2, "R_z2", um, "flank roughness, gear 2"}.positive().usually(0.5, 40).may_be_missing(),
      Field{&Input::nu_40, "nu_40", mm2_per_s, "kinematic viscosity of the oil at 40 °C (ISO 6336-2)"}
          .positive()
          .usually(10, 2000)
          .may_be_missing(),
      Field{&Input::s_R1, "s_R1", mm, "rim thickness below the root, gear 1 (ISO 6336-3); omitted: solid"}
          .positive()
          .may_be_missing(),
      Field{&Input::s_R2, "s_R2", mm, "rim thickness below the root, gear 2"}.positive().may_be_missing(),
      Choice{&Input::material_1, "material_1", "material and heat treatment, gear 1"},
      Choice{&Input::material_2, "material_2", "material and heat treatment, gear 2"},
      Choice{&Input::quality_1, "quality_1", "material quality of ISO 6336-5, gear 1"}.may_be_missing(),
      Choice{&Input::quality_2, "quality_2", "material quality of ISO 6336-5, gear 2"}.may_be_missing(),
      Field{&Input::H_1, "H_1", ratio, "flank hardness, gear 1: HBW of steel, nodular and grey, else HV"}
          .within(100, 900)
          .may_be_missing(),
      Field{&Input::H_2, "H_2", ratio, "flank hardness, gear 2"}.within(100, 900).may_be_missing(),
      Field{&Input::sigma_Hlim_1, "sigma_Hlim_1", MPa,
            "allowable stress number for contact, gear 1, in place of quality_1"}
          .positive()
          .usually(250, 1650)
          .may_be_missing(),
      Field{&Input::sigma_Hlim_2, "sigma_Hlim_2", MPa, "allowable stress number for contact, gear 2"}
          .positive()
          .usually(250, 1650)
          .may_be_missing(),
      Field{&Input::sigma_Flim_1, "sigma_Flim_1", MPa, "nominal stress number for bending, gear 1: half of sigma_FE"}
          .positive()
          .usually(40, 525)
          .may_be_missing(),
      Field{&Input::sigma_Flim_2, "sigma_Flim_2", MPa, "nominal stress number for bending, gear 2"}
          .positive()
          .usually(40, 525)
          .may_be_missing(),
      Choice{&Input::place, "place", "position of the pinion relative to the bearings (DIN 3990-11)"}.may_be_missing(),
      Field{&Input::l, "l", mm, "bearing span of the pinion shaft"}.positive().may_be_missing(),
      Field{&Input::s, "s", mm, "distance of the pinion from the middle of the span"}.positive().may_be_missing(),
      Field{&Input::d_sh, "d_sh", mm, "diameter of the pinion shaft"}.positive().may_be_missing(),
      Choice{&Input::stiffening, "stiffening", "stiffening effect of the pinion"}.may_be_missing(),
      Choice{&Input::crowning, "crowning", "lead modification: crowning or end relief"}.may_be_missing(),
      Field{&Input::f_ma, "f_ma", um, "misalignment due to manufacturing deviations; omitted: by the grade"}
          .at_least(0)
          .usually(0, 100)
          .may_be_missing(),
      Choice{&Input::pattern, "pattern", "contact pattern under load"}.may_be_missing(),
      Field{&Input::C_a, "C_a", um, "tip relief at grade 5 (ISO 6336-1); omitted: by running in"}
          .at_least(0)
          .usually(0, 150)
          .may_be_missing(),
      Field{&Input::L_h, "L_h", hour, "required life; omitted: endurance"}
          .positive()
          .usually(100, 3e5)
          .customarily_at_least(100)
          .may_be_missing(),
      Count{&Input::q_1, "q_1", 1, 20, "load cycles of a tooth of gear 1 per revolution: of a sun the planets"}
          .may_be_missing(),
      Count{&Input::q_2, "q_2", 1, 20, "load cycles of a tooth of gear 2 per revolution"}.may_be_missing(),
      Field{&Input::S_Hmin, "S_Hmin", ratio, "required safety factor against pitting"}
          .at_least(1)
          .usually(1, 2)
          .may_be_missing()
          .factor(),
      Field{&Input::S_Fmin, "S_Fmin", ratio, "required safety factor against tooth breakage"}
          .at_least(1)
          .usually(1.2, 3)
          .customarily_at_least(1.2)
          .may_be_missing()
          .factor()};
  static constexpr auto inputs =
      join(inputs_of_teeth, inputs_of_capacity, deflection_inputs<Input>(), spectrum_inputs<Input>());

  static constexpr Fields results_of_pair{
      Field{&Result::F_t, "F_t", N, "nominal tangential force at the reference circle"},
      Field{&Result::v, "v", m_per_s, "velocity at the reference circle"},
      Field{&Result::c_th, "c_th", ratio, "theoretical single stiffness of the teeth, N/(mm um)"},
      Field{&Result::c_prime, "c_prime", ratio, "single stiffness of the teeth, N/(mm um)"},
      Field{&Result::c_gamma_alpha, "c_gamma_alpha", ratio, "mesh stiffness, N/(mm um)"},
      Field{&Result::c_gamma_beta, "c_gamma_beta", ratio, "mesh stiffness for the face load factor, N/(mm um)"},
      Field{&Result::x_c, "x_c", ratio, "sum of the profile shifts: the series of the stiffness holds from -0.5 to 2"}
          .limit(-0.5, 2)
          .where_it_applies(),
      Field{&Result::N_res, "N_res", ratio, "resonance ratio: speed / resonance speed"},
      Field{&Result::f_pbeff, "f_pbeff", um, "base pitch deviation after running in"},
      Field{&Result::y_alpha, "y_alpha", um, "running-in allowance of the pitch deviation"},
      Field{&Result::B_p, "B_p", ratio, "effect of the pitch deviation on the dynamic load"},
      Field{&Result::B_f, "B_f", ratio, "effect of the profile deviation on the dynamic load"},
      Field{&Result::B_k, "B_k", ratio, "effect of the tip relief on the dynamic load"},
      Field{&Result::K_V, "K_V", ratio, "dynamic factor"},
      Field{&Result::x_v, "x_v", ratio, "related pitch line velocity: the dynamic constants hold below 10"}
          .limit(0, 10)
          .where_it_applies(),
      Field{&Result::f_sh, "f_sh", um, "equivalent misalignment due to pinion and shaft deformation"},
      Field{&Result::F_betax, "F_betax", um, "initial equivalent misalignment, before running in"},
      Field{&Result::y_beta, "y_beta", um, "running-in allowance"},
      Field{&Result::F_betay, "F_betay", um, "equivalent misalignment after running in"},
      Field{&Result::K_Hbeta, "K_Hbeta", ratio, "face load factor, contact"},
      Field{&Result::q_alpha, "q_alpha", ratio, "stiffness x pitch deviation / line load (ISO 6336-1)"},
      Field{&Result::K_Halpha, "K_Halpha", ratio, "transverse load factor, contact"},
      Field{&Result::K_Falpha, "K_Falpha", ratio, "transverse load factor, root"},
      Field{&Result::K_Fbeta1, "K_Fbeta1", ratio, "face load factor, root of gear 1"},
      Field{&Result::K_Fbeta2, "K_Fbeta2", ratio, "face load factor, root of gear 2"},
      Field{&Result::Z_H, "Z_H", ratio, "zone factor"},
      Field{&Result::Z_E, "Z_E", ratio, "elasticity factor, sqrt(MPa)"},
      Field{&Result::Z_eps, "Z_eps", ratio, "contact ratio factor"},
      Field{&Result::Z_beta, "Z_beta", ratio, "helix factor"},
      Field{&Result::Z_B, "Z_B", ratio, "single-pair tooth contact factor, gear 1"},
      Field{&Result::Z_D, "Z_D", ratio, "single-pair tooth contact factor, gear 2"},
      Field{&Result::Z_LVR, "Z_LVR", ratio, "factor of lubricant, velocity and roughness"},
      Field{&Result::Z_L, "Z_L", ratio, "lubricant factor"},
      Field{&Result::Z_v, "Z_v", ratio, "velocity factor"},
      Field{&Result::Z_R, "Z_R", ratio, "roughness factor"},
      Field{&Result::Z_NT1, "Z_NT1", ratio, "life factor for contact, gear 1"},
      Field{&Result::Z_NT2, "Z_NT2", ratio, "life factor for contact, gear 2"},
      Field{&Result::sigma_H0, "sigma_H0", MPa, "nominal contact stress at the pitch point"},
      Field{&Result::sigma_H1, "sigma_H1", MPa, "contact stress, gear 1"},
      Field{&Result::sigma_H2, "sigma_H2", MPa, "contact stress, gear 2"},
      Field{&Result::sigma_HG1, "sigma_HG1", MPa, "pitting stress limit, gear 1"},
      Field{&Result::sigma_HG2, "sigma_HG2", MPa, "pitting stress limit, gear 2"},
      Field{&Result::S_H1, "S_H1", ratio, "safety factor against pitting, gear 1"},
      Field{&Result::S_H2, "S_H2", ratio, "safety factor against pitting, gear 2"},
      Field{&Result::Y_Fa1, "Y_Fa1", ratio, "form factor, gear 1"},
      Field{&Result::Y_Fa2, "Y_Fa2", ratio, "form factor, gear 2"},
      Field{&Result::Y_Sa1, "Y_Sa1", ratio, "stress correction factor, gear 1"},
      Field{&Result::Y_Sa2, "Y_Sa2", ratio, "stress correction factor, gear 2"},
      Field{&Result::Y_F1, "Y_F1", ratio, "form factor, outer point of single pair contact, gear 1"},
      Field{&Result::Y_F2, "Y_F2", ratio, "form factor, outer point of single pair contact, gear 2"},
      Field{&Result::Y_S1, "Y_S1", ratio, "stress correction factor, gear 1, for Y_F1"},
      Field{&Result::Y_S2, "Y_S2", ratio, "stress correction factor, gear 2, for Y_F2"},
      Field{&Result::Y_B1, "Y_B1", ratio, "rim thickness factor, gear 1"},
      Field{&Result::Y_B2, "Y_B2", ratio, "rim thickness factor, gear 2"},
      Field{&Result::Y_NT1, "Y_NT1", ratio, "life factor for bending, gear 1"},
      Field{&Result::Y_NT2, "Y_NT2", ratio, "life factor for bending, gear 2"},
      Field{&Result::Y_eps, "Y_eps", ratio, "contact ratio factor, root"},
      Field{&Result::f_eps, "f_eps", ratio, "load distribution influence factor (ISO 6336-3:2019)"},
      Field{&Result::Y_beta, "Y_beta", ratio, "helix factor, root"},
      Field{&Result::sigma_F01, "sigma_F01", MPa, "nominal root stress, gear 1"},
      Field{&Result::sigma_F02, "sigma_F02", MPa, "nominal root stress, gear 2"},
      Field{&Result::sigma_F1, "sigma_F1", MPa, "root stress, gear 1"},
      Field{&Result::sigma_F2, "sigma_F2", MPa, "root stress, gear 2"},
      Field{&Result::sigma_FG1, "sigma_FG1", MPa, "tooth root stress limit, gear 1"},
      Field{&Result::sigma_FG2, "sigma_FG2", MPa, "tooth root stress limit, gear 2"},
      Field{&Result::S_F1, "S_F1", ratio, "safety factor against tooth breakage, gear 1"},
      Field{&Result::S_F2, "S_F2", ratio, "safety factor against tooth breakage, gear 2"},
      Field{&Result::u_H1, "u_H1", ratio, "pitting, gear 1: required / calculated safety factor"}.check("S_Hmin"),
      Field{&Result::u_H2, "u_H2", ratio, "pitting, gear 2: required / calculated safety factor"}.check("S_Hmin"),
      Field{&Result::u_F1, "u_F1", ratio, "tooth breakage, gear 1: required / calculated safety factor"}.check(
          "S_Fmin"),
      Field{&Result::u_F2, "u_F2", ratio, "tooth breakage, gear 2: required / calculated safety factor"}.check(
          "S_Fmin"),
      Field{&Result::x_eps, "x_eps", ratio, "transverse contact ratio: the method holds from 1 to 2"}.limit(1, 2),
      Field{&Result::x_free, "x_free", ratio, "undercut: minimum margin of profile shift to the undercut limit"}
          .limit(-0.02, 100)
          .criterion(),
      Field{&Result::s_a, "s_a", ratio, "tip thickness: minimum in modules (0.2; case-hardened 0.4)"}
          .limit(0.2, 100)
          .criterion(),
      Field{&Result::f_int, "f_int", ratio, "interference: minimum clearance between tips and fillets, in modules"}
          .limit(-0.01, 1e4)
          .criterion()
          .where_it_applies(),
      Field{&Result::c_n, "c_n", mm, "tip clearance, the smaller one"}.limit(-1e-6, 1e4).criterion(),
      Field{&Result::j_bn, "j_bn", mm, "normal backlash (negative: jamming)"}.limit(-1e-6, 1e3).criterion()};
  static constexpr auto results = join(results_of_pair, spectrum_results<Result>());

  /// Of one pair of teeth; a search for the pair skips those that break them.
  static constexpr std::array rules_of_teeth{
      Rule<Input>{&is_laid_out, "a_w, x_1, x_2, z_1, z_2, m_n, beta",
                  "the working pressure angle from a_w, or from x_1 and x_2, must exceed zero"},
      Rule<Input>{
          &has_rims, "s_R1, s_R2, m_n, z_1, z_2",
          "a rim is thicker than half the tooth depth, below which ISO 6336-3 does not rate it, and thinner than "
          "the root radius"},
      Rule<Input>{&is_stiffened, "stiffening, d_sh",
                  "a pinion stiffens its shaft where d_1 is 1.15 d_sh or more: stiffening = \"none\""},
      Rule<Input>{
          &is_in_place, "place, l, s, d_sh, b",
          "an overhung pinion (c) has s above l/2, one between the bearings (a, b, d, e) below; the span is wider "
          "than the face, and the shaft no thicker than the root circle"}};
  static constexpr std::array rules_of_values{
      Rule<Input>{&has_strengths, "quality_1, quality_2, sigma_Hlim_1, sigma_Hlim_2, sigma_Flim_1, sigma_Flim_2",
                  "each gear needs quality and H, or sigma_Hlim and sigma_Flim", &missing_strength},
      Rule<Input>{&has_line, "material_1, material_2, quality_1, quality_2, H_1, H_2",
                  "ISO 6336-5 has no data for this material, quality and hardness", &missing_line},
      Rule<Input>{[](const Input& in) { return in.rho_fP <= in.h_fP; }, "rho_fP, h_fP",
                  "the root radius must fit into the dedendum"},
      Rule<Input>{&has_wide_tip, "s_pr, h_fP, rho_fP", "the tip of the tool must be wide enough for its roundings"},
      Rule<Input>{[](const Input& in) { return in.finish == Finish::hobbed || (is_set(in.R_z1) && is_set(in.R_z2)); },
                  "finish, R_z1, R_z2", "ground or shaved flanks need the roughness of both gears"},
      Rule<Input>{[](const Input& in) {
                    const bool rough = is_set(in.R_z1) && is_set(in.R_z2);
                    return in.standard == RatingStandard::din3990 || (is_set(in.nu_40) && rough);
                  },
                  "standard, nu_40, R_z1, R_z2",
                  "ISO 6336-2 needs the viscosity of the oil, nu_40, and the roughness of the flanks, R_z1 and R_z2"},
      Rule<Input>{[](const Input& in) {
                    return in.standard == RatingStandard::iso6336 || (!is_set(in.s_R1) && !is_set(in.s_R2));
                  },
                  "standard, s_R1, s_R2", "a rim is rated by ISO 6336-3: standard = \"iso6336\""},
      Rule<Input>{[](const Input& in) {
                    return in.standard == RatingStandard::iso6336 || in.root_edition == RootEdition::of_2006;
                  },
                  "standard, root_edition", "an edition of ISO 6336-3 needs standard = \"iso6336\""},
      Rule<Input>{[](const Input& in) { return in.standard == RatingStandard::iso6336 || !is_set(in.C_a); },
                  "standard, C_a", "tip relief is a quantity of ISO 6336-1: standard = \"iso6336\""},
      Rule<Input>{[](const Input& in) { return !(abs(in.n_1) <= 0.0 * rpm); }, "n_1",
                  "a running gear needs a speed greater than zero"}};
  static constexpr auto rules_of_capacity = join(rules_of_values, position_rules<Input>());
  static constexpr auto rules =
      join(rules_of_capacity, rules_of_teeth, deflection_rules<Input>(), spectrum_rules<Input>());

  /// Flanks that are ground and then finished by tumbling, from memory.
  static double least_roughness(const Input&) { return in_si(0.5 * um); }
  static constexpr std::array bounds{
      Bound<Input>{"f_ma", "the helix slope tolerance of the grade", &least_deviation}.least(),
      Bound<Input>{"f_sh_1", "the deflection of a pinion midway between its bearings by method C", &deflection_midway}
          .least()
          .sparing_results(),
      Bound<Input>{"R_z1", "the smoothest ground flanks", &least_roughness}.least(),
      Bound<Input>{"R_z2", "the smoothest ground flanks", &least_roughness}.least(),
      Bound<Input>{"nu_40", "the curves of ISO 6336-2", [](const Input&) { return in_si(500.0 * mm2_per_s); }},
      Bound<Input>{"pattern", "an unfavourable contact pattern", [](const Input&) { return 0.0; }},
      Bound<Input>{"sigma_Hlim_1", "the best quality of this material in ISO 6336-5",
                   [](const Input& in) { return strength_bounds(in.material_1, in.quality_1, in.H_1).sigma_H; }},
      Bound<Input>{"sigma_Hlim_2", "the best quality of this material in ISO 6336-5",
                   [](const Input& in) { return strength_bounds(in.material_2, in.quality_2, in.H_2).sigma_H; }},
      Bound<Input>{"sigma_Flim_1", "the best quality of this material in ISO 6336-5",
                   [](const Input& in) { return strength_bounds(in.material_1, in.quality_1, in.H_1).sigma_F; }},
      Bound<Input>{"sigma_Flim_2", "the best quality of this material in ISO 6336-5",
                   [](const Input& in) { return strength_bounds(in.material_2, in.quality_2, in.H_2).sigma_F; }}};

  static constexpr std::array meanings{Meaning{"z_1, T_1", flanks_ground, "finish", "ground"}};
  static constexpr std::array senses{SenseClaim{"T_1", "idler", "none, gear_1, gear_2", "both"}};
  static constexpr bool turns = true;
  static constexpr auto life = "L_h";
  static constexpr bool has_flanks = true;
  static constexpr std::array modes{
      Mode<Input>{"pitting_1", "pitting, gear 1", &always<Input>}.judged_by("u_H1, x_eps"),
      Mode<Input>{"pitting_2", "pitting, gear 2", &always<Input>}.judged_by("u_H2, x_eps"),
      Mode<Input>{"root_1", "tooth breakage, gear 1", &always<Input>}.judged_by("u_F1, x_eps"),
      Mode<Input>{"root_2", "tooth breakage, gear 2", &always<Input>}.judged_by("u_F2, x_eps"),
      Mode<Input>{"dynamic", "dynamic tooth load", &always<Input>}.judged_by("x_v, x_c"),
      Mode<Input>{"undercut", "undercut", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"interference", "tip and fillet interference",
                  [](const Input& in) { return where(!is_set(in.s_pr)); }}
          .judged_by("f_int")
          .of_shape(),
      Mode<Input>{"protuberance", "tip and fillet interference, roots of a protuberance tool",
                  [](const Input& in) { return where(is_set(in.s_pr)); }}
          .of_shape(),
      Mode<Input>{"clearance", "tip clearance", &always<Input>}.judged_by("c_n").of_shape(),
      Mode<Input>{"backlash", "backlash", &always<Input>}.judged_by("j_bn").of_shape(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unrated_peaks<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special(),
      Mode<Input>{"micropitting", "micropitting", &unseen<Input>}.special(),
      Mode<Input>{"case_crushing", "case crushing", &unseen<Input>}.special(),
      Mode<Input>{"wear", "wear of the tooth flanks", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::gear
