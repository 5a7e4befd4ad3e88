// Regions on a chart of a grid: between its dots a point passes or fails as the surrounding dots do, and the limit is
// at utilisation 1 if that decides.
#pragma once

#include "lib/draw/chart/levels.hpp"
#include "lib/figure/chart.hpp"

namespace loadpath::draw {

class Regions {
 public:
  Regions(const figure::Chart& chart, Lattice lattice);

  /// The dot nearest to a place, if the place is on its side of the limit; else one about it that is.
  [[nodiscard]] const figure::Chart::Dot& at(Point place) const;
  /// The boundary of the failing region.
  [[nodiscard]] std::vector<std::vector<Point>> limit() const;
  /// Within the region that does not fail, the boundary of points not assessed or invalid.
  [[nodiscard]] std::vector<std::vector<Point>> unknown() const;
  /// The boundaries between governing modes.
  [[nodiscard]] std::vector<std::vector<Point>> between_modes() const;
  [[nodiscard]] std::vector<std::vector<Point>> level(double value) const;

 private:
  const figure::Chart& chart_;
  Lattice lattice_;
  std::vector<double> excess_;  // above zero if a dot fails; NaN if the design is invalid
};

}  // namespace loadpath::draw
