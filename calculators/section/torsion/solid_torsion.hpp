// A solid section of any straight outline, with holes, in torsion: Prandtl's stress function by boundary elements.
//
// Decides torsion constant, section modulus and the place of the largest stress from two meshes, the second
// twice as fine, by Richardson's extrapolation; how far the fine one is from it is said and limited. Saint-Venant: free
// to warp. At an inner corner the elastic stress has no bound: the section modulus is not given there.
// Not covered: stress at inner corners, held warping, fatigue, bending. Curves are followed by points.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/section/polygon.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"

#include <array>

namespace loadpath::section {

inline constexpr std::size_t most_sides = 40;
/// How far the finer net may be from the extrapolated torsion constant and section modulus.
inline constexpr double worst_I_t = 2e-3, worst_W_t = 2e-2;

/// The fields of section.polygon, of an input that derives from its.
template <class Input>
constexpr auto contour_inputs() {
  List<Polygon::Corner, 64> Input::*const points = &Polygon::Input::points;
  List<Polygon::Hole, 8> Input::*const holes = &Polygon::Input::holes;
  return Fields{ListField{points, "points", "corners of the contour, in order around the edge"}.as_arrays(),
                ListField{holes, "holes", "holes"}.may_be_missing()};
}

struct SolidTorsion {
  static constexpr auto id = "section.solid_torsion";
  static constexpr auto title = "Torsion of a solid section (Prandtl)";
  static constexpr auto scope =
      "Torsion constant, torsional section modulus, maximum shear stress with its location, and twist of a "
      "polygonal section with holes (at most 40 sides) by Prandtl's stress function; stress at re-entrant "
      "corners, restrained warping and fatigue are not covered.";
  static constexpr auto source = "[Prandtl]";
  static constexpr auto headline = "I_t = {I_t}";
  static constexpr auto subject = "torsion";
  static constexpr auto synonyms =
      "torsion of non-circular bars, Saint-Venant torsion, Prandtl stress function, membrane analogy, triangle, "
      "hexagon, polygon torsion, boundary element, Torsion nichtkreisförmiger Querschnitte, "
      "Prandtlsche Spannungsfunktion, кручение некруглых стержней, функция Прандтля";
  static constexpr auto example = R"([project]
title = "Hexagon bar, 30 mm across flats"

[bar]
calculator = "section.solid_torsion"
T = "250 N*m"
points = [["17.3205 mm", "0 mm"], ["8.66025 mm", "15 mm"], ["-8.66025 mm", "15 mm"], ["-17.3205 mm", "0 mm"], ["-8.66025 mm", "-15 mm"], ["8.66025 mm", "-15 mm"]]
G = "80 GPa"
tau_adm = "60 MPa"
theta_adm = "4 deg/m"
)";

  struct Input : Polygon::Input, ShearStrength {
    Moment T = unset<Moment>;
    double K_A = 1.0;
    Stress G = unset<Stress>;
    Twist theta_adm = unset<Twist>;
  };

