// A planar mechanism in SI units: links, joints, drivers and loads. Angles in rad, moments positive counter-clockwise.
#pragma once

#include "lib/mechanism/vec.hpp"

#include <string>
#include <vector>

namespace loadpath::mechanism {

/// The fixed link. Its frame is the global frame.
inline constexpr int ground = -1;

/// Where a link's own frame lies in the global one; also its rates of change.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double phi = 0.0;
};

struct Link {
  std::string name;
  double mass = 0.0;     // kg
  double inertia = 0.0;  // kg m^2, about the mass centre
  Vec centre;            // mass centre, link frame
  Pose pose;             // the stated assembly, near which the mechanism is closed
};

enum class JointKind { revolute, prismatic, slot };

/// Of the three freedoms between two links, how many a joint takes away.
constexpr int constraint_count(JointKind kind) { return kind == JointKind::slot ? 1 : 2; }

/// A joint between link i and link j. Revolute: point_i and point_j coincide. Slot: the pin point_i of link i lies on
/// the line of link j through point_j at `direction`; it may turn. Prismatic: the same, and phi_i - phi_j = `angle`.
struct Joint {
  std::string name;
  JointKind kind = JointKind::revolute;
  int i = ground;
  int j = ground;
  Vec point_i;             // frame of i
  Vec point_j;             // frame of j
  double direction = 0.0;  // of the line, frame of j
  double angle = 0.0;      // prismatic only
};

/// Rotary: coordinate = phi_i - phi_j + offset. Linear, on a prismatic or slot joint: coordinate = distance of point_i
/// from point_j along the line, + offset. The effort (moment or force) is what the drive does to link i; it does the
/// opposite to link j. Power = effort * speed.
struct Driver {
  enum class Kind { rotary, linear };
  std::string name;
  Kind kind = Kind::rotary;
  int i = ground;
  int j = ground;
  int joint = -1;  // index into joints, linear only
  double offset = 0.0;
};

struct Load {
  std::string name;
  int link = 0;
  Vec point;                     // link frame
  Vec force;                     // N
  bool turns_with_link = false;  // true: force in the link's axes; false: in the global ones
  double moment = 0.0;           // N m
};

/// The force in global axes, on a link that is turned by this.
inline Vec global_force(const Load& load, const Turn& turned) {
  return load.turns_with_link ? turned(load.force) : load.force;
}

struct Model {
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Driver> drivers;
  std::vector<Load> loads;
  Vec gravity;  // m/s^2, (0, -9.81) for gravity downward
};

}  // namespace loadpath::mechanism
