// The results of gear.crossed.
#pragma once

#include "calculators/gear/crossed/types.hpp"

namespace loadpath::gear {

inline constexpr auto crossed_results = [] {
  using Result = CrossedTypes::Result;
  constexpr auto both = "F_t1|F_t2, F_a1|F_a2, F_r, T_1|T_2|gear_1.T|gear_2.T";
  return Fields{
      Field{&Result::i, "i", ratio, "gear ratio z_2/z_1; differs from the ratio of the diameters"},
      Field{&Result::Sigma, "Sigma", deg, "shaft angle: sum of the helix angles"},
      Field{&Result::d_1, "d_1", mm, "reference diameter, gear 1"},
      Field{&Result::d_2, "d_2", mm, "reference diameter, gear 2"},
      Field{&Result::a, "a", mm, "centre distance"},
      Field{&Result::d_a1, "d_a1", mm, "tip diameter, gear 1"},
      Field{&Result::d_a2, "d_a2", mm, "tip diameter, gear 2"},
      Field{&Result::d_f1, "d_f1", mm, "root diameter, gear 1"},
      Field{&Result::d_f2, "d_f2", mm, "root diameter, gear 2"},
      Field{&Result::d_b1, "d_b1", mm, "base diameter, gear 1"},
      Field{&Result::d_b2, "d_b2", mm, "base diameter, gear 2"},
      Field{&Result::beta_b1, "beta_b1", deg, "base helix angle, gear 1"},
      Field{&Result::beta_b2, "beta_b2", deg, "base helix angle, gear 2"},
      Field{&Result::g_a1, "g_a1", mm, "path of contact from the pitch point to the tip of gear 1"},
      Field{&Result::g_a2, "g_a2", mm, "path of contact from the pitch point to the tip of gear 2"},
      Field{&Result::eps_n, "eps_n", ratio, "contact ratio: path of contact / normal base pitch"}
          .limit(1, 100)
          .criterion(),
      Field{&Result::x_free, "x_free", ratio, "undercut: minimum margin of profile shift to the undercut limit"}
          .limit(-0.02, 1000)
          .criterion(),
      Field{&Result::s_a, "s_a", ratio, "tip thickness: minimum in normal modules (0.2; case-hardened 0.4)"}
          .limit(0.2, 100)
          .criterion(),
      Field{&Result::x_b1, "x_b1", ratio, "axial travel of the contact point / face width, gear 1"}
          .limit(0, 1 + 1e-9)
          .criterion(),
      Field{&Result::x_b2, "x_b2", ratio, "axial travel of the contact point / face width, gear 2"}
          .limit(0, 1 + 1e-9)
          .criterion(),
      Field{&Result::n_2, "n_2", rpm, "speed of gear 2"},
      Field{&Result::v_1, "v_1", m_per_s, "pitch line velocity, gear 1"},
      Field{&Result::v_2, "v_2", m_per_s, "pitch line velocity, gear 2"},
      Field{&Result::v_s, "v_s", m_per_s, "sliding velocity along the teeth at the pitch point"},
      Field{&Result::eta, "eta", ratio, "efficiency of the mesh, gear 1 drives; without bearings, seals and churning"},
      Field{&Result::eta_b, "eta_b", ratio, "efficiency of the mesh, gear 2 drives (0 or less: self-locking)"},
      Field{&Result::x_L, "x_L", ratio, "self-locking: friction along the teeth of gear 1 / driving force"}
          .limit(1, 1e6)
          .criterion()
          .where_it_applies(),
      Field{&Result::T_1, "T_1", N_m, "torque of gear 1, nominal"}.load().with("F_t1|F_t2, F_a1|F_a2, F_r"),
      Field{&Result::T_2, "T_2", N_m, "torque of gear 2, nominal"}.load().with("F_t1|F_t2, F_a1|F_a2, F_r"),
      Field{&Result::F_n, "F_n", N, "normal tooth force, nominal"}.load().with(both),
      Field{&Result::F_t1, "F_t1", N, "tangential force on gear 1, nominal"}.load().with(
          "F_a1, F_r, T_1|T_2|gear_1.T|gear_2.T"),
      Field{&Result::F_t2, "F_t2", N, "tangential force on gear 2, nominal"}.load().with(
          "F_a2, F_r, T_1|T_2|gear_1.T|gear_2.T"),
      Field{&Result::F_a1, "F_a1", N, "axial force on gear 1, nominal, for counter-clockwise rotation of gear 1"}
          .load()
          .with("F_t1, F_r, T_1|T_2|gear_1.T|gear_2.T"),
      Field{&Result::F_a2, "F_a2", N, "axial force on gear 2, nominal, for counter-clockwise rotation of gear 1"}
          .load()
          .with("F_t2, F_r, T_1|T_2|gear_1.T|gear_2.T"),
      Field{&Result::F_r, "F_r", N, "radial force, separating the gears, nominal"}.load().with(
          "F_t1|F_t2, F_a1|F_a2, T_1|T_2|gear_1.T|gear_2.T"),
      Field{&Result::P_1, "P_1", kW, "power of gear 1, nominal"},
      Field{&Result::P_2, "P_2", kW, "power of gear 2, nominal"},
      Field{&Result::P_V, "P_V", kW, "power loss of the mesh"},
      Field{&Result::F_y1, "F_y1", N, "tangential force on gear 1 along y of its shaft, signed, with K_A"}
          .load()
          .with("F_z1, F_r, T_1|gear_1.T")
          .holding("K_A"),
      Field{&Result::F_z1, "F_z1", N, "axial force on gear 1 along z of its shaft, signed, with K_A"}
          .load()
          .with("F_y1, F_r, T_1|gear_1.T")
          .holding("K_A"),
      Field{&Result::F_y2, "F_y2", N, "tangential force on gear 2 along y of its shaft, signed, with K_A"}
          .load()
          .with("F_z2, F_r, T_2|gear_2.T")
          .holding("K_A"),
      Field{&Result::F_z2, "F_z2", N, "axial force on gear 2 along z of its shaft, signed, with K_A"}
          .load()
          .with("F_y2, F_r, T_2|gear_2.T")
          .holding("K_A"),
      Group{&Result::gear_1, "gear_1", "shaft load of gear 1: x towards gear 2, for load"}.handed_over(),
      Group{&Result::gear_2, "gear_2",
            "shaft load of gear 2: x towards gear 1, z is z of gear 1 turned by Sigma towards its y, for load"}
          .handed_over(),
      Field{&Result::m_R1, "m_R1", ratio, "backup ratio of gear 1: rim / tooth depth (minimum 1.2)"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Result::m_R2, "m_R2", ratio, "backup ratio of gear 2: rim / tooth depth (minimum 1.2)"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Result::b_e, "b_e", mm, "effective face width: the smaller one, at most 10 m_n"},
      Field{&Result::C, "C", MPa, "load value K_A F_t/(b_e p_n), with the larger tangential force"},
      Field{&Result::u_C, "u_C", ratio, "wear and pitting: load value / allowable load value"}.check("C_adm")};
}();

}  // namespace loadpath::gear
