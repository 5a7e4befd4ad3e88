// Class, order and kind of an Assur group from its joints alone.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/structure/group.hpp"

namespace loadpath::mechanism {

/// Sets contour_class, order and kind from the group's links, joints and drivers.
///
/// Replacements lead to the chain that is classed: a joint with one constraint becomes a link with two joints, as a pin
/// in a slot a slider with a pin and a slide, and teeth a link with two pins; the two links of a driven or a rigid
/// joint become one, for their place to each other is given. What is driven from the ground or from an earlier group
/// vanishes so: that is an initial link.
void classify(const Model& model, Group& group);

}  // namespace loadpath::mechanism
