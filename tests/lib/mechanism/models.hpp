// Mechanisms that several tests use.
#pragma once

#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/proof/balance.hpp"

#include <string>
#include <utility>

namespace loadpath::mechanism::models {

inline int add_link(Model& model, std::string name, Pose pose, double mass = 0.0, double inertia = 0.0,
                    Vec centre = {}) {
  model.links.push_back({std::move(name), mass, inertia, centre, pose});
  return static_cast<int>(model.links.size()) - 1;
}

/// A slender bar from its frame's origin along its x axis.
inline int add_bar(Model& model, std::string name, Pose pose, double length, double mass) {
  return add_link(model, std::move(name), pose, mass, mass * length * length / 12.0, {length / 2.0, 0.0});
}

inline void pin(Model& model, std::string name, int i, Vec point_i, int j, Vec point_j) {
  model.joints.push_back({std::move(name), JointKind::revolute, i, j, point_i, point_j});
}

inline void slide(Model& model, std::string name, int i, Vec point_i, int j, Vec point_j, double direction = 0.0,
                  double angle = 0.0) {
  model.joints.push_back({std::move(name), JointKind::prismatic, i, j, point_i, point_j, direction, angle});
}

inline void slot(Model& model, std::string name, int i, Vec point_i, int j, Vec point_j, double direction = 0.0) {
  model.joints.push_back({std::move(name), JointKind::slot, i, j, point_i, point_j, direction});
}

inline void drive_turning(Model& model, std::string name, int i, int j = ground, double offset = 0.0) {
  model.drivers.push_back({std::move(name), Driver::Kind::rotary, i, j, -1, offset});
}

inline void drive_sliding(Model& model, std::string name, int joint, double offset = 0.0) {
  model.drivers.push_back({std::move(name), Driver::Kind::linear, ground, ground, joint, offset});
}

inline void load(Model& model, std::string name, int link, Vec point, Vec force, double moment = 0.0) {
  model.loads.push_back({std::move(name), link, point, force, false, moment});
}

/// Crank 0.1 m, rod 0.3 m, piston 2 kg on the x axis with -1000 N.
inline Model slider_crank() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int crank = add_bar(model, "crank", {0.0, 0.0, 1.0}, 0.1, 1.0);
  const int rod = add_bar(model, "rod", {0.054, 0.084, -0.28}, 0.3, 1.5);
  const int piston = add_link(model, "piston", {0.34, 0.0, 0.0}, 2.0);
  pin(model, "O", crank, {}, ground, {});
  pin(model, "A", rod, {}, crank, {0.1, 0.0});
  pin(model, "B", piston, {}, rod, {0.3, 0.0});
  slide(model, "guide", piston, {}, ground, {});
  drive_turning(model, "motor", crank);
  load(model, "gas", piston, {}, {-1000.0, 0.0});
  return model;
}

/// With friction in every joint.
inline Model rubbing_slider_crank(double coefficient) {
  Model model = slider_crank();
  for (Joint& joint : model.joints) {
    joint.friction.coefficient = coefficient;
    joint.friction.pin_radius = 0.01;
    joint.guide_length = 0.08;
    joint.guide_width = 0.05;
  }
  return model;
}

/// Crank 0.1, coupler 0.35, rocker 0.3, ground 0.4 m.
inline Model four_bar_without_load() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int crank = add_bar(model, "crank", {0.0, 0.0, 1.0}, 0.1, 1.0);
  const int coupler = add_bar(model, "coupler", {0.054, 0.084, 0.5}, 0.35, 1.5);
  const int rocker = add_bar(model, "rocker", {0.4, 0.0, 1.8}, 0.3, 1.2);
  pin(model, "O", crank, {}, ground, {});
  pin(model, "A", coupler, {}, crank, {0.1, 0.0});
  pin(model, "B", rocker, {0.3, 0.0}, coupler, {0.35, 0.0});
  pin(model, "C", rocker, {}, ground, {0.4, 0.0});
  drive_turning(model, "motor", crank);
  return model;
}

/// -20 N m on the rocker.
inline Model four_bar() {
  Model model = four_bar_without_load();
  load(model, "couple", 2, {}, {}, -20.0);
  return model;
}

/// The four-bar with a bar of 0.5 m from the rocker's tip to a slider on y = 0.25 m with -1000 N.
inline Model six_bar() {
  Model model = four_bar_without_load();
  const int bar = add_bar(model, "bar", {0.33, 0.29, 0.0}, 0.5, 1.0);
  const int slider = add_link(model, "slider", {0.8, 0.25, 0.0}, 2.0);
  pin(model, "B2", bar, {}, 2, {0.3, 0.0});
  pin(model, "D", slider, {}, bar, {0.5, 0.0});
  slide(model, "guide", slider, {}, ground, {0.0, 0.25});
  load(model, "push", slider, {}, {-1000.0, 0.0});
  return model;
}

