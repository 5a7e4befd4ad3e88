// gear.rating by ISO 6336-2 and -3:2006 (its load factors: rating_iso_load.cpp): published examples, form factors by an
// independent construction, and what both standards have in common.
#include "calculators/gear/rating/rating.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <string_view>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using namespace loadpath::test;
using In = Rating::Input;

bool is_refused(const In& in, std::string_view keys) {
  for (const auto& rule : Rating::rules) {
    if (!rule.only_warns && std::string_view(rule.fields) == keys && !rule.holds(in)) return true;
  }
  return false;
}

Rating::Result rated_well(const In& in) {
  for (const auto& rule : Rating::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  return evaluated<Rating>(in);
}

In of_iso(double m, int z_1, int z_2, double beta, double b, double R_z, double nu_40) {
  In in;
  in.standard = RatingStandard::iso6336;
  in.m_n = m * mm, in.z_1 = z_1, in.z_2 = z_2, in.beta = beta * deg.one, in.b = b * mm;
  in.x_1 = in.x_2 = 0.0, in.rho_fP = 0.25, in.shortening = Shortening::none, in.f_ma = 0.0 * mm;
  in.R_z1 = in.R_z2 = R_z * um, in.nu_40 = nu_40 * mm2_per_s, in.place = gear::Place::middle, in.grade = 6;
  in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.sigma_Hlim_1 = in.sigma_Hlim_2 = 1500.0 * MPa, in.sigma_Flim_1 = in.sigma_Flim_2 = 430.0 * MPa;
  return in;
}

/// Example 1 of ISO/TR 6336-30.
In example_1() {
  In in = of_iso(8, 17, 103, 15.8, 100, 6, 320);
  in.x_1 = 0.14522, in.x_2 = unset<double>, in.a_w = 500.0 * mm, in.h_fP = 1.4, in.rho_fP = 0.39, in.grade = 5;
  in.T_1 = 9000.0 * N_m, in.n_1 = 360.0 * rpm, in.L_h = 50000.0 * hour;
  return in;
}

In shifted() {
  In in = of_iso(4, 19, 104, 0, 48.64, 5, 150);
  in.x_1 = 0.5, in.x_2 = 0.15, in.n_1 = 980.0 * rpm, in.T_1 = 55.0 * kW.one / in.n_1, in.K_A = 1.75;
  return in;
}

/// A case-hardened pinion on a quenched and tempered wheel.
In soft_wheel() {
  In in = of_iso(3, 25, 60, 0, 24, 6, 150);
  in.n_1 = 1450.0 * rpm, in.T_1 = 15.0 * kW.one / in.n_1, in.K_A = 1.25, in.grade = 7, in.R_z2 = 12.0 * um;
  in.material_2 = GearMaterial::through_alloy, in.H_2 = 266;
  in.sigma_Hlim_2 = 740.0 * MPa, in.sigma_Flim_2 = 295.0 * MPa;
  return in;
}

}  // namespace

