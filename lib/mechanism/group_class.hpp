// Class, order and kind of an Assur group from its joints alone.
#pragma once

#include "lib/mechanism/assur.hpp"

namespace loadpath::mechanism {

/// Sets contour_class, order and kind from the group's links, joints and drivers.
///
/// Two replacements lead to the chain that is classed: a pin in a slot becomes a slider with a pin and a slide, and the
/// two links of a driven joint become one, for their place to each other is given. What is driven from the ground or
/// from an earlier group vanishes so: that is an initial link.
void classify(const Model& model, Group& group);

}  // namespace loadpath::mechanism
