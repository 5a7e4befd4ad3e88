// Conversions that a product makes twice, or not at all: 2*pi times an angular velocity, a diameter for a radius.
#pragma once

#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/tree.hpp"

namespace loadpath::expression {

/// The first product of the tree with such a conversion; a Fault without a message if there is none. `of`: the kinds of
/// references. Only whole products are looked at, and the terms of sums: a part of one may go on to something else.
Fault wrong_conversion(const Tree& tree, const Expression::KindOf& of, const Declared& declared);

}  // namespace loadpath::expression
