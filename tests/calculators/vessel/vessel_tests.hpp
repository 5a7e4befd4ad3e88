// What the tests of the vessels share.
#pragma once

#include "calculators/catalogue.hpp"
#include "calculators/vessel/wall.hpp"
#include "lib/project/project.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace loadpath::tests {

inline double rel(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }

template <class C>
typename C::Result solve(const typename C::Input& in) {
  NoTrace trace;
  return C::evaluate(in, trace);
}

/// The messages of a step that is not right, with their hints, in one text.
inline std::string messages(const std::string& step) {
  std::vector<Issue> issues;
  project::Project p = project::read_project("[v]\n" + step, "case.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(p, issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + "; " + i.hint.text() + "\n";
  return all;
}

inline bool says(const std::string& step, const std::string& words) {
  return messages(step).find(words) != std::string::npos;
}

}  // namespace loadpath::tests
