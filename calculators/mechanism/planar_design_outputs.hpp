// What parts are designed for: internal forces of links, edges of guides, teeth, rolling contacts, springs, losses.
#pragma once

#include "calculators/mechanism/planar_outputs.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath {

void add_design_outputs(const PlanarMechanism::Input& in, const mechanism::Model& model,
                        std::vector<MechanismOutput>& out);
void list_design_patterns(std::vector<ResultPattern>& patterns);

/// Links that are said to be uniform bars and are not. Needs values.
std::vector<FieldFault> check_mass_lines(const PlanarMechanism::Input& in, const mechanism::Model& model);

/// The power that a joint with friction takes, W.
double loss_of(const mechanism::Model& model, std::size_t joint, const mechanism::Position& at);

}  // namespace loadpath
