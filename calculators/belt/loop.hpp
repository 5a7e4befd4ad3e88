// The loop of a belt around any number of pulleys, inside and outside of it: straight spans along common tangents,
// arcs, exact lengths. And how far one pulley, a tensioner, has to move for a belt of a given length.
//
// A directed line of direction psi has the centre of a circle on its left at the distance r where
// d sin(theta - psi) = r_2 - r_1, for the centres' distance d and direction theta; r counts negative on its right.
#pragma once

#include "lib/figure/figure.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::belt {

inline constexpr std::size_t most_pulleys = 16;

/// A pulley as the circle of the belt's middle line; m.
struct Circle {
  figure::Point at;
  double radius = 0.0;
  bool outside = false;  // the belt's back runs on it
};

struct LoopSpan {
  figure::Point from, to;
  double direction = 0.0;  // rad
  double length = 0.0;     // m
};

enum class Flaw { none, touching, untouched, through, crossing };

/// Spans run from each pulley to the next one, the last back to the first.
struct Loop {
  std::array<LoopSpan, most_pulleys> spans{};
  std::array<double, most_pulleys> wraps{};  // rad
  std::size_t count = 0;
  double length = 0.0;            // m
  Flaw flaw = Flaw::none;         // then the rest does not count
  std::size_t at = 0, other = 0;  // the pulleys of the flaw; `through`: of the span behind `at`, and what it hits
};

/// Two pulleys or more in the order in which the belt runs. `turn`: +1 where it runs counter-clockwise around those
/// inside of it, -1 clockwise.
Loop lay_loop(std::span<const Circle> circles, double turn);

/// The shortest displacement, forward or back, of a pulley along a direction at which the belt has this length, m; if
/// there is none, the belt lengths possible along it without a flaw.
struct Shift {
  std::optional<double> way;
  double shortest = 0.0, longest = 0.0;
};
Shift shift_for(double length, std::span<const Circle> circles, double turn, std::size_t moving, double direction);

/// One closed line of the belt, for drawings.
std::vector<figure::Point> belt_line(std::span<const Circle> circles, double turn, const Loop& loop);

}  // namespace loadpath::belt