/// The four-bar with equal rockers 0.4 m apart, coupled one after the other: `dyads` of them.
inline Model chain(int dyads) {
  Model model = four_bar();
  for (int k = 1; k < dyads; ++k) {
    const int rocker = 2 * k;
    const int coupler = add_bar(model, "coupler " + std::to_string(k), {0.4 * k - 0.068, 0.292, 0.0}, 0.4, 1.5);
    const int next = add_bar(model, "rocker " + std::to_string(k), {0.4 * (k + 1), 0.0, 1.8}, 0.3, 1.2);
    pin(model, "A" + std::to_string(k), coupler, {}, rocker, {0.3, 0.0});
    pin(model, "B" + std::to_string(k), next, {0.3, 0.0}, coupler, {0.4, 0.0});
    pin(model, "C" + std::to_string(k), next, {}, ground, {0.4 * (k + 1), 0.0});
  }
  return model;
}

/// Six links: a crank of 0.064 m and a group of class III, a link with three pins on a bar and two rockers.
inline Model class_three() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int crank = add_bar(model, "crank", {0.0, 0.0, -1.357}, 0.064, 1.0);
  const int bar = add_bar(model, "bar", {0.0136, -0.0625, 0.119}, 0.1824, 1.1);
  const int plate = add_link(model, "plate", {0.1947, -0.041, -0.338}, 2.4, 0.019, {0.108, 0.022});
  const int right = add_bar(model, "right", {0.4977, 0.2425, -1.728}, 0.3739, 2.0);
  const int left = add_bar(model, "left", {0.1394, -0.0662, 0.859}, 0.369, 2.0);
  pin(model, "O", crank, {}, ground, {});
  pin(model, "A", bar, {}, crank, {0.064, 0.0});
  pin(model, "B", plate, {}, bar, {0.1824, 0.0});
  pin(model, "C", right, {0.3739, 0.0}, plate, {0.259, 0.0});
  pin(model, "D", right, {}, ground, {0.4977, 0.2425});
  pin(model, "E", left, {0.369, 0.0}, plate, {0.091, 0.3013});
  pin(model, "F", left, {}, ground, {0.1394, -0.0662});
  drive_turning(model, "motor", crank);
  return model;
}

/// Crank 0.03 m, slotted lever 20 kg about B at the origin; `with_slider`: a massless slider instead of the slot.
inline Model slotted_lever(bool with_slider = false, double gamma = -0.349065850398865915) {
  Model model;
  const Pose crank_pose{0.09, 0.0, -1.0471975511965976};
  const int crank = add_link(model, "crank", crank_pose);
  const int lever = add_link(model, "lever", {0.0, 0.0, -0.2425}, 20.0, 0.14, {0.055, 0.0});
  pin(model, "O", crank, {}, ground, {0.09, 0.0});
  pin(model, "B", lever, {}, ground, {});
  if (with_slider) {
    const int slider = add_link(model, "slider", {0.105, -0.026, -0.2425});
    pin(model, "A", slider, {}, crank, {0.03, 0.0});
    slide(model, "slide", slider, {}, lever, {});
  } else {
    slot(model, "A", crank, {0.03, 0.0}, lever, {});
  }
  drive_turning(model, "motor", crank);
  const Turn to_c = turn(gamma);
  model.loads.push_back({"F3", lever, to_c({0.04, 0.0}), to_c({0.0, -720.0}), true, 0.0});
  return model;
}

/// A crank on a moving base: the slot's line rotates, and both of its links have neighbours other than the ground.
inline Model slot_on_a_moving_link(bool with_slider) {
  Model model;
  model.gravity = {1.0, -9.0};
  const int crank = add_link(model, "crank", {0.0, 0.0, 0.4}, 1.2, 0.02, {0.05, 0.01});
  const int rod = add_link(model, "rod", {0.2, 0.08, 0.3}, 0.8, 0.03, {0.2, -0.02});
  const int lever = add_link(model, "lever", {0.5, -0.4, 1.7}, 2.0, 0.06, {0.1, 0.03});
  pin(model, "O", crank, {}, ground, {});
  pin(model, "A", rod, {}, crank, {0.2, 0.03});
  pin(model, "C", lever, {}, ground, {0.5, -0.4});
  pin(model, "D", rod, {0.45, 0.05}, lever, {0.62, -0.03});
  // A free arm on the crank whose pin runs in a slanting slot of the lever.
  const int arm = add_link(model, "arm", {0.2, 0.08, 0.0}, 0.5, 0.01, {0.1, 0.0});
  pin(model, "E", arm, {}, crank, {0.15, -0.02});
  const Vec tip{0.3, 0.02};
  const Vec foot{0.2, 0.01};
  const double direction = 1.3;
  if (with_slider) {
    const int slider = add_link(model, "slider", {0.44, -0.2, 1.7});
    pin(model, "F", arm, tip, slider, {});
    slide(model, "slide", slider, {}, lever, foot, direction);
  } else {
    slot(model, "F", arm, tip, lever, foot, direction);
  }
  drive_turning(model, "motor", crank);
  model.loads.push_back({"P", arm, {0.2, 0.1}, {40.0, -25.0}, true, 1.5});
  model.loads.push_back({"Q", lever, {0.3, 0.0}, {-60.0, 15.0}, false, -2.0});
  return model;
}

