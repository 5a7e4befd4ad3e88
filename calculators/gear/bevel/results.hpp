// The results of gear.bevel.
#pragma once

#include "calculators/gear/bevel/types.hpp"

namespace loadpath::gear {

/// A force on one of the gears, with those that act at the same time.
template <class Result>
constexpr auto tooth_force(Force Result::*at, const char* key, const char* doc, const char* with) {
  return Field<Result, Force>{at, key, N, doc}.load().with(with);
}

inline constexpr auto bevel_results = [] {
  using Result = BevelTypes::Result;
  return Fields{
      Field{&Result::i, "i", ratio, "gear ratio z_2/z_1"},
      Field{&Result::delta_1, "delta_1", deg, "pitch cone angle, gear 1"},
      Field{&Result::delta_2, "delta_2", deg, "pitch cone angle, gear 2"},
      Field{&Result::d_1, "d_1", mm, "outer pitch diameter, gear 1"},
      Field{&Result::d_2, "d_2", mm, "outer pitch diameter, gear 2"},
      Field{&Result::R_e, "R_e", mm, "outer cone distance"},
      Field{&Result::R_m, "R_m", mm, "mean cone distance"},
      Field{&Result::d_m1, "d_m1", mm, "mean pitch diameter, gear 1"},
      Field{&Result::d_m2, "d_m2", mm, "mean pitch diameter, gear 2"},
      Field{&Result::m_m, "m_m", mm, "mean module"},
      Field{&Result::h_a1, "h_a1", mm, "outer addendum, gear 1"},
      Field{&Result::h_a2, "h_a2", mm, "outer addendum, gear 2"},
      Field{&Result::h_f1, "h_f1", mm, "outer dedendum, gear 1"},
      Field{&Result::h_f2, "h_f2", mm, "outer dedendum, gear 2"},
      Field{&Result::d_a1, "d_a1", mm, "outer tip diameter, gear 1"},
      Field{&Result::d_a2, "d_a2", mm, "outer tip diameter, gear 2"},
      Field{&Result::d_f1, "d_f1", mm, "outer root diameter, gear 1"},
      Field{&Result::d_f2, "d_f2", mm, "outer root diameter, gear 2"},
      Field{&Result::d_fi1, "d_fi1", mm, "inner root diameter, gear 1"},
      Field{&Result::d_fi2, "d_fi2", mm, "inner root diameter, gear 2"},
      Field{&Result::theta_f1, "theta_f1", deg, "dedendum angle, gear 1"},
      Field{&Result::theta_f2, "theta_f2", deg, "dedendum angle, gear 2"},
      Field{&Result::delta_a1, "delta_a1", deg, "face (tip) cone angle, gear 1, for constant clearance"},
      Field{&Result::delta_a2, "delta_a2", deg, "face (tip) cone angle, gear 2, for constant clearance"},
      Field{&Result::delta_f1, "delta_f1", deg, "root cone angle, gear 1"},
      Field{&Result::delta_f2, "delta_f2", deg, "root cone angle, gear 2"},
      Field{&Result::z_v1, "z_v1", ratio, "virtual number of teeth, gear 1"},
      Field{&Result::z_v2, "z_v2", ratio, "virtual number of teeth, gear 2"},
      Field{&Result::x_R, "x_R", ratio, "face width / outer cone distance, at most 1/3"}
          .limit(0, (1.0 + 1e-9) / 3.0)
          .criterion(),
      Field{&Result::x_m, "x_m", ratio, "face width / outer module, from 2 to 10"}
          .limit(2 * (1 - 1e-9), 10 * (1 + 1e-9))
          .criterion(),
      Field{&Result::eps_v, "eps_v", ratio, "contact ratio of the virtual spur gears"}.limit(1, 100).criterion(),
      Field{&Result::x_free, "x_free", ratio, "undercut: minimum margin of profile shift to the undercut limit"}
          .limit(-0.02, 1000)
          .criterion(),
      Field{&Result::s_a, "s_a", ratio, "tip thickness: minimum in modules (0.2; case-hardened 0.4)"}
          .limit(0.2, 100)
          .criterion(),
      Field{&Result::n_2, "n_2", rpm, "speed of gear 2"},
      Field{&Result::v_e, "v_e", m_per_s, "pitch line velocity at the outer pitch diameter"},
      Field{&Result::T_2, "T_2", N_m, "torque of gear 2, nominal, without losses"}.load().with("F_t, F_r2, F_a2"),
      tooth_force(&Result::F_t, "F_t", "nominal tangential force at the mean pitch diameter",
                  "F_r1|F_r2, F_a1|F_a2, T_1|T_2|gear_1.T|gear_2.T"),
      tooth_force(&Result::F_r1, "F_r1", "nominal radial force on gear 1, towards its axis", "F_t, F_a1, T_1|gear_1.T"),
      tooth_force(&Result::F_a1, "F_a1", "nominal axial force on gear 1, away from the apex",
                  "F_t, F_r1, T_1|gear_1.T"),
      tooth_force(&Result::F_r2, "F_r2", "nominal radial force on gear 2, towards its axis", "F_t, F_a2, T_2|gear_2.T"),
      tooth_force(&Result::F_a2, "F_a2", "nominal axial force on gear 2, away from the apex",
                  "F_t, F_r2, T_2|gear_2.T"),
      tooth_force(&Result::F_y1, "F_y1", "tangential force on gear 1 along y of its shaft, signed, with K_A",
                  "F_r1, F_a1, T_1|gear_1.T")
          .holding("K_A"),
      Group{&Result::gear_1, "gear_1", "shaft load of gear 1: x towards the mesh, z away from the apex, for load"}
          .handed_over(),
      Group{&Result::gear_2, "gear_2", "shaft load of gear 2: x towards the mesh, z away from the apex, for load"}
          .handed_over(),
      Field{&Result::m_R1, "m_R1", ratio,
            "backup ratio of gear 1: rim at the inner end / tooth depth (tooth root formulas apply from 1.2)"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Result::m_R2, "m_R2", ratio, "backup ratio of gear 2: rim at the inner end / tooth depth"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Result::W_t, "W_t", N, "nominal tangential force at the outer pitch diameter, for the rating"},
      Field{&Result::K_v, "K_v", ratio, "dynamic factor"},
      Field{&Result::x_v, "x_v", ratio, "pitch line velocity / maximum for this accuracy number"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::K_s, "K_s", ratio, "size factor, bending"},
      Field{&Result::K_m, "K_m", ratio, "load distribution factor"},
      Field{&Result::C_s, "C_s", ratio, "size factor, pitting"},
      Field{&Result::C_xc, "C_xc", ratio, "crowning factor, pitting"},
      Field{&Result::C_p, "C_p", ratio, "elastic coefficient, sqrt(MPa)"},
      Field{&Result::N_1, "N_1", ratio, "load cycles, gear 1: the life factors hold from 1e3 to 1e10"}
          .limit(1e3, 1e10)
          .where_it_applies(),
      Field{&Result::N_2, "N_2", ratio, "load cycles, gear 2"}.limit(1e3, 1e10).where_it_applies(),
      Field{&Result::C_L1, "C_L1", ratio, "stress cycle factor for pitting, gear 1"},
      Field{&Result::C_L2, "C_L2", ratio, "stress cycle factor for pitting, gear 2"},
      Field{&Result::K_L1, "K_L1", ratio, "stress cycle factor for bending, gear 1"},
      Field{&Result::K_L2, "K_L2", ratio, "stress cycle factor for bending, gear 2"},
      Field{&Result::K_R, "K_R", ratio, "reliability factor, bending"},
      Field{&Result::C_R, "C_R", ratio, "reliability factor, pitting"},
      Field{&Result::K_T, "K_T", ratio, "temperature factor"},
      Field{&Result::s_c, "s_c", MPa, "contact stress"},
      Field{&Result::s_wc1, "s_wc1", MPa, "permissible contact stress, gear 1, at a safety factor of 1"},
      Field{&Result::s_wc2, "s_wc2", MPa, "permissible contact stress, gear 2, at a safety factor of 1"},
      Field{&Result::s_t1, "s_t1", MPa, "bending stress, gear 1"},
      Field{&Result::s_t2, "s_t2", MPa, "bending stress, gear 2"},
      Field{&Result::s_wt1, "s_wt1", MPa, "permissible bending stress, gear 1, at a safety factor of 1"},
      Field{&Result::s_wt2, "s_wt2", MPa, "permissible bending stress, gear 2, at a safety factor of 1"},
      Field{&Result::S_H1, "S_H1", ratio, "safety factor against pitting, gear 1"},
      Field{&Result::S_H2, "S_H2", ratio, "safety factor against pitting, gear 2"},
      Field{&Result::S_F1, "S_F1", ratio, "safety factor against tooth breakage, gear 1"},
      Field{&Result::S_F2, "S_F2", ratio, "safety factor against tooth breakage, gear 2"},
      Field{&Result::u_H1, "u_H1", ratio, "pitting, gear 1: required / calculated safety factor"}.check("S_Hmin"),
      Field{&Result::u_H2, "u_H2", ratio, "pitting, gear 2: required / calculated safety factor"}.check("S_Hmin"),
      Field{&Result::u_F1, "u_F1", ratio, "tooth breakage, gear 1: required / calculated safety factor"}.check(
          "S_Fmin"),
      Field{&Result::u_F2, "u_F2", ratio, "tooth breakage, gear 2: required / calculated safety factor"}.check(
          "S_Fmin")};
}();

}  // namespace loadpath::gear
