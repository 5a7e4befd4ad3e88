// Rotating bending: stresses that reverse with each revolution (lib/calculator/meaning.hpp).
#pragma once

#include "lib/project/project.hpp"

#include <optional>

namespace loadpath::project {

/// Message for an input that uses such a stress as a mean stress, or as one end of a cycle that is not symmetric.
std::optional<Message> turning_message(const Step& step, const Operand& operand, const Project& project);

}  // namespace loadpath::project
