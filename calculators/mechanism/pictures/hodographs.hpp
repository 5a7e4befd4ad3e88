// Hodographs of joint forces: the end of the force over the cycle, on either part and in fixed axes.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/words/names.hpp"
#include "lib/account/block.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::planar {

/// Joints that do not exist or are named twice. Needs no values.
void check_hodographs(NameFaults& faults);

/// Of the joints that the project names, else of the three pins with the largest forces. A joint without a force, or
/// whose force is not unique, has none.
std::vector<draw::Figure> hodograph_figures(const Mechanism::Input& in, const mechanism::Model& model,
                                            const Cycle& cycle, const Axis& axis);

/// What is to be said of those that the project names and that have none; `axis` is null where there is one position.
std::vector<account::Paragraph> missing_hodographs(const Mechanism::Input& in, const Cycle& cycle, const Axis* axis);

}  // namespace loadpath::planar
