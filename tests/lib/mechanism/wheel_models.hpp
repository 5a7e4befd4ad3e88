// Mechanisms with cams, gears, racks, belts, rolling wheels and rigid joints that several tests use.
#pragma once

#include "lib/mechanism/model/pair.hpp"
#include "tests/lib/mechanism/cam_models.hpp"

#include <cmath>
#include <vector>

namespace loadpath::mechanism::models {

inline void mesh(Model& model, JointKind kind, int i, Vec centre_i, double radius_i, int j, Vec centre_j,
                 double radius_j, double pressure_angle = 0.0) {
  Joint joint{.name = "mesh", .kind = kind, .i = i, .j = j, .point_i = centre_i, .point_j = centre_j};
  joint.radius_i = radius_i;
  joint.radius_j = radius_j;
  joint.pressure_angle = pressure_angle;
  model.joints.push_back(joint);
}

/// A wheel of mass 2 kg.
inline int add_wheel(Model& model, const char* name, Pose pose) { return add_link(model, name, pose, 2.0, 0.01); }

/// A pinion of 20 mm drives a wheel of 50 mm with a crank that pushes a slider.
inline Model gear_train(double pressure_angle = 0.0) {
  Model model;
  model.gravity = {0.0, -9.81};
  const int pinion = add_wheel(model, "pinion", {0.0, 0.0, 0.4});
  const int wheel = add_wheel(model, "wheel", {0.07, 0.0, 0.9});
  const int rod = add_bar(model, "rod", {0.07 + 0.03 * std::cos(0.9), 0.03 * std::sin(0.9), -0.2}, 0.12, 0.5);
  const int slider = add_link(model, "slider", {0.21, 0.0, 0.0}, 1.0);
  pin(model, "O", pinion, {}, ground, {});
  pin(model, "C", wheel, {}, ground, {0.07, 0.0});
  pin(model, "A", rod, {}, wheel, {0.03, 0.0});
  pin(model, "B", slider, {}, rod, {0.12, 0.0});
  slide(model, "guide", slider, {}, ground, {});
  mesh(model, JointKind::gear, pinion, {}, 0.02, wheel, {}, 0.05, pressure_angle);
  drive_turning(model, "motor", pinion);
  load(model, "push", slider, {}, {-300.0, 0.0});
  take_phases(model);
  return model;
}

/// Sun 20 mm, planet 15 mm, fixed ring 50 mm; a moment of 10 N m brakes the arm.
inline Model planetary() {
  Model model;
  const int sun = add_wheel(model, "sun", {0.0, 0.0, 0.0});
  const int arm = add_bar(model, "arm", {0.0, 0.0, 0.5}, 0.035, 0.3);
  const int planet = add_wheel(model, "planet", {0.035 * std::cos(0.5), 0.035 * std::sin(0.5), 0.0});
  pin(model, "O", sun, {}, ground, {});
  pin(model, "H", arm, {}, ground, {});
  pin(model, "P", planet, {}, arm, {0.035, 0.0});
  mesh(model, JointKind::gear, sun, {}, 0.02, planet, {}, 0.015, 0.349);
  mesh(model, JointKind::gear, planet, {}, 0.015, ground, {}, -0.05, 0.349);
  drive_turning(model, "motor", sun);
  load(model, "brake", arm, {}, {}, -10.0);
  take_phases(model);
  return model;
}

/// A crank's pinion of 30 mm moves a rack that lies on a slide 30 mm above its axis.
inline Model pinion_and_rack() {
  Model model;
  const int pinion = add_wheel(model, "pinion", {0.0, 0.0, 0.2});
  const int rack = add_link(model, "rack", {0.01, 0.03, 0.0}, 3.0);
  pin(model, "O", pinion, {}, ground, {});
  slide(model, "guide", rack, {}, ground, {0.0, 0.03});
  mesh(model, JointKind::rack, pinion, {}, -0.03, rack, {}, 0.0, 0.349);
  drive_turning(model, "motor", pinion);
  load(model, "cut", rack, {0.0, 0.02}, {-100.0, 40.0});
  take_phases(model);
  return model;
}

/// A crank rolls a wheel of 50 mm to and fro on the ground by a rod.
inline Model rolling_wheel() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int crank = add_bar(model, "crank", {0.0, 0.05, 1.0}, 0.04, 1.0);
  const int rod = add_bar(model, "rod", {0.0216, 0.0837, -0.17}, 0.2, 1.5);
  const int wheel = add_wheel(model, "wheel", {0.2187, 0.05, 0.3});
  pin(model, "O", crank, {}, ground, {0.0, 0.05});
  pin(model, "A", rod, {}, crank, {0.04, 0.0});
  pin(model, "B", wheel, {}, rod, {0.2, 0.0});
  mesh(model, JointKind::rolling_on_line, wheel, {}, 0.05, ground, {}, 0.0);
  drive_turning(model, "motor", crank);
  load(model, "pull", wheel, {0.0, 0.02}, {-50.0, 0.0});
  take_phases(model);
  return model;
}

