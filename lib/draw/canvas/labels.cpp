#include "lib/draw/canvas/labels.hpp"

#include <numbers>
#include <utility>

namespace loadpath::draw {
namespace {

// A name with a halo can be read over lines; over another name neither can be.
constexpr double hit = 1e3, over_text = 4e3, outside = 1e4, crowded = 3.0, close_by = 4.0;

constexpr std::size_t stretch = 16;  // segments of a line with an extent of their own: most are far from a label

/// Whether one box lies wholly on one side of the other.
bool is_apart(const Box& a, const Box& b) {
  return a.right < b.left || b.right < a.left || a.bottom < b.top || b.bottom < a.top;
}

/// Whether both ends of a segment lie on the same side of the box, as those of most segments do.
bool is_clear_of(const Box& box, Point from, Point to) {
  return (from.x < box.left && to.x < box.left) || (from.x > box.right && to.x > box.right) ||
         (from.y < box.top && to.y < box.top) || (from.y > box.bottom && to.y > box.bottom);
}

/// Clips the segment to the box (Liang and Barsky) and returns whether something is left.
bool enters(const Box& box, Point from, Point to) {
  if (is_clear_of(box, from, to)) return false;
  const Point d = to - from;
  double enter = 0.0, leave = 1.0;
  const auto clip = [&](double slope, double room) {
    if (slope == 0.0) return room >= 0.0;
    const double t = room / slope;
    (slope < 0.0 ? enter : leave) = slope < 0.0 ? std::max(enter, t) : std::min(leave, t);
    return enter <= leave;
  };
  return clip(-d.x, from.x - box.left) && clip(d.x, box.right - from.x) && clip(-d.y, from.y - box.top) &&
         clip(d.y, box.bottom - from.y);
}

Box spaced(const Box& label) { return {label.left - 6.0, label.top, label.right + 6.0, label.bottom}; }

/// The box that just clears `gap` from `foot` when it is pushed along `direction`.
Box pushed(Point foot, Point direction, double gap, double width, double height) {
  const double reach = gap + 0.5 * (std::fabs(direction.x) * width + std::fabs(direction.y) * height);
  return Box::around(foot + reach * direction, width, height);
}

}  // namespace

Labels::Line::Line(std::vector<Point> points, double half_width, double weight)
    : points_(std::move(points)), half_width_(half_width), weight_(weight) {
  if (points_.empty()) return;
  extent_ = Box::around(points_.front(), 0.0, 0.0);
  for (std::size_t begin = 0; begin + 1 < points_.size(); begin += stretch) {
    Box extent = Box::around(points_[begin], 0.0, 0.0);
    const std::size_t end = std::min(begin + stretch, points_.size() - 1);
    for (std::size_t i = begin + 1; i <= end; ++i) extent.include(Box::around(points_[i], 0.0, 0.0));
    extents_.push_back(extent);
    extent_.include(extent);
  }
}

bool Labels::Line::crosses(const Box& box) const {
  const Box wide = box.grown(half_width_);
  if (is_apart(wide, extent_)) return false;
  for (std::size_t k = 0; k < extents_.size(); ++k) {
    if (is_apart(wide, extents_[k])) continue;
    const std::size_t end = std::min((k + 1) * stretch, points_.size() - 1);
    for (std::size_t i = k * stretch; i < end; ++i) {
      if (enters(wide, points_[i], points_[i + 1])) return true;
    }
  }
  return false;
}

double Labels::cost(const Candidate& candidate, double enough) const {
  const Box& box = candidate.box;
  double hits = area_.contains(box) ? 0.0 : outside;
  for (const Box& other : boxes_) hits += box.meets(other) ? over_text : 0.0;
  for (const Line& line : lines_) {
    if (candidate.cost + hits >= enough) break;
    if (line.crosses(box.grown(close_by))) hits += line.weight() * (line.crosses(box) ? hit : crowded);
  }
  return candidate.cost + hits;
}

Box Labels::place(const std::vector<Candidate>& candidates) {
  Box best;
  double least = 1e300;
  for (const Candidate& c : candidates) {
    if (c.cost >= least) continue;
    if (const double all = cost(c, least); all < least) least = all, best = c.box;
  }
  boxes_.push_back(spaced(best));
  return best;
}

std::optional<Box> Labels::place_free(const std::vector<Candidate>& candidates) {
  const Box best = place(candidates);
  boxes_.pop_back();
  if (candidates.empty() || cost({best, 0.0}, hit) >= hit) return std::nullopt;
  boxes_.push_back(spaced(best));
  return best;
}

namespace {

/// A direction from a point, and its angle to that above and to the right.
struct Ray {
  Point direction;
  double away;
};
constexpr std::size_t directions = 32;

std::array<Ray, directions> rays() {
  std::array<Ray, directions> all;
  for (std::size_t i = 0; i < directions; ++i) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(directions);
    all[i] = {{std::cos(turn), -std::sin(turn)},
              std::fabs(std::remainder(turn - 0.25 * std::numbers::pi, 2.0 * std::numbers::pi))};
  }
  return all;
}

}  // namespace

std::vector<Candidate> around(Point point, double gap, double width, double height) {
  static const std::array<Ray, directions> from_point = rays();
  constexpr std::array<double, 7> distances{0.0, 6.0, 14.0, 24.0, 36.0, 52.0, 70.0};
  constexpr double close = 40.0;  // farther off it is better to cross a line, but not another name
  std::vector<Candidate> candidates;
  candidates.reserve(directions * distances.size());
  for (const double far : distances) {
    const double cost = far > close ? hit + far : far;
    for (const Ray& ray : from_point)
      candidates.push_back({pushed(point, ray.direction, gap + far, width, height), ray.away + cost});
  }
  return candidates;
}

std::array<Box, 2> both_sides(Point foot, Point direction, double gap, double width, double height) {
  const Point normal = across(direction);
  return {pushed(foot, normal, gap, width, height), pushed(foot, -1.0 * normal, gap, width, height)};
}

std::vector<Candidate> along_segment(Point from, Point to, double gap, double width, double height) {
  std::vector<Candidate> candidates;
  for (const double far : {0.0, 14.0, 28.0}) {  // one and two lines off: where links lie on one another
    for (const double t : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
      const Point foot = from + t * (to - from);
      for (const Box& box : both_sides(foot, unit(to - from), gap + far, width, height)) {
        const double below = box.centre().y > foot.y ? 1.0 : 0.0;
        candidates.push_back({box, below + far + 10.0 * std::fabs(t - 0.5)});
      }
    }
  }
  return candidates;
}

}  // namespace loadpath::draw