TEST_SUITE("gear rating by ISO 6336") {
  TEST_CASE("example 1 of ISO/TR 6336-30: every factor of the flanks, and both limits") {
    const auto r = rated_well(example_1());
    CHECK(rel(r.F_t / N, 127352) < 1e-5);
    CHECK(rel(r.Z_H, 2.39533) < 5e-6);
    CHECK(rel(r.Z_E, 189.81170) < 1e-7);
    CHECK(std::abs(r.Z_eps - 0.803) < 5e-4);
    CHECK(std::abs(r.Z_beta - 1.01944) < 5e-6);
    CHECK(r.Z_B == 1.0);
    CHECK(r.Z_D == 1.0);
    CHECK(std::abs(r.Z_L - 1.04739) < 5e-6);
    CHECK(std::abs(r.Z_v - 0.96911) < 5e-6);
    CHECK(std::abs(r.Z_R - 0.96599) < 5e-6);
    CHECK(std::abs(r.Z_NT1 - 0.91) < 5e-4);
    CHECK(std::abs(r.Z_NT2 - 0.962) < 5e-4);
    CHECK(rel(r.sigma_H0 / MPa, 1206.58207) < 2e-4);
    CHECK(rel(r.sigma_HG1 / MPa, 1338.48050) < 1e-8);
    CHECK(rel(r.sigma_HG2 / MPa, 1414.52551) < 1e-8);
  }

  TEST_CASE("a helical pair of 25 and 40 teeth: film factors and limit as published") {
    In in = of_iso(2, 25, 40, 20, 26, 18, 318);
    in.h_fP = 1.3, in.T_1 = 150.0 * N_m, in.n_1 = 3000.0 * rpm;
    const auto r = rated_well(in);
    CHECK(rel(r.F_t / N, 5638) < 1e-4);
    CHECK(std::abs(r.Z_L - 1.047) < 5e-4);
    CHECK(std::abs(r.Z_v - 0.995) < 5e-4);
    CHECK(std::abs(r.Z_R - 0.854) < 5e-4);
    CHECK(r.Z_NT1 == 0.85);
    CHECK(rel(r.sigma_HG1 / MPa, 1135.4) < 1e-3);
  }

  TEST_CASE(
      "form factors: the fillet drawn as the envelope of the rack, the load at the outer point of single contact") {
    const auto helical = rated_well(example_1());
    CHECK(rel(helical.Y_F1, 1.55591885) < 1e-8);
    CHECK(rel(helical.Y_S1, 1.82483753) < 1e-6);
    CHECK(rel(helical.Y_F2, 1.33657516) < 1e-8);
    CHECK(rel(helical.Y_S2, 2.07502158) < 1e-6);
    const auto spur = rated_well(shifted());
    CHECK(rel(spur.Y_F1, 1.22275448) < 1e-8);
    CHECK(rel(spur.Y_S1, 2.51792967) < 1e-6);
    CHECK(rel(spur.Y_F2, 1.42659226) < 1e-8);
    CHECK(rel(spur.Y_S2, 2.37408774) < 1e-6);
    CHECK(rel(spur.sigma_F01 / MPa, spur.F_t / N / (48.64 * 4.0) * 1.22275448 * 2.51792967) < 1e-6);
  }

  TEST_CASE("edition 2019 of the root: f_eps as printed for two planetary gears, and what it changes") {
    struct Row {
      int z_1, z_2;
      double x_1, x_2, b, f_eps;
    };
    for (const Row& row : {Row{41, 34, 0.3698, 0.9220, 750, 0.840}, Row{33, 27, 0.2004, 0.2624, 800, 0.801}}) {
      In in = of_iso(40, row.z_1, row.z_2, 15, row.b, 5, 320);
      in.x_1 = row.x_1, in.x_2 = row.x_2, in.shortening = Shortening::clearance;
      in.T_1 = 1e5 * N_m, in.n_1 = 10.0 * rpm;
      const auto before = rated_well(in);
      in.root_edition = RootEdition::of_2019;
      const auto r = rated_well(in);
      CHECK(std::abs(r.f_eps - row.f_eps) < 5e-4);
      CHECK(rel(r.Y_F1, r.f_eps * before.Y_F1) < 1e-12);
      CHECK(rel(r.Y_F2, r.f_eps * before.Y_F2) < 1e-12);
      CHECK(rel(r.Y_beta, before.Y_beta / std::pow(std::cos(15 * deg.one), 3)) < 1e-12);
      CHECK(r.Y_S1 == before.Y_S1);
      CHECK(r.sigma_H1 == before.sigma_H1);
      CHECK(!is_set(before.f_eps));
    }
    In spur = shifted();
    const auto before = rated_well(spur);
    spur.root_edition = RootEdition::of_2019;
    CHECK(rated_well(spur).f_eps == 1.0);
    CHECK(rel(rated_well(spur).sigma_F1, before.sigma_F1) < 1e-12);
    spur.standard = RatingStandard::din3990, spur.s_R1 = unset<Length>;
    CHECK(is_refused(spur, "standard, root_edition"));
  }

  TEST_CASE("f_eps is continuous in the overlap ratio, and never above 1") {
    double f = 1.0;
    for (double b = 10; b < 120; b += 0.5) {
      In in = of_iso(4, 23, 61, 12, b, 5, 150);
      in.T_1 = 100.0 * N_m, in.n_1 = 500.0 * rpm, in.root_edition = RootEdition::of_2019;
      const double now = rated_well(in).f_eps;
      CHECK(now <= f + 1e-12);
      CHECK(f - now < 0.1);
      f = now;
    }
    CHECK(f < 0.85);
  }

  TEST_CASE("limits of the root: notch by a slip layer of 0.003 mm, life at 1e10 cycles, no bonus for smooth flanks") {
    const double q_s = 3.32380358;  // of the pinion, from the same construction
    const double Y_delta = (1 + std::sqrt(0.2 * 0.003 * (1 + 2 * q_s))) / (1 + std::sqrt(1.2 * 0.003));
    CHECK(rel(rated_well(shifted()).sigma_FG1 / MPa, 860 * 0.85 * Y_delta) < 1e-6);
    In rough = shifted();  // Y_RrelT at 36 um 0.915 and at 20 um 0.957, as printed elsewhere
    rough.R_z1 = 36.0 * um;
    CHECK(std::abs(rated_well(rough).sigma_FG1 / rated_well(shifted()).sigma_FG1 - 0.915) < 5e-4);
    rough.R_z1 = 20.0 * um;
    CHECK(std::abs(rated_well(rough).sigma_FG1 / rated_well(shifted()).sigma_FG1 - 0.957) < 5e-4);
  }

  TEST_CASE("spur gears have one nominal contact stress by both standards; with a helix they differ by its cosine") {
    std::mt19937_64 random(7);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int i = 0; i < 200; ++i) {
      const double beta = i % 2 == 0 ? 0.0 : between(2, 25);
      In iso = of_iso(between(2, 8), 20 + i % 30, 30 + i % 70, beta, 40, 8, between(50, 400));
      iso.T_1 = between(50, 500) * N_m, iso.n_1 = between(50, 1500) * rpm;
      In din = iso;
      din.standard = RatingStandard::din3990;
      const auto a = rated_well(iso), b = rated_well(din);
      CHECK(rel(a.sigma_H0, b.sigma_H0 / std::cos(beta * deg.one)) < 1e-12);
      CHECK(a.Z_eps == b.Z_eps);
      CHECK(a.Z_B == b.Z_B);
      CHECK(a.Y_beta == b.Y_beta);
    }
  }

  TEST_CASE("where one pair always carries the load, the outer point of single contact is the tip") {
    In in = shifted();
    double low = 0.6, high = 1.0;
    for (int i = 0; i < 80; ++i) {
      in.h_aP = 0.5 * (low + high);
      (evaluated<Rating>(in).x_eps < 1.0 ? low : high) = in.h_aP;
    }
    In din = in;
    din.standard = RatingStandard::din3990;
    const auto a = evaluated<Rating>(in), b = evaluated<Rating>(din);
    CHECK(rel(a.Y_F1, b.Y_Fa1) < 1e-9);
    CHECK(rel(a.Y_S2, b.Y_Sa2) < 1e-9);
    CHECK(rel(a.sigma_F01, b.sigma_F01) < 1e-9);  // and Y_eps is 1
  }

  TEST_CASE("a soft gear with a hard pinion, and with a harder one of the same kind") {
    const auto r = rated_well(soft_wheel());
    CHECK(rel(r.sigma_HG1 / MPa, 1026.4872734) < 1e-9);
    CHECK(rel(r.sigma_HG2 / MPa, 529.8043985) < 1e-9);  // equivalent roughness 4.725 um, Z_W 1.04622
    In in = soft_wheel();
    in.material_1 = GearMaterial::through_alloy, in.H_1 = 300, in.H_2 = 250;
    in.sigma_Hlim_1 = in.sigma_Hlim_2 = 740.0 * MPa;
    const auto level = rated_well(in);  // 1.2 as hard: (0.00898 1.2 - 0.00829)(2.4 - 1)
    CHECK(rel(level.sigma_HG2, 1.0034804 * level.sigma_HG1) < 1e-12);
    in.H_1 = 299;
    CHECK(rated_well(in).sigma_HG2 == rated_well(in).sigma_HG1);
  }

  TEST_CASE("lives: static limits without film, a knee, and 0.85 of it from 1e10 cycles on") {
    In in = shifted();
    const auto endless = rated_well(in);
    const double film = endless.Z_LVR;
    double Z = HUGE_VAL, Y = HUGE_VAL;
    for (const double hours : {1e-2, 1.0, 1e2, 850.34013605, 1e4, 1e5, 2e5}) {
      in.L_h = hours * hour;
      const auto r = rated_well(in);
      CHECK(r.Z_NT1 <= Z);
      CHECK(r.Y_NT1 <= Y);
      Z = r.Z_NT1, Y = r.Y_NT1;
    }
    CHECK(Z == 0.85);
    CHECK(Y == 0.85);
    CHECK(Z == endless.Z_NT1);
    in.L_h = 850.34013605 * hour;  // 5e7 turns
    CHECK(rel(rated_well(in).Z_NT1, 1.0) < 1e-9);
    in.L_h = 1e-2 * hour;
    CHECK(rel(rated_well(in).sigma_HG1 / MPa, 1.6 * 1500) < 1e-12);
    CHECK(rel(rated_well(in).Z_NT1, 1.6 / film) < 1e-12);
  }

  TEST_CASE("rims: no loss from 1.2 times the tooth depth on, refused from half of it, and by DIN 3990") {
    In in = shifted();
    in.s_R1 = 8.0 * mm, in.s_R2 = 10.8 * mm;  // of a depth of 9 mm
    const auto r = rated_well(in), solid = rated_well(shifted());
    CHECK(rel(r.Y_B1, 1.6 * std::log(2.242 * 9 / 8)) < 1e-12);
    CHECK(std::abs(r.Y_B2 - 1.0) < 2e-4);
    CHECK(rel(r.sigma_F01, r.Y_B1 * solid.sigma_F01) < 1e-12);
    CHECK(solid.Y_B1 == 1.0);
    in.s_R1 = 4.5 * mm;
    CHECK(is_refused(in, "s_R1, s_R2, m_n, z_1, z_2"));
    in.s_R1 = 4.51 * mm;
    CHECK(!is_refused(in, "s_R1, s_R2, m_n, z_1, z_2"));
    in.standard = RatingStandard::din3990;
    CHECK(is_refused(in, "standard, s_R1, s_R2"));
  }

  TEST_CASE("ISO 6336 needs the oil and both roughnesses, DIN 3990-11 neither") {
    In in = shifted();
    in.nu_40 = unset<Viscosity>;
    CHECK(is_refused(in, "standard, nu_40, R_z1, R_z2"));
    in = shifted(), in.R_z2 = unset<Length>;
    CHECK(is_refused(in, "standard, nu_40, R_z1, R_z2"));
    in.standard = RatingStandard::din3990, in.nu_40 = unset<Viscosity>;
    CHECK(!is_refused(in, "standard, nu_40, R_z1, R_z2"));
    CHECK(mode_with("gear.rating", "standard = \"iso6336\"\nnu_40 = \"150 mm^2/s\"", "pitting_1") == "pass");
  }

  TEST_CASE("a pinion that stiffens its shaft: K' of the second column, where it is thick enough") {
    struct Row {
      gear::Place place;
      double alone, stiff;  // |1 + K' l s/d_1^2 (d_1/d_sh)^4 - 0.3| + 0.3
    };
    const std::array rows{Row{gear::Place::a, 6.914624, 4.5487744}, Row{gear::Place::b, 5.514624, 3.1487744},
                          Row{gear::Place::d, 4.035968, 2.2615808}, Row{gear::Place::e, 6.99328, 4.035968}};
    In in = shifted();
    in.l = 200.0 * mm, in.s = 40.0 * mm, in.d_sh = 50.0 * mm;
    for (const Row& row : rows) {
      in.place = row.place, in.stiffening = Stiffening::none;
      const Length alone = rated_well(in).f_sh;
      in.stiffening = Stiffening::pinion;
      CHECK(rel(rated_well(in).f_sh / alone, row.stiff / row.alone) < 1e-9);
      CHECK(rel(alone, row.alone * rated_well(shifted()).f_sh) < 1e-9);
    }
    in.d_sh = 66.2 * mm;  // d_1 is 76 mm
    CHECK(is_refused(in, "stiffening, d_sh"));
    in.d_sh = 66.0 * mm;
    CHECK(!is_refused(in, "stiffening, d_sh"));
  }
}
