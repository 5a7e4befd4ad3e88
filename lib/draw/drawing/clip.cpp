#include "lib/draw/drawing/clip.hpp"

namespace loadpath::draw {
namespace {

/// The part of a segment within the box (Liang and Barsky), as parameters; nothing: enter > leave.
std::pair<double, double> within(const Box& box, Point from, Point to) {
  const Point d = to - from;
  double enter = 0.0, leave = 1.0;
  const auto clip = [&](double slope, double room) {
    if (slope == 0.0) {
      if (room < 0.0) leave = -1.0;
      return;
    }
    const double t = room / slope;
    if (slope < 0.0)
      enter = std::max(enter, t);
    else
      leave = std::min(leave, t);
  };
  clip(-d.x, from.x - box.left), clip(d.x, box.right - from.x);
  clip(-d.y, from.y - box.top), clip(d.y, box.bottom - from.y);
  return {enter, leave};
}

/// The part of a closed outline where `depth` is not negative (Sutherland and Hodgman).
template <class Depth>
std::vector<Point> cut(const std::vector<Point>& outline, const Depth& depth) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point from = outline[i], to = outline[(i + 1) % outline.size()];
    const double a = depth(from), b = depth(to);
    if (a >= 0.0) kept.push_back(from);
    if ((a >= 0.0) != (b >= 0.0)) kept.push_back(from + a / (a - b) * (to - from));
  }
  return kept;
}

}  // namespace

std::vector<std::vector<Point>> clipped(const std::vector<Point>& polyline, const Box& box) {
  std::vector<std::vector<Point>> pieces;
  bool goes_on = false;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Point from = polyline[i - 1], to = polyline[i];
    const auto [enter, leave] = within(box, from, to);
    if (enter > leave) {
      goes_on = false;
      continue;
    }
    if (!goes_on || enter > 0.0) pieces.push_back({from + enter * (to - from)});
    pieces.back().push_back(from + leave * (to - from));
    goes_on = leave >= 1.0;
  }
  return pieces;
}

std::vector<Point> clipped_area(std::vector<Point> outline, const Box& box) {
  outline = cut(outline, [&](Point p) { return p.x - box.left; });
  outline = cut(outline, [&](Point p) { return box.right - p.x; });
  outline = cut(outline, [&](Point p) { return p.y - box.top; });
  return cut(outline, [&](Point p) { return box.bottom - p.y; });
}

std::vector<std::pair<Point, Point>> hatching(const std::vector<Point>& outline, double spacing, bool falling) {
  const Point along = std::sqrt(0.5) * (falling ? Point{1.0, 1.0} : Point{1.0, -1.0}), normal = across(along);
  double low = 1e300, high = -1e300;
  for (const Point p : outline) low = std::min(low, dot(p, normal)), high = std::max(high, dot(p, normal));
  std::vector<std::pair<Point, Point>> strokes;
  // The lines are at multiples of their distance on the page, so that neighbouring parts are hatched alike.
  for (double at = spacing * std::ceil(low / spacing); at < high; at += spacing) {
    std::vector<double> hits;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point from = outline[i], to = outline[(i + 1) % outline.size()];
      const double a = dot(from, normal) - at, b = dot(to, normal) - at;
      if ((a < 0.0) != (b < 0.0)) hits.push_back(dot(from + a / (a - b) * (to - from), along));
    }
    std::sort(hits.begin(), hits.end());
    for (std::size_t i = 1; i < hits.size(); i += 2) {
      if (hits[i] - hits[i - 1] > 0.3)
        strokes.emplace_back(at * normal + hits[i - 1] * along, at * normal + hits[i] * along);
    }
  }
  return strokes;
}

double mean_thickness(const std::vector<Point>& outline) {
  double twice_area = 0.0, around = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point from = outline[i], to = outline[(i + 1) % outline.size()];
    twice_area += cross(from, to), around += length(to - from);
  }
  return around > 0.0 ? std::fabs(twice_area) / around : 0.0;
}

}  // namespace loadpath::draw
