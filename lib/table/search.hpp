// Searches rows of tables: "I_min >= 300 cm^4 and h <= 200 mm", sorted by one of their values.
//
//   condition   comparison, or several joined by `and`
//   comparison  column, one of >= <= > < = !=, and a quantity of the column's dimension with its unit
//   order       column, with - before it from the largest down
//
// A column is named by its key, or by a plain word: mass, area, depth, width. A row without the value does not
// match, and is sorted last; of a value that depends on the size the one at the smallest size counts.
#pragma once

#include "lib/table/table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

struct Comparison {
  std::string key;
  std::string sign;
  double si = 0.0;

  [[nodiscard]] bool holds(double value) const;
};
using Condition = std::vector<Comparison>;

/// The column of this key, in metric units where a table has them; null if there is none.
const Column* find_column(const std::vector<const Table*>& tables, std::string_view key);

/// The condition, or its fault with the place: unknown columns with near ones, other dimensions.
Outcome<Condition> read_condition(std::string_view text, const std::vector<const Table*>& tables);

struct Order {
  std::string key;  // empty: as in the tables
  bool falls = false;
};
Outcome<Order> read_order(std::string_view text, const std::vector<const Table*>& tables);

/// The rows that hold every comparison, in order; equal ones as in the tables.
std::vector<Entry> search(const std::vector<const Table*>& tables, const Condition& condition, const Order& order);

/// A value in SI as the search sees it; NaN if the row has none.
double searched_value(const Row& row, std::string_view key);

}  // namespace loadpath::table
