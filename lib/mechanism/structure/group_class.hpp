// Class, order and kind of an Assur group, derived from its joints.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/structure/group.hpp"

namespace loadpath::mechanism {

/// Sets contour_class, order and kind from the group's links, joints and drivers.
///
/// Replacements lead to the chain that is classified: a joint with one constraint becomes a link with two joints, a
/// pin in a slot becomes a slider with a pin and a slide, and teeth a link with two pins; the two links of a driven
/// or a rigid joint become one, because their relative position is given. Members driven from the ground or from an
/// earlier group thereby vanish: that is an initial link.
void classify(const Model& model, Group& group);

}  // namespace loadpath::mechanism
