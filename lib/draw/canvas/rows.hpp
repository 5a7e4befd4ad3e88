// Rows of texts that do not touch.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace loadpath::draw {

inline constexpr double row_height = 17.0;

/// Each text goes to the first row where it has room.
class Rows {
 public:
  std::size_t row_of(double left, double right) {
    std::size_t row = 0;
    while (row < taken_.size() && !is_free(taken_[row], left, right)) ++row;
    if (row == taken_.size()) taken_.emplace_back();
    taken_[row].push_back({left, right});
    return row;
  }
  [[nodiscard]] double height() const { return row_height * static_cast<double>(taken_.size()); }

 private:
  using Row = std::vector<std::pair<double, double>>;
  static bool is_free(const Row& row, double left, double right) {
    return std::none_of(row.begin(), row.end(), [&](const auto& t) { return left < t.second && t.first < right; });
  }
  std::vector<Row> taken_;
};

}  // namespace loadpath::draw
