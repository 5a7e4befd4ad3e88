// Helpers for the tests of the contract: the calculators, and their examples solved.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace loadpath::test {

/// The calculators of this run that are one function from a record to a record.
inline std::vector<const Calculator*> plain_calculators() {
  std::vector<const Calculator*> plain;
  for (const Calculator* c : calculators_taken()) {
    if (c->evaluate != nullptr) plain.push_back(c);
  }
  return plain;
}

inline project::Project example_of(const Calculator& c, std::vector<Issue>& issues) {
  return project::read_project(c.example, "example.toml", catalogue(), issues);
}

/// The input and result of a calculator's example.
struct SolvedExample {
  Record input, result;
  std::vector<std::shared_ptr<const Axis>> axes;  // of the series in the input
};

inline SolvedExample solved_example(const Calculator& c) {
  std::vector<Issue> issues;
  project::Project p = example_of(c, issues);
  REQUIRE(issues.empty());
  const project::Reading& reading = p.steps[0]->input().reading;
  SolvedExample s{reading.record.clone(), Record(*c.result), reading.axes};
  project::solve(p, issues);
  for (const account::Entry& e : p.steps[0]->account().inputs) {  // inputs filled by rows of tables
    const Leaf leaf = find_leaf(s.input, e.path);
    if (leaf && leaf.field->get != nullptr && std::isnan(leaf.get()) && e.value.si.size() == 1) leaf.set(e.value.si[0]);
  }
  Trace trace;
  c.explain(s.input.data.get(), s.result.data.get(), trace);
  return s;
}

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace loadpath::test
