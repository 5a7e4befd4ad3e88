// A planar mechanism in SI units: links, joints, drivers and loads. Angles in rad, moments positive
// counter-clockwise. Templates on the scalar: results can be differentiated by the numbers of a model.
#pragma once

#include "lib/mechanism/model/profile.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <memory>
#include <string>
#include <vector>

namespace loadpath::mechanism {

/// The fixed link. Its frame is the global frame.
inline constexpr int ground = -1;

/// The pose of a link's own frame in the global one; also its rates of change.
template <class Scalar>
struct BasicPose {
  Scalar x = 0.0;
  Scalar y = 0.0;
  Scalar phi = 0.0;
};
using Pose = BasicPose<double>;

template <class Scalar>
struct BasicLink {
  std::string name;
  Scalar mass = 0.0;        // kg
  Scalar inertia = 0.0;     // kg m^2, about the mass centre
  BasicVec<Scalar> centre;  // mass centre, link frame
  BasicPose<Scalar> pose;   // the stated assembly, near which the mechanism is closed
};
using Link = BasicLink<double>;

/// `none`: the rest of a joint whose constraints are all released (release.hpp).
enum class JointKind { revolute, prismatic, slot, rigid, gear, rack, belt, rolling, rolling_on_line, cam, none };

/// The number of degrees of freedom, of three between two links, that a joint removes.
constexpr int constraint_count(JointKind kind) {
  switch (kind) {
    case JointKind::rigid:
      return 3;
    case JointKind::revolute:
    case JointKind::prismatic:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      return 2;
    case JointKind::slot:
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt:
    case JointKind::cam:
      return 1;
    case JointKind::none:
      return 0;
  }
  return 0;
}

/// The contact element of link i on a cam: a roller or a rounded edge about a point, or a flat face.
enum class CamContact { round, flat };

/// Resistance to the motion of a joint. Dry friction depends on the joint's force: in a pin by its radius, in a slide
/// by the two edges that carry the slider (`Joint::guide_length`), in rolling by the lever arm of the resistance.
template <class Scalar>
struct BasicFriction {
  Scalar coefficient = 0.0;
  Scalar pin_radius = 0.0;   // m: revolute, slot
  Scalar rolling_arm = 0.0;  // m: rolling
  Scalar viscous = 0.0;      // N m s, or N s/m in a slide
  Scalar loss = 0.0;         // teeth, belts: part of the power that passes from link i to link j, 1 - efficiency
  Scalar loss_back = 0.0;    // the same from link j to link i; beyond 1 if nothing is transmitted
  /// Mixed friction (forces/mixed_friction.hpp): the coefficient at rest is (1 + rise) times that of fast sliding.
  double rise = 0.0;
  double stribeck_speed = 0.0;  // m/s; with a rise
  double stribeck_exponent = 2.0;
  /// Whether there is some that goes with the joint's force, and has its sense even at rest.
  [[nodiscard]] bool dry() const { return coefficient > 0.0 || rolling_arm > 0.0 || loss > 0.0 || loss_back > 0.0; }
  [[nodiscard]] bool any() const { return dry() || viscous > 0.0; }
};
using Friction = BasicFriction<double>;

/// A joint between link i and link j.
/// - Revolute: point_i and point_j coincide. Slot: the pin point_i of link i is on the line of link j through point_j
///   at `direction`; it may rotate. Prismatic: the same, and phi_i - phi_j = `angle`. Rigid: revolute, and the angle.
/// - Wheels with centres at point_i and point_j that roll on each other: a gear imposes only that (other joints fix
///   its centres), rolling fixes the contact too. An internal ring has a negative radius. A belt, or chain, couples
///   wheels at a distance; crossed, one radius is negative.
/// - Rack and rolling on a line: wheel i on the line of j through point_j at `direction`, at a distance of radius_i
///   on the side on which it is assembled.
/// The constant of rolling, `phase`, is as in the stated assembly (set_phase).
/// - Cam: link i touches the profile of link j, whose axis is point_j and which is rotated by `direction`. Round: it
///   has a roller about point_i, or an edge, radius_i = 0; the spin of the roller is not a coordinate. Flat: it has a
///   face through point_i in the direction `angle` of the frame of i, with the cam to its right.
template <class Scalar>
struct BasicJoint {
  std::string name;
  JointKind kind = JointKind::revolute;
  int i = ground;
  int j = ground;
  BasicVec<Scalar> point_i;  // frame of i
  BasicVec<Scalar> point_j;  // frame of j
  Scalar direction = 0.0;    // direction of the line or the profile, frame of j
  Scalar angle = 0.0;        // prismatic and rigid; of a flat face, frame of i
  Scalar radius_i = 0.0;     // m, of wheels; on a line negative on its right side
  Scalar radius_j = 0.0;
  Scalar pressure_angle = 0.0;  // pressure angle of teeth, rad: gear and rack
  Scalar tension = 0.0;         // N, of the slack side of a belt
  Scalar guide_length = 0.0;    // m, of the block about point_i: prismatic
  Scalar guide_width = 0.0;     // m, between the faces that the block rests on: prismatic
  BasicFriction<Scalar> friction = {};
  Scalar phase = 0.0;  // m
  CamContact contact = CamContact::round;
  std::shared_ptr<const Profile> profile = nullptr;  // cam: in m, independent of the unit of length of the model
  Scalar metre = 1.0;                                // in that unit
};
using Joint = BasicJoint<double>;

enum class DriverKind { rotary, linear };

/// Rotary: coordinate = phi_i - phi_j + offset. Linear, on a prismatic or slot joint: coordinate = distance of
/// point_i from point_j along the line, + offset. The effort (moment or force) acts on link i, and its opposite on
/// link j. Power = effort * speed.
template <class Scalar>
struct BasicDriver {
  using Kind = DriverKind;
  std::string name;
  Kind kind = Kind::rotary;
  int i = ground;
  int j = ground;
  int joint = -1;  // index into joints, linear only
  Scalar offset = 0.0;
};
using Driver = BasicDriver<double>;

template <class Scalar>
struct BasicLoad {
  std::string name;
  int link = 0;
  BasicVec<Scalar> point;        // link frame
  BasicVec<Scalar> force;        // N
  bool turns_with_link = false;  // true: force in the link's axes; false: in the global ones
  Scalar moment = 0.0;           // N m
};
using Load = BasicLoad<double>;

/// The force in global axes of a load given in its own axes, on a link with this rotation.
template <class Scalar>
BasicVec<Scalar> global_force(const BasicLoad<Scalar>& load, BasicVec<Scalar> own, const BasicTurn<Scalar>& turned) {
  return load.turns_with_link ? turned(own) : own;
}

enum class SpringKind { linear, turning };

/// A spring with a damper between link i and link j: from point to point, or, turning, between the links' angles.
template <class Scalar>
struct BasicSpring {
  using Kind = SpringKind;
  std::string name;
  Kind kind = Kind::linear;
  int i = ground;
  int j = ground;
  BasicVec<Scalar> point_i;  // frame of i
  BasicVec<Scalar> point_j;  // frame of j
  Scalar rate = 0.0;         // N/m or N m/rad
  Scalar free = 0.0;         // free length, m; turning: phi_i - phi_j without moment, rad
  Scalar damping = 0.0;      // N s/m or N m s/rad
};
using Spring = BasicSpring<double>;

template <class Scalar>
struct BasicModel {
  std::vector<BasicLink<Scalar>> links;
  std::vector<BasicJoint<Scalar>> joints;
  std::vector<BasicDriver<Scalar>> drivers;
  std::vector<BasicLoad<Scalar>> loads;
  std::vector<BasicSpring<Scalar>> springs;
  BasicVec<Scalar> gravity;  // m/s^2, (0, -9.81) for gravity downward
};
using Model = BasicModel<double>;

}  // namespace loadpath::mechanism
