// The eye under the tension of a pin: net section next to the bore, shear-out ahead of it, bearing pressure.
//
// Decides the three nominal stresses of textbooks, [Bhandari-4]: the force over both sides of the bore, over the two
// planes from the bore to the crown, and over the projected bore. Allowable values are typed, or R_e over a safety,
// in shear by [Mises]. These apply to eyes of the usual shape, whose crown is not thinner than their sides, as
// table 3.9 of [EN1993-1-8] draws them: others are not covered. Of a wider eye 2.5 bores of its width count. The force
// acts along the axis of the eye and counts as tension. An eye, or one cheek of a clevis: each is a step of its own.
// Not covered: forces across the axis, the notch of the bore in fatigue, bushes, welds.
#pragma once

#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::pin {

struct Lug {
  static constexpr auto id = "pin.lug";
  static constexpr auto title = "Lug (eye) of a pin joint";
  static constexpr auto scope =
      "Nominal net section, shear-out and bearing stresses of an eye or one clevis cheek loaded along its "
      "axis; eyes other than round heads, transverse forces and the stress concentration of the bore are not "
      "covered.";
  static constexpr auto source = "[Bhandari-4], [EN1993-1-8], [Mises]";
  static constexpr auto headline = "d = {d}, t = {t}";
  static constexpr auto subject = "lug at rest";
  static constexpr auto synonyms =
      "lug, eye, eye bar, clevis cheek, net section, shear-out, tear-out, bearing stress, Augenstab, Lasche, Auge, "
      "Gabel, проушина, ушко";
  static constexpr auto example = R"([project]
title = "Eye of a rod"

[eye]
calculator = "pin.lug"
F = "50 kN"
d = "40 mm"
b = "80 mm"
a = "20 mm"
t = "40 mm"
sigma_adm = "80 MPa"
tau_adm = "40 MPa"
p_adm = "80 MPa"
)";

  struct Input {
    Force F = unset<Force>;
    double K_A = 1.0;
    Length d = unset<Length>, b = unset<Length>, a = unset<Length>, t = unset<Length>;
    Stress sigma_adm = unset<Stress>, tau_adm = unset<Stress>, p_adm = unset<Stress>, R_e = unset<Stress>;
    double S = unset<double>;
  };
  static Applies loaded(const Input& in);
  static Applies varies(const Input& in);
  static constexpr Fields inputs{
      RecordField<Input>{"load", "eye or clevis cheek of a pin joint: load = \"=pin.eye\""},
      Field{&Input::F, "F", N, "force of the pin on the eye, along its axis, magnitude"}.load(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A on F (1 if F includes it)"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Field{&Input::d, "d", mm, "bore diameter"}.positive().usually(2, 500),
      Field{&Input::b, "b", mm, "width of the eye transverse to the force, bore included"}
          .positive()
          .usually(4, 2000)
          .findable("R40"),
      Field{&Input::a, "a", mm, "crown thickness: from the bore edge to the end of the eye, along the force"}
          .positive()
          .usually(1, 1000),
      Field{&Input::t, "t", mm, "thickness of the eye, or of one cheek"}
          .at_most_that_of_source("t_1, t_2")
          .positive()
          .usually(1, 1000)
          .findable("R40"),
      Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable stress of the net section, replaces R_e"}
          .positive()
          .usually(5, 1500)
          .customarily_at_most(700)
          .may_be_missing(),
      Field{&Input::tau_adm, "tau_adm", MPa, "allowable shear stress, replaces R_e"}
          .positive()
          .usually(5, 1000)
          .customarily_at_most(400)
          .may_be_missing(),
      Field{&Input::p_adm, "p_adm", MPa, "allowable bearing pressure in the bore"}
          .positive()
          .usually(1, 1500)
          .customarily_at_most(400)
          .may_be_missing(),
      Field{&Input::R_e, "R_e", MPa, "yield strength of the eye"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "t")
          .where_it_has(),
      Field{&Input::S, "S", ratio, "required safety factor on R_e"}
          .at_least(1)
          .usually(1.2, 10)
          .customarily_at_least(1.2)
          .may_be_missing()
          .factor()};

  struct Result {
    Force F_d = unset<Force>;
    Stress sigma_n = unset<Stress>, tau_s = unset<Stress>, p = unset<Stress>;
    double K_t = unset<double>;
    Length r_n = unset<Length>;
    double u_n = unset<double>, u_s = unset<double>, u_p = unset<double>, x_a = unset<double>;
    StressCycle cycle;
  };
  static constexpr Fields results{
      Field{&Result::F_d, "F_d", N, "design force: with the application factor"}.holding("K_A"),
      Field{&Result::sigma_n, "sigma_n", MPa, "nominal stress of the net section at the bore"}.holding("K_A"),
      Field{&Result::tau_s, "tau_s", MPa, "shear stress in the two shear-out planes"}.holding("K_A"),
      Field{&Result::p, "p", MPa, "bearing pressure in the bore"}.holding("K_A"),
      Field{&Result::K_t, "K_t", ratio,
            "stress concentration factor of the bore on the net section, at least that of an open hole"},
      Field{&Result::r_n, "r_n", mm, "notch radius of the bore"},
      Field{&Result::u_n, "u_n", ratio, "net section: nominal stress / allowable stress"}.check("sigma_adm, S"),
      Field{&Result::u_s, "u_s", ratio, "shear-out: shear stress / allowable stress"}.check("tau_adm, S"),
      Field{&Result::u_p, "u_p", ratio, "bearing: pressure / allowable pressure"}.check("p_adm"),
      Field{&Result::x_a, "x_a", ratio, "side width / crown thickness of the eye"}.limit(0, 1 + 1e-9),
      Group{&Result::cycle, "cycle", "nominal stress of the net section, for fatigue.cycle: cycle"}.handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !(in.b <= in.d); }, "b, d", "the lug must be wider than its bore"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.S) && is_set(in.sigma_adm) && is_set(in.tau_adm)); },
                  "S, sigma_adm, tau_adm", "allowable stresses include the safety factor: omit S"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S) || is_set(in.R_e); }, "S, R_e",
                  "the safety factor S needs the yield strength R_e, or a material"}};

  static constexpr std::array meanings{Meaning{"sigma_adm", allowable_in_normal},
                                       Meaning{"tau_adm", allowable_in_shear},
                                       Meaning{"K_t", fatigue::notch_in_tension}};
  static constexpr std::array notch_claims{NotchClaim{"sigma_n, cycle.sigma_max", "K_t"}};
  static constexpr std::array modes{
      Mode<Input>{"net", "net section tension", &loaded}.judged_by("u_n").wanting("sigma_adm"),
      Mode<Input>{"shear_out", "shear-out", &loaded}.judged_by("u_s").wanting("tau_adm"),
      Mode<Input>{"crown", "end distance of the lug", &loaded}.judged_by("x_a").of_shape(),
      Mode<Input>{"bearing", "bearing pressure in the bore", &loaded}.judged_by("u_p"),
      Mode<Input>{"fatigue", "fatigue at the bore edge", &varies}
          .left_to("fatigue.cycle", "cycle.fatigue")
          .in_service(),
      Mode<Input>{"across", "transverse loads on the lug", &unseen<Input>}.by_companions()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::pin
