// From the lines of a trace to the lines of a report: every name of a formula with its value and unit.
#pragma once

#include "lib/formula/tree.hpp"
#include "lib/project/step.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace loadpath::project {

/// `input` and `result` are the records of the traced evaluation.
std::vector<account::Derived> derive(const Trace& trace, const Record& input, const Record& result);

/// The value that a name has in a scope after the lines before `line`: of in.d that of the input; of r.F_c and of a
/// plain name that of the earlier lines of the scope, of the element of the result that the scope names, of outer
/// scopes, and of a plain name at last that of the input. Nothing if it is unknown.
class Names {
 public:
  Names(const Record& input, const Record& result) : input_(input), result_(result) {}
  struct Known {
    double si = 0.0;
    std::string unit;
  };
  [[nodiscard]] std::optional<Known> find(const std::string& scope, std::string_view name) const;
  [[nodiscard]] std::optional<double> si_of(const std::string& scope, std::string_view name) const;
  /// The unit that the field of a line's symbol is shown in, or a readable one.
  [[nodiscard]] std::string unit_of(const Line& line) const;
  void add(const Line& line, const std::string& unit);

  /// A formula read once: elements of lists have the same.
  struct Formula {
    std::optional<formula::Node> tree;
    std::vector<std::string> names;  // of the tree
    std::string shown;
  };
  [[nodiscard]] const Formula& formula_of(const Line& line) const;

 private:
  [[nodiscard]] bool is_angle(const Line& line) const;
  [[nodiscard]] std::string unit_of_speed(const Line& line) const;
  using Find = std::optional<Known> (Names::*)(const std::string& scope, std::string_view name) const;
  [[nodiscard]] std::optional<Known> find_outwards(std::string scope, std::string_view name, Find in_scope) const;
  [[nodiscard]] std::optional<Known> find_line(const std::string& scope, std::string_view name) const;
  [[nodiscard]] std::optional<Known> find_result(const std::string& scope, std::string_view name) const;
  [[nodiscard]] std::optional<Known> find_any(const std::string& scope, std::string_view name) const;

  const Record& input_;
  const Record& result_;
  std::map<std::string, Known> lines_;  // by scope and symbol
  mutable std::unordered_map<std::string_view, Formula> formulas_;
};

}  // namespace loadpath::project
