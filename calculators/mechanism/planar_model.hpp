// From the words of a project to the solver's model: names become indices, points become vectors.
#pragma once

#include "calculators/mechanism/planar.hpp"
#include "lib/mechanism/whole/system.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath {

using ModelFault = FieldFault;

/// Names that do not exist, points that are not on their link, doubtful alternatives. Needs no values.
std::vector<ModelFault> check_names(const PlanarMechanism::Input& in);

/// Pins that two drawn links show at different places. Needs values.
std::vector<ModelFault> check_drawing(const PlanarMechanism::Input& in, const mechanism::Model& model);

/// The model; `in` has passed check_names. Links without a stated pose are placed as drawn, or by their joints.
mechanism::Model model_of(const PlanarMechanism::Input& in);

/// The names of a joint's point on its two links: as written, else the joint's own name.
std::pair<Name, Name> point_names(const PlanarMechanism::Joint& joint);

/// The index of a link, or mechanism::ground.
int link_index(const PlanarMechanism::Input& in, const Name& name);
/// The point of a link in the link's axes; nullptr where it has none of that name.
const PlanarMechanism::Point* find_point(const PlanarMechanism::Input& in, int link, const Name& name);
mechanism::Vec vector_of(const PlanarMechanism::Point& point);

/// A moving point that results are given for. A pin is one point of all its links; other points belong to one link.
struct TracedPoint {
  std::string name;
  int link = 0;
  mechanism::Vec at;  // link frame
};
std::vector<TracedPoint> traced_points(const PlanarMechanism::Input& in);

}  // namespace loadpath
