// The position of a view on the page: its scale, and the space for dimension lines around it.
#pragma once

#include "lib/draw/canvas/view.hpp"
#include "lib/figure/drawing.hpp"

#include <array>
#include <string>

namespace loadpath::draw {

inline constexpr double dimension_row = 23.0;                       // from a dimension line to the next one farther out
inline constexpr double first_row = 20.0;                           // from the drawing to the first
inline constexpr double short_dimension = 24.0, short_lead = 16.0;  // has its heads outside, with lines so long

/// The view without parts that have no position or no value.
figure::Drawing::View without_gaps(const figure::Drawing::View& view);

/// The number of digits of a value in a drawing: four; five for lengths from one metre.
int digits_of(const figure::Drawing::Value& value);

/// "R = 600 mm", the symbol marked.
std::string words_of(const figure::Drawing::Value& value);

/// A dimension outside the drawing, and the row of its line.
struct Row {
  std::size_t length = 0;
  std::size_t row = 0;
  bool narrow = false;  // its text has no room above the line
};

struct ViewFit {
  double scale = 1.0;   // view units per metre
  double newton = 0.0;  // view units per newton
  Point origin;
  Box area;    // all of the view with title, dimensions and scale bar
  Box extent;  // extent of the parts only
  Box words;   // area available for words: without title and scale bar
  std::vector<Row> rows;

  [[nodiscard]] Point at(Point p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
};

/// At this corner of the page, in this width.
ViewFit fit(const figure::Drawing::View& view, Point corner, double width);

}  // namespace loadpath::draw
