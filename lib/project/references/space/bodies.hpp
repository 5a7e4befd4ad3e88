// What takes up space around the axis of a shaft: its segments, the gears on it, its bearings.
#pragma once

#include "lib/project/project.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// A cylinder around the axis of a shaft, between two positions along it, in metres.
struct Cylinder {
  enum class Kind { segment, gear, bearing };
  Kind kind;
  std::string path;  // of its position or size in the shaft: "seats.wheel.x", "pieces.collar.d"
  std::string name;  // for messages: "gear 2 of 'stage_1'"
  double from, to, D;
};

/// A gear of a cylindrical pair on a shaft.
struct GearOnShaft {
  std::string seat;     // "seats.wheel."
  std::string pair;     // step of the pair
  bool is_first;        // gear 1 of it
  double x, b, m_n, a;  // centre, rim width, module, centre distance
  double d_f;           // root circle
  bool has_angle;       // given in the file
  Cylinder body;
};

/// The gears of external gear.pair steps whose loads a shaft takes; sizes that are unknown are NaN.
std::vector<GearOnShaft> gears_on(const Step& shaft, const Project& project);
std::vector<Cylinder> segments_of(const Step& shaft, const Project& project);
/// The bearings of bearing.rolling that take their load from the shaft.
std::vector<Cylinder> bearings_of(const Step& shaft, const Project& project);

bool is_shaft(const Step& step);

}  // namespace loadpath::project
