// One mesh of a planetary set as a gear pair, input record of gear.pair: pair = "=set.sun_mesh".
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

namespace loadpath::gear {

/// The mesh relative to a stationary carrier: gear 1 is the sun, or the planet inside the ring. Loads of the planet
/// with the largest share; the application factor is not included yet.
struct MeshOfSet {
  Mesh mesh = Mesh::external;
  double z_1 = unset<double>, z_2 = unset<double>;
  Length m_n = unset<Length>;
  double beta = unset<double>, x_1 = unset<double>, x_2 = unset<double>, h_aP = unset<double>;
  Length d_a2 = unset<Length>;
  Moment T_1 = unset<Moment>;
  AngularSpeed n_1 = unset<AngularSpeed>;
  Idler idler = Idler::gear_2;

  static constexpr Fields fields{
      Choice{&MeshOfSet::mesh, "mesh", "type of mesh: external gear, ring gear or rack"},
      Field{&MeshOfSet::z_1, "z_1", ratio, "number of teeth, gear 1"},
      Field{&MeshOfSet::z_2, "z_2", ratio, "number of teeth, gear 2"},
      Field{&MeshOfSet::m_n, "m_n", mm, "normal module"},
      Field{&MeshOfSet::beta, "beta", deg, "helix angle"},
      Field{&MeshOfSet::x_1, "x_1", ratio, "profile shift coefficient, gear 1"},
      Field{&MeshOfSet::x_2, "x_2", ratio, "profile shift coefficient, gear 2"},
      Field{&MeshOfSet::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"},
      Field{&MeshOfSet::d_a2, "d_a2", mm, "tip diameter of the ring gear, if its addendum differs"},
      Field{&MeshOfSet::T_1, "T_1", N_m, "torque on gear 1 from this mesh, positive if gear 1 drives"}.load().holding(
          "K_gamma"),
      Field{&MeshOfSet::n_1, "n_1", rpm, "speed of gear 1 relative to the carrier"},
      Choice{&MeshOfSet::idler, "idler", "planet: reversed tooth bending"}};
};

}  // namespace loadpath::gear
