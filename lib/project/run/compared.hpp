// Values compared by checks: the demand and the capacity whose ratio is a utilisation, if the formula of the check is
// one value over another.
#pragma once

#include "lib/project/run/evaluation/results.hpp"

#include <map>
#include <string>

namespace loadpath::project {

/// By the path of the check: "u_tau", "segments[2].u_tau".
using ComparedValues = std::map<std::string, account::Compared>;

/// Compares for every check, at the position of its maximum. Moves the evaluation.
ComparedValues compare_checks(Evaluation& evaluation, const Results& results);

}  // namespace loadpath::project
