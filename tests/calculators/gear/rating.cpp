#include "calculators/gear/rating/rating.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using namespace loadpath::test;
using In = Rating::Input;

Rating::Result rated(const In& in) {
  for (const auto& rule : Rating::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  NoTrace trace;
  return Rating::evaluate(in, trace);
}

In teeth(double m, int z_1, int z_2, double x_1, double x_2, double beta, double b) {
  In in;
  in.m_n = m * mm, in.z_1 = z_1, in.z_2 = z_2, in.x_1 = x_1, in.x_2 = x_2, in.beta = beta * deg.one, in.b = b * mm;
  in.rho_fP = 0.25, in.shortening = Shortening::none, in.f_ma = 0.0 * mm, in.place = gear::Place::middle;
  return in;
}

void load(In& in, double kW_in, double n, double K_A, int grade) {
  in.n_1 = n * rpm, in.T_1 = kW_in * kW.one / in.n_1, in.K_A = K_A, in.grade = grade;
}

void of(In& in, GearMaterial material, double sigma_Hlim, double sigma_FE) {
  in.material_1 = in.material_2 = material;
  in.sigma_Hlim_1 = in.sigma_Hlim_2 = sigma_Hlim * MPa, in.sigma_Flim_1 = in.sigma_Flim_2 = sigma_FE / 2.0 * MPa;
}

In case_A() {
  In in = teeth(4, 19, 104, 0.5, 0.15, 0, 48.64);
  load(in, 55, 980, 1.75, 6);
  of(in, GearMaterial::case_hardened, 1500, 860);
  in.finish = Finish::ground, in.R_z1 = in.R_z2 = 5.0 * um;
  return in;
}

/// The printed example of DIN 3990-11: a case-hardened pinion with a quenched and tempered wheel.
In printed_example() {
  In in = teeth(16, 23, 113, 0.313, -0.071, 7, 480);
  load(in, 1500, 275.2, 1.25, 6);
  of(in, GearMaterial::case_hardened, 1500, 860);
  in.material_2 = GearMaterial::through_alloy, in.H_2 = 266;
  in.sigma_Hlim_2 = 740.0 * MPa, in.sigma_Flim_2 = 295.0 * MPa;
  in.finish = Finish::mixed, in.R_z1 = in.R_z2 = 5.0 * um, in.f_ma = 10.0 * um, in.pattern = Pattern::favourable;
  return in;
}

}  // namespace

