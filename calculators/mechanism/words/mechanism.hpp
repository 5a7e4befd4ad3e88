// A planar mechanism in a project: links, joints, drives and loads as a user writes them.
//
// Decides positions, velocities, accelerations, the reaction of every joint and the driving moment or force, over a
// turn of the crank, over strokes of cylinders, or at given positions (lib/mechanism). Rigid links; play counts as an
// error only. Signs: moments counter-clockwise positive; a joint's force is that of its first link on its second
// (R_12). A link's points are written in its own axes, or, where neither origin nor angle is given, as drawn on paper.
#pragma once

#include "calculators/mechanism/words/cam_profile.hpp"
#include "calculators/mechanism/words/course.hpp"
#include "calculators/mechanism/words/design.hpp"
#include "calculators/mechanism/words/drives.hpp"
#include "calculators/mechanism/words/loading.hpp"
#include "calculators/mechanism/words/parts.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

struct Mechanism {
  static constexpr auto id = "mechanism.planar";
  static constexpr auto title = "Planar mechanism";
  static constexpr auto scope =
      "Motion, joint reactions and driving effort of a planar mechanism with pins, slides, slots, gears, belts, cams, "
      "rolling wheels and friction, with masses and loads, over a cycle or at given positions. Rigid links; play "
      "counts "
      "as an error of outputs, elasticity is not covered.";
  static constexpr auto source = "[A10], [B29], [B31], [D3]";
  static constexpr auto headline = "torque {drive.M}|force {cylinders.*.F}";
  static constexpr auto example = R"([project]
title = "Slider-crank"

[press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 72 }

[press.ground]
O = ["0 mm", "0 mm"]
B = ["0 mm", "0 mm"]

[press.links.crank]
points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }
angle = "30 deg"

[press.links.rod]
points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }
angle = "-7 deg"

[press.links.slider]
points = { B = ["0 mm", "0 mm"] }
angle = "0 deg"
mass = "2 kg"

[press.joints]
O = { type = "revolute", links = ["crank", "ground"] }
A = { type = "revolute", links = ["crank", "rod"] }
B = { type = "revolute", links = ["rod", "slider"] }
guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "B"] }