/// A wheel of 30 mm on an arm rolls on a fixed one of 50 mm, guided only by the contact and the rod to the arm.
inline Model rolling_on_wheel() {
  Model model;
  const int arm = add_bar(model, "arm", {0.0, 0.0, 0.3}, 0.06, 1.0);
  const int rod = add_bar(model, "rod", {0.06 * std::cos(0.3), 0.06 * std::sin(0.3), 0.9}, 0.03, 0.4);
  const int wheel = add_wheel(model, "wheel", {0.0716, 0.0358, 0.0});
  pin(model, "O", arm, {}, ground, {});
  pin(model, "A", rod, {}, arm, {0.06, 0.0});
  pin(model, "B", wheel, {}, rod, {0.03, 0.0});
  mesh(model, JointKind::rolling, wheel, {}, 0.03, ground, {}, 0.05);
  drive_turning(model, "motor", arm);
  load(model, "brake", wheel, {0.01, 0.0}, {20.0, -5.0}, 0.4);
  take_phases(model);
  return model;
}

/// Pulleys of 40 and 60 mm, the second on a rocker that a coupler moves; `crossed`: they turn in opposite senses.
inline Model belt_on_rocker(bool crossed, double tension = 0.0) {
  Model model = four_bar_without_load();
  const int pulley = add_wheel(model, "pulley", {0.4, 0.0, 0.0});
  const int wheel = add_wheel(model, "wheel", {0.4 + 0.3 * std::cos(1.8), 0.3 * std::sin(1.8), 0.0});
  pin(model, "P", pulley, {}, 2, {});
  pin(model, "Q", wheel, {}, 2, {0.3, 0.0});
  mesh(model, JointKind::belt, pulley, {}, 0.04, wheel, {}, crossed ? -0.06 : 0.06);
  model.joints.back().tension = tension;
  drive_turning(model, "spindle", pulley);
  load(model, "work", wheel, {}, {}, -3.0);
  take_phases(model);
  return model;
}

/// The four-bar with its coupler in two pieces.
inline Model welded_four_bar() {
  Model model = four_bar();
  const int end = add_bar(model, "end", {0.25, 0.17, 0.9}, 0.1, 0.5);
  Joint weld{.name = "weld", .kind = JointKind::rigid, .i = end, .j = 1, .point_i = {}, .point_j = {0.25, 0.0}};
  weld.angle = 0.4;
  model.joints.push_back(weld);
  load(model, "tip", end, {0.1, 0.0}, {30.0, -70.0});
  return model;
}

/// A mechanism of each joint type other than pin, slide or slot.
struct Case {
  const char* name;
  Model model;
};
inline std::vector<Case> cases() {
  std::vector<Case> all{{"gear train", gear_train(0.349)},
                        {"planetary", planetary()},
                        {"rack", pinion_and_rack()},
                        {"rolling wheel", rolling_wheel()},
                        {"rolling on a wheel", rolling_on_wheel()},
                        {"open belt", belt_on_rocker(false)},
                        {"tight belt", belt_on_rocker(false, 50.0)},
                        {"crossed belt", belt_on_rocker(true, 20.0)},
                        {"weld", welded_four_bar()}};
  for (CamCase& c : cam_cases()) all.push_back({c.name, std::move(c.model)});
  return all;
}

}  // namespace loadpath::mechanism::models
