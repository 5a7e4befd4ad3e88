// The frame of a plot: ranges, axes, and the position of a value on the page.
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/draw/canvas/display.hpp"
#include "lib/draw/canvas/ticks.hpp"

#include <optional>
#include <string>

namespace loadpath::draw {

/// The smallest range that holds all values that were seen.
class Extent {
 public:
  void see(double value);
  [[nodiscard]] bool empty() const { return range_.low > range_.high; }
  [[nodiscard]] Range range() const { return empty() ? Range{0.0, 1.0} : range_; }

 private:
  Range range_{1e300, -1e300};
};

/// The position of a plot that shares its horizontal scale with those above; only the last one labels the scale.
struct Strip {
  Box area;
  Range across;  // SI, from the left to the right of the area
  bool last = false;
};

class PlotFrame {
 public:
  /// On a page of its own; or as a strip.
  explicit PlotFrame(const figure::Plot& plot, const std::optional<Strip>& strip = {});
  /// On a page of its own, around exactly these SI values.
  PlotFrame(const figure::Scale& x, const figure::Scale& y, const Extent& across, const Extent& up);

  /// The place of SI values; nothing if one is not available.
  [[nodiscard]] std::optional<Point> place(double x, double y) const;
  /// The place of a value on the left side; nothing if it is not available.
  [[nodiscard]] std::optional<Point> left_end(double y) const;
  /// The height of zero, or of the end of the range that is nearest to it.
  [[nodiscard]] double zero_line() const;
  [[nodiscard]] const Box& area() const { return area_; }
  [[nodiscard]] double height() const { return area_.bottom + (tells_across_ ? 44.0 : 6.0); }
  [[nodiscard]] bool empty() const { return empty_; }
  [[nodiscard]] const Display& x() const { return x_; }
  [[nodiscard]] const Display& y() const { return y_; }
  /// A value with its unit, as the axis writes it.
  [[nodiscard]] std::string x_quantity(double si) const { return x_.quantity(si, across_.power); }
  [[nodiscard]] std::string y_quantity(double si) const { return y_.quantity(si, up_.power); }

  void draw(Canvas& canvas) const;

 private:
  [[nodiscard]] Point at(double x, double y) const;
  void take_page();
  void draw_grid(Canvas& canvas) const;
  void draw_ticks(Canvas& canvas) const;
  void draw_titles(Canvas& canvas) const;

  Display x_, y_;
  Axis across_, up_;  // display units
  Box area_;
  bool empty_ = false, tells_across_ = true;
};

}  // namespace loadpath::draw
