// The points of links: by which names joints and results know them, and where they are.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <string>
#include <utility>
#include <vector>

namespace loadpath::planar {

/// The names of a joint's point on its two links: as written, else the joint's own name.
std::pair<Name, Name> point_names(const planar::Joint& joint);

mechanism::Vec vector_of(const planar::Point& point);

/// The points of a link at which it has joints, each once.
std::vector<Name> joint_points(const Mechanism::Input& in, const Name& link);

/// Whether its points are given as they lie on paper: it has neither an origin nor an angle of its own.
bool is_drawn(const planar::Link& link);

/// A moving point that results are given for. A pin is one point of all its links; other points belong to one link.
struct TracedPoint {
  std::string name;
  int link = 0;
  mechanism::Vec at;  // link frame
};
std::vector<TracedPoint> traced_points(const Mechanism::Input& in);

}  // namespace loadpath::planar
