// A quantity that a calculator gets over an entire cycle at once. An ordinary input with a series gives one position
// after the other, so that the variation cannot be assessed.
#pragma once

#include "lib/quantity/series.hpp"
#include "lib/quantity/units.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace loadpath {

template <class Quantity>
struct Varying {
  Quantity one = unset<Quantity>;       // if it does not vary
  std::shared_ptr<const Value> series;  // if it varies; its axis outlives the record that contains it

  Varying() = default;
  Varying(Quantity value) : one(value) {}  // NOLINT(google-explicit-constructor)
  explicit Varying(Value value) : series(std::make_shared<const Value>(std::move(value))) {}

  [[nodiscard]] bool is_series() const { return series != nullptr; }
  /// 1 if it does not vary.
  [[nodiscard]] std::size_t positions() const { return is_series() ? series->si.size() : 1; }
  [[nodiscard]] Quantity at(std::size_t position) const {
    return is_series() ? from_si<Quantity>(series->si[position]) : one;
  }
};

template <class Quantity>
[[nodiscard]] bool is_set(const Varying<Quantity>& q) {
  return q.is_series() || is_set(q.one);
}

}  // namespace loadpath
