// Collects loops into batches, and the stack of turning points that have not closed yet.
#pragma once

#include "lib/rainflow/cycle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::rainflow {

/// Turning points, and their places in the series if requested.
struct Points {
  std::span<const double> values;
  std::span<const std::uint64_t> at;  // empty, or one for each value
};

/// Hands loops on in batches of one count.
class Loops {
 public:
  explicit Loops(Consumer& consumer) : consumer_(&consumer) {}

  template <bool placed>
  void put(const Loop& loop, const Where& where, double count = 1.0) {
    if (size_ == capacity || count != count_) hand_over();
    count_ = count;
    loops_[size_] = loop;
    if constexpr (placed) where_[size_] = where;
    placed_ = placed;
    ++size_;
  }
  void hand_over() {
    if (size_ == 0) return;
    consumer_->take({{loops_.data(), size_}, count_, {where_.data(), placed_ ? size_ : 0}});
    size_ = 0;
  }

 private:
  static constexpr std::size_t capacity = 1024;
  Consumer* consumer_;
  std::size_t size_ = 0;
  double count_ = 1.0;
  bool placed_ = false;
  std::array<Loop, capacity> loops_{};
  std::array<Where, capacity> where_{};
};

/// The turning points that wait for their loops to close.
template <bool placed>
class Waiting {
 public:
  void make_room(std::size_t more) {
    if (value_.size() < size_ + more) value_.resize(2 * (size_ + more));
    if (placed && at_.size() < value_.size()) at_.resize(value_.size());
  }
  /// Needs room.
  void push(double value, std::uint64_t at) {
    value_[size_] = value;
    if constexpr (placed) at_[size_] = at;
    ++size_;
  }
  void drop(std::size_t count) { size_ -= count; }
  /// The two points below the top.
  void drop_below_top() {
    value_[size_ - 3] = value_[size_ - 1];
    if constexpr (placed) at_[size_ - 3] = at_[size_ - 1];
    size_ -= 2;
  }
  /// The lowest of three points or fewer.
  void drop_first() {
    std::shift_left(value_.begin(), value_.begin() + 3, 1);
    if constexpr (placed) std::shift_left(at_.begin(), at_.begin() + 3, 1);
    --size_;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The k-th from the top, which is 1.
  [[nodiscard]] double top(std::size_t k) const { return value_[size_ - k]; }
  [[nodiscard]] double operator[](std::size_t i) const { return value_[i]; }
  [[nodiscard]] Loop loop(std::size_t i) const { return {value_[i], value_[i + 1]}; }
  [[nodiscard]] Where where(std::size_t i) const {
    if constexpr (placed) return {at_[i], at_[i + 1]};
    return {};
  }
  [[nodiscard]] Points points() const { return {{value_.data(), size_}, {at_.data(), placed ? size_ : 0}}; }

 private:
  std::vector<double> value_;
  std::vector<std::uint64_t> at_;
  std::size_t size_ = 0;
};

}  // namespace loadpath::rainflow
