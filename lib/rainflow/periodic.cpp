#include "lib/rainflow/counter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::rainflow {

namespace {

/// Converts places of a rotated period to those of the original.
class TurnedBack : public Consumer {
 public:
  TurnedBack(Consumer& consumer, std::size_t first, std::size_t period)
      : consumer_(&consumer), first_(first), period_(period) {}

  void take(const Batch& batch) override {
    where_.clear();
    for (const Where& where : batch.where) where_.push_back({turned_back(where.begin), turned_back(where.end)});
    consumer_->take({batch.loops, batch.count, where_});
  }
  void pass(std::span<const double> turning_points) override { consumer_->pass(turning_points); }

 private:
  /// Of a place in the period, or of its first sample once more.
  [[nodiscard]] std::uint64_t turned_back(std::uint64_t place) const {
    const std::uint64_t at = place + first_;
    return at < period_ ? at : at - period_;
  }

  Consumer* consumer_;
  std::uint64_t first_, period_;
  std::vector<Where> where_;
};

}  // namespace

std::optional<Fault> count_periodic(std::span<const double> period, const Rules& rules, Consumer& consumer) {
  Rules full = rules;
  full.residue = Residue::ignore;
  if (auto fault = contradiction(full)) return fault;
  for (std::size_t i = 0; i < period.size(); ++i) {
    if (std::abs(period[i]) <= largest_value) continue;
    return refusal(period[i], i);
  }
  if (period.empty()) return std::nullopt;
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto first = static_cast<std::size_t>(std::max_element(period.begin(), period.end(), smaller) - period.begin());
  TurnedBack turned(consumer, first, period.size());
  Counter counter(full, turned, Counter::Course::period);
  for (const auto part : {period.subspan(first), period.first(first), period.subspan(first, 1)}) {
    if (auto fault = counter.feed(part)) return fault;
  }
  counter.finish();
  return std::nullopt;
}

}  // namespace loadpath::rainflow
