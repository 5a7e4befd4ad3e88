#include "lib/draw/chart/hatching.hpp"

namespace loadpath::draw {
namespace {

constexpr double tread = 1.0;  // view units from look to look

/// The boundary between two places, of which the first is as `was`.
Point change(Point from, Point to, bool was, const std::function<bool(Point)>& holds) {
  for (int halving = 0; halving < 5; ++halving) {
    const Point middle = 0.5 * (from + to);
    (holds(middle) == was ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

void hatch_line(Point from, Point to, const std::function<bool(Point)>& holds, Strokes& strokes) {
  const int steps = 1 + static_cast<int>(length(to - from) / tread);
  Point last = from, begun = from;
  bool inside = holds(from);
  for (int k = 1; k <= steps; ++k) {
    const Point here = from + (static_cast<double>(k) / steps) * (to - from);
    if (holds(here) != inside) {
      const Point edge = change(last, here, inside, holds);
      if (inside) strokes.emplace_back(begun, edge);
      begun = edge;
      inside = !inside;
    }
    last = here;
  }
  if (inside) strokes.emplace_back(begun, to);
}

}  // namespace

Strokes hatching(const Box& area, double spacing, bool rising, const std::function<bool(Point)>& holds) {
  Strokes strokes;
  const double wide = area.width(), high = area.height();
  for (double at = spacing; at < wide + high; at += spacing) {  // intersection with the left side, or the bottom
    const double low = std::max(0.0, at - high), end = std::min(at, wide);
    const auto place = [&](double across) {
      return Point{area.left + across, rising ? area.top + at - across : area.bottom - at + across};
    };
    if (end > low) hatch_line(place(low), place(end), holds, strokes);
  }
  return strokes;
}

}  // namespace loadpath::draw
