#include "lib/table/largest.hpp"

#include <cmath>

namespace loadpath::table {

double largest_value(const Entry& row, std::string_view column) {
  if (const auto same = property(row, column)) return same->si;
  double most = std::nan("");
  for (const SizedProperty& at : values_by_size(row, column)) most = std::fmax(most, at.value.si);
  return most;
}

}  // namespace loadpath::table
