// A calculator without a project: one machine, or columns of them.
#pragma once

#include <loadpath/solution.hpp>
#include <loadpath/sweep.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace loadpath {
struct Calculator;
}

namespace loadpath::api {

struct Field {
  std::string name, meaning;
  Role role = Role::input;
  std::string kind;     // "stress"; "word", "list", ... for non-numbers
  std::string si_unit;  // "Pa"
  std::string unit;     // display unit: "MPa"
  bool optional = false;
  std::vector<std::string> words;  // possible words
};

/// A value in the syntax of a project file: "[{ x = \"0 mm\", T = \"5 N*m\" }]".
struct Inline {
  std::string toml;
};

/// The value of one input. Columns are read in place; all have the same length.
struct Given {
  std::string name;
  std::variant<std::string, double, Inline, std::span<const double>, std::vector<std::string>> value;
  std::string unit = {};  // unit of the numbers: "kN*m"; empty: SI
};

class Calculator {
 public:
  /// An Error with the nearest name if there is none: "shaft.torsion".
  static Calculator find(std::string_view id);
  static std::vector<Calculator> all();

  [[nodiscard]] std::string id() const;
  [[nodiscard]] std::string title() const;
  [[nodiscard]] std::string scope() const;
  [[nodiscard]] std::string example() const;
  [[nodiscard]] std::vector<Field> inputs() const;
  [[nodiscard]] std::vector<Field> results() const;

  /// Names of the solution are those of the calculator: "d_min".
  [[nodiscard]] Solution solve(std::span<const Given> inputs, bool strict = false) const;
  /// A row for each value of the columns. One that its field or a rule refuses is marked in `state`, and counted.
  [[nodiscard]] Sweep sweep(std::span<const Given> inputs, const SweepOptions& options = {}) const;

 private:
  explicit Calculator(const loadpath::Calculator& calculator) : calculator_(&calculator) {}

  const loadpath::Calculator* calculator_;
};

}  // namespace loadpath::api
