// The permitted values of a field of a project file, as JSON Schema: types, words, units, required keys.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <boost/json.hpp>

#include <string>
#include <string_view>

namespace loadpath::exports {

/// The definitions that the fields refer to ("$defs"): each dimension once.
class Definitions {
 public:
  /// A quantity: a text with a unit of its dimension or an expression, a stock to search in, a spread.
  boost::json::object quantity(const Dimension& dimension);
  /// A quantity, or a history of it: a file, or values.
  boost::json::object history(const Dimension& dimension);
  /// A name of a row of the built-in tables of a group, or another text: of the project's own.
  boost::json::object row(const std::string& group);
  [[nodiscard]] boost::json::object take() { return std::move(all_); }

  void add(const std::string& name, boost::json::object schema) { all_[name] = std::move(schema); }
  static boost::json::object reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }

 private:
  boost::json::object all_;
};

/// A table with nothing but a text: { stock = "R20" }, { file = "law.csv" }.
boost::json::object of_one_text(const char* key);

/// The keys of an aggregate. `blank`: an instance without values, which shows the required keys; null: none is
/// required.
boost::json::object object_of(std::span<const FieldInfo> fields, void* blank, Definitions& definitions);

/// Schema of `[tables]` of a project: rows of the groups that the calculators name.
boost::json::object tables_schema(Calculators calculators, Definitions& definitions);

}  // namespace loadpath::exports
