// A hub pressed or shrunk on a shaft: slip by the smallest fit, yield of both rings by the largest.
//
// Decides the pressure of two rings by [Lame] from the usable interference, U less 0.8 of both roughnesses [DIN7190];
// the torque and the axial force that its friction holds, which act at the same place and add as vectors, from U_min;
// the equivalent stress by Tresca at the bore of the hub, and at the surface of a solid or the bore of a hollow shaft,
// from U_max. A hub that gets warmer than its shaft loses interference, dT_1 and dT_2; a cooler one gains it. At a
// speed n both grow as discs do, [Lame], the hub more. All states count: cold and warm, at rest and at speed.
// Interferences are of the diameter. Elastic rings of one length. Not covered: yielding fits, the edge of the hub,
// bending that opens it, stepped hubs, creep, the shear by the torque.
#pragma once

#include "calculators/load/connection.hpp"
#include "calculators/shaft/parts/torque.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace loadpath::shaft {

struct PressFit {
  static constexpr auto id = "shaft.press_fit";
  static constexpr auto title = "Interference fit (press or shrink fit)";
  static constexpr auto scope =
      "Joint pressure at minimum and maximum interference of an elastic interference fit, slip under torque "
      "and axial force, yielding of shaft and hub, press-in force, heating for assembly, and loss of "
      "interference at speed; fatigue at the hub edge is not covered.";
  static constexpr auto source = "[Lame], [DIN7190]";
  static constexpr auto headline = "d = {d}, l = {l}";
  static constexpr auto subject = "interference fit";
  static constexpr auto synonyms =
      "interference fit, press fit, shrink fit, force fit, interference, oversize, Lamé, DIN 7190, slip, "
      "pressing force, joining temperature, Pressverband, Presssitz, Querpressverband, Längspressverband, "
      "Schrumpfverbindung, Übermaß, Fugendruck, посадка с натягом, прессовое соединение, натяг, соединение с натягом";
  static constexpr auto example = R"([project]
title = "Gear shrunk on a hollow shaft"

[gear]
calculator = "shaft.press_fit"
T = "600 N*m"
K_A = 1.25
d = "60 mm"
d_i = "20 mm"
D = "110 mm"
l = "60 mm"
U_min = "41 um"
U_max = "90 um"
Rz_1 = "4 um"
Rz_2 = "6.3 um"
mu = 0.14
S_r = 1.5
material = "C45E"
R_e_1 = "370 MPa"
R_e_2 = "370 MPa"
S_F = 1.2
U_c = "60 um"
dT_adm = "250 K"
)";

  struct Input {
    Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
    Moment T = unset<Moment>;
    Force F_z = unset<Force>;
    double K_A = 1.0;
    Length d = unset<Length>, d_i = 0.0 * mm.one, D = unset<Length>, l = unset<Length>;
    Length U_min = unset<Length>, U_max = unset<Length>;
    Length Rz_1 = unset<Length>, Rz_2 = unset<Length>;
    double mu = unset<double>, S_r = unset<double>;
    AngularSpeed n = unset<AngularSpeed>;
    Density rho_1 = unset<Density>, rho_2 = unset<Density>;
    Stress E_1 = unset<Stress>, E_2 = unset<Stress>;
    double nu_1 = unset<double>, nu_2 = unset<double>;
    Stress R_e_1 = unset<Stress>, R_e_2 = unset<Stress>;
    double S_F = unset<double>;
    Expansion alpha_1 = unset<Expansion>, alpha_2 = unset<Expansion>;
    Heating dT_1 = unset<Heating>, dT_2 = unset<Heating>;
    double mu_e = unset<double>;
    Force F_adm = unset<Force>;
    Length U_c = unset<Length>;
    Heating dT_adm = unset<Heating>;
  };
  static Length lost_by_heat(const Input& in);
  /// Whether speed and both densities are given.
  static bool is_at_speed(const Input& in) { return is_set(in.n) && is_set(in.rho_1) && is_set(in.rho_2); }
  static Length least_usable(const Input& in);
  static bool expands_as_its_metal(Stress E, Density rho, Expansion alpha);
  /// Metals of unlike stiffness expand unlike.
  static bool are_of_two_metals(const Input& in) { return abs(in.E_1 - in.E_2) > 0.1 * max(in.E_1, in.E_2); }
  static FieldFault nothing_left(const Input& in);
  static Applies loaded(const Input& in);
  static constexpr auto inputs = join(
      hub_inputs<Input>(),
      Fields{
          RecordField<Input>{"load", "shaft load of the mounted gear, belt, chain or drive: load = \"=gears.gear_2\""},
          Field{&Input::T, "T", N_m, "torque; omitted: pressures and stresses only"}
              .load()
              .one_of_body("torque")
              .may_be_missing(),
          Field{&Input::F_z, "F_z", N, "simultaneous axial force"}.load().may_be_missing(),
          Field{&Input::K_A, "K_A", ratio, "application factor K_A on torque and axial force (1 if they include it)"}
              .at_least(1)
              .usually(1, 4)
              .factor(),
          Field{&Input::d, "d", mm, "joint diameter"}.positive().usually(3, 1000).at_most_that_of_source("d, d_max"),
          Field{&Input::d_i, "d_i", mm, "bore diameter of the shaft"}.at_least(0),
          Field{&Input::D, "D", mm, "outer diameter of the hub (gear: root diameter)"}.positive().usually(5, 3000),
          Field{&Input::l, "l", mm, "joint length"}.positive().usually(2, 2000).findable("R20"),
          Field{&Input::U_min, "U_min", um, "minimum diametral interference of the fit"}.positive().usually(1, 1000),
          Field{&Input::U_max, "U_max", um, "maximum diametral interference of the fit"}.positive().usually(1, 2000),
          Field{&Input::Rz_1, "Rz_1", um, "roughness Rz of the shaft, for the smoothing"}.at_least(0).usually(0.4, 40),
          Field{&Input::Rz_2, "Rz_2", um, "roughness Rz of the hub, for the smoothing"}.at_least(0).usually(0.4, 40),
          Field{&Input::mu, "mu", ratio,
                "coefficient of friction against slip: dry steel on steel 0.12 to 0.2, oiled less"}
              .within(0.001, 1)
              .usually(0.05, 0.2)
              .may_be_missing(),
          Field{&Input::S_r, "S_r", ratio, "required safety factor against slip"}
              .at_least(1)
              .usually(1.2, 3)
              .customarily_at_least(1.2)
              .may_be_missing()
              .factor(),
          Field{&Input::n, "n", rpm, "speed of shaft and hub; the sign has no effect"}.of_body().may_be_missing(),
          Field{&Input::rho_1, "rho_1", kg_per_m3, "density of the shaft, for n"}
              .positive()
              .usually(500, 20000)
              .from("material", "rho"),
          Field{&Input::rho_2, "rho_2", kg_per_m3, "density of the hub, for n"}
              .positive()
              .usually(500, 20000)
              .from("material", "rho"),
          Field{&Input::E_1, "E_1", GPa, "modulus of elasticity of the shaft"}
              .positive()
              .usually(least_E, most_E)
              .from("material", "E"),
          Field{&Input::E_2, "E_2", GPa, "modulus of elasticity of the hub"}
              .positive()
              .usually(least_E, most_E)
              .from("material", "E"),
          Field{&Input::nu_1, "nu_1", ratio, "Poisson's ratio of the shaft"}.at_least(0).below(0.5).from("material",
                                                                                                         "nu"),
          Field{&Input::nu_2, "nu_2", ratio, "Poisson's ratio of the hub"}.at_least(0).below(0.5).from("material",
                                                                                                       "nu"),
          Field{&Input::R_e_1, "R_e_1", MPa, "yield strength of the shaft"}
              .positive()
              .at_most_that_of_source("R_e")
              .usually(50, 2500)
              .customarily_at_most(most_yield_strength)
              .may_be_missing(),
          Field{&Input::R_e_2, "R_e_2", MPa, "yield strength of the hub; brittle hubs are not covered"}
              .positive()
              .usually(50, 2500)
              .customarily_at_most(most_yield_strength)
              .may_be_missing(),
          Field{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
              .at_least(1)
              .usually(1, 3)
              .may_be_missing()
              .factor(),
          Field{&Input::alpha_1, "alpha_1", per_kelvin, "coefficient of thermal expansion of the shaft"}
              .positive()
              .from("material", "alpha"),
          Field{&Input::alpha_2, "alpha_2", per_kelvin, "coefficient of thermal expansion of the hub"}.positive().from(
              "material", "alpha"),
          Field{&Input::dT_1, "dT_1", kelvin, "temperature rise of the shaft in service"}
              .usually(-200, 400)
              .may_be_missing(),
          Field{&Input::dT_2, "dT_2", kelvin, "temperature rise of the hub in service"}
              .usually(-200, 400)
              .may_be_missing(),
          Field{&Input::mu_e, "mu_e", ratio, "coefficient of friction at press-in"}
              .positive()
              .usually(0.03, 0.3)
              .may_be_missing(),
          Field{&Input::F_adm, "F_adm", kN, "available press-in force"}.positive().may_be_missing(),
          Field{&Input::U_c, "U_c", um, "required assembly clearance of the heated hub; 0: sliding without clearance"}
              .at_least(0)
              .usually(5, 1000)
              .may_be_missing(),
          Field{&Input::dT_adm, "dT_adm", kelvin, "allowable heating of the hub, by its strength"}
              .positive()
              .usually(50, 400)
              .may_be_missing()});

  struct Result {
    double Q_1 = unset<double>, Q_2 = unset<double>;
    Length U_w_min = unset<Length>, U_w_max = unset<Length>, U_T = unset<Length>, U_n = unset<Length>;
    Stress p_min = unset<Stress>, p_max = unset<Stress>, p_n = unset<Stress>;
    Force F_res = unset<Force>, F_slip = unset<Force>;
    Moment T_slip = unset<Moment>;
    Stress sigma_1 = unset<Stress>, sigma_2 = unset<Stress>, sigma_t2 = unset<Stress>;
    Force F_e = unset<Force>;
    Heating dT_A = unset<Heating>;
    double u_s = unset<double>, u_1 = unset<double>, u_2 = unset<double>, u_F = unset<double>, u_A = unset<double>;
    Stress tau_t = unset<Stress>;
    double u_t = unset<double>, x_l = unset<double>, u_n = unset<double>, m_R = unset<double>;
    Connection connection;
  };
  static Applies twisted(const Input& in);
  static constexpr Fields results{
      Field{&Result::Q_1, "Q_1", ratio, "diameter ratio of the shaft: bore / joint diameter"},
      Field{&Result::Q_2, "Q_2", ratio, "diameter ratio of the hub: joint / outer diameter"},
      Field{&Result::U_T, "U_T", um, "thermal loss of interference in service; negative: gain"},
      Field{&Result::U_n, "U_n", um, "interference lost at speed; negative: gained"},
      Field{&Result::U_w_min, "U_w_min", um, "minimum effective interference, cold or in service"},
      Field{&Result::U_w_max, "U_w_max", um, "maximum effective interference, cold or in service"},
      Field{&Result::p_min, "p_min", MPa, "minimum joint pressure"},
      Field{&Result::p_max, "p_max", MPa, "maximum joint pressure"},
      Field{&Result::p_n, "p_n", MPa, "maximum pressure at speed"},
      Field{&Result::F_res, "F_res", kN, "resultant of circumferential and axial force"}.holding("K_A"),
      Field{&Result::F_slip, "F_slip", kN, "slip force at minimum pressure, axial or circumferential"},
      Field{&Result::T_slip, "T_slip", N_m, "slip torque at minimum pressure, without axial force"},
      Field{&Result::sigma_t2, "sigma_t2", MPa, "hoop stress at the hub bore, maximum pressure"},
      Field{&Result::sigma_1, "sigma_1", MPa, "equivalent stress of the shaft, maximum pressure or speed"},
      Field{&Result::sigma_2, "sigma_2", MPa, "equivalent stress of the hub at its bore, likewise"},
      Field{&Result::F_e, "F_e", kN, "press-in force at full engagement, maximum pressure"},
      Field{&Result::dT_A, "dT_A", kelvin, "heating of the hub for assembly"},
      Field{&Result::u_s, "u_s", ratio, "slip: S_r x resultant force / friction capacity"}
          .check("S_r")
          .where_it_applies(),
      Field{&Result::u_1, "u_1", ratio, "shaft: S_F x equivalent stress / yield strength"}.check("S_F"),
      Field{&Result::u_2, "u_2", ratio, "hub: S_F x equivalent stress / yield strength"}.check("S_F"),
      Field{&Result::u_n, "u_n", ratio, "speed: interference lost / minimum usable interference at rest"}
          .check("n")
          .sizeless()
          .where_it_applies(),
      rim_of_gear<Result>(),
      Field{&Result::u_F, "u_F", ratio, "press-in force / available press force"}.check("F_adm"),
      Field{&Result::u_A, "u_A", ratio, "required / allowable heating of the hub"}.check("dT_adm"),
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress of the shaft next to the hub"}.holding("K_A"),
      Field{&Result::u_t, "u_t", ratio, "torsion of the shaft: S_F x equivalent stress / yield strength"}.check("S_F"),
      Field{&Result::x_l, "x_l", ratio, "joint length / diameter (range of uniform torque transfer)"}.limit(0,
                                                                                                            1.5 + 1e-9),
      Group{&Result::connection, "connection", connection_doc}.handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !is_set(in.d_f) || in.d < in.d_f; }, "d_f, d",
                  "the shaft diameter must not exceed the root diameter of the mounted component"},
      Rule<Input>{[](const Input& in) { return !(in.D > 1.000001 * in.d_f) || in.d >= in.d_f; }, "D, d_f",
                  "the outer diameter of the hub must not exceed the root diameter of the mounted component"},
      Rule<Input>{
          [](const Input& in) { return bore_fits(in.bore, in.d); }, "bore, d",
          "the bore of the mounted component must equal the diameter of the fit; for another component give its "
          "bore, with because.bore = \"...\""},
      Rule<Input>{[](const Input& in) { return in.d_i < in.d && in.d < in.D; }, "d_i, d, D",
                  "the diameter of the fit must be between the bore of the shaft and the outer diameter of the hub"},
      Rule<Input>{[](const Input& in) { return in.U_min <= in.U_max; }, "U_min, U_max", "U_min must not exceed U_max"},
      Rule<Input>{
          [](const Input& in) { return is_set(in.E_1) && is_set(in.E_2) && is_set(in.nu_1) && is_set(in.nu_2); },
          "E_1, E_2, nu_1, nu_2", "give E and nu of shaft and hub, or a material of both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S_F) || (is_set(in.R_e_1) && is_set(in.R_e_2)); },
                  "S_F, R_e_1, R_e_2", "the safety factor against yielding needs the yield strengths R_e_1 and R_e_2"},
      Rule<Input>{[](const Input& in) {
                    return (!is_set(in.dT_1) || is_set(in.alpha_1)) && (!is_set(in.dT_2) || is_set(in.alpha_2));
                  },
                  "dT_1, dT_2, alpha_1, alpha_2",
                  "a heating needs the thermal expansion alpha of its part, or a material"},
      Rule<Input>{[](const Input& in) {
                    return expands_as_its_metal(in.E_1, in.rho_1, in.alpha_1) &&
                           expands_as_its_metal(in.E_2, in.rho_2, in.alpha_2);
                  },
                  "alpha_1, alpha_2, E_1, E_2, rho_1, rho_2",
                  "the thermal expansion alpha is not that of a metal with this modulus and density"},
      Rule<Input>{[](const Input& in) { return !is_set(in.F_adm) || is_set(in.mu_e); }, "F_adm, mu_e",
                  "the press-in force needs the coefficient of friction mu_e"},
      Rule<Input>{[](const Input& in) { return is_set(in.dT_adm) ? is_set(in.U_c) && is_set(in.alpha_2) : true; },
                  "dT_adm, U_c, alpha_2",
                  "the heating of the hub needs the clearance U_c and its thermal expansion alpha_2"},
      Rule<Input>{[](const Input& in) { return !(least_usable(in) <= 0.0 * mm.one); }, "U_min, Rz_1, Rz_2, dT_1, dT_2",
                  "no usable interference at U_min; take a tighter fit or smoother surfaces", &nothing_left}};

  static constexpr std::array meanings{Meaning{"R_e_1, R_e_2", yield_strength}};
  /// An interference that shaft and hub of the finest customary tolerances cannot have: the spread of two tolerances
  /// of grade IT5, 7 i each, is 14 i; half of it is left to selective assembly. i by ISO 286-1, d in mm.
  static double most_certain_interference(const Input& in) {
    const double d = in.d.value() * 1e3, i = (0.45 * std::cbrt(d) + 0.001 * d) * 1e-6;
    return in.U_min < in.U_max ? in.U_max.value() - 7.0 * i : std::numeric_limits<double>::quiet_NaN();
  }
  /// Lapped surfaces have this roughness; without any, U_min is the effective interference.
  static double least_roughness(Length Rz) {
    return Rz > 0.0 * um.one ? in_si(0.4 * um.one) : std::numeric_limits<double>::quiet_NaN();
  }
  static double least_of_shaft(const Input& in) { return least_roughness(in.Rz_1); }
  static double least_of_hub(const Input& in) { return least_roughness(in.Rz_2); }
  static constexpr std::array bounds{
      Bound<Input>{"U_min", "tolerances of shaft and hub of grade IT5", &most_certain_interference},
      Bound<Input>{"Rz_1", "a lapped surface", &least_of_shaft}.least(),
      Bound<Input>{"Rz_2", "a lapped surface", &least_of_hub}.least()};
  static constexpr std::array modes{
      Mode<Input>{"slip", "slip of the interference fit", &loaded}.judged_by("u_s, x_l").wanting("T, mu, S_r"),
      Mode<Input>{"shaft", "yielding of the shaft", &always<Input>}.judged_by("u_1"),
      Mode<Input>{"core", "torsional yielding of the shaft", &twisted}.judged_by("u_t"),
      Mode<Input>{"hub", "yielding of the hub bore", &always<Input>}.judged_by("u_2"),
      Mode<Input>{"pressing", "press-in force", &always<Input>}.judged_by("u_F").of_service(),
      Mode<Input>{"shrinking", "hub heating for shrink fitting", &always<Input>}.judged_by("u_A").of_service(),
      Mode<Input>{"fatigue", "shaft fatigue and fretting, hub edge",
                  [](const Input& in) { return shown_by(in.K_A > 1.0); }}
          .in_service()
          .assessed_additionally_in("shaft.design"),
      Mode<Input>{"opening", "joint gaping under bending", &unseen<Input>}.by_companions(),
      Mode<Input>{"speed", "centrifugal loss of interference",
                  [](const Input& in) { return is_set(in.n) ? where(abs(in.n) > 0.0 * rpm) : Applies::unseen; }}
          .judged_by("u_n")
          .wanting("rho_1, rho_2")
          .special(),
      Mode<Input>{"wall", "gear rim over the fit", &has_root<Input>}.judged_by("m_R").wanting("d_f").of_shape(),
      overhang<Input>(),
      Mode<Input>{"warmth", "thermal loss of interference",
                  [](const Input& in) {
                    if (is_set(in.dT_1) || is_set(in.dT_2)) return Applies::no;
                    return are_of_two_metals(in) ? where(true) : Applies::unseen;
                  }}
          .wanting("dT_1, dT_2")
          .special(),
      Mode<Input>{"brittle", "brittle fracture of the hub", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::shaft
