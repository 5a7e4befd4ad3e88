// Mechanisms with cams that several tests use.
#pragma once

#include "lib/mechanism/model/pair.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace loadpath::mechanism::models {

inline constexpr double quarter_turn = 0.5 * std::numbers::pi;

inline Joint& touch(Model& model, int follower, Vec point, int cam, Profile profile, CamContact contact, double radius,
                    double direction = quarter_turn) {
  Joint joint{.name = "contact", .kind = JointKind::cam, .i = follower, .j = cam, .point_i = point, .point_j = {}};
  joint.direction = direction;
  joint.radius_i = radius;
  joint.contact = contact;
  joint.profile = std::make_shared<const Profile>(std::move(profile));
  model.joints.push_back(joint);
  return model.joints.back();
}

/// Rise over 120 degrees, dwell, fall over 150 degrees.
inline Lift rise_dwell_fall(LiftLaw law, double rise) {
  const double per_degree = std::numbers::pi / 180.0;
  return Lift(std::vector<LiftSegment>{{law, 120.0 * per_degree, rise},
                                       {LiftLaw::dwell, 40.0 * per_degree, 0.0},
                                       {law, 150.0 * per_degree, -rise},
                                       {LiftLaw::dwell, 50.0 * per_degree, 0.0}});
}

inline int add_cam(Model& model, double angle) {
  model.gravity = {0.0, -9.81};
  const int cam = add_link(model, "cam", {0.0, 0.0, angle}, 1.5, 0.002, {0.004, 0.003});
  pin(model, "O", cam, {}, ground, {});
  drive_turning(model, "motor", cam);
  return cam;
}

/// A follower of 0.8 kg on a guide along y, `offset` to the left of the cam's axis, pressed down.
inline int add_follower(Model& model, double offset, double height) {
  const int follower = add_link(model, "follower", {-offset, height, 0.0}, 0.8);
  slide(model, "guide", follower, {}, ground, {-offset, 0.0}, quarter_turn);
  load(model, "press", follower, {0.003, 0.05}, {15.0, -400.0});
  return follower;
}

/// A roller of 10 mm on a cam with a base circle of 30 mm, which lifts it by 12 mm.
inline Model cam_with_roller(LiftLaw law = LiftLaw::polynomial_4567, double offset = 0.006,
                             CamSense sense = CamSense::counter_clockwise) {
  Model model;
  const int cam = add_cam(model, 0.7);
  const int follower = add_follower(model, offset, 0.043);
  touch(model, follower, {}, cam, Profile(SlidingFollower{rise_dwell_fall(law, 0.012), sense, 0.04, offset}, 0.01),
        CamContact::round, 0.01);
  return model;
}

/// An arm of 60 mm with a roller of 8 mm, its pivot 70 mm to the right of the cam's axis.
inline Model cam_with_arm() {
  Model model;
  const int cam = add_cam(model, 0.5);
  const SwingingFollower path{
      rise_dwell_fall(LiftLaw::polynomial_4567, 0.3), CamSense::counter_clockwise, 0.038, 0.07, 0.06, 1.0};
  const int arm = add_bar(model, "arm", {0.07, 0.0, std::numbers::pi - path.base_angle() - 0.05}, 0.06, 0.3);
  pin(model, "A", arm, {}, ground, {0.07, 0.0});
  load(model, "press", arm, {0.05, 0.0}, {-20.0, -300.0}, 2.0);
  touch(model, arm, {0.06, 0.0}, cam, Profile(path, 0.008), CamContact::round, 0.008, 0.0);
  return model;
}

/// An arm whose frame's x axis runs along a flat face, but for the offset of that; `cam_angle` as stated.
inline int add_face(Model& model, const SwingingFace& face, int cam, double cam_angle, double length) {
  const double angle = face.sense == CamSense::clockwise ? -cam_angle : cam_angle;
  const double swing = face.base_angle() + face.lift.at(angle).s;
  const Pose pose{face.pivot, 0.0, std::numbers::pi - face.side * swing};
  const int arm = add_bar(model, "arm", pose, length, 0.3);
  pin(model, "A", arm, {}, ground, {face.pivot, 0.0});
  touch(model, arm, {0.0, face.side * face.offset}, cam, Profile(face), CamContact::flat, 0.0, 0.0).angle =
      face.side > 0.0 ? std::numbers::pi : 0.0;  // with the cam to its right
  return arm;
}

