// The teeth of a pair and their load, input record of gear.rating: mesh = "=stage.mesh".
#pragma once

#include "calculators/gear/pair_input.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

namespace loadpath::gear {

/// The finish of the flanks, which a pair and its rating have in common.
inline constexpr auto flanks_ground = "teeth with ground or shaved flanks";
inline constexpr auto flanks_not_ground = "teeth with flanks as cut or cast";

/// Set for an external pair under load only. The torque excludes the application factor, which is a field of its own.
struct RatedMesh {
  double z_1 = unset<double>, z_2 = unset<double>;
  Length m_n = unset<Length>;
  double alpha_n = unset<double>, beta = unset<double>, x_1 = unset<double>, x_2 = unset<double>;
  Length a_w = unset<Length>;
  double h_aP = unset<double>, h_fP = unset<double>, rho_fP = unset<double>;
  Shortening shortening = Shortening::clearance;
  Length b = unset<Length>;
  Moment T_1 = unset<Moment>;
  AngularSpeed n_1 = unset<AngularSpeed>;
  double K_A = unset<double>;
  Idler idler = Idler::none;

  static constexpr Fields fields{
      Field{&RatedMesh::z_1, "z_1", ratio, "number of teeth, gear 1"},
      Field{&RatedMesh::z_2, "z_2", ratio, "number of teeth, gear 2"},
      Field{&RatedMesh::m_n, "m_n", mm, "normal module"},
      Field{&RatedMesh::alpha_n, "alpha_n", deg, "normal pressure angle"},
      Field{&RatedMesh::beta, "beta", deg, "helix angle"},
      Field{&RatedMesh::x_1, "x_1", ratio, "profile shift coefficient, gear 1"},
      Field{&RatedMesh::x_2, "x_2", ratio, "profile shift coefficient, gear 2"},
      Field{&RatedMesh::a_w, "a_w", mm, "working centre distance"},
      Field{&RatedMesh::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"},
      Field{&RatedMesh::h_fP, "h_fP", ratio, "dedendum of the basic rack, in modules"},
      Field{&RatedMesh::rho_fP, "rho_fP", ratio, "root fillet radius of the basic rack, in modules"},
      Choice{&RatedMesh::shortening, "shortening", "tip shortening"},
      Field{&RatedMesh::b, "b", mm, "common face width"},
      Field{&RatedMesh::T_1, "T_1", N_m, "torque of gear 1, nominal"}.load(),
      Field{&RatedMesh::n_1, "n_1", rpm, "speed of gear 1"},
      Field{&RatedMesh::K_A, "K_A", ratio, "application factor K_A, not included in T_1"},
      Choice{&RatedMesh::idler, "idler", "idler gear (reversed tooth bending)"}};
};

}  // namespace loadpath::gear
