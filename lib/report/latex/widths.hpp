// How wide the columns of a table are set.
#pragma once

#include <string>
#include <vector>

namespace loadpath::report::tex {

/// Letters that a column needs: to break nothing but between words, and to break nothing at all.
struct Need {
  double least = 0.0, all = 0.0;
};

/// What it has where there is little room.
double comfortable(const Need& need);

inline constexpr double letters_of_line = 122.0;  // in the smallest type

struct Widths {
  std::string type;            // "\\small"
  std::vector<double> shares;  // of a line; 0: as wide as what stands in the column
};

/// The largest type in which the columns stand beside each other, and what each then has.
Widths widths_of(const std::vector<Need>& needs);

}  // namespace loadpath::report::tex
