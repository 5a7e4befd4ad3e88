// Bars that the tests of the columns share.
#pragma once

#include "calculators/catalogue.hpp"
#include "calculators/column/buckling.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::tests {

using test::rel;

/// The bar of [B25]: 40 mm by 60 mm, 1.8 m, of St37.
inline column::Buckling::Input bar_of_steel(column::Ends ends) {
  column::Buckling::Input in;
  in.l = 1.8 * m;
  in.b = 40.0 * mm;
  in.h = 60.0 * mm;
  in.ends = ends;
  in.E = 210.0 * GPa;
  in.R_e = 235.0 * MPa;
  in.a_T = 310.0 * MPa;
  in.b_T = 1.14 * MPa;
  in.lambda_0 = 60.0;
  in.lambda_1 = 105.0;
  in.n_st = 2.0;
  in.lambda_max = 1000.0;
  return in;
}

inline column::Buckling::Result solve(const column::Buckling::Input& in) {
  return test::evaluated<column::Buckling>(in);
}

inline const column::MethodResult& by(const column::Buckling::Result& r, std::string_view name) {
  static const column::MethodResult none;
  for (const auto& method : r.methods) {
    if (method.name.view() == name) return method;
  }
  return none;
}

inline project::Project solved(const std::string& text, std::vector<Issue>& issues) {
  project::Project p = project::read_project(text, "case.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(p, issues);
  return p;
}

/// The errors of a step of these lines, in words: one line for each issue.
inline std::string complaints(const std::string& lines) {
  std::vector<Issue> issues;
  static_cast<void>(solved("[bar]\n" + lines, issues));
  std::string all;
  for (const Issue& issue : issues) all += issue.key + ": " + issue.message.text() + "\n";
  return all;
}

}  // namespace loadpath::tests
