// The content of one cell of a table or of a verdict.
#pragma once

#include "lib/account/state.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <variant>

namespace loadpath::account {

/// A value in a unit; NaN is printed as "not available".
struct Quantity {
  double si = 0.0;
  std::string unit;  // "N*m"
  int digits = 5;
};
/// A symbol of a formula: "tau_adm".
struct Symbol {
  std::string name;
};
/// A utilisation: the writer draws a bar next to it.
struct Utilisation {
  double value = 0.0;
};
/// A value that a search has found: the writer emphasises it. What was given with it follows.
struct Sized {
  std::string text;
  std::string rest = {};  // "d = 48 mm, l = 36 mm"; may be empty
  /// What follows the mark of the text.
  [[nodiscard]] std::string behind() const { return rest.empty() ? rest : ", " + rest; }
};
/// Text of the user or of a message: escaped by the writer.
using Cell = std::variant<std::string, Message, Quantity, Symbol, State, Utilisation, Sized>;

}  // namespace loadpath::account
