#include "lib/quantity/dimension.hpp"

#include <cstdlib>
#include <numeric>
#include <string_view>

namespace loadpath {
namespace {

struct Named {
  Dimension dimension;
  std::string_view name;
};

constexpr Named names[] = {
    {Dimension::of(0, 0, 0), "plain number"},
    {Dimension::of(1, 0, 0), "length"},
    {Dimension::of(2, 0, 0), "area"},
    {Dimension::of(3, 0, 0), "volume or section modulus"},
    {Dimension::of(4, 0, 0), "second moment of area"},
    {Dimension::of(-1, 0, 0), "curvature"},
    {Dimension::of(0, 1, 0), "mass"},
    {Dimension::of(-1, 1, 0), "mass per length"},
    {Dimension::of(-3, 1, 0), "density"},
    {Dimension::of(2, 1, 0), "moment of inertia"},
    {Dimension::of(0, 1, -1), "mass flow"},
    {Dimension::of(0, 0, 1), "time"},
    {Dimension::of(0, 0, -1), "frequency"},
    {Dimension::of(1, 0, -1), "speed"},
    {Dimension::of(1, 0, -2), "acceleration"},
    {Dimension::of(3, 0, -1), "volume flow"},
    {Dimension::of(2, 0, -1), "kinematic viscosity"},
    {Dimension::of(-1, 1, -1), "dynamic viscosity"},
    {Dimension::of(1, 1, -2), "force"},
    {Dimension::of(1, 1, -1), "momentum"},
    {Dimension::of(2, 1, -2), "moment"},
    {Dimension::of(2, 1, -3), "power"},
    {Dimension::of(2, 1, -3, 0, 1), "power, as moment times angular velocity"},
    {Dimension::of(-1, 1, -2), "stress"},
    {Dimension::of(0, 1, -2), "stiffness"},
    {Dimension::of(3, 1, -2), "bending stiffness"},
    {Dimension::of(2, 1, -2, 0, -1), "torsional stiffness"},
    {Dimension::of(-1, 1, -2) * Dimension::of(1, 0, 0).power(1, 2), "fracture toughness"},
    {Dimension::of(0, 0, 0, 0, 1), "angle"},
    {Dimension::of(-1, 0, 0, 0, 1), "angle per length"},
    {Dimension::of(0, 0, -1, 0, 1), "angular velocity"},
    {Dimension::of(0, 0, -2, 0, 1), "angular acceleration"},
    {Dimension::of(0, 0, 0, 1), "temperature"},
    {Dimension::of(0, 0, 0, -1), "coefficient of thermal expansion"},
};

/// "m^2", "kg", "m^(1/2)".
std::string factor(std::string_view unit, int twelfths) {
  const int common = std::gcd(twelfths, Dimension::one), top = twelfths / common, bottom = Dimension::one / common;
  if (bottom != 1) return std::string(unit) + "^(" + std::to_string(top) + "/" + std::to_string(bottom) + ")";
  return top == 1 ? std::string(unit) : std::string(unit) + "^" + std::to_string(top);
}

}  // namespace

std::string name_of(const Dimension& dimension) {
  for (const Named& named : names)
    if (named.dimension == dimension) return std::string(named.name);
  return "quantity in " + si_unit(dimension);
}

std::string si_unit(const Dimension& dimension) {
  constexpr std::string_view units[] = {"m", "kg", "s", "K", "rad"};
  constexpr Dimension::Base order[] = {Dimension::mass, Dimension::length, Dimension::time, Dimension::temperature,
                                       Dimension::angle};
  std::string above, below;
  int count_below = 0;
  for (const Dimension::Base base : order) {
    const int twelfths = dimension.twelfths[base];
    if (twelfths == 0) continue;
    std::string& part = twelfths > 0 ? above : below;
    count_below += twelfths < 0 ? 1 : 0;
    part += (part.empty() ? "" : "*") + factor(units[base], std::abs(twelfths));
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (count_below > 1 ? "(" + below + ")" : below);
}

}  // namespace loadpath
