// Helpers for the tests of drawings: whether every dimension shows its true length, and nothing is drawn outside.
#pragma once

#include "lib/draw/canvas/view.hpp"
#include "lib/draw/drawing/clip.hpp"
#include "lib/draw/svg.hpp"
#include "lib/figure/drawing.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace loadpath::draw::test {

inline const figure::Drawing& drawing_of(const figure::Figure& figure) {
  return *std::get<figure::Drawn>(figure.content);
}

/// A length is measured along its line: a level one in x, an upright one in y.
inline double measured(const figure::Drawing::Length& l) {
  switch (l.side) {
    case figure::Drawing::Side::below:
    case figure::Drawing::Side::above:
      return std::fabs(l.to.x - l.from.x);
    case figure::Drawing::Side::left:
    case figure::Drawing::Side::right:
      return std::fabs(l.to.y - l.from.y);
    case figure::Drawing::Side::in_place:
      break;
  }
  return length(l.to - l.from);
}

/// Every dimension has the length, width or magnitude in the drawing that it states.
inline void check_dimensions(const figure::Figure& figure) {
  for (const auto& view : drawing_of(figure).views) {
    for (const auto& l : view.lengths) {
      CAPTURE(l.value.symbol);
      CHECK(measured(l) == doctest::Approx(std::fabs(l.value.si)).epsilon(1e-9));
    }
    for (const auto& r : view.radii) CHECK((r.diameter ? 2.0 : 1.0) * r.radius == doctest::Approx(r.value.si));
    for (const auto& a : view.angles) CHECK(std::fabs(a.sweep) == doctest::Approx(a.value.si));
    for (const auto& f : view.forces) CHECK(length(f.force) == doctest::Approx(f.value.si));
  }
}

/// All places of lines, circles and texts within the frame.
inline std::string outside_frame(std::string_view svg) {
  const std::size_t start = svg.find("viewBox=\"0 0 ") + 13;
  const double wide = std::stod(std::string(svg.substr(start)));
  const double high = std::stod(std::string(svg.substr(svg.find(' ', start))));
  const auto is_out = [&](double x, double y) { return x < -0.6 || y < -0.6 || x > wide + 0.6 || y > high + 0.6; };
  for (const Element& e : elements(svg, "circle")) {
    const double x = number(e.tag, "cx"), y = number(e.tag, "cy"), r = number(e.tag, "r");
    if (is_out(x - r, y - r) || is_out(x + r, y + r)) return std::string(e.tag);
  }
  for (const Element& e : elements(svg, "text")) {
    const Box box = text_box(e);
    const bool turned = has(e.tag, "rotate");
    const double half = 0.5 * box.width(), x = number(e.tag, "x"), y = number(e.tag, "y");
    const bool out = turned ? is_out(x - 8.0, y - half) || is_out(x, y + half)
                            : is_out(box.left, box.top) || is_out(box.right, box.bottom);
    if (out) return words(e.text);
  }
  for (const Element& e : elements(svg, "path")) {  // M x y l dx dy ..., or strokes M x y L x y
    const std::string d(attribute(e.tag, "d"));
    figure::Point at;
    char command = 'M';
    for (std::size_t i = 0; i < d.size();) {
      if (std::isalpha(static_cast<unsigned char>(d[i])) != 0) {
        command = d[i++];
        continue;
      }
      if (d[i] == ' ') {
        ++i;
        continue;
      }
      if (command == 'A') {  // only its end
        std::size_t used = 0;
        double values[7];
        for (double& value : values) value = std::stod(d.substr(i), &used), i += used;
        at = {values[5], values[6]};
      } else {
        std::size_t used = 0;
        const double x = std::stod(d.substr(i), &used);
        i += used;
        const double y = std::stod(d.substr(i), &used);
        i += used;
        at = command == 'l' ? figure::Point{at.x + x, at.y + y} : figure::Point{x, y};
      }
      if (is_out(at.x, at.y)) return std::string(e.tag).substr(0, 60);
    }
  }
  return {};
}

/// Invariants of every drawing: it is complete, shows no NaN, and stays within its frame.
inline void check_drawn(const figure::Figure& figure) {
  const std::string text = svg(figure);
  CHECK(well_formed(text));
  CHECK_FALSE(has(text, "nan"));
  CHECK_FALSE(has(text, "inf"));
  CHECK_FALSE(has(text, "NaN"));
  CHECK(outside_frame(text) == "");
  CHECK_FALSE(has(text, "<desc></desc>"));
  check_dimensions(figure);
}

/// The points of the paths of a kind of line in a view.
inline std::vector<std::vector<figure::Point>> paths_of(const figure::Drawing::View& view, figure::Drawing::Line line) {
  std::vector<std::vector<figure::Point>> found;
  for (const auto& path : view.paths) {
    if (path.line == line) found.push_back(path.points);
  }
  return found;
}

inline double distance_to_segment(figure::Point p, figure::Point from, figure::Point to) {
  const figure::Point d = to - from;
  const double whole = dot(d, d), t = whole > 0.0 ? std::clamp(dot(p - from, d) / whole, 0.0, 1.0) : 0.0;
  return length(p - (from + t * d));
}

inline double distance_to(figure::Point p, const std::vector<figure::Point>& closed) {
  double least = 1e300;
  for (std::size_t i = 0; i < closed.size(); ++i)
    least = std::min(least, distance_to_segment(p, closed[i], closed[(i + 1) % closed.size()]));
  return least;
}

}  // namespace loadpath::draw::test
