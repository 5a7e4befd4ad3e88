// A chart drawn, and where its dots lie.
#pragma once

#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/plot/frame.hpp"
#include "lib/figure/chart.hpp"

#include <optional>
#include <vector>

namespace loadpath::draw {

struct ChartPicture {
  Picture picture;
  std::vector<std::optional<Point>> places;  // positions of the dots; none for dots without any
};

ChartPicture chart_picture(const figure::Chart& chart);

// The frame common to the two kinds.
PlotFrame frame_of(const figure::Chart& chart);
/// The number of dots that pass, that fail by each mode...
std::string counts_of(const figure::Chart& chart);
/// One row below the figure: a symbol and its meaning.
class Legend {
 public:
  Legend(Canvas& canvas, double top) : canvas_(canvas), y_(top) {}
  /// The centre of the next symbol; the words are written to its right.
  Point next(std::string_view words);
  [[nodiscard]] double bottom() const { return y_ + 10.0; }

 private:
  Canvas& canvas_;
  double x_ = 14.0, y_;
};

/// Over two results: dots, and the front that none of them is beyond.
Picture cloud_picture(const figure::Chart& chart, const PlotFrame& frame,
                      const std::vector<std::optional<Point>>& places);
/// Over two inputs: contour lines, and the failing region hatched.
Picture field_picture(const figure::Chart& chart, const PlotFrame& frame);

}  // namespace loadpath::draw
