// Joints from the words of a project to those of the solver: which fields each type takes, and what becomes of them.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::planar {

/// Fields that the type of the joint needs and has not, or has and does not take.
std::vector<FieldFault> check_fields(const planar::Joint& joint);

/// All but links and points; the angle may be unset, to be taken as assembled.
mechanism::Joint joint_values(const planar::Joint& joint);

/// The radii of wheels, and what resists in joints; only where there are such.
std::vector<account::Table> detail_tables(const Mechanism::Input& in);

/// Sets values from the assembly, once all links are placed and the drives are known: angles that are not given, the
/// side of wheels on lines and of flat faces on cams, the phases of wheels.
void take_from_assembly(mechanism::Model& model);

}  // namespace loadpath::planar
