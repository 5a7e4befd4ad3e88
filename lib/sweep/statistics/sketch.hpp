// Quantiles of any number of values in bounded memory, independent of the order: values are counted by their sign,
// exponent and the first 12 bits of their mantissa.
//
// A class is 2^-12 of its values wide, and knows the least and the largest of them: between the two, values are taken
// as evenly spread. So quantiles of up to two values per class, and of values of which a class has one only (stocks,
// counts), are exact, others within 0.025 %. 96 KiB per power of two that is met; a spread of a hundred to one takes
// less than 1 MiB, and all numbers that there are 384 MiB.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"
#include "lib/sweep/statistics/confidence.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace loadpath::sweep {

struct ValueClass {
  std::uint64_t count = 0;
  double least = std::numeric_limits<double>::infinity(), largest = -std::numeric_limits<double>::infinity();
};

class Sketch {
 public:
  /// Infinite values and NaN are not counted.
  void add(std::span<const double> values);
  void merge(const Sketch& other);
  /// The classes with values, in their order.
  [[nodiscard]] std::vector<ValueClass> classes() const;

  void store(Writer& writer) const;
  void load(Reader& reader);

 private:
  using Page = std::vector<ValueClass>;  // classes of one sign and exponent; empty if there are no values
  Page& page(std::size_t number);

  std::vector<Page> pages_;
};

/// Bins from edge to edge, the first and the last edge being those of all values.
struct Histogram {
  std::vector<double> edges;
  std::vector<std::uint64_t> counts;
};

/// The results of a sketch.
class Ranks {
 public:
  explicit Ranks(const Sketch& sketch);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The value of rank 0 ... count() - 1.
  [[nodiscard]] double at(std::uint64_t rank) const;
  /// With linear interpolation between ranks p (n - 1), as numpy and R (type 7) do it; NaN if there are no values.
  [[nodiscard]] double quantile(double p) const;
  /// The bounds of the quantile with this confidence; NaN on a side where the sample is too small.
  [[nodiscard]] Interval quantile_bounds(double p, double confidence) const;
  /// The number of values below x.
  [[nodiscard]] std::uint64_t below(double x) const;
  /// Bins of equal breadth; of equal ratio where all values are above zero, else none.
  [[nodiscard]] Histogram histogram(std::size_t bins) const;
  [[nodiscard]] Histogram logarithmic_histogram(std::size_t bins) const;

 private:
  [[nodiscard]] Histogram counted(std::vector<double> edges) const;

  std::vector<ValueClass> classes_;
  std::vector<std::uint64_t> before_;  // values before each class
  std::uint64_t count_ = 0;
};

}  // namespace loadpath::sweep
