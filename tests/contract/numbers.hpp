// The numbers of a project as they are typed, and the permitted replacements.
#pragma once

#include "lib/project/project.hpp"
#include "lib/toml/tree.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// A number of a project: the path to it, and its key.
struct Number {
  std::vector<std::size_t> way;  // entries and items, from the top on
  std::string name;              // "shaft.pieces[2].l"
  bool at_once = false;          // in a range, a distribution, a history, a formula: independent of other steps
};

toml::Tree& tree_at(toml::Tree& top, const std::vector<std::size_t>& way);
/// The numbers of all steps of a project.
std::vector<Number> numbers_of(const toml::Tree& top, const project::Project& project);

/// The text of an expression that is this number.
std::string expression_of(const toml::Tree& number);

/// A project with one more step; references to it wait until it is solved.
toml::Tree with_other_step(const toml::Tree& tree);
/// "=30 mm" as a value known only later: "=(30 mm)*(contract_one.h/contract_one.h)".
std::string waiting(const std::string& expression);

}  // namespace loadpath::test
