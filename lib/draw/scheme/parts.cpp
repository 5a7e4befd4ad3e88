#include "lib/draw/scheme/parts.hpp"

#include <numbers>

namespace loadpath::draw {

namespace {

double distance_to_segment(Point p, Point from, Point to) {
  const Point d = to - from;
  const double whole = dot(d, d);
  const double t = whole > 0.0 ? std::clamp(dot(p - from, d) / whole, 0.0, 1.0) : 0.0;
  return length(p - (from + t * d));
}

/// The corners that protrude by more than a little: for points on a line the two ends remain.
std::vector<Point> without_flat_corners(std::vector<Point> hull) {
  constexpr double little = 1e-5;  // tolerance relative to the hull's size
  Box box{hull[0].x, hull[0].y, hull[0].x, hull[0].y};
  for (const Point p : hull) box.include({p.x, p.y, p.x, p.y});
  const double tolerance = little * std::hypot(box.width(), box.height());
  for (std::size_t i = 0; i < hull.size() && hull.size() > 2;) {
    const Point before = hull[i == 0 ? hull.size() - 1 : i - 1], after = hull[i + 1 == hull.size() ? 0 : i + 1];
    if (distance_to_segment(hull[i], before, after) > tolerance)
      ++i;
    else
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return hull;
}

}  // namespace

std::vector<Point> convex_hull(std::vector<Point> points) {
  const auto before = [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  const auto same = [](Point a, Point b) { return a.x == b.x && a.y == b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return without_flat_corners(std::move(hull));
}

std::vector<Point> ring(Point centre, double radius) {
  constexpr int corners = 12;
  std::vector<Point> points;
  for (int i = 0; i <= corners; ++i) points.push_back(centre + radius * along(2.0 * std::numbers::pi * i / corners));
  return points;
}

std::vector<Point> block(Point centre, Point direction) {
  const Point a = 0.5 * block_length * direction, b = 0.5 * block_width * across(direction);
  return {centre + a + b, centre + a - b, centre - a - b, centre - a + b};
}

void hatch(Canvas& canvas, Point from, Point to) {
  constexpr double spacing = 6.0, size = 6.0;
  const Point d = unit(to - from);
  const Point stroke = size * (across(d) - d);
  std::vector<std::pair<Point, Point>> strokes;
  const double whole = length(to - from);
  for (double s = spacing; s <= whole + 1e-9 && strokes.size() < 200; s += spacing) {
    strokes.push_back({from + s * d, from + s * d + stroke});
  }
  canvas.strokes("light", strokes);
}

void support(Canvas& canvas, Point pin, Point direction) {
  constexpr double depth = 15.0, half = 8.5, ground_half = 13.0;
  const Point foot = pin + depth * direction, side = across(direction);
  canvas.polygon("pin", {pin, foot + half * side, foot - half * side});
  const Point from = foot + ground_half * side, to = foot - ground_half * side;
  canvas.line("outline", from, to);
  hatch(canvas, from, to);
}

void arrow_head(Canvas& canvas, std::string_view fill, Point tip, Point direction, double size) {
  const Point back = tip - size * direction, side = 0.34 * size * across(direction);
  canvas.polygon(fill, {tip, back + side, back - side});
}

void arrow(Canvas& canvas, int colour, Point from, Point to) {
  constexpr double head = 11.0;
  const double size = std::min(head, 0.7 * length(to - from));
  const Point direction = unit(to - from);
  const std::string number = std::to_string(colour);
  canvas.line("force c" + number, from, to - 0.8 * size * direction);
  arrow_head(canvas, "f" + number, to, direction, size);
}

void couple(Canvas& canvas, Point at, Point opening, bool positive) {
  constexpr double pi = std::numbers::pi, head = 10.0;
  const double gap = std::atan2(-opening.y, opening.x), side = positive ? 1.0 : -1.0;
  const double start = gap + side * 0.25 * pi, sweep = side * 1.5 * pi;
  const double lead = head / couple_radius;  // the head follows the arc by its length
  canvas.arc("force c1", at, couple_radius, start, sweep - 0.7 * side * lead);
  const double end = start + sweep;
  const Point tip = at + couple_radius * Point{std::cos(end), -std::sin(end)};
  const double behind = end - side * lead;
  const Point back = at + couple_radius * Point{std::cos(behind), -std::sin(behind)};
  arrow_head(canvas, "f1", tip, unit(tip - back), head);
}

}  // namespace loadpath::draw
