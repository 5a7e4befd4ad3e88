#include "calculators/belt/loop.hpp"

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::belt {

namespace {

using figure::Point;

Point between(Point from, Point to) { return {to.x - from.x, to.y - from.y}; }
double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// +1 where the belt turns counter-clockwise around the circle, -1 clockwise.
double sense(const Circle& c, double turn) { return c.outside ? -turn : turn; }

/// Where a line of this direction, with the circle on the side that its sense says, touches it.
Point contact(const Circle& c, double side, double direction) {
  return {c.at.x + side * c.radius * std::sin(direction), c.at.y - side * c.radius * std::cos(direction)};
}

LoopSpan span_between(const Circle& from, const Circle& to, double turn) {
  const Point line = between(from.at, to.at);
  const double d = std::hypot(line.x, line.y), rise = sense(to, turn) * to.radius - sense(from, turn) * from.radius;
  LoopSpan s;
  s.direction = std::atan2(line.y, line.x) - std::asin(rise / d);
  s.length = std::sqrt((d - rise) * (d + rise));
  s.from = contact(from, sense(from, turn), s.direction);
  s.to = contact(to, sense(to, turn), s.direction);
  return s;
}

/// In [0, 2 pi).
double positive_angle(double angle) {
  const double turns = std::floor(angle / (2.0 * pi));
  return angle - 2.0 * pi * turns;
}

double distance_to(const LoopSpan& s, Point p) {
  const Point along = between(s.from, s.to), off = between(s.from, p);
  const double part = std::clamp((along.x * off.x + along.y * off.y) / (s.length * s.length), 0.0, 1.0);
  return distance(p, {s.from.x + part * along.x, s.from.y + part * along.y});
}

bool intersect(const LoopSpan& a, const LoopSpan& b) {
  const auto sides = [](const LoopSpan& line, const LoopSpan& ends) {
    const Point along = between(line.from, line.to);
    return cross(along, between(line.from, ends.from)) * cross(along, between(line.from, ends.to)) < 0.0;
  };
  return sides(a, b) && sides(b, a);
}

class Laying {
 public:
  Laying(std::span<const Circle> circles, double turn) : circles_(circles), turn_(turn) {}

  Loop lay() {
    loop_.count = count();
    if (touch()) return loop_;
    for (std::size_t k = 0; k < count(); ++k) {
      loop_.spans[k] = span_between(circles_[k], circles_[next(k)], turn_);
      loop_.length += loop_.spans[k].length;
    }
    wrap();
    if (loop_.flaw == Flaw::none) find_hits();
    if (loop_.flaw == Flaw::none) find_crossings();
    return loop_;
  }

 private:
  [[nodiscard]] std::size_t count() const { return circles_.size(); }
  [[nodiscard]] std::size_t next(std::size_t k) const { return (k + 1) % count(); }

  bool has_flaw(Flaw flaw, std::size_t at, std::size_t other) {
    loop_.flaw = flaw, loop_.at = at, loop_.other = other;
    return true;
  }

  bool touch() {
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t k = i + 1; k < count(); ++k) {
        const double apart = distance(circles_[i].at, circles_[k].at);
        if (!(apart > circles_[i].radius + circles_[k].radius)) return has_flaw(Flaw::touching, i, k);
      }
    }
    return false;
  }

  /// The belt turns once in all; a pulley that it does not reach counts as a turn more, or less where it is outside.
  void wrap() {
    double sum = 0.0;
    for (std::size_t k = 0; k < count(); ++k) {
      const double before = loop_.spans[(k + count() - 1) % count()].direction, after = loop_.spans[k].direction;
      const double side = sense(circles_[k], turn_);
      loop_.wraps[k] = positive_angle(side * (after - before));
      loop_.length += loop_.wraps[k] * circles_[k].radius;
      sum += turn_ * side * loop_.wraps[k];
    }
    const double turns = std::round(sum / (2.0 * pi));
    if (turns == 1.0) return;
    const bool outside = turns < 1.0;
    std::size_t widest = count();
    for (std::size_t k = 0; k < count(); ++k) {
      if (circles_[k].outside != outside) continue;
      if (widest == count() || loop_.wraps[k] > loop_.wraps[widest]) widest = k;
    }
    const bool missed = widest != count() && loop_.wraps[widest] > 1.5 * pi;
    has_flaw(missed ? Flaw::untouched : Flaw::crossing, missed ? widest : 0, 0);
  }

  void find_hits() {
    for (std::size_t s = 0; s < count(); ++s) {
      for (std::size_t k = 0; k < count(); ++k) {
        if (k == s || k == next(s)) continue;
        if (!(distance_to(loop_.spans[s], circles_[k].at) < circles_[k].radius)) continue;
        has_flaw(Flaw::through, s, k);
        return;
      }
    }
  }

  void find_crossings() {
    for (std::size_t a = 0; a < count(); ++a) {
      for (std::size_t b = a + 1; b < count(); ++b) {
        if (!intersect(loop_.spans[a], loop_.spans[b])) continue;
        has_flaw(Flaw::crossing, a, b);
        return;
      }
    }
  }

  std::span<const Circle> circles_;
  double turn_;
  Loop loop_;
};

