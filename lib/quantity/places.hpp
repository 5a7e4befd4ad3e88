// The places of an axis.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace loadpath {

/// Places in ascending or descending order: numbers in SI, or samples of a history by their numbers, in half of the
/// memory.
class Places {
 public:
  Places() = default;
  Places(std::vector<double> si) : si_(std::move(si)) {}  // NOLINT(google-explicit-constructor): a list of numbers
  Places(std::initializer_list<double> si) : si_(si) {}

  [[nodiscard]] std::size_t size() const { return samples_.empty() ? si_.size() : samples_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  double operator[](std::size_t i) const { return samples_.empty() ? si_[i] : static_cast<double>(samples_[i]); }
  [[nodiscard]] double front() const { return (*this)[0]; }
  [[nodiscard]] double back() const { return (*this)[size() - 1]; }
  /// The numbers; empty for samples.
  [[nodiscard]] std::span<const double> numbers() const { return si_; }
  [[nodiscard]] std::span<double> numbers() { return si_; }
  [[nodiscard]] std::vector<double> values() const {
    return samples_.empty() ? si_ : std::vector<double>(samples_.begin(), samples_.end());
  }

  void reserve_samples(std::size_t count) { samples_.reserve(count); }
  /// Behind the last one. Samples beyond the range of 32 bits become numbers, as do those before them.
  void add_sample(std::uint64_t number) {
    if (si_.empty() && number <= std::numeric_limits<std::uint32_t>::max()) {
      samples_.push_back(static_cast<std::uint32_t>(number));
      return;
    }
    if (si_.empty()) si_ = values();
    samples_ = {};
    si_.push_back(static_cast<double>(number));
  }
  void add(double si) { si_.push_back(si); }

  bool operator==(const Places&) const = default;

 private:
  std::vector<double> si_;
  std::vector<std::uint32_t> samples_;  // empty if the places are numbers
};

}  // namespace loadpath
