// A round shaft end that carries a transverse force on an overhang and a torque: bending and torsion together.
//
// Decides the minimum diameter at the bearing, where the bending moment F a and the torque T act at the same time, by
// von Mises or Tresca; checks the neutral axis, where transverse shear and torsion add, and torsion only where
// tau_adm is given. Static strength with allowable stresses (safety factor included). Not covered: fatigue of the
// rotating shaft, notches and keyways, deflection, the bearing side of the shaft.
#pragma once

#include "calculators/load/hub.hpp"
#include "calculators/shaft/parts/modes.hpp"
#include "calculators/shaft/parts/power.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>

namespace loadpath::shaft {

struct Overhung {
  static constexpr auto id = "shaft.overhung";
  static constexpr auto title = "Overhung shaft end in bending and torsion";
  static constexpr auto scope =
      "Minimum diameter of a circular shaft at the bearing next to an overhang, for simultaneous transverse "
      "force and torque, with the static stresses at the chosen diameter; fatigue, notches and deflection are "
      "not covered.";
  static constexpr auto source = "[B19], [Mises]";
  static constexpr auto headline = "d = {d}";
  static constexpr auto subject = "bending and torsion";
  static constexpr auto synonyms =
      "overhung shaft, cantilever shaft, shaft end, crankshaft end, bending and torsion, equivalent moment, "
      "von Mises, Tresca, fliegende Lagerung, Wellenende, Biegung und Torsion, Vergleichsmoment, overhang, Welle, "
      "консоль вала, изгиб с кручением, эквивалентный момент, вал";
  static constexpr auto example = R"([project]
title = "Crank on an overhang"

[crank]
calculator = "shaft.overhung"
F = "3654 N"
a = "50 mm"
T = "78.3 N*m"
K_A = 1.4
sigma_adm = "60 MPa"
tau_adm = "30 MPa"
)";

  enum class Hypothesis { mises, tresca };

  struct Input {
    Force F = unset<Force>;
    Length a = unset<Length>;
    Moment T = unset<Moment>;
    Power P = unset<Power>;
    AngularSpeed n = unset<AngularSpeed>;
    double K_A = 1.0;
    Length d = unset<Length>;
    double chi = unset<double>;
    Length d_bore = unset<Length>;
    Stress sigma_adm = unset<Stress>;
    Stress tau_adm = unset<Stress>;
    Hypothesis hypothesis = Hypothesis::mises;
    Length d_f = unset<Length>, b_r = unset<Length>;
  };
  static constexpr Length outside(const Input& in) { return in.d; }
  /// A component whose rim reaches over the bearing.
  static constexpr Applies reaches_bearing(const Input& in) { return where(in.a < 0.5 * in.b_r); }
  static constexpr Applies loaded(const Input& in) {
    return where(abs(in.F) > 0.0 * N.one || abs(in.T) > 0.0 * N_m.one || in.P > 0.0 * kW.one);
  }
  static constexpr auto inputs = join(
      Fields{
          RecordField<Input>{"load", "shaft load of the mounted gear, belt, chain or drive: load = \"=gears.gear_2\""},
          Field{&Input::F, "F", N, "transverse force on the overhang"}.load(),
          Field{&Input::a, "a", mm, "overhang: distance from the force to the bearing centre"}.at_least(0).usually(1,
                                                                                                                   1e4),
          Field{&Input::T, "T", N_m, "simultaneous torque"}.load().one_of_body("torque").may_be_missing()},
      power_inputs<Input>(),
      Fields{Field{&Input::K_A, "K_A", ratio, "application factor K_A on force and torque (1 if they include it)"}
                 .at_least(1)
                 .usually(1, 4)
                 .factor(),
             Field{&Input::d, "d", mm, "outer diameter"}.positive().usually(1, 2000).searched("R40").may_be_missing(),
             Field{&Input::chi, "chi", ratio, "bore ratio d_bore/d of the sizing"}
                 .at_least(0)
                 .one_of_body("bore")
                 .below(0.99)
                 .may_be_missing(),
             Field{&Input::d_bore, "d_bore", mm, "bore diameter"}
                 .at_least(0)
                 .one_of_body("bore")
                 .may_be_missing()
                 .kept_in_search(),
             Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable equivalent stress (safety factor included)"}
                 .positive()
                 .usually(1, 2000),
             Field{&Input::tau_adm, "tau_adm", MPa, "allowable shear stress in pure torsion"}
                 .positive()
                 .usually(1, 1000)
                 .may_be_missing(),
             Choice{&Input::hypothesis, "hypothesis", "failure theory of the equivalent stress"}.may_be_missing(),
             root_size<Input>(), rim_size<Input>()});

