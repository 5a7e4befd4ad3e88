// Results for the designer of a cam and its follower at a solved position.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <optional>

namespace loadpath::mechanism {

struct CamState {
  double pressing = 0.0;  // contact force, N, of the cam on the follower; negative: contact would be lost
  double sliding = 0.0;   // m/s, of the follower on the cam, counter-clockwise round it; 0 for a roller's surface
  /// The angle between the normal of the contact and the path of the follower's point, rad, 0 to pi/2; none if no pin
  /// or slide of the follower determines that path.
  std::optional<double> pressure_angle;
};

/// For a joint of the kind cam.
CamState cam_state(const Model& model, std::size_t joint, const Position& at);

/// The joint that determines the path of a follower: its slide or pivot, on the ground if it has one there.
std::optional<std::size_t> guide_of(const Model& model, std::size_t joint);

}  // namespace loadpath::mechanism
