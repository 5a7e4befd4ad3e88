// The unit of a quantity, as a product of units of the table: N·m, mm², kg·m/s², W/(m*K), об/мин.
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/quantity/unit_table.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <string_view>

namespace loadpath {

/// The power of ten is kept apart, so that mm^3 is 1e-9 and not a product of three roundings.
struct ParsedUnit {
  double factor = 1.0;
  int ten = 0;
  double offset = 0.0;
  Dimension dimension;
  int names = 0;       // number of units of the table in it
  unsigned marks = 0;  // union of the marks

  [[nodiscard]] bool has(Mark mark) const { return (marks & static_cast<unsigned>(mark)) != 0; }
  [[nodiscard]] double to_si(double value) const;
  [[nodiscard]] double from_si(double si) const;
};

/// The unit that reaches from `at` to the end of `text`.
Outcome<ParsedUnit> read_unit(std::string_view text, std::size_t at);

}  // namespace loadpath