TEST_SUITE("gear.rating") {
  TEST_CASE("the printed example of DIN 3990-11: safety factors as printed, factors as by an independent program") {
    const auto r = rated(printed_example());
    CHECK(std::abs(r.S_H1 - 2.1) < 0.05);
    CHECK(std::abs(r.S_H2 - 1.2) < 0.05);
    CHECK(std::abs(r.S_F2 - 3.3) < 0.05);
    CHECK(rel(in_si(r.F_t), 280768) < 1e-5);
    CHECK(rel(in_si(r.v), 5.342) < 1e-3);
    CHECK(rel(r.K_V, 1.0245) < 1e-4);
    CHECK(rel(r.f_sh / um, 28.93) < 3e-3);
    CHECK(rel(r.K_Hbeta, 1.2694) < 1e-3);
    CHECK(rel(r.Z_eps, 0.7858) < 1e-4);
    CHECK(rel(r.Z_H, 2.4440) < 1e-4);
    CHECK(rel(r.Z_beta, 0.9963) < 1e-4);
    CHECK(rel(r.sigma_H0 / MPa, 500.42) < 1e-3);
    CHECK(rel(r.sigma_HG1 / MPa, 1338.6) < 1e-4);
    CHECK(rel(r.sigma_HG2 / MPa, 762.5) < 1e-4);
    CHECK(rel(r.Y_eps, 0.7071) < 1e-4);
    CHECK(rel(r.Y_beta, 0.9417) < 1e-4);
    CHECK(rel(r.Y_Fa2, 2.2113) < 1e-3);
    CHECK(rel(r.Y_Sa2, 1.9369) < 1e-3);
    CHECK(rel(r.S_F2, 3.310) < 2e-3);
  }

  TEST_CASE("case-hardened spur gears with profile shift, by an independent program") {
    const auto r = rated(case_A());
    CHECK(rel(r.K_V, 1.0279) < 1e-4);
    CHECK(rel(r.K_Hbeta, 1.1065) < 1e-4);
    CHECK(rel(r.K_Fbeta1, 1.0865) < 1e-4);
    CHECK(rel(r.Z_B, 1.0055) < 1e-4);
    CHECK(rel(r.sigma_H0 / MPa, 875.4) < 1e-3);
    CHECK(rel(r.sigma_H1 / MPa, 1241.8) < 1e-3);
    CHECK(rel(r.sigma_H2 / MPa, 1235.0) < 1e-3);
    CHECK(rel(r.S_H1, 1.208) < 1e-3);
    CHECK(rel(r.S_H2, 1.215) < 1e-3);
    CHECK(rel(r.Y_Fa1, 2.2463) < 1e-3);
    CHECK(rel(r.Y_Sa1, 1.9147) < 1e-3);
    CHECK(rel(r.Y_Fa2, 2.1617) < 1e-3);
    CHECK(rel(r.Y_Sa2, 2.0088) < 1e-3);
    CHECK(rel(r.sigma_F01 / MPa, 230.15) < 1e-3);
    CHECK(rel(r.S_F1, 1.912) < 1e-3);
    CHECK(rel(r.S_F2, 1.894) < 1e-3);
  }

  TEST_CASE("residual undercut by a protuberance tool: the fillet drawn as the envelope of the tool") {
    struct Row {
      double s_pr, Y_Fa1, Y_Sa1, Y_Fa2, Y_Sa2;
    };
    for (const Row& row : {Row{0.02, 2.355210454, 1.7020250, 2.225553577, 1.7812150},
                           Row{0.06, 2.529768329, 1.6685225, 2.393620216, 1.7434130}}) {
      In in = case_A();
      in.h_fP = 1.4, in.rho_fP = 0.39;
      const auto plain = rated(in);
      in.s_pr = row.s_pr;
      const auto r = rated(in);
      CHECK(rel(r.Y_Fa1, row.Y_Fa1) < 1e-8);
      CHECK(rel(r.Y_Sa1, row.Y_Sa1) < 1e-5);  // its curvature by finite differences
      CHECK(rel(r.Y_Fa2, row.Y_Fa2) < 1e-8);
      CHECK(rel(r.Y_Sa2, row.Y_Sa2) < 1e-5);
      CHECK(r.Y_Fa1 > plain.Y_Fa1);
      CHECK(r.sigma_H1 == plain.sigma_H1);
      CHECK(!is_set(r.f_int));
      in.s_pr = 0.0;
      CHECK(rel(rated(in).Y_Fa1, plain.Y_Fa1) < 1e-12);
    }
  }

  TEST_CASE("quenched and tempered helical gears, hobbed") {
    In in = teeth(5, 21, 79, 0.25, 0, 12, 80);
    in.rho_fP = 0.375;
    load(in, 60, 970, 1.25, 7);
    of(in, GearMaterial::through_alloy, 740, 590);
    in.H_1 = in.H_2 = 266, in.R_z1 = in.R_z2 = 12.0 * um;
    const auto r = rated(in);
    CHECK(rel(r.K_V, 1.0971) < 1e-4);
    CHECK(rel(r.K_Hbeta, 1.0964) < 1e-4);
    CHECK(rel(r.sigma_H0 / MPa, 458.4) < 1e-3);
    CHECK(rel(r.S_H1, 1.119) < 1e-3);
    CHECK(rel(r.Y_Fa1, 2.3910) < 1e-3);
    CHECK(rel(r.Y_Sa2, 1.7777) < 1e-3);
    CHECK(rel(r.S_F1, 5.579) < 1e-3);
    CHECK(rel(r.S_F2, 5.729) < 1e-3);
  }

  TEST_CASE("a hard pinion work-hardens its soft gear") {
    In in = teeth(3, 25, 60, 0, 0, 0, 24);
    load(in, 15, 1450, 1.25, 7);
    of(in, GearMaterial::case_hardened, 1500, 860);
    in.material_2 = GearMaterial::through_alloy, in.H_2 = 266;
    in.sigma_Hlim_2 = 740.0 * MPa, in.sigma_Flim_2 = 295.0 * MPa, in.R_z1 = 6.0 * um, in.R_z2 = 12.0 * um;
    const auto r = rated(in);
    CHECK(rel(r.sigma_H0 / MPa, 597.2) < 1e-4);
    CHECK(rel(r.Z_B, 1.0458) < 1e-4);
    CHECK(rel(r.S_H1, 1.668) < 1e-3);
    CHECK(rel(r.S_H2, 0.964) < 1e-3);
    CHECK(rel(r.S_F1, 5.078) < 2e-3);
    CHECK(rel(r.S_F2, 3.676) < 1e-3);
    in.R_z1 = 6.1 * um;  // too rough for it
    CHECK(rel(rated(in).S_H2, r.S_H2 / 1.12) < 1e-12);
  }

  TEST_CASE("nitrided helical gears of a large module") {
    In in = teeth(8, 18, 71, 0.3, 0.1, 15, 120);
    load(in, 300, 480, 1.5, 6);
    of(in, GearMaterial::nitrided, 1250, 740);
    in.finish = Finish::ground, in.R_z1 = in.R_z2 = 6.0 * um;
    const auto r = rated(in);
    CHECK(rel(r.K_Hbeta, 1.1685) < 1e-4);
    CHECK(rel(r.sigma_H0 / MPa, 848.3) < 1e-3);
    CHECK(rel(r.S_H1, 1.098) < 1e-3);
    CHECK(rel(r.sigma_F01 / MPa, 231.26) < 1e-3);
    CHECK(rel(r.S_F1, 1.792) < 1e-3);
    CHECK(rel(r.S_F2, 1.832) < 1e-3);
  }

  TEST_CASE("equal gears have equal safety factors; more load, less face width and a coarser grade lower them") {
    std::mt19937_64 random(5);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int i = 0; i < 500; ++i) {
      const int z = 20 + static_cast<int>(between(0, 60));
      In in = teeth(between(1, 10), z, z, 0.1, 0.1, i % 2 == 0 ? 0.0 : between(5, 20), 30);
      in.b = between(6, 12) * in.m_n;
      load(in, between(5, 50), between(200, 1500), between(1, 2), 6 + i % 5);
      of(in, GearMaterial::case_hardened, 1500, 860);
      const auto r = rated(in);
      const bool is_light = r.F_t * in.K_A / in.b <= 100.0 * N_per_mm.one;  // the standard's factors leap there
      if (!(r.x_v < 10.0) || is_light) continue;
      CHECK(rel(r.S_H1, r.S_H2) < 1e-9);
      CHECK(rel(r.S_F1, r.S_F2) < 1e-9);
      In more = in;
      more.T_1 = 1.3 * in.T_1;
      CHECK(rated(more).S_H1 < r.S_H1);
      CHECK(rated(more).S_F1 < r.S_F1);
      In coarse = in;
      coarse.grade = 7 + i % 5;
      CHECK(rated(coarse).S_H1 <= r.S_H1);
      CHECK(rated(coarse).S_F1 <= r.S_F1);
    }
  }

  TEST_CASE("finite life has higher limits, which end at those of endurance and of static load") {
    In in = case_A();
    const auto endless = rated(in);
    double before = HUGE_VAL;
    for (const double hours : {1e-2, 1.0, 1e2, 1e3, 1e5}) {
      in.L_h = hours * hour;
      const auto r = rated(in);
      CHECK(r.S_F1 <= before);
      CHECK(r.S_H1 <= 1.6 * endless.S_H1 * (1.0 + 1e-12));
      before = r.S_F1;
    }
    CHECK(before == endless.S_F1);
  }

  TEST_CASE("lines of ISO 6336-5 by quality and hardness") {
    In in = case_A();
    in.sigma_Hlim_1 = in.sigma_Flim_1 = unset<Stress>;
    in.quality_1 = Quality::MQ, in.H_1 = 720;
    CHECK(rel(rated(in).S_H1, rated(case_A()).S_H1) < 1e-12);
    in.H_1 = 500;
    CHECK(!Rating::has_line(in));
    in.H_1 = unset<double>;
    CHECK(!Rating::has_strengths(in));
  }

  TEST_CASE("missing input does not pass") {
    CHECK(mode_with("gear.rating", "S_Hmin = ", "pitting_1") == "not-judged");
    CHECK(mode_with("gear.rating", "S_Fmin = ", "root_2") == "not-judged");
    CHECK(mode_with("gear.rating", "", "pitting_1") == "pass");
    CHECK(mode_with("gear.rating", "T_1 = \"4000 N*m\"", "pitting_1") == "fail");
    CHECK(mode_with("gear.rating", "n_1 = \"20000 rpm\"", "dynamic") == "not-covered");
    // Numbers of no such material.
    const std::string soft = "material_1 = \"through_alloy\"\nquality_1 = \nH_1 = 266\nsigma_Flim_1 = \"300 MPa\"\n";
    CHECK(mode_with("gear.rating", soft + "sigma_Hlim_1 = \"800 MPa\"\nT_1 = \"100 N*m\"", "pitting_1") == "pass");
    CHECK(mode_with("gear.rating", soft + "sigma_Hlim_1 = \"1500 MPa\"\nT_1 = \"250 N*m\"", "pitting_1") ==
          "not-judged");
  }
}