/// The piston of the slider-crank, driven along its guide.
inline Model driven_piston() {
  Model model = slider_crank();
  model.drivers.clear();
  drive_sliding(model, "cylinder", 3, 0.05);
  return model;
}

/// A boom on a pivot, raised by a cylinder that swings about its foot.
inline Model boom() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int arm = add_link(model, "boom", {0.0, 0.0, 0.6}, 120.0, 30.0, {1.1, 0.1});
  const int barrel = add_link(model, "barrel", {0.7, -0.5, 1.2}, 15.0, 0.5, {0.3, 0.0});
  const int rod = add_link(model, "rod", {0.9, 0.6, 1.2}, 8.0, 0.3, {-0.4, 0.0});
  pin(model, "O", arm, {}, ground, {});
  pin(model, "foot", barrel, {}, ground, {0.7, -0.5});
  pin(model, "head", rod, {}, arm, {1.2, -0.05});
  slide(model, "cylinder", rod, {}, barrel, {});
  drive_sliding(model, "oil", 3);
  load(model, "payload", arm, {2.4, 0.0}, {0.0, -2000.0});
  return model;
}

/// Two driven cranks 0.2 and 0.15 m at 0.5 m and the two bars of 0.4 m between them; a force at the pin of the bars.
inline Model five_bar() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int left = add_bar(model, "left", {0.0, 0.0, 2.0}, 0.2, 1.0);
  const int right = add_bar(model, "right", {0.5, 0.0, 1.0}, 0.15, 0.8);
  const int first = add_bar(model, "first", {-0.08, 0.18, 0.5}, 0.4, 1.5);
  const int second = add_bar(model, "second", {0.58, 0.13, 2.4}, 0.4, 1.4);
  pin(model, "O", left, {}, ground, {});
  pin(model, "C", right, {}, ground, {0.5, 0.0});
  pin(model, "A", first, {}, left, {0.2, 0.0});
  pin(model, "B", second, {}, right, {0.15, 0.0});
  pin(model, "P", first, {0.4, 0.0}, second, {0.4, 0.0});
  drive_turning(model, "motor", left);
  drive_turning(model, "second motor", right);
  load(model, "work", first, {0.4, 0.0}, {-80.0, 150.0}, 3.0);
  return model;
}

/// A turning column with an arm that a cylinder moves out: no loop.
inline Model telescope() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int column = add_bar(model, "column", {0.0, 0.0, 0.7}, 1.2, 30.0);
  const int arm = add_bar(model, "arm", {0.6, 0.5, 0.7}, 1.0, 12.0);
  pin(model, "O", column, {}, ground, {});
  slide(model, "cylinder", arm, {}, column, {0.1, 0.05});
  drive_turning(model, "motor", column);
  drive_sliding(model, "oil", 1);
  load(model, "payload", arm, {1.0, 0.0}, {0.0, -700.0});
  return model;
}

/// An ellipse trammel: two pins of a bar, 0.3 m apart, in two crossed slots; a cylinder pushes the first along its
/// slot.
inline Model trammel() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int bar = add_bar(model, "bar", {0.2, 0.0, 2.3}, 0.5, 2.0);
  slot(model, "A", bar, {}, ground, {});
  slot(model, "B", bar, {0.3, 0.0}, ground, {}, 1.4);
  drive_sliding(model, "cylinder", 0);
  load(model, "P", bar, {0.5, 0.0}, {70.0, -40.0}, 2.0);
  return model;
}

/// The position at these drives, from the stated assembly. Check `status`.
struct Solved {
  Status status;
  Position at;
  Residuals left = {};
};
inline Solved solve(const Model& model, std::vector<Drive> drives, bool statics = false) {
  GroupSystem system(model);
  Solved solved{system.assemble(), blank_position(model)};
  if (solved.status == Status::closed) solved.status = system.solve(drives, solved.at, statics);
  if (solved.status == Status::closed) solved.left = residuals(model, drives, statics, solved.at);
  return solved;
}
/// At the stated assembly, drivers at rest.
inline Solved solve_at_rest(const Model& model) {
  GroupSystem system(model);
  Solved solved{system.assemble(), blank_position(model)};
  std::vector<Drive> drives(model.drivers.size());
  if (solved.status != Status::closed) return solved;
  for (std::size_t k = 0; k < drives.size(); ++k) drives[k].coordinate = system.coordinate(k);
  solved.status = system.solve(drives, solved.at);
  return solved;
}

}  // namespace loadpath::mechanism::models
