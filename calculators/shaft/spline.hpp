// A splined shaft in its hub: pressure on the flanks, shear of the teeth, the shaft in torsion, wear where
// the hub slides.
//
// Decides by the mean pressure on the flanks, p = 2 T/(d_m z h_w l phi): phi is the load-carrying share, 0.75
// centred inside and 0.9 on the flanks, [WelleNabe], or typed (1/k_phi of DIN 5466); k_l what the pressure is more at
// one end. Each side against what it allows, 0.9 R_e or typed; a hub that slides under its torque against a pressure
// that is typed. Profiles of ISO 14 by `spline = "8x52x60"`; those of DIN 5480 by their diameters. K_A acts once, on T
// and not on T_max. Not covered: bending of the teeth, the burst of a thin hub, DIN 5466 but by its factors.
#pragma once

#include "calculators/load/connection.hpp"
#include "calculators/shaft/parts/pieces.hpp"
#include "calculators/shaft/parts/torque.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>
#include <cmath>

namespace loadpath::shaft {

struct Spline {
  static constexpr auto id = "shaft.spline";
  static constexpr auto title = "Spline connection";
  static constexpr auto scope =
      "Mean bearing pressure on the flanks of straight-sided or involute splines in shaft and hub, shear of "
      "the teeth, wear of a sliding hub, and the hub wall under a root circle; tooth bending and shaft fatigue "
      "at the spline end are not covered.";
  static constexpr auto source = "[Bhandari-9], [WelleNabe], [DIN6892], [Mises]";
  static constexpr auto headline = "{z}x{d_1#}x{d_2}";
  static constexpr auto subject = "spline connection";
  static constexpr auto synonyms =
      "spline, splined shaft, involute spline, straight-sided spline, ISO 14, DIN 5480, shaft-hub connection, "
      "Keilwelle, Zahnwelle, Keilwellenverbindung, Flankenpressung, шлицы, шлицевое соединение, эвольвентные шлицы";
  static constexpr auto example = R"([project]
title = "Gear of a lathe on its splined shaft"

[seat]
calculator = "shaft.spline"
T = "640 N*m"
torque = "one_way"
K_A = 1.25
spline = "8x52x60"
l = "50 mm"
hub = "fixed"
centring = "inner"
R_e_1 = "370 MPa"
S_F = 1.5
R_e_2 = "300 MPa"
)";

  enum class Hub { unknown, fixed, slides };
  enum class Centring { inner, flanks };

  struct Input {
    Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
    Moment T = unset<Moment>, T_max = unset<Moment>;
    Sense torque = Sense::unknown;
    double K_A = 1.0;
    double z = unset<double>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, b = unset<Length>, g = 0.0 * mm, d_bore = 0.0 * mm;
    Length l = unset<Length>;
    Hub hub = Hub::unknown;
    Centring centring = Centring::inner;
    double phi = unset<double>, k_l = unset<double>;
    Stress R_e_1 = unset<Stress>, R_e_2 = unset<Stress>;
    double S_F = unset<double>;
    Stress p_adm_1 = unset<Stress>, p_adm_2 = unset<Stress>, p_adm_w = unset<Stress>, tau_adm = unset<Stress>;
    double f_W = unset<double>, beta_b = unset<double>, beta_t = unset<double>;
  };
  static Applies slides(const Input& in);
  static Applies bears_evenly(const Input& in);
  static Applies low_factors(const Input& in);
  static constexpr Fields inputs = join(
      torque_inputs<Input>(), hub_inputs<Input>(),
      Fields{Field{&Input::z, "z", ratio, "number of spline teeth"}.within(3, 500).from("spline", "z"),
             Field{&Input::d_1, "d_1", mm,
                   "inner diameter of the contact flanks (involute spline: tip diameter of the hub)"}
                 .at_most_that_of_source("d, d_max")
                 .positive()
                 .usually(5, 500)
                 .from("spline", "d_1"),
             Field{&Input::d_2, "d_2", mm,
                   "outer diameter of the contact flanks (involute spline: tip diameter of the shaft)"}
                 .positive()
                 .usually(6, 500)
                 .from("spline", "d_2"),
             Field{&Input::b, "b", mm, "tooth thickness, for shear"}.positive().from("spline", "b").where_it_has(),
             Field{&Input::g, "g", mm, "flank chamfer, deducted at tip and root"}.at_least(0).usually(0, 2),
             Field{&Input::d_bore, "d_bore", mm, "bore diameter of the shaft"}.at_least(0).one_of_body("bore"),
             Field{&Input::l, "l", mm, "effective spline length"}.positive().usually(5, 1000),
             Choice{&Input::hub, "hub", "hub type: fixed or sliding"}.may_be_missing(),
             Choice{&Input::centring, "centring", "centring of the hub, for the share of load-carrying flanks"},
             Field{&Input::phi, "phi", ratio, "share of load-carrying flanks, replaces that of the centring"}
                 .within(0.1, 1)
                 .customarily_at_most(0.9)
                 .may_be_missing()
                 .factor(),
             Field{&Input::k_l, "k_l", ratio,
                   "length load factor k_l: maximum / mean pressure along the length; omitted: uniform, up to "
                   "1.3 d_m"}
                 .within(1, 5)
                 .may_be_missing()
                 .factor(),
             Field{&Input::R_e_1, "R_e_1", MPa, "yield strength of the shaft"}
                 .positive()
                 .at_most_that_of_source("R_e")
                 .usually(150, 2000)
                 .customarily_at_most(most_yield_strength)
                 .may_be_missing(),
             shaft_safety<Input>(),
             Field{&Input::R_e_2, "R_e_2", MPa, "yield strength of the hub, at its thickness; none for a brittle hub"}
                 .positive()
                 .usually(100, 2000)
                 .customarily_at_most(most_yield_strength)
                 .may_be_missing(),
             Field{&Input::p_adm_1, "p_adm_1", MPa, "allowable bearing pressure on the shaft, replaces R_e_1"}
                 .positive()
                 .usually(2, 1500)
                 .customarily_at_most(700)
                 .may_be_missing(),
             Field{&Input::p_adm_2, "p_adm_2", MPa,
                   "allowable bearing pressure on the hub, replaces R_e_2 (required for cast iron)"}
                 .positive()
                 .usually(2, 1500)
                 .customarily_at_most(700)
                 .may_be_missing(),
             Field{&Input::p_adm_w, "p_adm_w", MPa,
                   "allowable bearing pressure of a sliding hub (a few MPa if it slides under torque)"}
                 .positive()
                 .usually(1, 40)
                 .may_be_missing(),
             Field{&Input::tau_adm, "tau_adm", MPa,
                   "allowable shear stress of a tooth; by von Mises from its allowable pressure if omitted"}
                 .positive()
                 .usually(10, 1000)
                 .customarily_at_most(400)
                 .may_be_missing(),
             Field{&Input::f_W, "f_W", ratio,
                   "load direction factor f_W for a reversing torque, reduces the allowable pressure"}
                 .within(0.1, 1)
                 .may_be_missing()
                 .factor(),
             Field{&Input::beta_b, "beta_b", ratio,
                   "fatigue notch factor of the shaft at the spline end in bending, from tests"}
                 .within(1, 10)
                 .may_be_missing(),
             Field{&Input::beta_t, "beta_t", ratio,
                   "fatigue notch factor of the shaft at the spline end in torsion, from tests"}
                 .within(1, 10)
                 .may_be_missing()});

