// The elements of a picture, in drawing order: lines, areas, dots, words. Recorded here; svg_writer.hpp and
// lib/draw/tikz write them.
#pragma once

#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/canvas/view.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace loadpath::draw {

enum class Anchor { start, middle, end };

class Canvas {
 public:
  using Stroke = std::pair<Point, Point>;
  /// Names are literals.
  using Attributes = std::vector<std::pair<std::string_view, std::string>>;

  struct Path {
    std::string style;
    std::vector<Point> points;
    bool closed = false;
  };
  struct Strokes {
    std::string style;
    std::vector<Stroke> strokes;
  };
  struct Dots {
    std::string style;
    std::vector<Point> places;
  };
  struct Circle {
    std::string style;
    Point centre;
    double radius = 0.0;
  };
  struct Arc {
    std::string style;
    Point centre;
    double radius = 0.0, start = 0.0, sweep = 0.0;
  };
  struct Rectangle {
    std::string style;
    Box box;
  };
  struct Words {
    std::string style;
    Point at;
    Text text;
    Anchor anchor = Anchor::start;
    bool turned = false;
  };
  struct GroupBegin {
    Attributes attributes;
  };
  struct GroupEnd {};
  using Element = std::variant<Path, Strokes, Dots, Circle, Arc, Rectangle, Words, GroupBegin, GroupEnd>;

  /// `style`: classes of the rules in style.hpp ("grid", "curve c1").
  void line(std::string_view style, Point from, Point to) { path(style, {from, to}, false); }
  void polyline(std::string_view style, std::vector<Point> points) { path(style, std::move(points), false); }
  void polygon(std::string_view style, std::vector<Point> points) { path(style, std::move(points), true); }
  /// Strokes that belong together, each from first to second: a grid, a hatching.
  void strokes(std::string_view style, std::vector<Stroke> strokes);
  /// Many dots as one path: strokes without length, which the round ends of the style make visible.
  void dots(std::string_view style, std::vector<Point> places);
  void circle(std::string_view style, Point centre, double radius);
  /// Counter-clockwise on the page by `sweep` radians from `start`, also negative.
  void arc(std::string_view style, Point centre, double radius, double start, double sweep);
  void rectangle(std::string_view style, const Box& box);
  /// `at` is on the base line; `turned`: reading upwards.
  void text(std::string_view style, Point at, Text text, Anchor anchor = Anchor::start, bool turned = false);
  /// Centred in a box of one line.
  void centred_text(std::string_view style, const Box& box, Text text);

  /// Appends the elements of another canvas, at its positions.
  void append(const Canvas& other);

  /// Begins a group of elements, for scripts of a page.
  void begin_group(Attributes attributes);
  void end_group();

  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }

 private:
  void path(std::string_view style, std::vector<Point> points, bool closed);

  std::vector<Element> elements_;
};

}  // namespace loadpath::draw
