// Sizing and checking a round shaft, solid or bored, in torsion: strength, stiffness, twist.
//
// Decides the least diameter by tau <= tau_adm and by theta <= theta_adm, the stresses and the twist at the diameter
// that is chosen, and which condition governs. Linear elastic, circular sections, static torques (Saint-Venant).
// Sign: torques positive as given; the internal moment of a stretch is the sum of the torques to its left.
// Not covered: bending (see shaft.overhung), fatigue, notches, keyways, buckling of thin tubes.
#pragma once

#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/shaft/parts/modes.hpp"
#include "calculators/shaft/parts/power.hpp"
#include "calculators/shaft/torsion/diagram.hpp"
#include "calculators/shaft/torsion/types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace loadpath::shaft {

struct Torsion : TorsionTypes {
  static constexpr auto id = "shaft.torsion";
  static constexpr auto title = "Shaft in torsion";
  static constexpr auto scope =
      "Least diameter of a round shaft, solid or bored, by strength and by stiffness; stresses and twist at the "
      "chosen diameter. Static torsion of circular sections. Bending, fatigue and notches are not covered.";
  static constexpr auto source = "[B19]";
  static constexpr auto synonyms =
      "shaft, torsion, torque, line shaft, angle of twist, twist, torsional stiffness, hollow shaft, "
      "shaft diameter, Welle, Verdrehung, Verdrehwinkel, Torsionsmoment, вал, кручение, угол закручивания, "
      "крутящий момент";
  static constexpr auto example = R"([project]
title = "Line shaft"

[line_shaft]
calculator = "shaft.torsion"
torques = [
  { x = "0 mm", T = "900 N*m" },
  { x = "300 mm", T = "-3600 N*m" },
  { x = "800 mm", T = "1500 N*m" },
  { x = "1000 mm", T = "1200 N*m" },
]
G = "80 GPa"
tau_adm = "30 MPa"
theta_adm = "0.004 rad/m"
)";

  static bool torques_close(const Input& in);
  static bool asks_twist(const Input& in);
  static bool torques_on_shaft(const Input& in);
  static bool bores_fit(const Input& in);
  static Applies loaded(const Input& in);
  static FieldFault two_safeties(const Input& in);
  static FieldFault open_sum(const Input& in);
  static FieldFault torque_off_shaft(const Input& in);
  static constexpr auto inputs = join(
      Fields{RecordField<Input>{"load", "what gear, belt, chain or drive sits on it, whole: load = \"=gears.gear_2\""},
             Field{&Input::T, "T", N_m, "torque through the whole shaft, in place of torques"}.load().may_be_missing()},
      power_inputs<Input>(),
      Fields{Field{&Input::l, "l", mm, "length of the shaft, for the angle of twist"}.positive().may_be_missing(),
             Field{&Input::d, "d", mm, "outer diameter"}.positive().usually(1, 2000).searched("R40").may_be_missing(),
             Field{&Input::chi, "chi", ratio, "bore ratio d_bore/d of the sizing"}
                 .at_least(0)
                 .below(0.99)
                 .may_be_missing(),
             Field{&Input::d_bore, "d_bore", mm, "diameter of the bore"}.at_least(0).may_be_missing().kept_in_search(),
             diameter_at_heat_treatment(&Input::d_h),
             Field{&Input::K_A, "K_A", ratio, "service factor: what the loads do not contain, once"}
                 .at_least(1)
                 .usually(1, 4)
                 .factor(),
             Field{&Input::G, "G", GPa, "shear modulus"}.positive().usually(1, 500).from("material", "G")},
      shear_strength_inputs<Input>("d_s"),
      Fields{
          Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable twist per length"}
              .positive()
              .usually(0.02, 10)
              .may_be_missing(),
          Field{&Input::F, "F", N, "transverse force that comes with the torque; bends the shaft"}.load().coming_with(
              "T"),
          Choice{&Input::fixed, "fixed", "end that is held; its reaction closes the sum of the torques"}
              .may_be_missing(),
          ListField{&Input::torques, "torques", "torques along the shaft; their sum is zero unless an end is fixed"}
              .may_be_missing(),
          ListField{&Input::segments, "segments", "cylinders from left to right"}.may_be_missing()});

  static constexpr Fields results{
      Field{&Result::tau_all, "tau_all", MPa, "allowable shear stress"},
      Field{&Result::M_max, "M_max", N_m, "largest design moment"}.holding("K_A"),
      Field{&Result::d_strength, "d_strength", mm, "least diameter by strength"},
      Field{&Result::d_stiffness, "d_stiffness", mm, "least diameter by stiffness"},
      Field{&Result::d_min, "d_min", mm, "least diameter by both"},
      Choice{&Result::governs, "governs", "condition that asks for the larger diameter"},
      Field{&Result::D_star, "D_star", mm, "diameter below which stiffness governs, solid or bored alike"},
      Field{&Result::d, "d", mm, "outer diameter where no segment has its own"},
      Field{&Result::d_bore, "d_bore", mm, "bore at that diameter"},
      Field{&Result::d_max, "d_max", mm, "largest outer diameter of the shaft"},
      Field{&Result::d_s, "d_s", mm, "diameter whose strength the material has: at heat treatment, else the largest"},
      Field{&Result::tau_max, "tau_max", MPa, "largest shear stress"},
      Field{&Result::theta_max, "theta_max", deg_per_m, "largest twist per length"},
      Field{&Result::phi, "phi", deg, "twist of the right end against the left, positive like M"},
      Field{&Result::phi_max, "phi_max", deg, "largest twist between any two sections"},
      Field{&Result::u_tau, "u_tau", ratio, "strength: largest shear stress over the allowable one"}.check(
          "tau_adm, sigma_adm, S"),
      Field{&Result::u_theta, "u_theta", ratio, "stiffness: largest twist per length over the allowable one"}.check(
          "theta_adm"),
      Field{&Result::F_bend, "F_bend", N, "bending: transverse force, which torsion alone does not cover"}
          .limit(0, 1e-3, "F")
          .sizeless(),
      Field{&Result::K_ts, "K_ts", ratio, "lower bound of the stress concentration factor of the shoulders in torsion"}
          .where_it_applies(),
      Group{&Result::cycle, "cycle", "largest stress of the shaft, for fatigue.cycle: cycle"}.handed_over(),
      ListField{&Result::segments, "segments", "stretches of constant moment and diameter, left to right"},
      ListField{&Result::sections, "sections", "sections between the stretches"}};

  static constexpr auto rules = join(
      std::array{Rule<Input>{[](const Input& in) { return (is_set(in.T) || is_set(in.P)) == in.torques.empty(); },
                             "T, P, torques", "give the torque T, or the power P with the speed n, or torques"}},
      power_rules<Input>(),
      std::array{
          Rule<Input>{[](const Input& in) {
                        return is_set(in.tau_adm) || is_set(in.sigma_adm) || (is_set(in.R_e) && is_set(in.S)) ||
                               ((is_set(in.theta_adm) || asks_twist(in)) && !is_set(in.S));
                      },
                      "tau_adm, sigma_adm, R_e, S, G",
                      "give tau_adm, or S with the yield strength R_e (or a material), or sigma_adm with behaviour; or "
                      "theta_adm alone, or the diameter and G for the twist, which leaves the strength open"},
          Rule<Input>{[](const Input& in) {
                        return is_set(in.sigma_adm) == (in.behaviour != Behaviour::unsaid) &&
                               !(is_set(in.sigma_adm) && (is_set(in.tau_adm) || is_set(in.S)));
                      },
                      "sigma_adm, behaviour, tau_adm, S",
                      "sigma_adm goes with behaviour, and stands in place of tau_adm and S"},
          Rule<Input>{[](const Input& in) { return !is_set(in.tau_adm) || !(is_set(in.S) || is_set(in.R_e)); },
                      "tau_adm, R_e, S", "tau_adm already holds the safety: give tau_adm, or R_e with S, never both",
                      &two_safeties},
          Rule<Input>{[](const Input& in) { return !is_set(in.theta_adm) || is_set(in.G); }, "theta_adm, G",
                      "theta_adm needs the shear modulus G (or a material)"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.chi) && is_set(in.d_bore)); }, "chi, d_bore",
                      "give the bore as chi or as d_bore, never both"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.d) && is_set(in.d_bore)) || in.d_bore < in.d; },
                      "d_bore, d", "the bore must be smaller than the shaft"},
          Rule<Input>{[](const Input& in) { return in.fixed == Fixed::none || !in.torques.empty(); }, "fixed, torques",
                      "a fixed end goes with torques; T alone runs through the whole shaft"},
          Rule<Input>{[](const Input& in) { return in.segments.empty() || !is_set(in.l); }, "l, segments",
                      "the length is the sum of the segments: give l or segments"},
          Rule<Input>{&torques_close, "torques, fixed", "the torques must sum to zero, or one end must be fixed",
                      &open_sum},
          Rule<Input>{&torques_on_shaft, "torques, segments, l", "every torque must lie on the shaft",
                      &torque_off_shaft},
          Rule<Input>{&bores_fit, "segments, d",
                      "the bore of a segment must be smaller than its diameter; give it as chi or as "
                      "d_bore, never both"},
          heat_treated_before_turning<Input>()});

  static constexpr std::array meanings{all_in_shear, all_in_normal};
  static constexpr std::array notch_claims{NotchClaim{"tau_max, cycle.sigma_max", "K_ts"}};
  static constexpr auto modes =
      with_modes_of_shafts(std::array{Mode<Input>{"yield", "yield in torsion", &loaded}.judged_by("u_tau").asking(
                                          "give tau_adm, or S with the yield strength R_e (or a material)"),
                                      Mode<Input>{"twist", "twist", &loaded}.judged_by("u_theta").of_service(),
                                      Mode<Input>{"bending", "bending by forces across the shaft: a shaft.overhung",
                                                  [](const Input& in) { return shown_by(is_set(in.F)); }}
                                          .judged_by("F_bend")
                                          .wanting("F")
                                          .in_service(),
                                      fatigue_of_shaft<Input>().left_to("fatigue.cycle", "cycle.fatigue")});

  static constexpr std::array forms{Form{"T, K_A, G, tau_adm, theta_adm",
                                         "d_strength, d_stiffness, d_min, D_star, tau_max, theta_max, u_tau, u_theta"},
                                    Form{"T, d, K_A, G, tau_adm, theta_adm",
                                         "d_strength, d_stiffness, d_min, D_star, tau_max, theta_max, u_tau, u_theta"}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::shaft