  struct Result {
    Moment T_eq = unset<Moment>;
    Length d_m = unset<Length>, h_w = unset<Length>;
    double share = unset<double>;
    Force F_t = unset<Force>;
    Stress p = unset<Stress>, tau = unset<Stress>, tau_t = unset<Stress>;
    double u_1 = unset<double>, u_2 = unset<double>, u_w = unset<double>, u_tau = unset<double>, u_W = unset<double>;
    double u_t = unset<double>, x_l = unset<double>, x_s = unset<double>, m_R = unset<double>, x_R = unset<double>;
    SplineNotch notch;
    Connection connection;
  };
  static constexpr Fields results{
      Field{&Result::T_eq, "T_eq", N_m, "equivalent torque: with the application factor, or the peak torque"}.holding(
          "K_A"),
      Field{&Result::d_m, "d_m", mm, "mean diameter of the flanks"},
      Field{&Result::h_w, "h_w", mm, "contact height of a flank"},
      Field{&Result::share, "share", ratio, "share of load-carrying flanks"},
      Field{&Result::F_t, "F_t", N, "circumferential force at the mean diameter"}.holding("K_A"),
      Field{&Result::p, "p", MPa, "maximum bearing pressure on the flanks"},
      Field{&Result::tau, "tau", MPa, "shear stress of the teeth"},
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress of the shaft core"}.holding("K_A"),
      Field{&Result::u_1, "u_1", ratio, "shaft: bearing pressure / allowable pressure"}.check("p_adm_1, R_e_1"),
      Field{&Result::u_2, "u_2", ratio, "hub: bearing pressure / allowable pressure"}.check("p_adm_2, R_e_2"),
      Field{&Result::u_w, "u_w", ratio, "sliding hub: bearing pressure / allowable pressure"}.check("p_adm_w"),
      Field{&Result::u_tau, "u_tau", ratio, "shear of the teeth: shear stress / allowable shear stress"}
          .check("tau_adm, p_adm_1, R_e_1")
          .where_it_applies(),
      Field{&Result::u_W, "u_W", ratio, "reversing torque: larger utilisation of the flanks / f_W"}
          .check("f_W")
          .where_it_applies(),
      Field{&Result::u_t, "u_t", ratio, "torsion of the shaft core: S_F x equivalent stress / yield strength"}.check(
          "S_F"),
      Field{&Result::x_l, "x_l", ratio, "effective length / d_m (uniform pressure up to 1.3)"}
          .limit(0, 1.3 + 1e-9)
          .where_it_applies(),
      Field{&Result::x_s, "x_s", ratio, "d_2/d_1 (ISO 14 and DIN 5480: up to 1.5; limit set by loadpath)"}.limit(0,
                                                                                                                 1.5),
      rim_of_gear<Result>(),
      wall_of_hub<Result>("tooth depth / wall of the hub under the root circle (limit set by loadpath)"),
      Group{&Result::notch, "notch", "spline end, for a notch of shaft.design: part"}.handed_over(),
      Group{&Result::connection, "connection", connection_doc}.handed_over()};

