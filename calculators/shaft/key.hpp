// A parallel key: pressure on its sides in shaft and hub, shear, what fits the shaft and the hub.
//
// Decides by method C of [DIN6892]: a uniform pressure over the effective length and over the height in the shaft
// keyway, t_1, and in the hub keyway, h - t_1, each against the permissible pressure of its part, 0.9 R_e or typed;
// two keys carry 1.5 times one. Sizes are those of DIN 6885-1 by `key = "14x9"`, or typed. K_A acts once, on T and
// not on T_max, which is the full peak torque. Without friction of the fit, and without chamfers. Not covered:
// reversing torque, except by the factor f_W of method B that is typed; how uneven the pressure is along the key
// (method B); keys that are pressed in; three keys and more.
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
#include "lib/figure/figure.hpp"
#include "lib/quantity/units.hpp"

#include <array>
#include <vector>

namespace loadpath::shaft {

struct Key {
  static constexpr auto id = "shaft.key";
  static constexpr auto title = "Parallel key";
  static constexpr auto scope =
      "Bearing pressure of one or two parallel keys on shaft, hub and key, shear of the key, the fit of the "
      "key to shaft diameter, keyways and hub length, and the hub wall under the root circle of a gear, "
      "sprocket or pulley; shaft fatigue at the keyway end and fretting are not covered.";
  static constexpr auto source = "[DIN6892], [Mises]";
  static constexpr auto headline = "{b#}x{h#}x{l}";
  static constexpr auto subject = "key connection";
  static constexpr auto synonyms =
      "key, parallel key, feather key, keyway, keyseat, shaft-hub connection, bearing pressure, DIN 6892, DIN 6885, "
      "Passfeder, Passfedernut, Welle-Nabe-Verbindung, Flächenpressung, шпонка, призматическая шпонка, "
      "шпоночный паз, шпоночное соединение, смятие";
  static constexpr auto example = R"([project]
title = "Wheel on a shaft of 50 mm"

[seat]
calculator = "shaft.key"
T = "450 N*m"
torque = "one_way"
K_A = 1.25
d = "50 mm"
key = "14x9"
l = "70 mm"
l_n = "75 mm"
R_e_1 = "370 MPa"
S_F = 1.5
R_e_2 = "300 MPa"
R_e_k = "420 MPa"
)";

  enum class Form { A, B };