/// The loop with one of its circles moved.
class Moved {
 public:
  Moved(std::span<const Circle> circles, double turn, std::size_t moving, double direction)
      : count_(circles.size()), turn_(turn), moving_(moving), step_{std::cos(direction), std::sin(direction)} {
    std::copy(circles.begin(), circles.end(), circles_.begin());
    start_ = circles_[moving].at;
  }
  /// Nothing where the loop has a flaw.
  std::optional<double> length(double way) {
    circles_[moving_].at = {start_.x + way * step_.x, start_.y + way * step_.y};
    const Loop loop = lay_loop(std::span(circles_).first(count_), turn_);
    if (loop.flaw != Flaw::none) return {};
    return loop.length;
  }
  /// Beyond it the length only grows with the displacement.
  [[nodiscard]] double farthest() const {
    double most = 0.0;
    for (std::size_t k = 0; k < count_; ++k)
      most = std::max(most, distance(start_, circles_[k].at) + circles_[k].radius);
    return most + circles_[moving_].radius;
  }

 private:
  std::array<Circle, most_pulleys> circles_{};
  std::size_t count_;
  double turn_;
  std::size_t moving_;
  Point start_, step_;
};

/// A displacement, and the length of the belt there.
struct Sample {
  double way = 0.0, length = 0.0;
};

/// Bisection between two displacements, one of a longer and one of a shorter belt.
double bisect(Moved& loop, double length, Sample low, Sample high) {
  const bool rises = high.length > low.length;
  for (int n = 0; n < 200; ++n) {
    const double middle = 0.5 * (low.way + high.way);
    const auto found = loop.length(middle);
    if (middle == low.way || middle == high.way || !found) break;
    ((*found < length) == rises ? low : high) = {middle, *found};
  }
  return 0.5 * (low.way + high.way);
}

/// The last displacement without a flaw between one without and one with it.
Sample border(Moved& loop, Sample clean, double flawed) {
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (clean.way + flawed);
    const auto found = loop.length(middle);
    if (middle == clean.way || middle == flawed) break;
    if (found) {
      clean = {middle, *found};
    } else {
      flawed = middle;
    }
  }
  return clean;
}

/// One direction of displacement of a pulley, step by step, until the belt has the length or runs into a pulley.
class Walk {
 public:
  Walk(Moved& loop, double length, double step) : loop_(&loop), length_(length), step_(step) {}

  /// The displacement, if the belt has its length within the next step.
  std::optional<double> go_on(Shift& seen) {
    if (blocked_) return {};
    const double way = steps_++ * step_;
    const auto found = loop_->length(way);
    std::optional<double> there;
    if (found) {
      if (!before_ && steps_ > 1) see(border(*loop_, {way, *found}, way - step_), seen);
      there = see({way, *found}, seen);
    } else if (before_) {
      there = see(border(*loop_, *before_, way), seen);
      blocked_ = true;
    }
    return there;
  }

 private:
  std::optional<double> see(Sample next, Shift& seen) {
    seen.shortest = seen.longest == 0.0 ? next.length : std::min(seen.shortest, next.length);
    seen.longest = std::max(seen.longest, next.length);
    std::optional<double> there;
    if (before_ && (next.length - length_) * (before_->length - length_) <= 0.0)
      there = bisect(*loop_, length_, *before_, next);
    before_ = next;
    return there;
  }

  Moved* loop_;
  double length_, step_;
  int steps_ = 0;
  std::optional<Sample> before_;
  bool blocked_ = false;  // by a pulley; positions behind it cannot be reached
};

}  // namespace

Loop lay_loop(std::span<const Circle> circles, double turn) { return Laying(circles, turn).lay(); }

Shift shift_for(double length, std::span<const Circle> circles, double turn, std::size_t moving, double direction) {
  constexpr int steps = 1000;
  Moved loop(circles, turn, moving, direction);
  const double step = std::max(2.0 * loop.farthest(), length) / steps;
  std::array<Walk, 2> walks{Walk(loop, length, step), Walk(loop, length, -step)};
  Shift shift;
  for (int n = 0; n <= steps && !shift.way; ++n) {
    for (Walk& walk : walks) {
      shift.way = walk.go_on(shift);
      if (shift.way) break;
    }
  }
  return shift;
}

std::vector<figure::Point> belt_line(std::span<const Circle> circles, double turn, const Loop& loop) {
  std::vector<figure::Point> line;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    const LoopSpan& to = loop.spans[(k + circles.size() - 1) % circles.size()];
    const double side = sense(circles[k], turn);
    const int parts = std::max(1, static_cast<int>(std::ceil(loop.wraps[k] / (pi / 48.0))));
    for (int n = 0; n <= parts; ++n)
      line.push_back(contact(circles[k], side, to.direction + side * loop.wraps[k] * n / parts));
  }
  return line;
}

}  // namespace loadpath::belt
