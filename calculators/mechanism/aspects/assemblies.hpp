// The assembly of a planar mechanism that a project chooses by the names of its sides.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::planar {

/// Puts the links of the model where the assembly has them whose sides are named; the other sides as stated. Nothing
/// changes, and faults say why, where there is no such assembly. The model has passed mechanism::diagnose, which gave
/// the structure.
std::vector<FieldFault> choose_assembly(const Mechanism::Input& in, const mechanism::Structure& structure,
                                        mechanism::Model& model);

}  // namespace loadpath::planar
