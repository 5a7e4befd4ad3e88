// The widths of a table's columns.
#pragma once

#include <string>
#include <vector>

namespace loadpath::report::tex {

/// Letters that a column needs: to break only between words, and to break nothing at all.
struct Need {
  double least = 0.0, all = 0.0;
};

/// The width of a column where there is little space.
double comfortable(const Need& need);

inline constexpr double letters_of_line = 122.0;  // in the smallest type

struct Widths {
  std::string type;            // "\\small"
  std::vector<double> shares;  // shares of a line; 0: as wide as the content of the column
};

/// The largest type size in which the columns fit, and their widths in it.
Widths widths_of(const std::vector<Need>& needs);

}  // namespace loadpath::report::tex