  static constexpr auto rules = join(
      rules_of_sides<Input>(),
      std::array{
          Rule<Input>{[](const Input& in) { return !is_set(in.d_f) || in.d_2 < in.d_f; }, "d_f, d_2",
                      "the shaft diameter must not exceed the root diameter of the mounted component"},
          Rule<Input>{[](const Input& in) {
                        return !is_set(in.bore) || bore_fits(in.bore, in.d_1) || bore_fits(in.bore, in.d_2);
                      },
                      "bore, d_1, d_2",
                      "the bore of the mounted component must equal d_1 or d_2; for another component give its "
                      "bore, with because.bore = \"...\""},
          Rule<Input>{[](const Input& in) { return !is_set(in.z) || in.z == std::floor(in.z); }, "z",
                      "the number of teeth of a spline must be an integer"},
          Rule<Input>{[](const Input& in) { return !(in.d_2 <= in.d_1); }, "d_1, d_2", "d_2 must be larger than d_1"},
          Rule<Input>{[](const Input& in) { return !(in.d_2 - in.d_1 <= 4.0 * in.g); }, "g, d_1, d_2",
                      "the chamfers must be smaller than the flank height"},
          Rule<Input>{[](const Input& in) { return !is_set(in.b) || !(in.z * in.b >= pi * in.d_2); }, "b, z, d_2",
                      "tooth thickness b leaves no hub teeth at this z and d_2; reduce b or z"},
          Rule<Input>{[](const Input& in) { return !(in.d_bore >= in.d_1); }, "d_bore, d_1",
                      "the bore must be smaller than the shaft core"},
          Rule<Input>{[](const Input& in) { return !is_set(in.p_adm_w) || in.hub == Hub::slides; }, "p_adm_w, hub",
                      "p_adm_w requires a sliding hub: hub = \"slides\""},
          Rule<Input>{[](const Input& in) { return is_set(in.beta_b) == is_set(in.beta_t); }, "beta_b, beta_t",
                      "give both beta_b and beta_t, or neither"}});

  static constexpr std::array senses{SenseClaim{"T", "torque", "one_way", "reversing"}};
  static constexpr std::array modes{
      Mode<Input>{"shaft", "bearing pressure, shaft spline", &torque_loads<Input>}.judged_by("u_1"),
      Mode<Input>{"hub", "bearing pressure, hub spline", &torque_loads<Input>}.judged_by("u_2"),
      Mode<Input>{"teeth", "shear of the spline teeth", &torque_loads<Input>}.judged_by("u_tau").wanting("b"),
      Mode<Input>{"core", "torsional yielding of the shaft core", &torque_loads<Input>}.judged_by("u_t").left_to(
          "shaft.design", "notch.yield"),
      Mode<Input>{"reversal", "bearing pressure under reversing torque", &torque_reverses<Input>}
          .judged_by("u_W")
          .in_service(),
      Mode<Input>{"wear", "flank wear of a sliding hub", &slides}.judged_by("u_w"),
      Mode<Input>{"form", "spline tooth depth", &torque_loads<Input>}.judged_by("x_s").of_shape(),
      Mode<Input>{"length", "effective spline length", &bears_evenly}.judged_by("x_l").of_shape(),
      Mode<Input>{"fatigue", "shaft fatigue at the spline end", &torque_varies<Input>}
          .left_to("shaft.design", "notch.fatigue")
          .in_service(),
      Mode<Input>{"seat", "hub tilting", &unseen<Input>}.by_companions(),
      Mode<Input>{"wall", "hub wall under the root circle", &has_root<Input>}
          .judged_by("m_R, x_R")
          .wanting("d_f")
          .of_shape(),
      overhang<Input>(),
      Mode<Input>{"notch_factors", "notch factors of the splines, shaft fatigue", &low_factors}.advising(
          "give beta_b and beta_t of DIN 743, or their source: accept.notch_factors = \"...\""),
      Mode<Input>{"burst", "hub bursting due to radial flank forces", &unseen<Input>},
      Mode<Input>{"fretting", "fretting of the spline flanks", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Spline::Hub) {
  using Hub = Spline::Hub;
  return std::array{ChoiceName<Hub>{Hub::unknown, "unknown", "unknown"}, ChoiceName<Hub>{Hub::fixed, "fixed", "fixed"},
                    ChoiceName<Hub>{Hub::slides, "slides", "sliding"}};
}
constexpr auto choices_of(Spline::Centring) {
  using Centring = Spline::Centring;
  return std::array{ChoiceName<Centring>{Centring::inner, "inner", "inner centring: 0.75 of the flanks carry load"},
                    ChoiceName<Centring>{Centring::flanks, "flanks", "flank centring: 0.9 of the flanks carry load"}};
}

}  // namespace loadpath::shaft
