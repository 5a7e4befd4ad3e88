// All that the program knows of a calculator: every field, rule, result, failure mode and source, and its example.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli {

/// What assesses a failure mode, or what to do so that something does.
std::string assessor_of(const ModeInfo& mode);

void show_in_full(const Calculator& calculator);

/// The parts that can be requested separately: "inputs", "modes".
std::vector<std::string> part_names();
/// False where there is no part of that name.
bool show_part(const Calculator& calculator, std::string_view name);

}  // namespace loadpath::cli
