// Plane motion of a body at one instant: angular velocity, pole of velocities, velocities and accelerations of its
// points.
//
// The angular velocity is given, or follows from the velocities of two points A and B: by the theorem of projections
// where the perpendiculars to them meet, by the tips of the velocities where both are perpendicular to AB. Equal
// velocities are a translation, without a pole; equal magnitudes do not suffice (opposite velocities turn about the
// middle of AB). Sign: angles counter-clockwise from x. Source: [B29].
#pragma once

#include "calculators/motion/plane_types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct Plane : PlaneTypes {
  static constexpr auto id = "motion.plane";
  static constexpr auto title = "Plane motion of a rigid body";
  static constexpr auto scope =
      "Angular velocity and instantaneous centre of velocity of a body in plane motion at one instant, from "
      "its angular velocity or the velocities of two points, with velocities of further points and, for a "
      "known acceleration of A, their accelerations.";
  static constexpr auto source = "[B29], [B28]";
  static constexpr auto headline = "omega = {omega}|v_B = {v_B}";
  static constexpr auto synonyms =
      "plane motion, rigid body kinematics, instantaneous centre, instant centre of rotation, relative velocity, "
      "ebene Bewegung, Momentanpol, плоское движение, мгновенный центр скоростей, плоскопараллельное движение";
  static constexpr auto example = R"toml([project]
title = "A rod that slides down a wall"

[rod]
calculator = "motion.plane"
A = ["0 m", "4 m"]
B = ["3 m", "0 m"]
v_A = "0.6 m/s"
alpha_A = "-90 deg"
alpha_B = "0 deg"
points = [{ name = "C", x = "1.5 m", y = "2 m" }]
)toml";

  static constexpr Fields inputs{
      Group{&Input::A, "A", "position of A: [x, y]"}.as_array(),
      Group{&Input::B, "B", "position of B: [x, y]"}.as_array().may_be_missing(),
      Field{&Input::v_A, "v_A", m_per_s, "velocity of A along alpha_A, signed"},
      Field{&Input::alpha_A, "alpha_A", deg, "direction of the velocity of A, from x"},
      Field{&Input::omega, "omega", rad_per_s, "angular velocity, counter-clockwise positive; omitted: from B"}
          .may_be_missing(),
      Field{&Input::v_B, "v_B", m_per_s,
            "velocity of B along alpha_B, signed; needed where both velocities are "
            "perpendicular to AB"}
          .may_be_missing(),
      Field{&Input::alpha_B, "alpha_B", deg, "direction of the velocity of B, from x"}.may_be_missing(),
      Field{&Input::a_A, "a_A", m_per_s2, "acceleration of A along alpha_aA, signed"}.may_be_missing(),
      Field{&Input::alpha_aA, "alpha_aA", deg, "direction of the acceleration of A, from x"},
      Field{&Input::epsilon, "epsilon", rad_per_s2, "angular acceleration, counter-clockwise positive"}
          .may_be_missing(),
      Field{&Input::alpha_aB, "alpha_aB", deg,
            "direction of the acceleration of B (a straight guide), in place of "
            "epsilon"}
          .may_be_missing(),
      ListField{&Input::points, "points", "further points of the body"}.may_be_missing()};

  static constexpr Fields results{
      Choice{&Result::found, "found", "basis of the angular velocity"},
      Choice{&Result::kind, "kind", "state of motion at this instant"},
      Field{&Result::AB, "AB", m, "distance of A and B"},
      Field{&Result::beta, "beta", deg, "direction from A to B, from x"},
      Field{&Result::v_B, "v_B", m_per_s, "velocity of B along alpha_B, signed"},
      Field{&Result::omega, "omega", rad_per_s, "angular velocity, counter-clockwise positive"},
      Field{&Result::x_P, "x_P", m, "pole of velocities, x; none in a translation"},
      Field{&Result::y_P, "y_P", m, "pole of velocities, y; none in a translation"},
      Field{&Result::PA, "PA", m, "distance of A from the pole of velocities"},
      Field{&Result::epsilon, "epsilon", rad_per_s2, "angular acceleration, counter-clockwise positive"},
      Field{&Result::a_B, "a_B", m_per_s2, "acceleration of B along alpha_aB, signed"},
      Field{&Result::x_Q, "x_Q", m, "pole of accelerations, x"},
      Field{&Result::y_Q, "y_Q", m, "pole of accelerations, y"},
      ListField{&Result::states, "states", "A, B and the further points"}};

  static bool has_B(const Input& in) { return is_set(in.B.x) && is_set(in.B.y); }
  static bool is_B_apart(const Input& in);
  static bool has_one_way(const Input& in);
  static bool has_speed_of_B(const Input& in);
  static bool projections_agree(const Input& in);
  static FieldFault projections(const Input& in);
  static bool guide_is_oblique(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.A.x) && is_set(in.A.y); }, "A", "give A = [x, y]"},
      Rule<Input>{[](const Input& in) { return is_set(in.B.x) == is_set(in.B.y); }, "B", "give B = [x, y]"},
      Rule<Input>{
          &has_one_way, "omega, B, v_B, alpha_B",
          "the angular velocity is omega, or comes from B with alpha_B (or v_B = \"0 m/s\"): give one of the two"},
      Rule<Input>{&is_B_apart, "A, B", "A and B must be different points"},
      Rule<Input>{
          &has_speed_of_B, "v_B, alpha_B, A, B",
          "if the velocity of B is perpendicular to AB, its magnitude does not follow from that of A: give v_B"},
      Rule<Input>{&projections_agree, "v_B, v_A, alpha_A, alpha_B, A, B",
                  "the projections of the velocities of A and B on AB must be equal: AB is rigid", &projections},
      Rule<Input>{[](const Input& in) { return !(is_set(in.epsilon) && is_set(in.alpha_aB)); }, "epsilon, alpha_aB",
                  "the angular acceleration is epsilon, or follows from alpha_aB: give one of the two"},
      Rule<Input>{[](const Input& in) { return !is_set(in.a_A) || is_set(in.epsilon) || is_set(in.alpha_aB); },
                  "a_A, epsilon, alpha_aB", "accelerations need epsilon, or alpha_aB, in addition to a_A"},
      Rule<Input>{[](const Input& in) { return is_set(in.a_A) || !(is_set(in.epsilon) || is_set(in.alpha_aB)); },
                  "a_A, epsilon, alpha_aB", "accelerations need that of A: give a_A (\"0 m/s^2\" where it has none)"},
      Rule<Input>{&guide_is_oblique, "alpha_aB, A, B",
                  "alpha_aB needs B, and must not be perpendicular to AB: epsilon would not follow; give epsilon"}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::motion