[[press.loads]]
link = "slider"
at = "B"
F_x = "-1 kN"
F_y = "0 N"
)";

  struct Side {
    Name side;
    static constexpr Fields fields{NameField{&Side::side, "side", "side of a group: \"B_left\", \"D_ahead\""}};
  };

  enum class Analysis { kinetostatic, statics };
  /// A cylinder and the joint that it slides in.
  struct Actuator {
    Name name, joint;
    bool driven = true;  // else a load pushes the first link of the joint
    bool between_points = false;
  };
  struct Input {
    std::vector<Point> ground;
    std::vector<Link> links;
    std::vector<Joint> joints;
    std::vector<CamProfile> profiles;
    Crank crank;
    std::vector<Cylinder> cylinders;
    Whole positions = 1;
    std::vector<Load> loads;
    std::vector<Course> courses;
    std::vector<Spring> springs;
    std::vector<Side> sides;
    std::vector<Tolerance> tolerances;
    std::vector<Accuracy> accuracy;
    std::vector<Counterweight> counterweights;
    Balance balance = Balance::rms;
    std::vector<Hodograph> hodographs;
    Acceleration gravity = 0.0 * m_per_s2.one;
    double gravity_direction = -pi / 2.0;
    Analysis analysis = Analysis::kinetostatic;
    std::vector<Actuator> actuators;  // what cylinders have become (words/cylinders.hpp): no field
  };
  static constexpr Fields inputs{
      ListField{&Input::ground, "ground", "points of the fixed link"}.as_arrays().may_be_missing(),
      ListField{&Input::links, "links", "moving links, by name"},
      ListField{&Input::joints, "joints", "joints, by name"},
      ListField{&Input::profiles, "profiles", "profiles of cams, by name"}.may_be_missing(),
      Group{&Input::crank, "crank", "drive of a revolute joint"}.may_be_missing(),
      ListField{&Input::cylinders, "cylinders", "cylinders between two points, and drives of prismatic joints, by name"}
          .may_be_missing(),
      Count{&Input::positions, "positions", 1, 7200,
            "positions of a stroke, or of a law of motion, of cylinders without a crank"},
      ListField{&Input::loads, "loads", "forces and couples"}.may_be_missing(),
      ListField{&Input::courses, "courses", "how loads vary over time, a stroke or by a formula, by name"}
          .may_be_missing(),
      ListField{&Input::springs, "springs", "springs and dampers, by name"}.may_be_missing(),
      ListField{&Input::sides, "sides",
                "assembly by the sides of its groups, which the report lists; as stated or drawn where missing"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Input::tolerances, "tolerances", "dimensions and masses that are not exact, by name"}.may_be_missing(),
      ListField{&Input::accuracy, "accuracy", "outputs whose error by tolerances and play is wanted, by name"}
          .may_be_missing(),
      ListField{&Input::counterweights, "counterweights", "where counterweights are wanted, by name"}.may_be_missing(),
      Choice{&Input::balance, "balance", "what counterweights make as small as it gets"}.may_be_missing(),
      ListField{&Input::hodographs, "hodographs",
                "joints whose force is drawn as a hodograph; the busiest where missing"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::gravity, "gravity", m_per_s2, "acceleration of gravity, its magnitude; none where missing"}.usually(
          -30, 30),
      Field{&Input::gravity_direction, "gravity_direction", deg, "direction of gravity"},
      Choice{&Input::analysis, "analysis", "with the inertia of the links, or loads alone"}.may_be_missing()};

  /// The rows that judge a mode are those of the aspects; a mode without a row does not concern the mechanism.
  static constexpr std::array modes{
      Mode<Input>{"closing", "a position where it does not close, a cycle that does not end where it began",
                  &always<Input>}
          .judged_by("closes, returns, returns_*, directed_*, assembly")
          .of_shape(),
      Mode<Input>{"jamming", "friction that holds it", &always<Input>}.judged_by("moves").of_shape(),
      Mode<Input>{"contact", "wheels and followers that leave what they run on", &always<Input>}.judged_by("contact_*"),
      Mode<Input>{"profile", "a cam that cannot be made, or that its roller does not reach", &always<Input>}
          .judged_by("profile_*, hollow_*")
          .of_shape(),
      Mode<Input>{"pressure_angle", "a cam that jams its follower by its pressure angle", &always<Input>}
          .judged_by("pressure_*")
          .of_shape(),
      Mode<Input>{"uniqueness", "reactions that equilibrium alone does not decide", &always<Input>}
          .judged_by("determinate")
          .of_shape(),
      Mode<Input>{"solution", "motion or forces that independent methods find otherwise", &always<Input>}
          .judged_by("force_balance, moment_balance, power_balance, motion, trustworthy, whole_system, "
                     "opened_chain, "
                     "released_constraints, virtual_power, zhukovsky_lever")
          .of_shape(),
      Mode<Input>{"courses", "loads where the points of their course do not reach", &always<Input>}.judged_by(
          "course_*"),
      Mode<Input>{"resolution", "a largest reaction between the positions", &always<Input>}
          .judged_by("resolution")
          .of_shape(),
      Mode<Input>{"strength", "strength of the links and pins that no step takes", &unseen<Input>}.assessed_beside(
          "link.member, pin.joint, column.buckling, shaft.design"),
      Mode<Input>{"pins", "wear of pins: pressure times speed", &unseen<Input>}.special()};
};

constexpr auto choices_of(Mechanism::Analysis) {
  using T = Mechanism::Analysis;
  return std::array{ChoiceName<T>{T::kinetostatic, "kinetostatic", "loads, weights and inertia"},
                    ChoiceName<T>{T::statics, "static", "loads and weights; no inertia"}};
}

}  // namespace loadpath::planar
