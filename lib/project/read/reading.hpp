// The content of a project file's table for the record of a calculator: literals at once, expressions for later.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/sweep/point/axis.hpp"
#include "lib/sweep/point/distribution.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// A number whose value is an expression over other steps.
struct Operand {
  std::string path;  // path of the leaf, within the step
  Leaf leaf;
  Expression expression;
  std::string text;                                         // as written, without the '='
  Place place;                                              // place of the text after the '='
  bool of_record = false;                                   // not typed
  bool may_be_incomplete = false;                           // records: inputs missing there stay open
  double early = std::numeric_limits<double>::quiet_NaN();  // SI, where it is known before any step is solved
};

/// A complete object taken from another step: a word, a list, a record, the row of a table.
struct Taken {
  std::string path;                  // path that it fills, within the step
  const FieldInfo* field = nullptr;  // null: a row
  std::string source;                // "pick.best"
  Place place;                       // place of the text after the '='
  bool of_record = false;            // not typed
  bool may_be_incomplete = false;    // records: inputs missing there stay open
  const Axis* axis = nullptr;        // axis of a list that contains series
};

/// The goal of a search: the smallest of a stock, or the largest value, or the first row of a table, that passes.
struct Search {
  std::string path;
  Leaf leaf;          // without field: the row of a table, or a name, one of the kinds of the rows of a group
  std::string stock;  // empty: the largest value
  Place place;
  bool names_stock = false;  // the user, not the field
  std::string where = {};    // rows: a condition on their values, "d = 40 mm" (lib/table/search.hpp)
};

/// An input that takes many values: a range, a list, words, a distribution. `run` takes one of them.
struct Varied {
  std::string path;
  Leaf leaf;  // without field: the row of a table
  Place place;
  std::string shared = {};              // "values.n", where all that refer to it take the same
  sweep::Axis axis = {};                // SI, of choices their numbers
  std::vector<std::string> words = {};  // words of a row or a choice
  std::optional<sweep::Distribution> distribution = {};
  std::string stock = {};  // whose sizes are the values: filled in once the tables are known
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  std::size_t at = 0;  // index of the current word
};

/// A typed value whose field a record gives too.
struct TypedOverride {
  std::string path;    // within the step
  std::string source;  // path of the record's value: "press.links.rod.l"
  bool is_word = false;
  bool is_load = false;      // a load on the part, according to the record
  const char* factors = "";  // factors that a load of the record includes: "K_A"
};

/// A field that has no value yet, and must have one.
struct MissingInput {
  std::string path;
  const FieldInfo* field;
  Place place;
};

/// A typed leaf: its text in the file, and the place.
struct Typed {
  std::string text;
  Place place;
  bool mean_of_uncertain = false;
  std::string shared = {};  // "values.n", which it was written as
  bool of_point = false;    // the value of a point of the sweep
  std::string part = {};    // of a file: its column, or its row
};

/// The content of a table for a record.
struct Reading {
  Record record;
  Record parameters;  // parameters of the template that laid the record out; without type if there is none
  std::vector<Operand> operands;
  std::vector<Operand> whole;  // single values of the record, derived from all positions of a series
  std::vector<Taken> taken;
  std::vector<Taken> records;         // among the operands and the words now, field by field
  std::vector<TypedOverride> kept;    // typed, though a record has it too
  std::vector<MissingInput> missing;  // fields that a record may fill, known when all steps are read
  std::vector<Search> searches;
  std::vector<Varied> varied;
  std::map<std::string, Typed> typed;  // by the path of the leaf; lists and groups by their own path too
  std::set<std::string> faulty;        // top-level fields with an error: consequences for others are not reported
  std::vector<std::shared_ptr<const Axis>> axes;  // axes of series read from files
  Place place;                                    // place of the table

  /// That of a path within the step; null if a number, or nothing, is typed there.
  [[nodiscard]] const Operand* operand(std::string_view path) const {
    const auto at = std::ranges::find(operands, path, &Operand::path);
    return at == operands.end() ? nullptr : &*at;
  }
};

/// "=30 mm": the number as typed without the '='; nothing if the text refers to something, or is not an expression.
/// `known` gives values of references; nothing if it gives none.
std::optional<toml::Tree> number_of(const toml::Tree& tree,
                                    const std::function<const Value*(const std::string&)>& known);

/// "=pick.section" without anything else: the path it refers to; nothing for any other text, or an unreadable
/// expression.
std::optional<std::string> lone_reference(const toml::Tree& tree);

/// Whether the input comes from a record of another step.
bool is_of_record(const Reading& reading, const std::string& path);

/// The issue of a field without a value.
Issue missing_field(const MissingInput& missing, const std::string& prefix);

/// Visits every path of other steps that the reading refers to position by position: their load components load the
/// part.
template <class Visit>
void for_each_loading_reference(const Reading& reading, const Visit& visit) {
  for (const Operand& operand : reading.operands) {
    for (const auto& reference : operand.expression.references()) visit(reference.path);
  }
  for (const Taken& taken : reading.taken) visit(taken.source);
}

/// Every path of other steps that the reading refers to.
template <class Visit>
void for_each_reference(const Reading& reading, const Visit& visit) {
  for_each_loading_reference(reading, visit);
  for (const Operand& operand : reading.whole) {
    for (const auto& reference : operand.expression.references()) visit(reference.path);
  }
}

/// "must be > 0 mm", from the bounds of a field.
Message bounds_message(const FieldInfo& field);
/// "must be at least 1.2": the bound of a result that the value exceeds.
Message bound_message(const FieldInfo& field, double si);
/// The bound without the margin for rounding: "-1e-9" is 0, in the unit of the field.
double without_margin(const FieldInfo& field, double bound);
/// Whether the upper bound of a result is only there to keep it finite.
bool is_open_above(const FieldInfo& field);
/// Whether a size, in SI, is beyond all machines, so that its powers could leave the range of numbers.
bool is_out_of_proportion(double si);
Message out_of_proportion(const std::string& path, const FieldInfo& field, double si);
/// "d = 4500 mm is unusual: 5 mm to 2000 mm is expected".
Message unusual(const std::string& path, const FieldInfo& field, double si);
/// What to check of an unusual value: its unit, where it has one.
Message unusual_hint(const FieldInfo& field);

/// A name of a step, link or joint: letters, digits and '_', not starting with a digit.
bool is_name(std::string_view text);

/// The place of the character at byte `at` of a text that starts at `start`.
Place place_in(const Place& start, std::string_view text, std::size_t at, std::size_t length);

}  // namespace loadpath::project
