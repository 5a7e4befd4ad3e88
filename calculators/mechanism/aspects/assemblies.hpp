// The assemblies of a planar mechanism in a project: chosen by the names of their sides, listed, and whether the one
// that is followed is kept over the cycle.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/cycle/kinematics.hpp"
#include "lib/account/account.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// Puts the links of the model where the assembly has them whose sides are named; the other sides as stated. Nothing
/// changes, and faults say why, where there is no such assembly. The model has passed mechanism::diagnose, which gave
/// the structure.
std::vector<FieldFault> choose_assembly(const Mechanism::Input& in, const mechanism::Structure& structure,
                                        mechanism::Model& model);

/// Said only where a group passes to another of its assemblies, and no joint that holds too much keeps it from that: at
/// the change point the drive alone does not tell which way the mechanism goes on.
std::vector<account::Verdict> changes_of_assembly(const std::string& step, const mechanism::Model& model,
                                                  const Cycle& cycle, const Kinematics& kinematics, const Axis* axis);

/// Assemblies at the first position, transmission angles, strokes, instantaneous centres at the first position.
std::vector<account::Block> motion_tables(const account::Account& account, const mechanism::Model& model,
                                          const Cycle& cycle, const Kinematics& kinematics, const Axis* axis);

}  // namespace loadpath::planar
