// What a designer asks about a cam and its follower at a solved position.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <optional>

namespace loadpath::mechanism {

struct CamState {
  double pressing = 0.0;  // N, that the cam pushes the follower with; negative: it would have to pull
  double sliding = 0.0;  // m/s, of the follower on the cam, counter-clockwise round it; a roller's surface stands still
  /// Between the normal of the contact and the path of the follower's point, rad, 0 to pi/2; none where no pin or slide
  /// of the follower tells that path.
  std::optional<double> pressure_angle;
};

/// Of a joint of the kind cam.
CamState cam_state(const Model& model, std::size_t joint, const Position& at);

/// The joint that tells the path of a follower: its slide or pivot, on the ground if it has one there.
std::optional<std::size_t> guide_of(const Model& model, std::size_t joint);

}  // namespace loadpath::mechanism
