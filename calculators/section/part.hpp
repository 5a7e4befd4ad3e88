// A part of a built-up section before it is put to its place: what its own calculator or its row of a table says of it.
#pragma once

#include "calculators/section/built_up_types.hpp"
#include "lib/text/issue.hpp"

#include <optional>

namespace loadpath::section {

/// In the axes of its own sketch.
struct Shaped {
  Properties own;
  Extremes extremes;
};

/// Error of a part; none if it is complete.
std::optional<FieldFault> fault_of(const BuiltUpTypes::Part& part);

/// The shape of a complete part, or of its row of a table.
BuiltUpTypes::Part as_shape(const BuiltUpTypes::Part& part);

/// Properties of a complete part.
Shaped shaped(const BuiltUpTypes::Part& part);
/// For drawing, in the same axes.
Contours contours(const BuiltUpTypes::Part& part);

}  // namespace loadpath::section
