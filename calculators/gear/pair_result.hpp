// Result of a gear pair.
#pragma once

#include "calculators/gear/rated_mesh.hpp"
#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

namespace loadpath::gear {

inline constexpr double most_shift = 3.0;  // for one gear, in normal modules

struct PairResult {
  double u = unset<double>;
  double alpha_t = unset<double>, alpha_wt = unset<double>;
  Length m_t = unset<Length>, a = unset<Length>, a_w = unset<Length>;
  double x_0 = unset<double>, x_2 = unset<double>, k = unset<double>;
  Length d_1 = unset<Length>, d_2 = unset<Length>, d_b1 = unset<Length>, d_b2 = unset<Length>;
  Length d_w1 = unset<Length>, d_w2 = unset<Length>;
  Length d_a1 = unset<Length>, d_a2 = unset<Length>, d_f1 = unset<Length>, d_f2 = unset<Length>;
  Length c_1 = unset<Length>, c_2 = unset<Length>, d_clear = unset<Length>;
  Length p_et = unset<Length>, g_f = unset<Length>, g_a = unset<Length>, g_alpha = unset<Length>;
  double eps_alpha = unset<double>, eps_beta = unset<double>, eps_gamma = unset<double>;
  double x_min1 = unset<double>, x_min2 = unset<double>, x_free = unset<double>;
  Length s_n1 = unset<Length>, s_n2 = unset<Length>, s_an1 = unset<Length>, s_an2 = unset<Length>;
  double q_a = unset<double>, s_a = unset<double>, f_int = unset<double>;
  Length j_bn = unset<Length>;
  double k_W1 = unset<double>, k_W2 = unset<double>;
  Length W_1 = unset<Length>, W_2 = unset<Length>;
  Length b = unset<Length>;
  AngularSpeed n_2 = unset<AngularSpeed>;
  Speed v = unset<Speed>;
  Moment T_2 = unset<Moment>;
  Force F_t = unset<Force>, F_tw = unset<Force>, F_rw = unset<Force>, F_a = unset<Force>, F_bn = unset<Force>;
  Force F_x1 = unset<Force>, F_y1 = unset<Force>, F_z1 = unset<Force>;
  Force F_x2 = unset<Force>, F_y2 = unset<Force>, F_z2 = unset<Force>;
  ShaftLoad gear_1, gear_2;
  RatedMesh mesh;
  double K_v = unset<double>, v_share = unset<double>;
  double Y_1 = unset<double>, Y_2 = unset<double>;
  Stress sigma_F1 = unset<Stress>, sigma_F2 = unset<Stress>;
  double u_F1 = unset<double>, u_F2 = unset<double>;
  Length s_R1 = unset<Length>, s_R2 = unset<Length>;
  double m_R1 = unset<double>, m_R2 = unset<double>;
};

inline constexpr Fields pair_results{
    Field{&PairResult::u, "u", ratio, "gear ratio z_2/z_1"},
    Field{&PairResult::alpha_t, "alpha_t", deg, "transverse pressure angle"},
    Field{&PairResult::m_t, "m_t", mm, "transverse module"},
    Field{&PairResult::a, "a", mm, "reference centre distance"},
    Field{&PairResult::a_w, "a_w", mm, "working centre distance"},
    Field{&PairResult::alpha_wt, "alpha_wt", deg, "working pressure angle, transverse"},
    Field{&PairResult::x_0, "x_0", ratio, "sum of profile shift coefficients for zero backlash"},
    Field{&PairResult::x_2, "x_2", ratio, "profile shift coefficient, gear 2, given or from a_w"}
        .limit(-most_shift, most_shift)
        .where_it_applies(),
    Field{&PairResult::d_1, "d_1", mm, "reference diameter of gear 1"},
    Field{&PairResult::d_2, "d_2", mm, "reference diameter of gear 2"},
    Field{&PairResult::d_b1, "d_b1", mm, "base diameter of gear 1"},
    Field{&PairResult::d_b2, "d_b2", mm, "base diameter of gear 2"},
    Field{&PairResult::d_w1, "d_w1", mm, "working pitch diameter of gear 1"}.same_as_that_of_source("drive.d_w1"),
    Field{&PairResult::d_w2, "d_w2", mm, "working pitch diameter of gear 2"}.same_as_that_of_source("drive.d_w2"),
    Field{&PairResult::k, "k", ratio, "tip shortening in normal modules"},
    Field{&PairResult::d_a1, "d_a1", mm, "tip diameter of gear 1"},
    Field{&PairResult::d_a2, "d_a2", mm, "tip diameter of gear 2 (ring gear: inner diameter)"},
    Field{&PairResult::d_f1, "d_f1", mm, "root diameter of gear 1"}.at_least_that_of_source("d"),
    Field{&PairResult::d_f2, "d_f2", mm, "root diameter of gear 2 (ring gear: outer diameter)"},
    Field{&PairResult::c_1, "c_1", mm, "tip clearance, gear 1"}.limit(-1e-6, 1e4).criterion(),
    Field{&PairResult::c_2, "c_2", mm, "tip clearance, gear 2"}.limit(-1e-6, 1e4).criterion(),
    Field{&PairResult::d_clear, "d_clear", mm,
          "minimum tip diameter of the ring gear without interference with the fillet of gear 1"},
    Field{&PairResult::p_et, "p_et", mm, "transverse base pitch"},
    Field{&PairResult::g_f, "g_f", mm, "path of approach (from the tip of gear 2 to the pitch point)"},
    Field{&PairResult::g_a, "g_a", mm, "path of recess (from the pitch point to the tip of gear 1)"},
    Field{&PairResult::g_alpha, "g_alpha", mm, "length of path of contact"},
    Field{&PairResult::eps_alpha, "eps_alpha", ratio, "transverse contact ratio"},
    Field{&PairResult::eps_beta, "eps_beta", ratio, "overlap ratio"},
    Field{&PairResult::eps_gamma, "eps_gamma", ratio, "total contact ratio (at least 1)"}.limit(1, 100).criterion(),
    Field{&PairResult::x_min1, "x_min1", ratio, "profile shift coefficient at the undercut limit, gear 1"},
    Field{&PairResult::x_min2, "x_min2", ratio, "profile shift coefficient at the undercut limit, gear 2"},
    Field{&PairResult::x_free, "x_free", ratio,
          "undercut: minimum margin of profile shift to the undercut limit (-0.02 is harmless)"}
        .limit(-0.02, 100)
        .criterion(),
    Field{&PairResult::s_n1, "s_n1", mm, "normal tooth thickness of gear 1 at the reference circle"},
    Field{&PairResult::s_n2, "s_n2", mm, "normal tooth thickness of gear 2 at the reference circle"},
    Field{&PairResult::s_an1, "s_an1", mm, "normal tip thickness of gear 1"},
    Field{&PairResult::s_an2, "s_an2", mm, "normal tip thickness of gear 2"},
    Field{&PairResult::q_a, "q_a", ratio,
          "flanks: minimum tip diameter / base diameter (no involute inside the base circle)"}
        .limit(1, 1e4)
        .criterion(),
    Field{&PairResult::s_a, "s_a", ratio, "tip thickness: minimum in modules (0.2; case-hardened 0.4)"}
        .limit(0.2, 100)
        .criterion(),
    Field{&PairResult::f_int, "f_int", ratio,
          "interference: minimum clearance between tips and fillets, or tips of pinion and ring "
          "gear, in modules (ring gear: clear from d_a2 = d_clear on)"}
        .limit(-0.01, 1e4)
        .criterion(),
    Field{&PairResult::j_bn, "j_bn", mm, "normal backlash (negative: jamming)"}.limit(-1e-6, 1e3).criterion(),
    Field{&PairResult::k_W1, "k_W1", ratio, "number of teeth of gear 1 spanned by W_1"},
    Field{&PairResult::W_1, "W_1", mm, "base tangent length, gear 1; none if b is too small for the measurement"},
    Field{&PairResult::k_W2, "k_W2", ratio, "number of teeth of gear 2 spanned by W_2"},
    Field{&PairResult::W_2, "W_2", mm, "base tangent length, gear 2; none if b is too small for the measurement"},
    Field{&PairResult::b, "b", mm, "common face width"},
    Field{&PairResult::n_2, "n_2", rpm, "speed of gear 2, negative if opposite to gear 1"},
    Field{&PairResult::v, "v", m_per_s, "pitch line velocity; of a rack its speed"},
    Field{&PairResult::T_2, "T_2", N_m, "torque of gear 2 on its shaft, without losses"}.load().with(
        "F_x2, F_y2, F_z2"),
    Field{&PairResult::F_t, "F_t", N, "nominal tangential force at the reference circle, for strength"}.load().with(
        "F_rw, F_a, T_1|T_2|gear_1.T|gear_2.T"),
    Field{&PairResult::F_tw, "F_tw", N, "tangential force at the working circle, for the bearings"}.load().with(
        "F_rw, F_a, T_1|T_2|gear_1.T|gear_2.T"),
    Field{&PairResult::F_rw, "F_rw", N, "radial force at the working circle"}.load().with(
        "F_tw, F_a, T_1|T_2|gear_1.T|gear_2.T"),
    Field{&PairResult::F_a, "F_a", N, "axial force"}.load().with("F_tw, F_rw, T_1|T_2|gear_1.T|gear_2.T"),
    Field{&PairResult::F_bn, "F_bn", N, "normal tooth force"}.load().with("T_1|T_2|gear_1.T|gear_2.T"),
    Field{&PairResult::F_x1, "F_x1", N, "force on gear 1 along x, from axis 1 to the pitch point"}.load().with(
        "F_y1, F_z1, T_1|gear_1.T"),
    Field{&PairResult::F_y1, "F_y1", N, "force on gear 1 along y, in the frame of F_x1"}.load().with(
        "F_x1, F_z1, T_1|gear_1.T"),
    Field{&PairResult::F_z1, "F_z1", N, "force on gear 1 along z, its axis"}.load().with("F_x1, F_y1, T_1|gear_1.T"),
    Field{&PairResult::F_x2, "F_x2", N, "force on gear 2 along x, in the frame of F_x1, not its own"}.load().with(
        "F_y2, F_z2, T_2|gear_2.T"),
    Field{&PairResult::F_y2, "F_y2", N, "force on gear 2 along y, in the frame of F_x1"}.load().with(
        "F_x2, F_z2, T_2|gear_2.T"),
    Field{&PairResult::F_z2, "F_z2", N, "force on gear 2 along z, in the frame of F_x1"}.load().with(
        "F_x2, F_y2, T_2|gear_2.T"),
    Group{&PairResult::gear_1, "gear_1", "shaft load of gear 1, in the frame of its shaft, for load"}.handed_over(),
    Group{&PairResult::gear_2, "gear_2", "shaft load of gear 2, in the frame of its shaft, for load"}.handed_over(),
    Group{&PairResult::mesh, "mesh", "teeth and load, for gear.rating"}.handed_over(),
    Field{&PairResult::K_v, "K_v", ratio, "velocity factor on the load; 1 without cutting"},
    Field{&PairResult::v_share, "v_share", ratio,
          "velocity factor: pitch line velocity / upper limit of its formula (a strength check needs "
          "cutting)"}
        .limit(0, 1, "n_1")
        .where_it_applies(),
    Field{&PairResult::Y_1, "Y_1", ratio, "Lewis form factor, gear 1, load at the tip"},
    Field{&PairResult::Y_2, "Y_2", ratio, "Lewis form factor, gear 2, load at the tip"},
    Field{&PairResult::sigma_F1, "sigma_F1", MPa, "Lewis bending stress, gear 1"},
    Field{&PairResult::sigma_F2, "sigma_F2", MPa, "Lewis bending stress, gear 2"},
    Field{&PairResult::u_F1, "u_F1", ratio, "tooth root bending, gear 1 (Lewis): stress / allowable stress"}.check(
        "sigma_adm_1"),
    Field{&PairResult::u_F2, "u_F2", ratio, "tooth root bending, gear 2 (Lewis): stress / allowable stress"}.check(
        "sigma_adm_2"),
    Field{&PairResult::s_R1, "s_R1", mm, "rim thickness of gear 1 above the keyway"},
    Field{&PairResult::m_R1, "m_R1", ratio,
          "backup ratio of gear 1: rim thickness / tooth depth (tooth root formulas apply from 1.2)"}
        .limit(1.2 * (1 - 1e-9), 1e6)
        .where_it_applies(),
    Field{&PairResult::s_R2, "s_R2", mm, "rim thickness of gear 2 above the keyway"},
    Field{&PairResult::m_R2, "m_R2", ratio, "backup ratio of gear 2: rim thickness / tooth depth"}
        .limit(1.2 * (1 - 1e-9), 1e6)
        .where_it_applies()};

}  // namespace loadpath::gear
