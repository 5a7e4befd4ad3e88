// What the writers share about tables: how wide a column is, what its numbers have in common, and which columns of many
// stand beside each other.
#pragma once

#include "lib/report/document.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::report {

inline constexpr std::size_t many_columns = 7;  // set closer, with units in the head
inline constexpr double between_columns = 1.6;  // letters

/// How many letters stand in a text: of UTF-8 its continuations do not count.
double letters_of(std::string_view text);

/// A column as it is set: in the head its unit, where all of its numbers have the same.
struct Column {
  std::size_t index = 0;
  bool numeric = false;
  std::string unit = {};
  double letters = 0.0;
};
Column column_of(const Table& table, std::size_t index, bool numeric);

/// A number of few digits, without the unit that stands in the head.
std::string number_of(Quantity q, const Column& column);

/// Columns beside each other.
struct Part {
  std::vector<Column> columns;
  double letters = 0.0;
};
/// What has no room beside each other becomes parts of the table; each begins with the name of the row.
std::vector<Part> parts_of(const std::vector<Column>& columns, double letters_of_line);

}  // namespace loadpath::report
