// Geometry, forces and first strength of a pair of cylindrical gears: two wheels, wheel and ring, wheel and rack.
//
// Decides the centre distance or the profile shift, all diameters, contact ratios, tooth thickness and base-tangent
// length, the tooth forces in space, and Lewis' bending stress; undercut, pointed tips, interference and lost contact
// are limits. ISO 21771 with all tooth counts positive: g = 1 for a wheel, -1 for a ring. A positive profile shift
// thickens the tooth, that of a ring too (KHK: opposite sign for a ring). Axes of the forces: x from axis 1 to the
// pitch point, z along the axes towards the viewer, y to make a right hand; gear_1 and gear_2 have them in the frame
// of each shaft instead (ShaftLoad). Lewis: static, load at the tip of one tooth, no stress concentration unless K_f
// is given: a first estimate that under-reports the fatigue stress at the fillet by 50 to 100 %. Not covered:
// pitting, the rating of ISO 6336, teeth of rings and racks in bending, radial assembly of a gear into its ring
// (trimming), the fillet that a shaper leaves.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "calculators/gear/pair_input.hpp"
#include "calculators/gear/pair_result.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::gear {

struct Pair {
  static constexpr auto id = "gear.pair";
  static constexpr auto title = "Cylindrical gear pair";
  static constexpr auto scope =
      "Geometry, contact ratio, tooth thickness, base tangent length and tooth forces of spur and helical "
      "gears with profile shift, external, internal or with a rack, and static bending stress by Lewis as a "
      "first estimate; pitting and tooth breakage are rated in gear.rating.";
  static constexpr auto source = "[ISO21771], [Lewis]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m_n}";
  static constexpr bool is_inlined = true;
  static constexpr auto details =
      "b = {b}, beta = {beta!}, x_1 = {x_1}, x_2 = {x_2}|b = {b}, x_1 = {x_1}, x_2 = {x_2}|x_1 = {x_1}, x_2 = {x_2}";
  static constexpr auto synonyms =
      "gear, spur gear, helical gear, internal gear, rack and pinion, pinion, profile shift, addendum modification, "
      "contact ratio, base tangent length, Lewis, tooth force, ISO 21771, Stirnrad, Stirnradpaar, Zahnrad, "
      "Profilverschiebung, Verzahnung, cylindrical gear, centre distance, tooth root stress, Zahnfußspannung, "
      "Achsabstand, зубчатая передача, цилиндрическая передача, зубчатое колесо, шестерня, модуль";
  static constexpr auto example = R"([project]
title = "First stage of a reducer"

[stage]
calculator = "gear.pair"
z_1 = 20
z_2 = 57
m_n = "2.5 mm"
beta = "12 deg"
hand = "right"
a_w = "100 mm"
x_1 = 0.3
b = "28 mm"
T_1 = "60 N*m"
n_1 = "1450 rpm"
K_A = 1.25
cutting = "hobbed"
sigma_adm_1 = "220 MPa"
sigma_adm_2 = "200 MPa"
)";

  using Result = PairResult;

  using Input = PairInput;
  static FieldFault bases_apart(const Input& in);
  static FieldFault no_working_angle(const Input& in);
  static bool bases_meet(const Input& in);
  static bool working_angle_exists(const Input& in);
  static bool carries(const Input& in) { return is_set(in.T_1) || is_set(in.P); }
  static constexpr double widest = 30.0;  // usual face width in normal modules
  static bool is_wide(const Input& in) {
    return is_set(in.b) ? in.b > widest * in.m_n : is_set(in.psi_m) && in.psi_m > widest;
  }
  static constexpr Fields inputs{
      RecordField<Input>{"pair", "mesh of a planetary set: pair = \"=set.sun_mesh\""},
      Choice{&Input::mesh, "mesh", "type of mesh: external gear, ring gear or rack"}.may_be_missing(),
      Count{&Input::z_1, "z_1", 5, 2000, "number of teeth, gear 1"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 5, 2000, "number of teeth, gear 2; none for a rack"}
          .may_be_missing()
          .same_as_that_of_source("stages[#].z_2"),
      Field{&Input::m_n, "m_n", mm, "normal module"}
          .positive()
          .usually(0.2, 50)
          .searched("module")
          .may_be_missing()
          .same_as_that_of_source("stages[#].m_n"),
      Field{&Input::alpha_n, "alpha_n", deg, "normal pressure angle"}.within(10, 35).usually(14.5, 25),
      Field{&Input::beta, "beta", deg, "helix angle at the reference diameter"}.within(0, 45).usually(0, 35),
      Choice{&Input::hand, "hand", "hand of helix, gear 1"}.may_be_missing(),
      Field{&Input::x_1, "x_1", ratio, "profile shift coefficient, gear 1"}
          .within(-most_shift, most_shift)
          .usually(-0.8, 1.2),
      Field{&Input::x_2, "x_2", ratio,
            "profile shift coefficient, gear 2, positive for a thicker tooth; omitted: from a_w, else zero"}
          .within(-most_shift, most_shift)
          .usually(-0.8, 1.2)
          .may_be_missing(),
      Field{&Input::a_w, "a_w", mm, "working centre distance (rack: from the axis to its reference line)"}
          .positive()
          .may_be_missing(),
      Field{&Input::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"}.within(0.3, 2).usually(0.8, 1.2),
      Field{&Input::h_fP, "h_fP", ratio, "dedendum of the basic rack, in modules"}.within(0.4, 2.5).usually(1, 1.4),
      Field{&Input::rho_fP, "rho_fP", ratio, "root fillet radius of the basic rack, in modules"}.within(0, 0.6),
      Choice{&Input::shortening, "shortening", "tip shortening of a pair with profile shift"}.may_be_missing(),
      Field{&Input::d_a2, "d_a2", mm, "tip diameter of gear 2, replaces that by h_aP (ring gear: inner diameter)"}
          .positive()
          .may_be_missing(),
      Field{&Input::A_s1, "A_s1", mm, "tooth thickness allowance, gear 1 (negative: thinner)"}.within(-5, 0),
      Field{&Input::A_s2, "A_s2", mm, "tooth thickness allowance, gear 2 (negative: thinner)"}.within(-5, 0),
      Count{&Input::k_W1, "k_W1", 0, 2000, "number of teeth spanned, gear 1; 0: selected"}.may_be_missing(),
      Count{&Input::k_W2, "k_W2", 0, 2000, "number of teeth spanned, gear 2; 0: selected"}.may_be_missing(),
      Field{&Input::b, "b", mm, "common face width"}.positive().may_be_missing(),
      Field{&Input::psi_m, "psi_m", ratio, "face width in normal modules, replaces b"}
          .positive()
          .usually(5, widest)
          .may_be_missing(),
      Field{&Input::T_1, "T_1", N_m,
            "torque on shaft 1, nominal; positive where gear 1 drives, negative where it is driven"}
          .load()
          .at_least_that_of_source("shafts[#].T")
          .with("F_x1, F_y1, F_z1")
          .may_be_missing(),
      Field{&Input::P, "P", kW, "nominal power input of gear 1, with n_1, replaces T_1"}
          .load()
          .at_least_that_of_source("shafts[#].P")
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of gear 1; a negative value reverses the direction in turns"}
          .near_that_of_source("shafts[#].n")
          .may_be_missing(),
      Choice{&Input::turns, "turns", "direction of rotation of gear 1, viewed from +z towards the origin"}
          .may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Field{&Input::K_f, "K_f", ratio, "stress concentration factor at the root fillet; 1: static Lewis stress"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Choice{&Input::cutting, "cutting", "manufacturing method of the teeth, for the velocity factor"}.may_be_missing(),
      Choice{&Input::idler, "idler", "idler gear (reversed tooth bending)"}.may_be_missing(),
      Field{&Input::Y_1, "Y_1", ratio, "Lewis form factor, gear 1; omitted: from the tooth form"}
          .within(0.01, 1)
          .usually(0.15, 0.8)
          .may_be_missing(),
      Field{&Input::Y_2, "Y_2", ratio, "Lewis form factor, gear 2; omitted: from the tooth form"}
          .within(0.01, 1)
          .usually(0.15, 0.8)
          .may_be_missing(),
      Field{&Input::sigma_adm_1, "sigma_adm_1", MPa,
            "allowable tooth root bending stress, gear 1, pulsating (safety factor included)"}
          .positive()
          .usually(10, 1000)
          .customarily_at_most(700)
          .may_be_missing(),
      Field{&Input::sigma_adm_2, "sigma_adm_2", MPa,
            "allowable tooth root bending stress, gear 2, pulsating (safety factor included)"}
          .positive()
          .usually(10, 1000)
          .customarily_at_most(700)
          .may_be_missing(),
      Field{&Input::bore_1, "bore_1", mm, "bore diameter of gear 1, for the rim"}.positive().may_be_missing(),
      Field{&Input::bore_2, "bore_2", mm, "bore diameter of gear 2, for the rim"}.positive().may_be_missing(),
      Field{&Input::t_k1, "t_k1", mm, "keyway depth in the hub, gear 1"}.at_least(0).usually(0, 50),
      Field{&Input::t_k2, "t_k2", mm, "keyway depth in the hub, gear 2"}.at_least(0).usually(0, 50)};
  static constexpr auto results = pair_results;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return (in.mesh == Mesh::rack) == (in.z_2 == 0); }, "mesh, z_2",
                  "two gears, or a gear and a ring gear, need z_2; a rack has no number of teeth"},
      Rule<Input>{[](const Input& in) { return in.mesh != Mesh::internal || in.z_2 > in.z_1; }, "mesh, z_1, z_2",
                  "a ring gear must have more teeth than its mating gear"},
      Rule<Input>{[](const Input& in) {
                    return in.mesh != Mesh::rack || !(is_set(in.x_2) || is_set(in.sigma_adm_2) || is_set(in.Y_2) ||
                                                      in.A_s2 < 0.0 * mm || in.k_W2 != 0 || is_set(in.d_a2));
                  },
                  "mesh, x_2, d_a2, A_s2, k_W2, Y_2, sigma_adm_2",
                  "a rack has only the position a_w of its reference line: omit the inputs of gear 2"},
      Rule<Input>{
          [](const Input& in) {
            return in.mesh != Mesh::internal || !(is_set(in.sigma_adm_2) || is_set(in.Y_2) || in.k_W2 != 0);
          },
          "mesh, k_W2, Y_2, sigma_adm_2",
          "Lewis' formula and the base-tangent length do not cover the teeth of a ring: leave out k_W2, Y_2 and "
          "sigma_adm_2"},
      Rule<Input>{&bases_meet, "a_w, z_1, z_2, m_n, alpha_n, beta",
                  "the centre distance is too small for the base circles", &bases_apart},
      Rule<Input>{&working_angle_exists, "x_1, x_2, z_1, z_2",
                  "no working pressure angle exists for these profile shifts", &no_working_angle},
      Rule<Input>{[](const Input& in) { return !(is_set(in.b) && is_set(in.psi_m)); }, "b, psi_m",
                  "give the face width as b or as psi_m, not both"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.T_1) && is_set(in.P)); }, "T_1, P",
                  "give the load as T_1 or as P, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{[](const Input& in) { return !(abs(in.n_1) <= 0.0 * rpm); }, "n_1",
                  "a running gear needs a speed greater than zero"},
      Rule<Input>{[](const Input& in) {
                    const bool load = is_set(in.T_1) || is_set(in.P), width = is_set(in.b) || is_set(in.psi_m);
                    return !asks_strength(in) || (load && width);
                  },
                  "sigma_adm_1, sigma_adm_2, T_1, P, b, psi_m",
                  "an allowable stress needs a load (T_1, or P with n_1) and a face width (b or psi_m)"},
      Rule<Input>{[](const Input& in) { return in.cutting == Cutting::none || is_set(in.n_1); }, "cutting, n_1",
                  "the velocity factor needs the speed n_1"},
      Rule<Input>{[](const Input& in) { return in.cutting != Cutting::none || !is_set(in.n_1) || !asks_strength(in); },
                  "cutting, n_1", "the gears rotate, but the tooth finish is not stated: no velocity factor is applied",
                  nullptr, true},
      Rule<Input>{[](const Input& in) { return in.rho_fP <= in.h_fP; }, "rho_fP, h_fP",
                  "the root radius must fit into the dedendum"},
      Rule<Input>{[](const Input& in) { return in.k_W1 < in.z_1 && (in.k_W2 == 0 || in.k_W2 < in.z_2); },
                  "k_W1, k_W2, z_1, z_2", "the number of spanned teeth must be less than that of the gear"},
      Rule<Input>{[](const Input& in) { return in.mesh == Mesh::external || !is_set(in.bore_2); }, "bore_2, mesh",
                  "a ring gear or a rack has no bore: omit bore_2"}};

  static double most_form_factor_1(const Input& in);
  static double most_form_factor_2(const Input& in);
  static constexpr auto of_tooth_form = "1.2 times the form factor of the tooth form";
  static constexpr std::array bounds{Bound<Input>{"Y_1", of_tooth_form, &most_form_factor_1},
                                     Bound<Input>{"Y_2", of_tooth_form, &most_form_factor_2}};
  static constexpr std::array meanings{
      Meaning{"mesh.z_1, mesh.T_1", flanks_ground, "cutting", "ground"},
      Meaning{"mesh.z_1, mesh.T_1", flanks_not_ground, "cutting", "cast, milled, hobbed"}};
  static constexpr bool turns = true;
  static constexpr std::array senses{SenseClaim{"T_1, P", "idler", "none, gear_1, gear_2", "both"}};
  static constexpr std::array modes{
      Mode<Input>{"dynamic", "dynamic tooth load",
                  [](const Input& in) {
                    return carries(in) && in.cutting == Cutting::none ? shown_by(is_set(in.n_1)) : Applies::no;
                  }}
          .wanting("n_1, cutting")
          .in_service()
          .left_to("gear.rating", "mesh.dynamic"),
      Mode<Input>{"root_1", "tooth root bending, gear 1 (Lewis)", [](const Input& in) { return where(carries(in)); }}
          .judged_by("u_F1, v_share")
          .left_to("gear.rating", "mesh.root_1"),
      Mode<Input>{"root_2", "tooth root bending, gear 2 (Lewis)",
                  [](const Input& in) { return where(carries(in) && in.mesh == Mesh::external); }}
          .judged_by("u_F2, v_share")
          .left_to("gear.rating", "mesh.root_2"),
      Mode<Input>{"root_mate", "tooth root bending, ring or rack",
                  [](const Input& in) { return where(carries(in) && in.mesh != Mesh::external); }},
      Mode<Input>{"fillet", "stress concentration at the root fillet",
                  [](const Input& in) { return carries(in) && in.K_f == 1.0 ? shown_by(is_set(in.n_1)) : Applies::no; }}
          .wanting("K_f")
          .left_to("gear.rating", "mesh.root_1, mesh.root_2"),
      Mode<Input>{"pitting_1", "pitting, gear 1", [](const Input& in) { return where(carries(in)); }}
          .left_to("gear.rating", "mesh.pitting_1")
          .where_handed_over(),
      Mode<Input>{"pitting_2", "pitting, gear 2", [](const Input& in) { return where(carries(in)); }}
          .left_to("gear.rating", "mesh.pitting_2")
          .where_handed_over(),
      Mode<Input>{"contact", "contact ratio", &always<Input>}.judged_by("eps_gamma").of_shape(),
      Mode<Input>{"flanks", "involute form of the flanks", &always<Input>}.judged_by("q_a, x_2").of_shape(),
      Mode<Input>{"undercut", "undercut", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"interference", "tip and fillet interference", &always<Input>}.judged_by("f_int").of_shape(),
      Mode<Input>{"clearance_1", "tip clearance, gear 1", &always<Input>}.judged_by("c_1").of_shape(),
      Mode<Input>{"clearance_2", "tip clearance, gear 2", &always<Input>}.judged_by("c_2").of_shape(),
      Mode<Input>{"backlash", "backlash", &always<Input>}.judged_by("j_bn").of_shape(),
      Mode<Input>{"trimming", "trimming interference at radial assembly",
                  [](const Input& in) { return in.mesh == Mesh::internal ? Applies::unseen : Applies::no; }}
          .special(),
      Mode<Input>{"width", "face load distribution", [](const Input& in) { return shown_by(is_wide(in)); }}.special(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unseen<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special(),
      Mode<Input>{"micropitting", "micropitting", &unseen<Input>}.special(),
      Mode<Input>{"wear", "wear of the tooth flanks", &unseen<Input>}.special(),
      Mode<Input>{"case_crushing", "case crushing", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special(),
      Mode<Input>{"rim_1", "rim thickness, gear 1", &unseen<Input>}.judged_by("m_R1").wanting("bore_1").special(),
      Mode<Input>{"rim_2", "rim thickness, gear 2", &unseen<Input>}.judged_by("m_R2").wanting("bore_2").special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::gear
