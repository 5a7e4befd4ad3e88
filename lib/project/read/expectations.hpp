// Expectations of a project on its own results: [[expect]].
#pragma once

#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// A reference value of an [[expect]] entry, for `verify`.
struct Expectation {
  std::string text;  // "crankshaft.d_min", as written
  Expression value;
  Literal is;
  std::string is_text;              // as written
  double number = 0.0;              // number of `is` in its own unit, as its digits count
  std::string unit;                 // unit of `is`; "-" for a number
  std::optional<int> digits;        // half a unit of this significant digit
  std::optional<double> within;     // relative
  std::optional<double> within_si;  // absolute
  std::string source;
  std::string note;  // "printed 15 N*m: erratum 0.4"
  Place place;
};

/// Adds those that can be read.
void read_expectations(const toml::Tree& tree, std::vector<Expectation>& expectations, std::vector<Issue>& issues);

}  // namespace loadpath::project