  static constexpr auto inputs =
      join(Fields{Field{&Input::T, "T", N_m, "torque"}.load(),
                  Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the torque includes it)"}
                      .at_least(1)
                      .usually(1, 4)
                      .factor()},
           contour_inputs<Input>(),
           Fields{Field{&Input::G, "G", GPa, "shear modulus, for the twist"}
                      .positive()
                      .usually(least_G, most_G)
                      .from("material", "G")},
           shear_strength_inputs<Input>("d_s"),
           Fields{Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable angle of twist per unit length"}
                      .positive()
                      .usually(0.02, 10)
                      .may_be_missing()});

  struct Result {
    SecondMoment I_t = unset<SecondMoment>;
    SectionModulus W_t = unset<SectionModulus>;
    Length y_t = unset<Length>, z_t = unset<Length>, d_s = unset<Length>;
    Stress tau_max = unset<Stress>, tau_all = unset<Stress>;
    Twist theta = unset<Twist>;
    double e_I = unset<double>, e_W = unset<double>, u_tau = unset<double>, u_theta = unset<double>;
    StressCycle cycle;
  };
  static constexpr Fields results{
      Field{&Result::I_t, "I_t", mm4, "torsion constant of Saint-Venant"},
      Field{&Result::W_t, "W_t", mm3, "section modulus in torsion; none where the section has an inner corner"},
      Field{&Result::y_t, "y_t", mm, "position of the maximum stress, to the right"},
      Field{&Result::z_t, "z_t", mm, "position of the maximum stress, upwards"},
      Field{&Result::d_s, "d_s", mm, "size whose strength the material has: the larger side of a box around it"},
      Field{&Result::tau_max, "tau_max", MPa, "maximum shear stress"},
      Field{&Result::tau_all, "tau_all", MPa, "allowable shear stress"},
      Field{&Result::theta, "theta", deg_per_m, "angle of twist per unit length, positive like T"},
      Field{&Result::e_I, "e_I", ratio, "error estimate of the torsion constant (fine mesh)"}.limit(0, worst_I_t),
      Field{&Result::e_W, "e_W", ratio, "error estimate of the section modulus (fine mesh)"}
          .limit(0, worst_W_t)
          .where_it_applies(),
      Field{&Result::u_tau, "u_tau", ratio, "strength: maximum / allowable shear stress"}.check().where_it_applies(),
      Field{&Result::u_theta, "u_theta", ratio, "stiffness: angle of twist per unit length / allowable angle"}.check(
          "theta_adm"),
      Group{&Result::cycle, "cycle", "maximum stress of the section, for fatigue.cycle: cycle"}.handed_over()};

  static bool sides_fit(const Input& in);
  static bool has_inner_corner(const Input& in);
  static Applies loaded(const Input& in);
  static Applies brittle(const Input& in);
  static Applies tough(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return Polygon::has_corners(in); }, "points, holes",
                  "a contour and each hole need at least three corners"},
      Rule<Input>{[](const Input& in) { return Polygon::is_simple(in); }, "points, holes",
                  "the sides of a contour must not touch or cross each other",
                  [](const Input& in) { return Polygon::crossing(in); }},
      Rule<Input>{[](const Input& in) { return Polygon::holes_are_inside(in); }, "holes, points",
                  "every hole must lie inside the contour and clear of other holes",
                  [](const Input& in) { return Polygon::hole_outside(in); }},
      Rule<Input>{&sides_fit, "points, holes", "contour and holes may have at most 40 sides"},
      Rule<Input>{[](const Input& in) { return one_shear_strength(in, false); },
                  "tau_adm, sigma_adm, behaviour, S, R_e",
                  "give one of them: tau_adm; sigma_adm with behaviour; S with the yield strength R_e (or a material)"},
      Rule<Input>{[](const Input& in) { return !is_set(in.theta_adm) || is_set(in.G); }, "theta_adm, G",
                  "theta_adm needs the shear modulus G (or a material)"}};

  static constexpr std::array meanings{all_in_shear, all_in_normal};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding in torsion", &tough}.judged_by("u_tau, e_I, e_W"),
      Mode<Input>{"fracture", "brittle fracture in torsion", &brittle}.judged_by("u_tau, e_I, e_W"),
      Mode<Input>{"twist", "angle of twist per unit length", &loaded}.judged_by("u_theta, e_I").of_service(),
      Mode<Input>{"corner", "stress concentration at re-entrant corners",
                  [](const Input& in) { return has_inner_corner(in) ? loaded(in) : Applies::no; }},
      Mode<Input>{"warping", "restrained warping stress", &unseen<Input>},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"fatigue", "fatigue", [](const Input& in) { return shown_by(in.K_A > 1.0); }}.in_service().left_to(
          "fatigue.cycle", "cycle.fatigue")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::section
