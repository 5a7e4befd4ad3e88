// What one thing on a shaft does to it, for a shaft to take whole: load = "=gears.gear_2". Gears, belts, chains and the
// drives of mechanisms give it.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/units.hpp"

#include <tuple>

namespace loadpath {

/// A design load: the nominal one times the service factor of who gives it, which is so in all of its parts. z lies
/// along the shaft, x points from its axis to that of its mate, or along the line of pull; it stands in space while the
/// shaft turns.
struct ShaftLoad {
  Moment T = unset<Moment>;
  Force F = unset<Force>, F_x = unset<Force>, F_y = unset<Force>, F_z = unset<Force>;
  Length d_w = unset<Length>;
  AngularSpeed n = unset<AngularSpeed>;

  static constexpr std::tuple fields{
      Field{&ShaftLoad::T, "T", N_m, "torque, with the service factor"}.load().with("F, F_z").holding("K_A"),
      Field{&ShaftLoad::F, "F", N, "transverse force: F_x with F_y"}.load().with("T, F_z").holding("K_A"),
      Field{&ShaftLoad::F_x, "F_x", N, "force along x, to the mate or along the line of pull"}.load().holding("K_A"),
      Field{&ShaftLoad::F_y, "F_y", N, "force along y"}.load().holding("K_A"),
      Field{&ShaftLoad::F_z, "F_z", N, "force along the shaft"}.load().holding("K_A"),
      Field{&ShaftLoad::d_w, "d_w", mm, "diameter that the forces act at"},
      Field{&ShaftLoad::n, "n", rpm, "speed of the shaft"}};
};

/// Forces on a shaft, nominal.
struct ShaftForces {
  Force x, y, z;
};

/// Of nominal loads.
inline ShaftLoad shaft_load(double K_A, Moment T, const ShaftForces& on, Length d_w, AngularSpeed n) {
  const Force F_x = K_A * on.x, F_y = K_A * on.y;
  return {K_A * abs(T), sqrt(F_x * F_x + F_y * F_y), F_x, F_y, K_A * on.z, d_w, n};
}

}  // namespace loadpath
