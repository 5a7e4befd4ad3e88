// The results of gear.worm.
#pragma once

#include "calculators/gear/worm/types.hpp"

namespace loadpath::gear {

inline constexpr auto worm_results = [] {
  using Result = WormTypes::Result;
  constexpr auto on_both = "F_t1|F_t2, F_r, T_1|T_2|worm.T|wheel.T";
  return Fields{
      Field{&Result::i, "i", ratio, "gear ratio z_2/z_1"},
      Field{&Result::q, "q", ratio, "diameter quotient of the worm: d_1/m_x"},
      Field{&Result::gamma, "gamma", deg, "lead angle at the reference diameter"},
      Field{&Result::p_x, "p_x", mm, "axial pitch of the worm"},
      Field{&Result::p_z, "p_z", mm, "lead"},
      Field{&Result::d_2, "d_2", mm, "reference diameter of the wheel"},
      Field{&Result::a, "a", mm, "centre distance"},
      Field{&Result::d_a1, "d_a1", mm, "tip diameter of the worm"},
      Field{&Result::d_f1, "d_f1", mm, "root diameter of the worm"},
      Field{&Result::d_a2, "d_a2", mm, "throat (tip) diameter of the wheel"},
      Field{&Result::d_f2, "d_f2", mm, "root diameter of the wheel"},
      Field{&Result::L_1, "L_1", mm, "recommended threaded length of the worm"},
      Field{&Result::b_2H, "b_2H", mm, "effective width of the wheel: a wider face is not in contact"},
      Field{&Result::x_b, "x_b", ratio, "face width of the wheel / axial module, at least 3"}
          .limit(3 * (1 - 1e-9), 1e4)
          .criterion(),
      Field{&Result::z_min, "z_min", ratio, "minimum number of teeth of the wheel without undercut"},
      Field{&Result::x_z, "x_z", ratio, "undercut: number of teeth of the wheel / minimum"}
          .limit(0.98, 1e4)
          .criterion(),
      Field{&Result::n_2, "n_2", rpm, "speed of the wheel"},
      Field{&Result::v_2, "v_2", m_per_s, "pitch line velocity of the wheel"},
      Field{&Result::v_s, "v_s", m_per_s, "sliding velocity at the reference diameter"},
      Field{&Result::mu, "mu", ratio, "coefficient of friction"},
      Field{&Result::eta, "eta", ratio,
            "efficiency of the mesh, the worm drives; without bearings, seals and churning"},
      Field{&Result::eta_b, "eta_b", ratio, "efficiency of the mesh, the wheel drives (0 or less: self-locking)"},
      Field{&Result::x_L, "x_L", ratio, "self-locking: tangent of the lead angle / of the friction angle"}
          .limit(0, 1)
          .criterion()
          .where_it_applies(),
      Field{&Result::T_1, "T_1", N_m, "torque of the worm, nominal"}.load().with("F_t1, F_t2, F_r"),
      Field{&Result::T_2, "T_2", N_m, "torque of the wheel, nominal"}.load().with("F_t1, F_t2, F_r"),
      Field{&Result::F_t1, "F_t1", N, "tangential force on the worm, the axial one on the wheel, nominal"}.load().with(
          "F_t2, F_r, T_1|T_2|worm.T|wheel.T"),
      Field{&Result::F_t2, "F_t2", N, "tangential force on the wheel, the axial one on the worm, nominal"}.load().with(
          "F_t1, F_r, T_1|T_2|worm.T|wheel.T"),
      Field{&Result::F_r, "F_r", N, "radial force, separating worm and wheel, nominal"}.load().with(
          "F_t1, F_t2, T_1|T_2|worm.T|wheel.T"),
      Field{&Result::F_n, "F_n", N, "normal tooth force, nominal"}.load().with(on_both),
      Field{&Result::P_1, "P_1", kW, "power of the worm, nominal"},
      Field{&Result::P_2, "P_2", kW, "power of the wheel, nominal"},
      Field{&Result::P_V, "P_V", kW, "power loss of the mesh"},
      Field{&Result::F_y1, "F_y1", N, "tangential force on the worm along y of its shaft, signed, with K_A"}
          .load()
          .with("F_z1, F_r, T_1|worm.T")
          .holding("K_A"),
      Field{&Result::F_z1, "F_z1", N, "axial force on the worm along z of its shaft, signed, with K_A"}
          .load()
          .with("F_y1, F_r, T_1|worm.T")
          .holding("K_A"),
      Field{&Result::tau_f1, "tau_f1", MPa,
            "torsional stress of the worm at its root circle, with K_A, at most 100 MPa"}
          .limit(0, 100)
          .criterion()
          .where_it_applies(),
      Group{&Result::worm, "worm", "shaft load of the worm: x towards the wheel, for load"}.handed_over(),
      Group{&Result::wheel, "wheel", "shaft load of the wheel: x towards the worm, z along y of the worm, for load"}
          .handed_over(),
      Field{&Result::m_R2, "m_R2", ratio,
            "backup ratio of the wheel: rim / tooth depth (tooth root formulas apply from 1.2)"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Result::C_s, "C_s", ratio, "materials factor (inch units): large wheels below 300 are not rated"}
          .limit(300, 1000)
          .where_it_applies(),
      Field{&Result::C_m, "C_m", ratio, "ratio correction factor"},
      Field{&Result::C_v, "C_v", ratio, "velocity factor"},
      Field{&Result::x_i, "x_i", ratio, "gear ratio: the ratio correction factor holds from 3 to 100"}
          .limit(3, 100)
          .where_it_applies(),
      Field{&Result::x_s, "x_s", ratio, "sliding velocity / 30 m/s, up to which the velocity factor holds"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::x_n, "x_n", ratio, "speed of the worm / 3600 rpm, up to which AGMA 6034 applies"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Result::F_e, "F_e", mm, "effective face width of the wheel, at most 0.67 d_1"},
      Field{&Result::W_tR, "W_tR", N, "rated tangential force of the wheel"},
      Field{&Result::S_W, "S_W", ratio, "safety factor against pitting and wear: rated / tangential force"},
      Field{&Result::y, "y", ratio, "form factor of the wheel, by the circular pitch"},
      Field{&Result::K_v, "K_v", ratio, "velocity factor for bending, on the load"},
      Field{&Result::sigma_F, "sigma_F", MPa, "bending stress of the wheel teeth"},
      Field{&Result::P_K, "P_K", kW, "heat that the case dissipates at the allowable temperature rise"},
      Field{&Result::dT, "dT", kelvin, "temperature rise of the oil above the surroundings"},
      Field{&Result::u_W, "u_W", ratio, "pitting and wear of the wheel: required / calculated safety factor"}.check(
          "S_Wmin"),
      Field{&Result::u_F, "u_F", ratio, "tooth bending of the wheel: stress / allowable stress"}.check("sigma_adm"),
      Field{&Result::u_T, "u_T", ratio, "heat: power loss / dissipated power"}.check("dT_adm, P_cool")};
}();

}  // namespace loadpath::gear
