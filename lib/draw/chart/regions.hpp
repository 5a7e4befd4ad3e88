// What holds where on a chart of a grid: between its dots it passes or fails as the dots about it do, and the limit
// lies where the utilisation is 1 if that decides.
#pragma once

#include "lib/draw/chart/levels.hpp"
#include "lib/figure/chart.hpp"

namespace loadpath::draw {

class Regions {
 public:
  Regions(const Chart& chart, Lattice lattice);

  /// The dot nearest to a place, if the place is on its side of the limit; else one about it that is.
  [[nodiscard]] const Chart::Dot& at(Point place) const;
  /// Where what fails begins.
  [[nodiscard]] std::vector<std::vector<Point>> limit() const;
  /// Where, of what does not fail, that begins which is not judged, or no machine.
  [[nodiscard]] std::vector<std::vector<Point>> unknown() const;
  /// Where one mode takes over from another.
  [[nodiscard]] std::vector<std::vector<Point>> between_modes() const;
  [[nodiscard]] std::vector<std::vector<Point>> level(double value) const;

 private:
  const Chart& chart_;
  Lattice lattice_;
  std::vector<double> excess_;  // above zero where a dot fails; NaN where there is no machine
};

}  // namespace loadpath::draw
