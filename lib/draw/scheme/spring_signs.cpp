// The signs of springs, dampers and welds.
#include "lib/draw/scheme/parts.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

constexpr double least_length = 4.0;
constexpr int windings = 6;

void zigzag(Canvas& canvas, Point from, Point to) {
  const Point d = unit(to - from), side = spring_half * across(d);
  const double whole = length(to - from), lead = std::min(10.0, 0.15 * whole);
  const double pitch = (whole - 2.0 * lead) / windings;
  std::vector<Point> points{from, from + lead * d};
  for (int n = 0; n < windings; ++n) {
    const Point start = from + (lead + n * pitch) * d;
    points.push_back(start + 0.25 * pitch * d + side);
    points.push_back(start + 0.75 * pitch * d - side);
  }
  points.push_back(to - lead * d);
  points.push_back(to);
  canvas.polyline("outline", points);
}

/// A cylinder, open towards `to`, with the piston in its middle.
void dashpot(Canvas& canvas, Point from, Point to) {
  const Point d = unit(to - from), side = spring_half * across(d);
  const double whole = length(to - from), half = std::min(14.0, 0.3 * whole);
  const Point middle = 0.5 * (from + to), bottom = middle - half * d, mouth = middle + half * d;
  canvas.line("outline", from, bottom);
  canvas.polyline("outline", {mouth + side, bottom + side, bottom - side, mouth - side});
  canvas.line("rail", middle + 0.75 * side, middle - 0.75 * side);
  canvas.line("outline", middle, to);
}

}  // namespace

void spring(Canvas& canvas, Point from, Point to, bool pulls, bool damps) {
  if (length(to - from) < least_length) return;
  if (!damps) return zigzag(canvas, from, to);
  if (!pulls) return dashpot(canvas, from, to);
  const Point d = unit(to - from), aside = 1.5 * spring_half * across(d);
  const Point first = from + 0.12 * (to - from), last = to - 0.12 * (to - from);
  canvas.line("outline", from, first);
  canvas.line("outline", last, to);
  canvas.line("outline", first + aside, first - aside);
  canvas.line("outline", last + aside, last - aside);
  zigzag(canvas, first + aside, last + aside);
  dashpot(canvas, first - aside, last - aside);
}

void coil(Canvas& canvas, Point at, bool pulls) {
  constexpr int steps = 40;
  constexpr double turns = 2.25;
  if (!pulls) {  // a damper: a drum
    canvas.circle("outline", at, coil_radius);
    return canvas.circle("outline", at, 0.65 * coil_radius);
  }
  std::vector<Point> points;
  for (int n = 0; n <= steps; ++n) {
    const double part = static_cast<double>(n) / steps, radius = pin_radius + part * (coil_radius - pin_radius);
    points.push_back(at + radius * along(2.0 * std::numbers::pi * turns * part));
  }
  canvas.polyline("outline", points);
}

void weld(Canvas& canvas, Point corner, Point along, Point other) {
  constexpr double leg = 14.0;
  canvas.polygon("solid", {corner, corner + leg * along, corner + leg * other});
}

void clamp(Canvas& canvas, Point end, Point direction) {
  constexpr double half = 14.0;
  const Point side = half * across(direction);
  canvas.line("outline", end + side, end - side);
  hatch(canvas, end - side, end + side);
}

}  // namespace loadpath::draw
