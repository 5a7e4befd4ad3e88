// What a table of a project file says about the record of a calculator: literals at once, expressions for later.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/sweep/point/axis.hpp"
#include "lib/sweep/point/distribution.hpp"
#include "lib/toml/tree.hpp"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// A number whose value is an expression over other steps.
struct Operand {
  std::string path;  // of the leaf, within the step
  Leaf leaf;
  Expression expression;
  std::string text;                                         // as written, without the '='
  Place place;                                              // of the text behind the '='
  bool of_record = false;                                   // nobody typed it
  bool may_lack = false;                                    // of a record: what that leaves open stays open
  double early = std::numeric_limits<double>::quiet_NaN();  // SI, where it is known before any step is solved
};

/// What is taken whole from another step: a word, a list, a record, the row of a table.
struct Taken {
  std::string path;                  // what it fills, within the step
  const FieldInfo* field = nullptr;  // null: a row
  std::string source;                // "pick.best"
  Place place;                       // of the text behind the '='
  bool of_record = false;            // nobody typed it
  bool may_lack = false;             // of a record: what that leaves open stays open
  const Axis* axis = nullptr;        // of a list that holds series
};

/// What is to be found: the smallest of a stock, or the largest value, or the first row of a table, that passes.
struct Search {
  std::string path;
  Leaf leaf;          // without field: the row of a table
  std::string stock;  // empty: the largest value
  Place place;
  bool names_stock = false;  // the user, not the field
};

/// An input that takes many values: a range, a list, words, what a distribution has. `run` takes one of them.
struct Varied {
  std::string path;
  Leaf leaf;  // without field: the row of a table
  Place place;
  std::string shared = {};              // "values.n", where all that refer to it take the same
  sweep::Axis axis = {};                // SI, of choices their numbers
  std::vector<std::string> words = {};  // of a row or a choice
  std::optional<sweep::Distribution> distribution = {};
  std::string stock = {};  // whose sizes are the values: filled in where the tables are known
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  std::size_t at = 0;  // of the words, the one that it has now
};

/// A value that was typed beside a record that has it too.
struct TypedBeside {
  std::string path;    // within the step
  std::string source;  // of the record's value: "press.links.rod.l"
  bool is_word = false;
  bool is_load = false;  // what the part has to bear, as the record says
};

/// A field that has no value yet, and must have one.
struct Lacking {
  std::string path;
  const FieldInfo* field;
  Place place;
};

/// A leaf that was typed: what stood in the file, and where.
struct Typed {
  std::string text;
  Place place;
  bool mean_of_uncertain = false;
  std::string shared = {};  // "values.n", which it was written as
};

/// What a table says about a record.
struct Reading {
  Record record;
  Record parameters;  // of the template that laid the record out; without type where there is none
  std::vector<Operand> operands;
  std::vector<Operand> whole;  // of one value in the record, which the step makes itself of all positions of a series
  std::vector<Taken> taken;
  std::vector<Taken> records;     // that are among the operands and the words now, field by field
  std::vector<TypedBeside> kept;  // typed, though a record has it too
  std::vector<Lacking> lacking;   // that a record may fill, which is known when all steps are read
  std::vector<Search> searches;
  std::vector<Varied> varied;
  std::map<std::string, Typed> typed;  // by the path of the leaf; lists and groups by their own path too
  std::set<std::string> faulty;        // top-level fields that an error is about: what else depends on them is not said
  std::vector<std::shared_ptr<const Axis>> axes;  // of series that files have given
  Place place;                                    // of the table
};

/// "=30 mm": the number as it is typed without its sign; nothing where the text refers to something, or is no
/// expression. `known` gives values of references; nothing where it gives none.
std::optional<toml::Tree> number_of(const toml::Tree& tree,
                                    const std::function<const Value*(const std::string&)>& known);

/// "=pick.section" alone: what it refers to; nothing where the text is another. An expression that cannot be read is
/// none.
std::optional<std::string> lone_reference(const toml::Tree& tree);

/// Whether the input comes from a record of another step.
bool is_of_record(const Reading& reading, const std::string& path);

/// That a field has no value.
Issue missing_field(const Lacking& lacking, const std::string& prefix);

/// Every path of other steps that the reading refers to position by position: what comes along with it loads the part.
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
/// Whether a size, in SI, is beyond all machines, so that its powers could leave the range of numbers.
bool is_out_of_proportion(double si);
Message out_of_proportion(const std::string& path, const FieldInfo& field, double si);
/// "d = 4500 mm is unusual: 5 mm to 2000 mm is expected".
Message unusual(const std::string& path, const FieldInfo& field, double si);

/// A name of a step, link or joint: letters, digits and '_', not starting with a digit.
bool is_name(std::string_view text);

/// The place of the character at byte `at` of a text that starts at `start`.
Place place_in(const Place& start, std::string_view text, std::size_t at, std::size_t length);

}  // namespace loadpath::project