  struct Input {
    Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
    Moment T = unset<Moment>, T_max = unset<Moment>;
    Sense torque = Sense::unknown;
    double K_A = 1.0;
    Length d = unset<Length>, d_bore = 0.0 * mm;
    Length b = unset<Length>, h = unset<Length>, t_1 = unset<Length>, t_2 = unset<Length>;
    Length d_over = unset<Length>, d_to = unset<Length>, l_min = unset<Length>, l_max = unset<Length>;
    Form form = Form::A;
    Length l = unset<Length>, l_n = unset<Length>;
    Whole i = 1;
    Stress R_e_1 = unset<Stress>, R_e_2 = unset<Stress>, R_e_k = unset<Stress>;
    double S_F = unset<double>;
    Stress p_adm_1 = unset<Stress>, p_adm_2 = unset<Stress>, p_adm_k = unset<Stress>, tau_adm = unset<Stress>;
    double f_W = unset<double>;
  };
  static bool sizes_given(const Input& in);
  static FieldFault other_length(const Input& in);
  static Length core(const Input& in) { return in.d - (in.i > 1 ? 2.0 : 1.0) * in.t_1; }
  static Applies twisted(const Input& in);
  static constexpr Fields inputs = join(
      torque_inputs<Input>(), hub_inputs<Input>(),
      Fields{
          Field{&Input::d, "d", mm, "shaft diameter"}.positive().usually(6, 500).findable("R40").at_most_that_of_source(
              "d, d_max"),
          Field{&Input::d_bore, "d_bore", mm, "bore diameter of the shaft"}.at_least(0).one_of_body("bore"),
          Field{&Input::b, "b", mm, "key width"}.positive().from("key", "b"),
          Field{&Input::h, "h", mm, "key height"}.positive().from("key", "h"),
          Field{&Input::t_1, "t_1", mm, "keyway depth in the shaft"}.positive().from("key", "t_1"),
          Field{&Input::t_2, "t_2", mm, "keyway depth in the hub"}.positive().from("key", "t_2"),
          Field{&Input::d_over, "d_over", mm, "shaft diameter range of the key section: lower limit, exclusive"}
              .positive()
              .from("key", "d_over"),
          Field{&Input::d_to, "d_to", mm, "shaft diameter range of the key section: upper limit, inclusive"}
              .positive()
              .from("key", "d_to"),
          Field{&Input::l_min, "l_min", mm, "minimum standard key length of this section"}
              .positive()
              .from("key", "l_min")
              .where_it_has(),
          Field{&Input::l_max, "l_max", mm, "maximum standard key length of this section"}
              .positive()
              .from("key", "l_max")
              .where_it_has(),
          Choice{&Input::form, "form", "key form: round ends (A) or straight ends (B)"}.may_be_missing(),
          Field{&Input::l, "l", mm, "key length"}.positive().usually(6, 400).findable("key"),
          Field{&Input::l_n, "l_n", mm, "hub length"}.positive().usually(5, 1000).may_be_missing(),
          Count{&Input::i, "i", 1, 2, "number of keys"}.may_be_missing(),
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
          Field{&Input::R_e_k, "R_e_k", MPa, "yield strength of the key"}
              .positive()
              .usually(150, 2000)
              .customarily_at_most(1000)
              .may_be_missing(),
          Field{&Input::p_adm_1, "p_adm_1", MPa, "allowable bearing pressure in the shaft, replaces R_e_1"}
              .positive()
              .usually(20, 1500)
              .customarily_at_most(700)
              .may_be_missing(),
          Field{&Input::p_adm_2, "p_adm_2", MPa,
                "allowable bearing pressure in the hub, replaces R_e_2 (required for cast iron)"}
              .positive()
              .usually(20, 1500)
              .customarily_at_most(700)
              .may_be_missing(),
          Field{&Input::p_adm_k, "p_adm_k", MPa, "allowable bearing pressure on the key, replaces R_e_k"}
              .positive()
              .usually(20, 1500)
              .customarily_at_most(700)
              .may_be_missing(),
          Field{&Input::tau_adm, "tau_adm", MPa,
                "allowable shear stress of the key; by von Mises from its allowable pressure if omitted"}
              .positive()
              .usually(10, 1000)
              .customarily_at_most(400)
              .may_be_missing(),
          Field{&Input::f_W, "f_W", ratio,
                "load direction factor f_W of method B for a reversing torque, reduces the allowable pressure"}
              .within(0.1, 1)
              .may_be_missing()
              .factor()});

