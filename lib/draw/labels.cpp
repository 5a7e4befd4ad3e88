#include "lib/draw/labels.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

constexpr double hit = 1e3, outside = 1e4;

/// Clips the segment to the box (Liang and Barsky) and tells whether something is left.
bool crosses(const Box& box, Point from, Point to) {
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

/// The box that just clears `gap` from `foot` when it is pushed along `direction`.
Box pushed(Point foot, Point direction, double gap, double width, double height) {
  const double reach = gap + 0.5 * (std::fabs(direction.x) * width + std::fabs(direction.y) * height);
  return Box::around(foot + reach * direction, width, height);
}

}  // namespace

void Labels::keep_off(const std::vector<Point>& polyline, double half_width) {
  for (std::size_t i = 1; i < polyline.size(); ++i) keep_off(polyline[i - 1], polyline[i], half_width);
}

double Labels::hits(const Box& box) const {
  double sum = area_.contains(box) ? 0.0 : outside;
  for (const Box& other : boxes_) sum += box.meets(other) ? 2.0 * hit : 0.0;
  for (const Line& line : lines_) sum += crosses(box.grown(line.half_width), line.from, line.to) ? hit : 0.0;
  return sum;
}

Box Labels::place(const std::vector<Candidate>& candidates) {
  Box best;
  double least = 1e300;
  for (const Candidate& c : candidates) {
    if (c.cost >= least) continue;
    if (const double sum = c.cost + hits(c.box); sum < least) least = sum, best = c.box;
  }
  boxes_.push_back(best);
  return best;
}

std::optional<Box> Labels::place_free(const std::vector<Candidate>& candidates) {
  const Box best = place(candidates);
  boxes_.pop_back();
  if (candidates.empty() || hits(best) > 0.0) return std::nullopt;
  boxes_.push_back(best);
  return best;
}

std::vector<Candidate> around(Point point, double gap, double width, double height) {
  constexpr int directions = 16;
  std::vector<Candidate> candidates;
  for (const double far : {0.0, 6.0, 14.0}) {
    for (int i = 0; i < directions; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / directions;
      const Point direction{std::cos(turn), -std::sin(turn)};
      const double away = std::fabs(std::remainder(turn - 0.25 * std::numbers::pi, 2.0 * std::numbers::pi));
      candidates.push_back({pushed(point, direction, gap + far, width, height), away + far});
    }
  }
  return candidates;
}

std::vector<Candidate> beside(Point from, Point to, double gap, double width, double height) {
  std::vector<Candidate> candidates;
  const Point normal = across(unit(to - from));
  for (const double t : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
    for (const double side : {1.0, -1.0}) {
      const double below = side * normal.y > 0.0 ? 1.0 : 0.0;
      const Box box = pushed(from + t * (to - from), side * normal, gap, width, height);
      candidates.push_back({box, below + 10.0 * std::fabs(t - 0.5)});
    }
  }
  return candidates;
}

}  // namespace loadpath::draw
