// The inputs of a call as a project of one step; columns as inputs with many values.
#pragma once

#include "api/translate.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/project/project.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/toml/tree.hpp"

#include <cstdint>
#include <loadpath/calculator.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace loadpath::api {

/// An input with a value for each row.
struct GivenColumn {
  std::string name;
  std::span<const double> numbers;   // or the numbers of words
  std::vector<double> own;           // converted numbers that the caller does not own
  std::optional<ParsedUnit> unit;    // nothing: SI
  const FieldInfo* field = nullptr;  // null: rows of a table
  double stand_in = 0.0;             // SI: a value that the field takes, for rows that have none
  bool is_words = false;

  /// The value of a row in SI, and whether it is valid: finite, and an integer where the field is a count.
  [[nodiscard]] bool take(std::size_t row, double& si) const;
};

struct Call {
  toml::Tree project;
  std::string step;
  std::vector<GivenColumn> columns;
  std::size_t rows = 1;
  Sources sources;
};

/// An Error if a name, a unit, a type or a length is wrong; the reader of the project reports wrong values.
Call read_call(const loadpath::Calculator& calculator, std::span<const Given> inputs);

/// The unit in which a number of the field is SI: "kg*m^2/s^2".
std::string si_text(const FieldInfo& field);

}  // namespace loadpath::api
