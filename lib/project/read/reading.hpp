// Reads a table of a project file into the record of a calculator: literals at once, expressions for later.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/toml/tree.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// A leaf whose value is an expression over other steps.
struct Operand {
  std::string path;  // of the leaf, within the step
  Leaf leaf;
  Expression expression;
  std::string text;  // as written, without the '='
  Place place;       // of the text behind the '='
};

/// A leaf whose value is to be found: the smallest of a stock that passes every check.
struct Search {
  std::string path;
  Leaf leaf;
  std::string stock;
  Place place;
};

/// A leaf that was typed: what stood in the file, and where.
struct Typed {
  std::string text;
  Place place;
  bool mean_of_uncertain = false;
};

/// What a table says about a record.
struct Reading {
  Record record;
  Record parameters;  // of the template that laid the record out; without type where there is none
  std::vector<Operand> operands;
  std::vector<Search> searches;
  std::map<std::string, Typed> typed;  // by the path of the leaf; lists and groups by their own path too
  std::set<std::string> faulty;        // top-level fields that an error is about: what else depends on them is not said
  Place place;                         // of the table
};

/// Reads `table` into a fresh record, or into one that `from` lays out: an element that is there already takes what
/// stands under its name. Keys in `reserved` are left to the caller; `prefix` starts the keys of issues.
Reading read_record(const toml::Tree& table, const RecordType& type, const Template* from, const std::string& prefix,
                    const std::vector<std::string>& reserved, std::vector<Issue>& issues);

/// "must be > 0 mm", from the bounds of a field.
Message bounds_message(const FieldInfo& field);

/// A name of a step, link or joint: letters, digits and '_', not starting with a digit.
bool is_name(std::string_view text);

/// The place of the character at byte `at` of a text that starts at `start`.
Place place_in(const Place& start, std::string_view text, std::size_t at, std::size_t length);

}  // namespace loadpath::project
