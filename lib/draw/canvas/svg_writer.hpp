// Writes SVG elements: at most two decimals, text escaped, never a number that is not finite.
#pragma once

#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/canvas/view.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::draw {

enum class Anchor { start, middle, end };

class SvgWriter {
 public:
  /// `style`: classes of the sheet that `document` writes ("grid", "curve c1").
  void line(std::string_view style, Point from, Point to);
  void polyline(std::string_view style, const std::vector<Point>& points);
  void polygon(std::string_view style, const std::vector<Point>& points);
  /// Strokes that belong together, each from first to second: a grid, a hatching.
  void strokes(std::string_view style, const std::vector<std::pair<Point, Point>>& strokes);
  /// Many dots as one path: strokes without length, which the round ends of the style make visible.
  void dots(std::string_view style, const std::vector<Point>& places);
  void circle(std::string_view style, Point centre, double radius);
  /// Counter-clockwise on the page by `sweep` radians from `start`, also negative.
  void arc(std::string_view style, Point centre, double radius, double start, double sweep);
  void rectangle(std::string_view style, const Box& box);
  /// `at` is on the base line; `turned`: reading upwards.
  void text(std::string_view style, Point at, const Text& text, Anchor anchor = Anchor::start, bool turned = false);
  /// Centred in a box of one line.
  void centred_text(std::string_view style, const Box& box, const Text& text);

  /// What another has written, at its places.
  void append(const SvgWriter& other) { body_ += other.body_; }

  /// What stands between belongs together; the attributes' values are escaped.
  void begin_group(const std::vector<std::pair<std::string_view, std::string>>& attributes);
  void end_group() { body_ += "</g>\n"; }

  /// The <svg> element around what was written.
  [[nodiscard]] std::string document(double height, std::string_view title, std::string_view description,
                                     double width = view_width) const;

 private:
  void open(std::string_view element, std::string_view style);
  void attribute(std::string_view name, double value);
  void path(std::string_view style, const std::vector<Point>& points, bool closed);

  std::string body_;
};

}  // namespace loadpath::draw