/// A flat face that swings about a pivot 70 mm to the right of the cam's axis, 4 mm before it.
inline Model cam_with_swinging_face() {
  Model model;
  const int cam = add_cam(model, 0.5);
  const SwingingFace face{
      rise_dwell_fall(LiftLaw::modified_sine, 0.3), CamSense::counter_clockwise, 0.03, 0.07, 0.004, 1.0};
  const int arm = add_face(model, face, cam, 0.5, 0.06);
  load(model, "press", arm, {0.05, 0.0}, {-20.0, -300.0}, 2.0);
  return model;
}

/// A flat face square to its guide.
inline Model cam_with_flat_face(LiftLaw law = LiftLaw::polynomial_4567) {
  Model model;
  const int cam = add_cam(model, 0.6);
  const int follower = add_follower(model, 0.01, 0.034);
  touch(model, follower, {}, cam, Profile(FlatFollower{rise_dwell_fall(law, 0.008), {}, 0.03}), CamContact::flat, 0.0);
  return model;
}

/// Points of an oval, evenly spread by its angle.
inline std::vector<Vec> oval_points(int count, double a, double b, Vec centre) {
  std::vector<Vec> points;
  for (int k = 0; k < count; ++k) {
    const double t = 4.0 * quarter_turn * k / count;
    points.push_back(centre + Vec{a * std::cos(t), b * std::sin(t)});
  }
  return points;
}

/// A flat face on a swinging arm, on an oval through points.
inline Model oval_with_flat_arm() {
  Model model;
  const int cam = add_cam(model, 0.4);
  const int arm = add_bar(model, "arm", {-0.05, 0.0, 0.6}, 0.1, 0.4);
  pin(model, "A", arm, {}, ground, {-0.05, 0.0});
  load(model, "press", arm, {0.09, 0.0}, {10.0, -200.0});
  touch(model, arm, {0.0, -0.004}, cam, Profile(SplineCurve(oval_points(24, 0.03, 0.025, {0.004, 0.0}))),
        CamContact::flat, 0.0, 0.2);
  return model;
}

/// An edge on a cam carried by a moving link, with a follower that slides on that link.
inline Model cam_on_a_moving_link() {
  Model model = four_bar_without_load();
  const int coupler = 1;
  const int cam = add_link(model, "cam", {0.0, 0.0, 0.3}, 0.5, 0.001);
  model.links.back().pose = {0.054 + 0.1 * std::cos(0.5), 0.084 + 0.1 * std::sin(0.5), 0.3};
  pin(model, "C", cam, {}, coupler, {0.1, 0.0});
  drive_turning(model, "second motor", cam, coupler);
  const int follower = add_link(model, "follower", {0.0, 0.0, 0.5}, 0.2, 0.0003, {0.0, 0.01});
  const Vec seat = Vec{0.054, 0.084} + turn(0.5)({0.1, 0.036});
  model.links.back().pose = {seat.x, seat.y, 0.5};
  slide(model, "guide", follower, {}, coupler, {0.1, 0.0}, quarter_turn, 0.0);
  load(model, "press", follower, {}, {5.0, -80.0});
  touch(model, follower, {}, cam, Profile(SplineCurve(oval_points(24, 0.036, 0.03, {0.003, 0.002}))), CamContact::round,
        0.0, 0.4);
  return model;
}

struct CamCase {
  const char* name;
  Model model;
};
inline std::vector<CamCase> cam_cases() {
  return {{"roller", cam_with_roller()},
          {"roller, the cam turns clockwise", cam_with_roller(LiftLaw::polynomial_4567, 0.004, CamSense::clockwise)},
          {"arm", cam_with_arm()},
          {"flat face", cam_with_flat_face()},
          {"swinging face", cam_with_swinging_face()},
          {"flat arm on an oval", oval_with_flat_arm()},
          {"edge on a moving link", cam_on_a_moving_link()}};
}

}  // namespace loadpath::mechanism::models