  struct Result {
    Moment T_eq = unset<Moment>;
    Force F_t = unset<Force>;
    Length l_tr = unset<Length>;
    double phi = unset<double>;
    Stress p_1 = unset<Stress>, p_2 = unset<Stress>, tau = unset<Stress>;
    double u_1 = unset<double>, u_2 = unset<double>, u_k = unset<double>, u_tau = unset<double>, u_W = unset<double>;
    double u_n = unset<double>, x_l = unset<double>, x_d = unset<double>, x_h = unset<double>, x_w = unset<double>;
    Stress tau_t = unset<Stress>;
    double u_t = unset<double>, x_b = unset<double>, x_t = unset<double>;
    double m_R = unset<double>, x_R = unset<double>;
    KeyNotch notch;
    Connection connection;
  };
  static constexpr Fields results{
      Field{&Result::T_eq, "T_eq", N_m, "equivalent torque: with the application factor, or the peak torque"}.holding(
          "K_A"),
      Field{&Result::F_t, "F_t", N, "circumferential force at the shaft surface"}.holding("K_A"),
      Field{&Result::l_tr, "l_tr", mm, "effective key length"},
      Field{&Result::phi, "phi", ratio, "load distribution factor phi"},
      Field{&Result::p_1, "p_1", MPa, "bearing pressure in the shaft keyway"},
      Field{&Result::p_2, "p_2", MPa, "bearing pressure in the hub keyway"},
      Field{&Result::tau, "tau", MPa, "shear stress of the key"},
      Field{&Result::u_1, "u_1", ratio, "shaft keyway: bearing pressure / allowable pressure"}.check("p_adm_1, R_e_1"),
      Field{&Result::u_2, "u_2", ratio, "hub keyway: bearing pressure / allowable pressure"}.check("p_adm_2, R_e_2"),
      Field{&Result::u_k, "u_k", ratio, "key: larger bearing pressure / allowable pressure"}.check("p_adm_k, R_e_k"),
      Field{&Result::u_tau, "u_tau", ratio, "shear of the key: shear stress / allowable shear stress"}.check(
          "tau_adm, p_adm_k, R_e_k"),
      Field{&Result::u_W, "u_W", ratio, "reversing torque: maximum utilisation of the key sides / f_W"}
          .check("f_W")
          .where_it_applies(),
      Field{&Result::u_n, "u_n", ratio, "key length / hub length"}.check("l_n"),
      Field{&Result::x_l, "x_l", ratio, "effective key length / shaft diameter (uniform pressure up to 1.3)"}.limit(
          0, 1.3 + 1e-9),
      Field{&Result::x_d, "x_d", ratio,
            "position of d in the range of shaft diameters of the key section: above 1 the shaft is too "
            "large, below 0 "
            "too small; key = \"?\" finds the section for d"}
          .limit(1e-9, 1 + 1e-9)
          .criterion()
          .where_it_applies(),
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress of the shaft core inside the keyways"}.holding("K_A"),
      Field{&Result::u_t, "u_t", ratio, "torsion of the shaft core: S_F x equivalent stress / yield strength"}.check(
          "S_F"),
      Field{&Result::x_b, "x_b", ratio, "width of a non-standard key / d (DIN 6885: up to 0.42)"}
          .limit(0, 0.42)
          .where_it_applies(),
      Field{&Result::x_t, "x_t", ratio, "keyway depth of a non-standard key / d (DIN 6885: up to 0.25)"}
          .limit(0, 0.25 * (1 + 1e-9))
          .where_it_applies(),
      Field{&Result::x_h, "x_h", ratio, "key height / sum of the keyway depths"}
          .limit(0, 1)
          .criterion()
          .where_it_applies(),
      Field{&Result::x_w, "x_w", ratio, "keyway depth / remaining wall of a hollow shaft (limit set by loadpath)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      rim_of_gear<Result>(),
      wall_of_hub<Result>("keyway depth / remaining wall of the hub under the root circle (limit set by loadpath)"),
      Group{&Result::notch, "notch", "keyway end, for a notch of shaft.design: part"}.handed_over(),
      Group{&Result::connection, "connection", connection_doc}.handed_over()};

  static constexpr auto rules = join(
      rules_of_sides<Input>(),
      std::array{
          Rule<Input>{[](const Input& in) {
                        return !is_set(in.d_f) || in.d + 2.0 * (is_set(in.t_2) ? in.t_2 : 0.0 * mm) < in.d_f;
                      },
                      "d_f, d, t_2", "the hub keyway must not cut the root circle of the mounted component"},
          Rule<Input>{[](const Input& in) { return bore_fits(in.bore, in.d); }, "bore, d",
                      "the bore of the mounted component must equal the shaft diameter; for another component give its "
                      "bore, with because.bore = \"...\""},
          Rule<Input>{&sizes_given, "b, h, t_1", "give a key: key = \"14x9\", or b, h and t_1"},
          Rule<Input>{[](const Input& in) { return !sizes_given(in) || in.t_1 < in.h; }, "t_1, h",
                      "keyway depth t_1 must be less than key height h"},
          Rule<Input>{[](const Input& in) { return !sizes_given(in) || 2.0 * in.t_1 < in.d - in.d_bore; },
                      "t_1, d, d_bore", "keyway depth t_1 must be less than d/2 or the wall of a hollow shaft"},
          Rule<Input>{
              [](const Input& in) { return !is_set(in.b) || !is_set(in.l) || in.form == Form::B || in.l > in.b; },
              "l, b, form", "key form A needs l > b"},
          Rule<Input>{[](const Input& in) { return is_set(in.d_over) == is_set(in.d_to) && !(in.d_to <= in.d_over); },
                      "d_over, d_to", "d_over and d_to must be given together, with d_to > d_over"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.p_adm_k) && is_set(in.R_e_k)); }, "p_adm_k, R_e_k",
                      "give p_adm_k or R_e_k, not both"},
          Rule<Input>{[](const Input& in) { return !(in.l < in.l_min) && !(in.l > in.l_max); }, "l, l_min, l_max",
                      "the standard has no key of this section and length", &other_length, true}});

  static constexpr std::array senses{SenseClaim{"T", "torque", "one_way", "reversing"}};
  static constexpr std::array modes{
      Mode<Input>{"shaft", "bearing pressure, shaft keyway", &torque_loads<Input>}.judged_by("u_1"),
      Mode<Input>{"hub", "bearing pressure, hub keyway", &torque_loads<Input>}.judged_by("u_2"),
      Mode<Input>{"key", "bearing pressure, key", &torque_loads<Input>}.judged_by("u_k"),
      Mode<Input>{"shear", "shear of the key", &torque_loads<Input>}.judged_by("u_tau"),
      Mode<Input>{"core", "torsional yielding of the shaft", &twisted}.judged_by("u_t").left_to("shaft.design",
                                                                                                "notch.yield"),
      Mode<Input>{"reversal", "bearing pressure under reversing torque", &torque_reverses<Input>}
          .judged_by("u_W")
          .in_service(),
      Mode<Input>{"length", "effective key length", &torque_loads<Input>}.judged_by("x_l").of_shape(),
      Mode<Input>{"hub_length", "key length within the hub", &always<Input>}.judged_by("u_n").of_shape(),
      Mode<Input>{"fit", "key size for the shaft diameter", &always<Input>}
          .judged_by("x_d, x_b, x_t")
          .advising("key = \"?\" finds the key of the table for d")
          .of_shape(),
      Mode<Input>{"depth", "key height within the keyways", &always<Input>}.judged_by("x_h").of_shape(),
      Mode<Input>{"bore", "shaft wall under the keyway", [](const Input& in) { return where(in.d_bore > 0.0 * mm); }}
          .judged_by("x_w")
          .of_shape(),
      Mode<Input>{"fatigue", "shaft fatigue at the keyway end", &torque_varies<Input>}
          .left_to("shaft.design", "notch.fatigue")
          .in_service(),
      Mode<Input>{"seat", "hub tilting and axial shift", &unseen<Input>}.by_companions(),
      Mode<Input>{"wall", "hub wall strength at the keyway", &has_root<Input>}
          .judged_by("m_R, x_R")
          .wanting("d_f")
          .of_shape(),
      overhang<Input>(),
      Mode<Input>{"fretting", "fretting of the key connection", &unseen<Input>}.special(),
      Mode<Input>{"balance", "unbalance of a single key", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Key::Form) {
  using Form = Key::Form;
  return std::array{ChoiceName<Form>{Form::A, "A", "round ends: effective length l - b"},
                    ChoiceName<Form>{Form::B, "B", "straight ends: effective length l"}};
}

}  // namespace loadpath::shaft
