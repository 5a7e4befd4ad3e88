// The largest value of a column that depends on the size.
#pragma once

#include "lib/table/table.hpp"

#include <string_view>

namespace loadpath::table {

/// In SI units, of a row: usually that of the smallest size. NaN if the row has none.
double largest_value(const Entry& row, std::string_view column);

}  // namespace loadpath::table
