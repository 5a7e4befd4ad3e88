// What parts are designed for: internal forces of links, edges of guides, teeth, rolling contacts, springs, losses.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::planar {

void add_design_outputs(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out);
void list_design_patterns(std::vector<ResultPattern>& patterns);

/// Links that are said to be uniform bars and are not. Needs values.
std::vector<FieldFault> check_mass_lines(const Mechanism::Input& in, const mechanism::Model& model);

/// The power that a joint with friction takes, W.
double loss_of(const mechanism::Model& model, std::size_t joint, const mechanism::Position& at);

}  // namespace loadpath::planar
