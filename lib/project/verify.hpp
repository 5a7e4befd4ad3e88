// Reference cases: expectations of a project compared with its results.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// One line of the table of `verify`; numbers in SI, shown in the unit that the expectation was written in.
struct Comparison {
  const Expectation* expectation = nullptr;
  double ours = 0.0;       // NaN: not available
  double deviation = 0.0;  // relative; absolute, in the unit of the expectation, where it expects 0
  double allowed = 0.0;    // the same kind
  bool holds = false;
};

/// The project must be solved.
std::vector<Comparison> compare(const Project& project);

/// The largest deviation that `digits` significant digits of `value` leave: half a unit of the last.
double half_unit(double value, int digits);

}  // namespace loadpath::project
