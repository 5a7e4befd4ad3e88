// The points that no other beats in every objective.
//
// A dominated point is removed: another is as good in each objective and better in one. Among points equal in all,
// the one of the smallest index remains, and the others are counted. The set does not depend on the order of the
// points.
//
// Its size is unbounded if objectives conflict at every point: then `bits` of the mantissa, 8 say, treat values of
// one class (2^-8 = 0.4 %) as equal. So there are at most 2^bits points per power of two with two objectives;
// reported points differ from the true front by less than a class.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace loadpath::sweep {

enum class Aim { min, max };

class Pareto {
 public:
  struct Point {
    std::uint64_t index = 0;
    std::uint64_t equals = 0;  // number of points treated as equal to it, including itself
    std::vector<double> objectives, values;
  };

  Pareto() = default;
  explicit Pareto(std::vector<Aim> aims, unsigned bits = 52);

  /// The points of a block, the first of which has the index `first`, with a column for each objective; `values(i)`
  /// makes the row of its i-th point. A point with an objective that is not finite is passed over.
  template <class Values>
  void add(std::uint64_t first, std::span<const double* const> objectives, std::size_t n, const Values& values) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < aims_.size(); ++k) objectives_[k] = objectives[k][i];
      if (!stays()) continue;
      if (Point* const taken = place(first + i, 1)) taken->values = values(i);
    }
  }
  void merge(const Pareto& other);
  /// In the order of the first objective, the best first; then of the second, and so on.
  [[nodiscard]] std::vector<Point> points() const;
  [[nodiscard]] std::size_t size() const { return members_.size(); }

  void store(Writer& writer) const;
  void load(Reader& reader);

 private:
  using Keys = std::vector<std::uint64_t>;  // keys of the objectives: the smaller the better

  /// Whether no point beats the one at hand.
  bool stays();
  /// Inserts the current point; if it is to be reported, returns its data.
  Point* place(std::uint64_t index, std::uint64_t equals);
  [[nodiscard]] bool is_better(std::uint64_t index, const Point& than) const;

  std::vector<Aim> aims_;
  unsigned dropped_ = 0;  // bits of the mantissa
  std::map<Keys, Point> members_;
  // The point at hand, and the keys of one that beat the point before: it may well beat the next.
  std::vector<double> objectives_;
  Keys keys_, beats_;
};

}  // namespace loadpath::sweep
