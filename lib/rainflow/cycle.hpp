// The result of counting a history: cycles, and their consumer.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::rainflow {

/// A hysteresis loop in the unit of the series: from a turning point to the next one that it closes with.
struct Loop {
  double from = 0.0, to = 0.0;

  /// Twice the amplitude, never negative.
  [[nodiscard]] double range() const { return std::abs(to - from); }
  [[nodiscard]] double mean() const { return from / 2.0 + to / 2.0; }
  friend bool operator==(const Loop&, const Loop&) = default;
};

/// The samples of the series, counted from 0, that a loop goes from and to.
struct Where {
  std::uint64_t begin = 0, end = 0;
  friend bool operator==(const Where&, const Where&) = default;
};

/// Loops that count alike: 1 each, or 0.5 as half cycles.
struct Batch {
  std::span<const Loop> loops;
  double count = 1.0;
  std::span<const Where> where;  // empty unless the counter was set to record places
};

/// Takes the results of a counter, batch by batch; the batches do not depend on the chunks of the series.
class Consumer {
 public:
  Consumer() = default;
  Consumer(const Consumer&) = default;
  Consumer(Consumer&&) = default;
  Consumer& operator=(const Consumer&) = default;
  Consumer& operator=(Consumer&&) = default;
  virtual ~Consumer() = default;
  virtual void take(const Batch& batch) = 0;
  /// The turning points themselves, in their order: for counting levels and not loops.
  virtual void pass(std::span<const double> /*turning_points*/) {}
};

/// Several at once.
class Consumers : public Consumer {
 public:
  explicit Consumers(std::vector<Consumer*> each) : each_(std::move(each)) {}
  void take(const Batch& batch) override {
    for (Consumer* const one : each_) one->take(batch);
  }
  void pass(std::span<const double> turning_points) override {
    for (Consumer* const one : each_) one->pass(turning_points);
  }

 private:
  std::vector<Consumer*> each_;
};

struct Cycle {
  double range = 0.0, mean = 0.0;
  double count = 1.0;  // or 0.5
  Where where;         // both 0 unless the counter was set to record places
};

/// Keeps every cycle, for histories that are short enough.
class CycleList : public Consumer {
 public:
  void take(const Batch& batch) override {
    for (std::size_t i = 0; i < batch.loops.size(); ++i) {
      const Loop& loop = batch.loops[i];
      cycles_.push_back({loop.range(), loop.mean(), batch.count, batch.where.empty() ? Where{} : batch.where[i]});
    }
  }
  [[nodiscard]] const std::vector<Cycle>& cycles() const { return cycles_; }

 private:
  std::vector<Cycle> cycles_;
};

}  // namespace loadpath::rainflow
