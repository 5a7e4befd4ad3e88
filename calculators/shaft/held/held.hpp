// A bar in torsion fixed at one end or both, rigidly or by a spring: statically indeterminate in general.
//
// Parts in series, cylinders and cones, solid or bored, each of its own material; sleeves or cores that rotate with
// them; torques at places and spread over a part. Decides the reactions, the moment and the rotation along the bar,
// the shear stress of every part and sleeve against its own strength, twist per length and rotation. Linear elastic,
// circular sections (Saint-Venant), slender cones: at 10 degrees the exact cone of [Foeppl] has 1 % less stress at
// its surface and turns by up to 5 % more. Sign: torques, reactions and rotations have one positive direction; the
// moment of a section is the sum of what acts to its right. Results include the service factor. Not covered: bending,
// fatigue, steps and notches, the joint between members side by side, yielding, warping.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/shaft/held/members.hpp"
#include "calculators/shaft/held/types.hpp"
#include "calculators/shaft/parts/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::shaft {

struct Held : HeldTypes {
  static constexpr auto id = "shaft.held";
  static constexpr auto title = "Bar in torsion with fixed or elastic ends";
  static constexpr auto scope =
      "Reactions, internal torques, rotations and shear stresses of a bar in torsion with one or both ends "
      "fixed or elastic, made of cylinders and cones in series with sleeves that rotate with them, under point "
      "and distributed torques; bending, fatigue, notches and the joint under a sleeve are not covered.";
  static constexpr auto source = "[B19], [Gere-3]";
  static constexpr auto headline = "torque {M_max}";
  static constexpr auto subject = "torsion";
  static constexpr auto synonyms =
      "statically indeterminate torsion, fixed-fixed bar, bar in torsion, torsion bar, composite shaft, "
      "tapered bar, sleeve, reaction torque, Drehstab, statisch unbestimmt, eingespannter Stab, Torsionsstab, "
      "статически неопределимое кручение, стержень, кручение, заделка";
  static constexpr auto example = R"([project]
title = "Torsion bar between two brackets"

[bar]
calculator = "shaft.held"
end_1 = "held"
end_2 = "elastic"
c_2 = "60 kN*m/rad"
segments = [
  { name = "root", l = "300 mm", d = "60 mm" },
  { name = "cone", l = "200 mm", d = "60 mm", d_2 = "40 mm" },
  { name = "tube", l = "400 mm", d = "40 mm", d_bore = "20 mm", m = "150 N*m/m" },
]
sleeves = [{ name = "bush", x = "100 mm", l = "150 mm", d = "75 mm", d_bore = "60 mm", G = "27 GPa", tau_adm = "30 MPa" }]
torques = [{ name = "lever", x = "500 mm", T = "900 N*m" }]
G = "80 GPa"
sigma_adm = "120 MPa"
behaviour = "ductile"
theta_adm = "2.5 deg/m"
phi_adm = "1 deg"
)";

  static constexpr auto inputs =
      join(Fields{ListField{&Input::segments, "segments", "segments of the bar, from the first end to the second"},
                  ListField{&Input::sleeves, "sleeves", "cylinders around or inside the bar that rotate with it"}
                      .may_be_missing(),
                  ListField{&Input::torques, "torques", "torques along the bar"}.may_be_missing(),
                  Choice{&Input::end_1, "end_1", "support of the first end: fixed, elastic or free"},
                  Choice{&Input::end_2, "end_2", "support of the second end: fixed, elastic or free"},
                  Field{&Input::c_1, "c_1", N_m_per_rad, "torsional stiffness of an elastic first end"}
                      .positive()
                      .may_be_missing(),
                  Field{&Input::c_2, "c_2", N_m_per_rad, "torsional stiffness of an elastic second end"}
                      .positive()
                      .may_be_missing(),
                  Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the loads include it)"}
                      .at_least(1)
                      .usually(1, 4)
                      .factor(),
                  Field{&Input::G, "G", GPa, "shear modulus of parts without their own"}
                      .positive()
                      .usually(least_G, most_G)
                      .from("material", "G")},
           shear_strength_inputs<Input>("d_s"),
           Fields{Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable angle of twist per unit length"}
                      .positive()
                      .usually(0.02, 10)
                      .customarily_at_most(15)
                      .may_be_missing(),
                  Field{&Input::phi_adm, "phi_adm", deg, "allowable rotation of any section from its unloaded position"}
                      .positive()
                      .usually(0.001, 90)
                      .customarily_at_most(45)
                      .may_be_missing()});

  static constexpr Fields results{
      Field{&Result::R_1, "R_1", N_m, "torque of the first support on the bar"}.load().holding("K_A"),
      Field{&Result::R_2, "R_2", N_m, "torque of the second support on the bar"}.load().holding("K_A"),
      Field{&Result::M_max, "M_max", N_m, "maximum torsional moment in the bar"}.holding("K_A"),
      Field{&Result::d_s, "d_s", mm, "diameter for the material strength: maximum of the bar"},
      Field{&Result::tau_max, "tau_max", MPa, "maximum shear stress"},
      Field{&Result::theta_max, "theta_max", deg_per_m, "maximum angle of twist per unit length"},
      Field{&Result::phi_1, "phi_1", deg, "rotation of the first end"},
      Field{&Result::phi_2, "phi_2", deg, "rotation of the second end"},
      Field{&Result::phi_max, "phi_max", deg, "maximum rotation"},
      Field{&Result::x_phi, "x_phi", mm, "location of the maximum rotation"},
      Field{&Result::s_max, "s_max", ratio, "steepest slope of a cone against the axis"}
          .limit(0, steepest_cone)
          .where_it_applies(),
      Field{&Result::u_tau, "u_tau", ratio, "strength: shear stress / allowable shear stress, maximum of all members"}
          .check(),
      Field{&Result::u_theta, "u_theta", ratio, "stiffness: maximum / allowable angle of twist per unit length"}.check(
          "theta_adm"),
      Field{&Result::u_phi, "u_phi", ratio, "stiffness: maximum / allowable rotation"}.check("phi_adm"),
      Field{&Result::K_ts, "K_ts", ratio, "lower bound of the stress concentration factor of the shoulders in torsion"}
          .where_it_applies(),
      Group{&Result::cycle, "cycle", "maximum shear stress of the bar, for fatigue.cycle: cycle"}.handed_over(),
      ListField{&Result::members, "members", "segments and sleeves at their maximum stress"},
      ListField{&Result::stretches, "stretches", "segments between neighbouring ends, torques and sleeves"},
      ListField{&Result::sections, "sections", "sections at the segment ends"}};

  static bool springs_fit(const Input& in);
  static bool one_strength(const Input& in);
  static bool strength_of_own(const Input& in);
  static bool has_moduli(const Input& in);
  static bool walls_stand(const Input& in);
  static bool on_bar(const Input& in);
  static FieldFault off_bar(const Input& in);
  static bool on_cylinders(const Input& in);
  static bool side_by_side(const Input& in);
  static Applies loaded(const Input& in);
  static Applies brittle(const Input& in);
  static Applies tough(const Input& in);
  static Applies thin(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.segments.empty(); }, "segments", "a bar needs at least one segment"},
      Rule<Input>{[](const Input& in) { return in.end_1 != End::free || in.end_2 != End::free; }, "end_1, end_2",
                  "at least one end must be fixed; for free ends use shaft.torsion"},
      Rule<Input>{&springs_fit, "end_1, end_2, c_1, c_2",
                  "c_1 and c_2 belong to elastic ends, and each elastic end needs one"},
      Rule<Input>{&one_strength, "tau_adm, sigma_adm, behaviour, S, R_e",
                  "give one of them: tau_adm; sigma_adm with behaviour; S with the yield strength R_e (or a material)"},
      Rule<Input>{&has_moduli, "G, segments, sleeves",
                  "every segment needs a shear modulus: its own G, or the common one"},
      Rule<Input>{&strength_of_own, "segments, sleeves",
                  "a segment with its own G is of another material: give its tau_adm too"},
      Rule<Input>{&walls_stand, "segments, sleeves", "a bore must be smaller than its segment, at both ends"},
      Rule<Input>{&on_bar, "torques, sleeves, segments", "torques and sleeves must lie on the bar", &off_bar},
      Rule<Input>{&on_cylinders, "sleeves, segments", "a sleeve needs a cylindrical segment, not a cone"},
      Rule<Input>{&side_by_side, "sleeves, segments",
                  "a sleeve must fit around the enclosed part, or inside of the bore: two members overlap"}};

  static constexpr std::array meanings{all_in_shear, all_in_normal,
                                       Meaning{"segments.tau_adm, sleeves.tau_adm", allowable_in_shear}};
  static constexpr std::array notch_claims{NotchClaim{"tau_max, cycle.sigma_max", "K_ts"}};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding in torsion", &tough}.judged_by("u_tau, s_max"),
      Mode<Input>{"fracture", "brittle fracture in torsion", &brittle}.judged_by("u_tau, s_max"),
      Mode<Input>{"twist", "angle of twist per unit length", &loaded}.judged_by("u_theta").of_service(),
      Mode<Input>{"rotation", "rotation of sections", &loaded}.judged_by("u_phi").of_service(),
      Mode<Input>{"ends", "strength of the end supports", &unseen<Input>},
      Mode<Input>{"joint", "shear and slip of sleeve joints",
                  [](const Input& in) { return where(!in.sleeves.empty() && loaded(in) == Applies::yes); }},
      Mode<Input>{"notch", "yielding at steps and notches", &unseen<Input>},
      fatigue_of_shaft<Input>().left_to("fatigue.cycle", "cycle.fatigue"),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"wall", "local buckling of thin walls", &thin},
      Mode<Input>{"critical_torsion", "torsional natural frequency", &unseen<Input>}.in_service()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::shaft
