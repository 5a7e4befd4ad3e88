// How a point of a link moves at a solved position.
#pragma once

#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/model/vec.hpp"

namespace loadpath::planar {

/// Global place, velocity and acceleration of a point of a link.
struct PointMotion {
  mechanism::Vec place, velocity, acceleration;
};
PointMotion motion_of(const mechanism::Position& p, int link, mechanism::Vec at);
/// Only its place.
inline mechanism::Vec on_paper(const mechanism::Position& p, int link, mechanism::Vec at) {
  return motion_of(p, link, at).place;
}

/// Angle of a link's axes; 0 for the ground.
double angle_of(const mechanism::Position& p, int link);

}  // namespace loadpath::planar
