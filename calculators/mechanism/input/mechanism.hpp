// A planar mechanism in a project: links, joints, drives and loads as a user writes them.
//
// Decides positions, velocities, accelerations, the reaction of every joint and the driving moment or force, over a
// turn of the crank, over strokes of cylinders, or at given positions (lib/mechanism). Rigid links; clearance: an
// error. Signs: moments counter-clockwise positive; a joint's force is that of its first link on its second (R_12). A
// link's points are written in its own axes, or, where neither origin nor angle is given, as drawn on paper.
#pragma once

#include "calculators/mechanism/input/cam_profile.hpp"
#include "calculators/mechanism/input/course.hpp"
#include "calculators/mechanism/input/design.hpp"
#include "calculators/mechanism/input/drives.hpp"
#include "calculators/mechanism/input/loading.hpp"
#include "calculators/mechanism/input/parts.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

struct Mechanism {
  static constexpr auto id = "mechanism.planar";
  static constexpr auto title = "Planar mechanism (kinematics, kinetostatics)";
  static constexpr auto scope =
      "Kinematics, joint reactions and driving torque or force of a planar mechanism of rigid links with revolute, "
      "prismatic and slot joints, gears, belts, cams, rolling wheels and friction, over a cycle or at given "
      "positions; joint clearance is treated as an error of the outputs; elasticity is not covered.";
  static constexpr auto source = "[A10], [B29], [B31], [D3]";
  static constexpr auto headline =
      "stable at {equilibrium.stable}|torque {drive.M!}|force {cylinders.*.F!}|joint force {joints.*.F!}|no forces: "
      "motion only";
  static constexpr auto synonyms =
      "mechanism, linkage, four-bar linkage, slider-crank, crank mechanism, slotted lever, scotch yoke, "
      "toggle press, cam, follower, kinematics, kinetostatics, inverse dynamics, joint reaction, driving torque, "
      "balancing, virtual power, Zhukovsky lever, Assur group, Koppelgetriebe, Kurbelgetriebe, Getriebe, "
      "Kinetostatik, Gelenkkraft, machine dynamics, Mechanismus, Kurvengetriebe, Kurvenscheibe, механизм, "
      "рычажный механизм, кривошипно-ползунный механизм, кулисный механизм, кулачок, кинетостатика, реакции, "
      "группа Ассура, рычаг Жуковского";
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

  enum class Analysis { kinetostatic, statics, equilibrium };
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
    double gamma_min = unset<double>;
    Analysis analysis = Analysis::kinetostatic;
    std::vector<Actuator> actuators;  // from cylinders (words/cylinders.hpp): not a field
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
      ListField{&Input::courses, "courses", "load curves over time, a stroke or by a formula, by name"}
          .may_be_missing(),
      ListField{&Input::springs, "springs", "springs and dampers, by name"}.may_be_missing(),
      ListField{&Input::sides, "sides",
                "assembly configuration of each group (the report lists them); omitted: as stated or drawn"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Input::tolerances, "tolerances", "toleranced dimensions and masses, by name"}.may_be_missing(),
      ListField{&Input::accuracy, "accuracy",
                "outputs whose error due to tolerances and clearance is requested, by name"}
          .may_be_missing(),
      ListField{&Input::counterweights, "counterweights", "links with counterweights, by name"}.may_be_missing(),
      Choice{&Input::balance, "balance", "quantity minimised by the counterweights"}.may_be_missing(),
      ListField{&Input::hodographs, "hodographs",
                "joints whose force is drawn as a hodograph; omitted: the three pins with the largest force"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::gravity, "gravity", m_per_s2, "acceleration of gravity, its magnitude; omitted: none"}.usually(-30,
                                                                                                                   30),
      Field{&Input::gravity_direction, "gravity_direction", deg, "direction of gravity"},
      Field{&Input::gamma_min, "gamma_min", deg,
            "required minimum transmission angle of every dyad: 40° in general, 30° for light loads"}
          .within(25, 90)
          .may_be_missing(),
      Choice{&Input::analysis, "analysis", "with the inertia of the links, or loads only"}.may_be_missing()};

  /// The rows that judge a mode are those of the aspects; a mode without a row does not concern the mechanism.
  static constexpr std::array modes{
      Mode<Input>{"closing", "loop closure and periodicity", &always<Input>}
          .judged_by("closes, returns, returns_*, directed_*, assembly")
          .of_shape(),
      Mode<Input>{"jamming", "frictional jamming (self-locking)", &always<Input>}.judged_by("moves, arm_*").of_shape(),
      Mode<Input>{"contact", "lift-off of wheels and followers", &always<Input>}.judged_by("contact_*"),
      Mode<Input>{"profile", "cam undercutting and roller fit", &always<Input>}
          .judged_by("profile_*, hollow_*")
          .of_shape(),
      Mode<Input>{"pressure_angle", "pressure angle of the cam follower", &always<Input>}
          .judged_by("pressure_*")
          .of_shape(),
      Mode<Input>{"transmission", "transmission angle", &always<Input>}.judged_by("transmission_*").of_shape(),
      Mode<Input>{"uniqueness", "static determinacy of reactions", &always<Input>}.judged_by("determinate").of_shape(),
      Mode<Input>{"solution", "verification by independent methods", &always<Input>}
          .judged_by("force_balance, moment_balance, power_balance, motion, trustworthy, whole_system, "
                     "opened_chain, "
                     "released_constraints, virtual_power, zhukovsky_lever")
          .of_shape(),
      Mode<Input>{"courses", "validity: load curves", &always<Input>}.judged_by("course_*"),
      Mode<Input>{"resolution", "position resolution of peak reactions", &always<Input>}
          .judged_by("resolution")
          .of_shape(),
      Mode<Input>{"strength", "strength of unchecked links and pins", &unseen<Input>}.assessed_additionally_in(
          "link.member, pin.joint, column.buckling, shaft.design"),
      Mode<Input>{"pins", "wear of pin joints (pv value)", &unseen<Input>}.special()};
};

constexpr auto choices_of(Mechanism::Analysis) {
  using T = Mechanism::Analysis;
  return std::array{ChoiceName<T>{T::kinetostatic, "kinetostatic", "loads, weights and inertia"},
                    ChoiceName<T>{T::statics, "static", "loads and weights; no inertia"},
                    ChoiceName<T>{T::equilibrium, "equilibrium",
                                  "only the positions where loads, weights and springs balance without the drive"}};
}

constexpr bool leaves_out_inertia(const Mechanism::Input& in) {
  return in.analysis != Mechanism::Analysis::kinetostatic;
}
/// Whether its positions are those at which it is in equilibrium without its drive.
constexpr bool stays_in_equilibrium(const Mechanism::Input& in) {
  return in.analysis == Mechanism::Analysis::equilibrium;
}

}  // namespace loadpath::planar
