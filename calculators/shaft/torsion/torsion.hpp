// Sizing and checking a round shaft, solid or bored, in torsion: strength, stiffness, twist.
//
// Decides the least diameter by tau <= tau_adm and by theta <= theta_adm, the stresses and the twist at the diameter
// that is chosen, and which condition governs. Linear elastic, circular sections, static torques (Saint-Venant).
// Sign: torques positive as given; the internal moment of a stretch is the sum of the torques to its left.
// Not covered: bending (see shaft.overhung), fatigue, notches, keyways, buckling of thin tubes.
#pragma once

#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/hub.hpp"
#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/shaft/parts/modes.hpp"
#include "calculators/shaft/parts/power.hpp"
#include "calculators/shaft/torsion/diagram.hpp"
#include "calculators/shaft/torsion/types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/sizing.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace loadpath::shaft {

struct Torsion : TorsionTypes {
  static constexpr auto id = "shaft.torsion";
  static constexpr auto title = "Shaft in torsion";
  static constexpr auto scope =
      "Minimum diameter of a solid or hollow circular shaft for strength and stiffness under static torsion, "
      "with the stresses and the angle of twist at the chosen diameter; bending, fatigue and notches are not "
      "covered.";
  static constexpr auto source = "[B19]";
  static constexpr auto headline = "d = {d}|torque {M_max}";
  static constexpr auto subject = "torsion";
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
  static bool radii_in_wall(const Input& in);
  static Applies loaded(const Input& in);
  static Length thinnest(const Input& in);
  static FieldFault two_safeties(const Input& in);
  static FieldFault no_strength(const Input& in);
  static FieldFault open_sum(const Input& in);
  static FieldFault torque_off_shaft(const Input& in);
  static FieldFault radius_outside(const Input& in);
  static constexpr auto inputs = join(
      Fields{
          RecordField<Input>{"load", "shaft load of the mounted gear, belt, chain or drive: load = \"=gears.gear_2\""},
          Field{&Input::T, "T", N_m, "torque over the full length, replaces torques"}
              .load()
              .one_of_body("torque")
              .may_be_missing()},
      power_inputs<Input>(),
      Fields{Field{&Input::l, "l", mm, "length of the shaft, for the angle of twist"}
                 .positive()
                 .one_of_body("length")
                 .may_be_missing(),
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
             diameter_at_heat_treatment(&Input::d_h),
             Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the loads include it)"}
                 .at_least(1)
                 .usually(1, 4)
                 .factor(),
             Field{&Input::G, "G", GPa, "shear modulus"}.positive().usually(least_G, most_G).from("material", "G")},
      shear_strength_inputs<Input>("d_s"),
      Fields{
          Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable angle of twist per unit length"}
              .positive()
              .usually(0.02, 10)
              .customarily_at_most(15)
              .may_be_missing(),
          Field{&Input::F, "F", N, "transverse force that acts with the torque and bends the shaft"}.load().coming_with(
              "T"),
          Choice{&Input::fixed, "fixed", "fixed end; its reaction balances the torques"}.may_be_missing(),
          ListField{&Input::torques, "torques", "torques along the shaft; sum zero unless an end is fixed"}
              .may_be_missing(),
          ListField{&Input::segments, "segments", "cylinders from left to right"}.may_be_missing(), root_size<Input>(),
          bore_size<Input>()});

  static constexpr Fields results{
      Field{&Result::tau_all, "tau_all", MPa, "allowable shear stress"},
      Field{&Result::M_max, "M_max", N_m, "maximum design moment"}.holding("K_A").one_of_body("torque"),
      Field{&Result::d_strength, "d_strength", mm, "minimum diameter for strength"},
      Field{&Result::d_stiffness, "d_stiffness", mm, "minimum diameter for stiffness"},
      Field{&Result::d_min, "d_min", mm, "minimum diameter for both"},
      Choice{&Result::governs, "governs", "governing condition"},
      Field{&Result::D_star, "D_star", mm, "diameter below which stiffness governs, solid or hollow"},
      Field{&Result::d, "d", mm, "outer diameter of segments without their own"},
      Field{&Result::d_bore, "d_bore", mm, "bore at d"}.one_of_body("bore"),
      Field{&Result::d_max, "d_max", mm, "maximum outer diameter of the shaft"},
      Field{&Result::d_s, "d_s", mm, "diameter for the material strength: heat treatment diameter, else the maximum"},
      Field{&Result::tau_max, "tau_max", MPa, "maximum shear stress"},
      Field{&Result::theta_max, "theta_max", deg_per_m, "maximum angle of twist per unit length"},
      Field{&Result::phi, "phi", deg, "angle of twist of the right end relative to the left, positive like M"},
      Field{&Result::phi_max, "phi_max", deg, "maximum angle of twist between any two sections"},
      Field{&Result::k_t, "k_t", N_m_per_rad, "torsional spring rate: torque at both ends / angle of twist"}
          .where_it_applies(),
      Field{&Result::u_tau, "u_tau", ratio, "strength: maximum / allowable shear stress"}.check(
          "tau_adm, sigma_adm, S"),
      Field{&Result::u_theta, "u_theta", ratio, "stiffness: maximum / allowable angle of twist per unit length"}.check(
          "theta_adm"),
      Field{&Result::F_bend, "F_bend", N, "bending: transverse force, not covered by pure torsion"}
          .limit(0, 1e-3, "F")
          .sizeless(),
      Field{&Result::K_ts, "K_ts", ratio, "lower bound of the stress concentration factor of the shoulders in torsion"}
          .where_it_applies(),
      Group{&Result::cycle, "cycle", "maximum shear stress of the shaft, for fatigue.cycle: cycle"}.handed_over(),
      ListField{&Result::segments, "segments", "shaft segments of constant torque and diameter, left to right"},
      ListField{&Result::sections, "sections", "sections at the segment ends"}};

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
                      "give tau_adm, or S with the yield strength R_e (or a material), or sigma_adm with behaviour",
                      &no_strength},
          Rule<Input>{[](const Input& in) {
                        return is_set(in.sigma_adm) == (in.behaviour != Behaviour::unsaid) &&
                               !(is_set(in.sigma_adm) && (is_set(in.tau_adm) || is_set(in.S)));
                      },
                      "sigma_adm, behaviour, tau_adm, S", "sigma_adm needs behaviour, and replaces tau_adm and S"},
          Rule<Input>{[](const Input& in) { return !is_set(in.tau_adm) || !(is_set(in.S) || is_set(in.R_e)); },
                      "tau_adm, R_e, S", "tau_adm includes the safety factor: give tau_adm, or R_e with S, not both",
                      &two_safeties},
          Rule<Input>{[](const Input& in) { return !is_set(in.theta_adm) || is_set(in.G); }, "theta_adm, G",
                      "theta_adm needs the shear modulus G (or a material)"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.chi) && is_set(in.d_bore)); }, "chi, d_bore",
                      "give the bore as chi or as d_bore, not both"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.d) && is_set(in.d_bore)) || in.d_bore < in.d; },
                      "d_bore, d", "the bore must be smaller than the outer diameter of the shaft"},
          Rule<Input>{[](const Input& in) { return in.fixed == Fixed::none || !in.torques.empty(); }, "fixed, torques",
                      "a fixed end needs torques; T acts through the full length"},
          Rule<Input>{[](const Input& in) { return in.segments.empty() || !is_set(in.l); }, "l, segments",
                      "the length is the sum of the segments: give l or segments"},
          Rule<Input>{&torques_close, "torques, fixed", "the torques must sum to zero, or one end must be fixed",
                      &open_sum},
          Rule<Input>{&torques_on_shaft, "torques, segments, l", "every torque must lie on the shaft",
                      &torque_off_shaft},
          Rule<Input>{&bores_fit, "segments, d",
                      "the bore of a segment must be smaller than its diameter; give it as chi or as "
                      "d_bore, not both"},
          Rule<Input>{&radii_in_wall, "segments, d", "the radius rho must lie between bore and surface",
                      &radius_outside},
          heat_treated_before_turning<Input>()});

  static constexpr std::array meanings{all_in_shear, all_in_normal};
  static constexpr std::array notch_claims{NotchClaim{"tau_max, cycle.sigma_max", "K_ts"}};
  static constexpr auto modes = with_modes_of_shafts(std::array{
      Mode<Input>{"yield", "yielding in torsion", &loaded}.judged_by("u_tau").asking(
          "give tau_adm, or S with the yield strength R_e (or a material)"),
      Mode<Input>{"twist", "angle of twist per unit length", &loaded}.judged_by("u_theta").of_service(),
      Mode<Input>{"bending", "bending due to transverse forces", [](const Input& in) { return shown_by(is_set(in.F)); }}
          .judged_by("F_bend")
          .assessed_in("shaft.design")
          .advising("replace with a step of shaft.design")
          .in_service(),
      within_root<Input, &thinnest>(), fatigue_of_shaft<Input>().left_to("fatigue.cycle", "cycle.fatigue")});

  static constexpr std::array forms{Form{"T, K_A, G, tau_adm, theta_adm",
                                         "d_strength, d_stiffness, d_min, D_star, tau_max, theta_max, u_tau, u_theta"},
                                    Form{"T, d, K_A, G, tau_adm, theta_adm",
                                         "d_strength, d_stiffness, d_min, D_star, tau_max, theta_max, u_tau, u_theta"}};

  static constexpr auto sized = "segments";
  static bool arrange(const Input& in, std::span<OpenSize> sought, std::size_t way);
  static bool raise(const Input& in, std::span<OpenSize> sought);
  static double cost(const Input& in);
  static const void* place(const Input& in, std::string_view list, const void* element);
  static Message unsound(const Input& in, std::span<const OpenSize> sought, std::size_t which);

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::shaft
