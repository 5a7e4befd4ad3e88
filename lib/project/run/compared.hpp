// Values compared by checks: the demand and the capacity whose ratio is a utilisation, if the formula of the check is
// one value over another.
#pragma once

#include "lib/project/run/evaluation/results.hpp"

#include <map>
#include <string>

namespace loadpath::project {

/// By the path of the check: "u_tau", "segments[2].u_tau".
using ComparedValues = std::map<std::string, account::Compared>;

/// The largest values of checks that are nearest to one position, by their paths.
using Checks = std::map<std::string, double>;
std::map<std::size_t, Checks> checks_by_position(const Evaluation& evaluation, const Results& results);

/// Compares in the lines of the calculation at the present position of the evaluation.
void add_compared(const Trace& trace, const Evaluation& evaluation, const Checks& checks, ComparedValues& compared);

}  // namespace loadpath::project
