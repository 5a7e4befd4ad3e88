#include "lib/quantity/format.hpp"

#include <cmath>
#include <string_view>

namespace loadpath {
namespace {

/// From which magnitude (SI) a unit is the habit of textbooks; the first row of a dimension serves if there is none.
struct PreferredUnit {
  Dimension dimension;
  std::string_view unit;
  double from = 0.0;
};

constexpr Dimension stress = Dimension::of(-1, 1, -2), force = Dimension::of(1, 1, -2), length = Dimension::of(1, 0, 0);
constexpr Dimension power = Dimension::of(2, 1, -3), work = Dimension::of(2, 1, -2);

constexpr PreferredUnit habits[] = {
    {stress, "MPa", 1e5},
    {stress, "GPa", 1e10},
    {stress, "kPa", 1e3},
    {stress, "Pa"},
    {force, "N"},
    {force, "kN", 1e4},
    {length, "mm"},
    {length, "m", 10.0},
    {power, "W"},
    {power, "kW", 1e3},
    {work, "N*m"},
    {length.power(2), "mm^2"},
    {length.power(3), "mm^3"},
    {length.power(4), "mm^4"},
    {Dimension::of(0, 1, 0), "kg"},
    {Dimension::of(2, 1, 0), "kg*m^2"},
    {Dimension::of(0, 0, 1), "s"},
    {Dimension::of(0, 0, -1), "1/s"},  // both angular velocities and frequencies
    {Dimension::of(0, 0, 0, 0, 1), "deg"},
    {Dimension::of(0, 0, -1, 0, 1), "rad/s"},
    {Dimension::of(-1, 0, 0, 0, 1), "deg/m"},
    {Dimension::of(2, 1, -2, 0, -1), "N*m/rad"},
    {Dimension::of(-2, -1, 2), "1/(N*m)"},
    {Dimension::of(-1, -1, 2), "1/N"},
    {Dimension::of(0, 1, -2), "N/mm"},
    {Dimension::of(3, 1, -2), "N*m^2"},
    {Dimension::of(-1, 1, -1), "Pa*s"},
    {Dimension::of(2, 0, -1), "mm^2/s"},
    {stress * length.power(1, 2), "MPa*m^(1/2)"},
};

}  // namespace

std::string readable_unit(double si, const Dimension& dimension, Kind kind) {
  if (kind == Kind::energy && dimension == work) return "J";
  const double size = std::fabs(si);
  const auto reached = [size](const PreferredUnit& habit) { return size > 0.0 && habit.from <= size; };
  const PreferredUnit* best = nullptr;
  for (const PreferredUnit& habit : habits) {
    if (habit.dimension != dimension) continue;
    if (best == nullptr || (reached(habit) && (!reached(*best) || habit.from > best->from))) best = &habit;
  }
  return best != nullptr ? std::string(best->unit) : si_unit(dimension);
}

}  // namespace loadpath
