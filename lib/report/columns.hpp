// Layout of tables common to the writers: column widths, common units and digits, and the division of many columns
// into parts.
#pragma once

#include "lib/report/document.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::report {

inline constexpr std::size_t many_columns = 7;  // set closer, with units in the head
inline constexpr double between_columns = 1.6;  // letters

/// The number of letters in a text: UTF-8 continuation bytes do not count.
double letters_of(std::string_view text);

/// A column as it is set: in the head its unit, where all of its numbers have the same.
struct Column {
  std::size_t index = 0;
  bool numeric = false;
  std::string unit = {};
  double letters = 0.0;
  std::vector<std::string> numbers = {};  // by row; empty for words
};
Column column_of(const Table& table, std::size_t index, bool numeric);

/// A number of few digits, without the unit, which is in the head.
std::string number_of(Quantity q, const Column& column);

/// A group of adjacent columns.
struct Part {
  std::vector<Column> columns;
  double letters = 0.0;
};
/// Divides a table too wide for the line into parts; each begins with the name of the row.
std::vector<Part> parts_of(const std::vector<Column>& columns, double letters_of_line);

}  // namespace loadpath::report
