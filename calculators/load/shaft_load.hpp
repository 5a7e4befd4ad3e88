// Load of one component on a shaft, an input record of the shaft: load = "=gears.gear_2". Gears, belts, chains and
// the drives of mechanisms give it.
#pragma once

#include "calculators/load/hub.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath {

/// A design load: the nominal one times the service factor of who gives it, which is so in all of its parts. Its
/// frame is that of the loaded shaft and is fixed in space while the shaft rotates: x points from the axis of this
/// shaft to that of its mate, or along the line of action, z along the shaft, in the same direction on both shafts of
/// a drive, and y makes a right hand with them. On the two shafts x and y thus point against each other: what acts
/// between them has the same F_x on both and the same F_y, and opposite F_z. F_x is positive where it draws the
/// shafts together (belt, chain, a wheel in a ring) and negative where it parts them (two wheels).
struct ShaftLoad {
  Moment T = unset<Moment>;
  Force F = unset<Force>, F_x = unset<Force>, F_y = unset<Force>, F_z = unset<Force>;
  Length d_w = unset<Length>, x_w = unset<Length>;
  AngularSpeed n = unset<AngularSpeed>;
  Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
  Mounted kind = Mounted::unsaid;

  static constexpr Fields fields{
      Field{&ShaftLoad::T, "T", N_m, "torque, with the application factor (belts, chains: service factor)"}
          .load()
          .with("F|F_x|F_y, F_z")
          .holding("K_A"),
      Field{&ShaftLoad::F, "F", N, "transverse force: F_x with F_y"}.load().with("T, F_z").holding("K_A"),
      Field{&ShaftLoad::F_x, "F_x", N, "force along x, positive toward the mating part"}
          .load()
          .with("T, F_y, F_z")
          .holding("K_A"),
      Field{&ShaftLoad::F_y, "F_y", N, "force along y, at right angles to x and the shaft"}
          .load()
          .with("T, F_x, F_z")
          .holding("K_A"),
      Field{&ShaftLoad::F_z, "F_z", N, "axial force; bends the shaft by F_z d_w/2"}
          .load()
          .with("T, F|F_x|F_y")
          .holding("K_A"),
      Field{&ShaftLoad::d_w, "d_w", mm, "diameter at which the forces act"},
      Field{&ShaftLoad::x_w, "x_w", mm, "distance from the axis to the point of action, along x"},
      Field{&ShaftLoad::n, "n", rpm, "speed of the shaft; of gears counter-clockwise positive"},
      Field{&ShaftLoad::d_f, "d_f", mm,
            "root diameter of an external gear or a sprocket, groove bottom diameter of a V-belt pulley; otherwise the "
            "diameter at which the forces act"},
      Field{&ShaftLoad::h_t, "h_t", mm, "tooth depth of an external gear"},
      Field{&ShaftLoad::b_r, "b_r", mm, "rim width of a gear or pulley"},
      Field{&ShaftLoad::bore, "bore", mm, "bore of a gear"},
      Choice{&ShaftLoad::kind, "kind", "source of the load"}};
};

/// Forces on a shaft in its own frame.
struct ShaftForces {
  Force x, y, z;
};

/// Record of design loads, with the service factor. `side`: 1 where they act at the point next to the mate, -1 at the
/// one away from it, as on a wheel in a ring, 0 at the axis, as for a belt.
inline ShaftLoad shaft_load(Moment T, const ShaftForces& own, Length d_w, AngularSpeed n, double side = 1.0) {
  ShaftLoad load;
  load.T = abs(T), load.F = sqrt(own.x * own.x + own.y * own.y);
  load.F_x = own.x, load.F_y = own.y, load.F_z = own.z;
  load.d_w = load.d_f = d_w, load.x_w = side * d_w / 2.0, load.n = n;
  return load;
}

}  // namespace loadpath