  struct Result {
    Moment M_b = unset<Moment>, M_t = unset<Moment>, M_v = unset<Moment>;
    Length d_v = unset<Length>, d_t = unset<Length>, d_min = unset<Length>;
    Length d = unset<Length>, d_bore = unset<Length>;
    Stress sigma_b = unset<Stress>, tau_t = unset<Stress>;
    Stress sigma_M = unset<Stress>, sigma_T = unset<Stress>, tau_Q = unset<Stress>;
    double u_v = unset<double>, u_Q = unset<double>, u_tau = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::M_b, "M_b", N_m, "bending moment at the bearing"}.holding("K_A"),
      Field{&Result::M_t, "M_t", N_m, "design torque"}.holding("K_A").one_of_body("torque"),
      Field{&Result::M_v, "M_v", N_m, "equivalent moment"}.holding("K_A"),
      Field{&Result::d_v, "d_v", mm, "minimum diameter by the equivalent stress"},
      Field{&Result::d_t, "d_t", mm, "minimum diameter by pure torsion"},
      Field{&Result::d_min, "d_min", mm,
            "minimum diameter by combined bending and torsion and by pure torsion; the neutral axis is "
            "checked at d"},
      Field{&Result::d, "d", mm, "outer diameter"},
      Field{&Result::d_bore, "d_bore", mm, "bore at d"}.one_of_body("bore"),
      Field{&Result::sigma_b, "sigma_b", MPa, "bending stress"},
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress"},
      Field{&Result::sigma_M, "sigma_M", MPa, "equivalent stress by von Mises, extreme fibre"},
      Field{&Result::sigma_T, "sigma_T", MPa, "equivalent stress by Tresca, extreme fibre"},
      Field{&Result::tau_Q, "tau_Q", MPa, "shear stress at the neutral axis, torsion and transverse shear"},
      Field{&Result::u_v, "u_v", ratio, "bending with torsion: equivalent / allowable stress"}.check(),
      Field{&Result::u_Q, "u_Q", ratio, "shear at the neutral axis: equivalent / allowable stress"}.check(),
      Field{&Result::u_tau, "u_tau", ratio, "pure torsion: shear stress / allowable shear stress"}.check("tau_adm")};

  static constexpr auto rules = join(
      std::array{
          Rule<Input>{[](const Input& in) { return is_set(in.T) || is_set(in.P); }, "T, P, n",
                      "give the torque T, or the power P with the speed n"},
          Rule<Input>{[](const Input& in) { return !(abs(in.F) > 0.0 * N.one) || !(in.a <= 0.0 * mm.one); }, "a, F",
                      "a transverse force on an overhang needs its distance a > 0 from the bearing centre"}},
      power_rules<Input>(),
      std::array{Rule<Input>{[](const Input& in) { return !(is_set(in.chi) && is_set(in.d_bore)); }, "chi, d_bore",
                             "give the bore as chi or as d_bore, not both"},
                 Rule<Input>{[](const Input& in) { return !(is_set(in.d) && is_set(in.d_bore)) || in.d_bore < in.d; },
                             "d_bore, d", "the bore must be smaller than the outer diameter of the shaft"}});

  static constexpr std::array meanings{Meaning{"sigma_b, M_b", reverses_in_turns}};
  static constexpr auto modes = with_modes_of_shafts(std::array{
      Mode<Input>{"yield", "yielding in bending and torsion", &loaded}.judged_by("u_v"),
      Mode<Input>{"shear", "shear yielding at the neutral axis", &loaded}.judged_by("u_Q"),
      Mode<Input>{"torsion", "yielding in pure torsion", [](const Input& in) { return where(is_set(in.tau_adm)); }}
          .judged_by("u_tau"),
      within_root<Input, &outside>(),
      Mode<Input>{"clearance", "component clear of the bearing", &reaches_bearing}.independent_of_loads().advising(
          "increase a to half of the rim width and more, or confirm a dished component: accept.clearance = \"...\""),
      fatigue_of_shaft<Input>().assessed_in("shaft.design")});

  // A search needs the least size first, then the checks at a size of the stock.
  static constexpr std::array forms{Form{"F, a, T, K_A, sigma_adm, tau_adm", "d, d_bore"},
                                    Form{"F, a, T, K_A, d, sigma_adm, tau_adm", "u_v, u_Q, u_tau"},
                                    Form{"F, a, T, K_A, d, sigma_adm, tau_adm", "d_v, u_v, u_Q, u_tau"},
                                    Form{"F, a, T, K_A, sigma_adm, tau_adm"},
                                    Form{"F, a, T, K_A, d, sigma_adm, tau_adm"},
                                    Form{"F, a, T, K_A, sigma_adm"},
                                    Form{"F, a, T, K_A, d, sigma_adm"}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Overhung::Hypothesis) {
  return std::array{
      ChoiceName<Overhung::Hypothesis>{Overhung::Hypothesis::mises, "mises", "von Mises, distortion-energy theory"},
      ChoiceName<Overhung::Hypothesis>{Overhung::Hypothesis::tresca, "tresca", "Tresca, maximum shear stress"}};
}

}  // namespace loadpath::shaft
