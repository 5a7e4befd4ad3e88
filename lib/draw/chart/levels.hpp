// Lines of equal level through values at the nodes of a lattice: marching squares.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <vector>

namespace loadpath::draw {

/// Positions of columns and rows on the page, each rising or falling; values are stored row by row.
struct Lattice {
  std::vector<double> x, y;
  [[nodiscard]] std::size_t node(std::size_t column, std::size_t row) const { return row * x.size() + column; }
};

/// A place within a cell, by shares of its sides.
struct InCell {
  std::size_t column, row;
  double across, up;
};
InCell cell_at(const Lattice& lattice, Point place);

/// Between the four corners of the cell; NaN if one has none.
double between(const Lattice& lattice, const std::vector<double>& values, const InCell& in);

/// Open and closed lines; none goes through a cell with a corner that has no value.
std::vector<std::vector<Point>> level_lines(const Lattice& lattice, const std::vector<double>& values, double level);

}  // namespace loadpath::draw
