// Helpers for the tests of vessels.
#pragma once

#include "calculators/catalogue.hpp"
#include "calculators/vessel/wall.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace loadpath::tests {

using test::rel;

template <class C>
constexpr auto solve = test::evaluated<C>;

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
