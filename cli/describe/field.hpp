// One input, result or failure mode of a calculator: unit, bounds, where its value comes from, what uses it.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <string>

namespace loadpath::cli {

/// `name`: a key, or a path as "torques.x"; of a template its parameter. False where nothing has that name.
bool show_field(const Calculator& calculator, const std::string& name);

/// What was meant by a name that is none; the exit code.
int refuse_field(const Calculator& calculator, const std::string& name);

}  // namespace loadpath::cli
