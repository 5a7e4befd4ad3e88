// The points at which something is largest, in full.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::sweep {

/// The K rows with the largest key; among equal keys those of smaller index. The selection does not depend on the
/// order. Memory: K rows.
class Worst {
 public:
  struct Row {
    double key;
    std::uint64_t index;
    std::vector<double> values;
  };

  explicit Worst(std::size_t most = 0) : most_(most) {}

  /// The points of a block, the first of which has the index `first`; `values(i)` makes the row of its i-th point. A
  /// NaN key is not counted.
  template <class Values>
  void add(std::uint64_t first, std::span<const double> keys, const Values& values) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (enters(keys[i], first + i)) insert({keys[i], first + i, values(i)});
    }
  }
  void merge(const Worst& other);
  /// The worst first.
  [[nodiscard]] std::vector<Row> rows() const;

  void store(Writer& writer) const;
  void load(Reader& reader);

 private:
  [[nodiscard]] bool enters(double key, std::uint64_t index) const {
    if (rows_.size() < most_) return key == key;
    return most_ > 0 && (key > rows_.front().key || (key == rows_.front().key && index < rows_.front().index));
  }
  void insert(Row row);

  std::size_t most_;
  std::vector<Row> rows_;  // a heap, the least bad in front
};

}  // namespace loadpath::sweep
