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

/// What is wrong with a part; nothing where it is whole.
std::optional<FieldFault> fault_of(const BuiltUpTypes::Part& part);

/// The shape that a whole part has, or that its row of a table stands for.
BuiltUpTypes::Part as_shape(const BuiltUpTypes::Part& part);

/// Of a part that is whole.
Shaped shaped(const BuiltUpTypes::Part& part);
/// For drawing, in the same axes.
Contours contours(const BuiltUpTypes::Part& part);

}  // namespace loadpath::section
