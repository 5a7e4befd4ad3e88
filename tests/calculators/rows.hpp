// The rows of laws, limits and limit cases as steps that run, for the contract of the formulas.
#pragma once

#include <string>
#include <vector>

namespace loadpath::test {

/// The example of a calculator with other lines.
struct Run {
  std::string calculator;
  std::string lines;
};

std::vector<Run> runs_of_laws();
std::vector<Run> runs_of_limits();
std::vector<Run> runs_of_limit_cases();

}  // namespace loadpath::test
