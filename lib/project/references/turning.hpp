// The bending of a shaft that turns: its stress reverses with each turn (lib/calculator/meaning.hpp).
#pragma once

#include "lib/project/project.hpp"

#include <optional>

namespace loadpath::project {

/// What is wrong with an input that takes such a stress as a part of a cycle that stays, or as one end of a cycle that
/// is not symmetric to it.
std::optional<Message> turning_message(const Step& step, const Operand& operand, const Project& project);

}  // namespace loadpath::project
