// Load factors of gear.rating by ISO 6336-1:2006: the printed example, values computed independently in every range of
// the resonance ratio, and what holds for all pairs.
#include "calculators/gear/rating/rating.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using namespace loadpath::test;
using In = Rating::Input;

Rating::Result rated_by_iso(const In& in) {
  for (const auto& rule : Rating::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  return evaluated<Rating>(in);
}

In pair_by_iso(double m, int z_1, int z_2, double beta, double x_1, double x_2, double b) {
  In in;
  in.standard = RatingStandard::iso6336;
  in.m_n = m * mm, in.z_1 = z_1, in.z_2 = z_2, in.beta = beta * deg.one, in.b = b * mm;
  in.x_1 = x_1, in.x_2 = x_2, in.rho_fP = 0.25, in.shortening = Shortening::none;
  in.R_z1 = in.R_z2 = 5.0 * um, in.nu_40 = 150.0 * mm2_per_s, in.place = gear::Place::middle;
  in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.sigma_Hlim_1 = in.sigma_Hlim_2 = 1500.0 * MPa, in.sigma_Flim_1 = in.sigma_Flim_2 = 430.0 * MPa;
  return in;
}

In under(In in, double T_1, double n_1, int grade, double K_A) {
  in.T_1 = T_1 * N_m, in.n_1 = n_1 * rpm, in.grade = grade, in.K_A = K_A;
  return in;
}

void soften(In& in, bool both) {
  in.material_2 = GearMaterial::through_alloy, in.sigma_Hlim_2 = 740.0 * MPa, in.sigma_Flim_2 = 295.0 * MPa;
  in.H_2 = 266;
  if (both) in.material_1 = in.material_2, in.sigma_Hlim_1 = in.sigma_Hlim_2, in.H_1 = 266;
}

/// Example 1 of ISO/TR 6336-30, with a tip relief of 70 um.
In printed_pair() {
  In in = under(pair_by_iso(8, 17, 103, 15.8, 0.14522, 0, 100), 9000, 360, 5, 1);
  in.x_2 = unset<double>, in.a_w = 500.0 * mm, in.h_fP = 1.4, in.rho_fP = 0.39, in.C_a = 70.0 * um;
  in.R_z1 = in.R_z2 = 6.0 * um, in.nu_40 = 320.0 * mm2_per_s, in.L_h = 50000.0 * hour;
  return in;
}

In reducer() { return under(pair_by_iso(4, 19, 104, 0, 0.5, 0.15, 48), 400, 980, 6, 1.25); }

double all_of(const Rating::Result& r) { return r.K_V * r.K_Hbeta * r.K_Halpha; }

/// A pair that any designer might lay out, below resonance.
In any_pair(std::mt19937_64& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const double m = between(2, 8);
  In in =
      pair_by_iso(m, 18 + static_cast<int>(between(0, 20)), 40 + static_cast<int>(between(0, 60)),
                  between(0, 1) < 0.5 ? 0.0 : between(5, 25), between(0, 0.4), between(-0.2, 0.2), m * between(5, 12));
  const double z_1 = in.z_1, T = between(30, 200) * m * m * (in.b / mm) * z_1 / 2000.0;
  return under(in, T, between(50, 800), 6 + static_cast<int>(between(0, 4)), between(1, 1.75));
}

}  // namespace

TEST_SUITE("gear rating load factors of ISO 6336-1") {
  TEST_CASE("example 1 of ISO/TR 6336-30: stiffnesses, load factors, stress and safety factors as printed") {
    const auto r = rated_by_iso(printed_pair());  // tip diameters are rounded to 0.01 mm there
    CHECK(rel(r.c_th, 17.85584) < 5e-5);
    CHECK(rel(r.c_prime, 12.37047) < 5e-5);
    CHECK(rel(r.c_gamma_alpha, 17.46485) < 3e-4);
    CHECK(rel(r.c_gamma_beta, 14.84512) < 3e-4);
    CHECK(std::abs(r.K_V - 1.003) < 5e-4);
    CHECK(std::abs(r.K_Hbeta - 1.16) < 5e-4);
    CHECK(std::abs(r.K_Fbeta1 - 1.12803) < 5e-5);
    CHECK(r.K_Halpha == 1.0);
    CHECK(r.K_Falpha == 1.0);
    CHECK(rel(r.sigma_H1 / MPa, 1301.35343) < 2e-4);
    CHECK(rel(r.S_H1, 1.02853) < 2e-4);
    CHECK(rel(r.S_H2, 1.08696) < 2e-4);
  }

  TEST_CASE("the last stage of a wind turbine: stiffness as two other programs compute it") {
    const auto r = rated_by_iso(under(pair_by_iso(14, 24, 95, 10, 0.48, 0.669, 360), 50000, 100, 6, 1));
    CHECK(rel(r.c_th, 20.051822093657176) < 1e-12);
    CHECK(rel(r.c_prime, 15.402808090686957) < 1e-12);
  }

  TEST_CASE("below, at, above and far above resonance, by an independent computation") {
    struct Row {
      double n_1, N_res, K_V, F_betax, K_Hbeta;
    };
    for (const Row& row : {Row{980, 0.064322021, 1.039771864, 18.343976022, 1.485498558},
                           Row{14000, 0.918886017, 2.288324229, 22.520228046, 1.270824379},
                           Row{20000, 1.312694311, 1.829828624, 20.986617399, 1.315620032},
                           Row{40000, 2.625388621, 1.301974669, 19.221011718, 1.406262036}}) {
      In in = reducer();
      in.n_1 = row.n_1 * rpm;
      const auto r = rated_by_iso(in);
      CHECK(rel(r.N_res, row.N_res) < 1e-8);
      CHECK(rel(r.K_V, row.K_V) < 1e-8);
      CHECK(rel(r.F_betax / um, row.F_betax) < 1e-8);
      CHECK(rel(r.K_Hbeta, row.K_Hbeta) < 1e-8);
      CHECK(r.B_k == 1.0);
      CHECK(!is_set(r.x_v));
    }
  }

  TEST_CASE("light, soft, fast, finely and coarsely cut pairs, by an independent computation") {
    struct Row {
      In in;
      double c_prime, K_V, y_beta, K_Hbeta, K_Fbeta, K_Halpha, K_Falpha;
    };
    In soft = under(pair_by_iso(5, 21, 79, 12, 0.25, 0, 80), 590, 970, 7, 1.25);
    soften(soft, true);
    In mixed = under(pair_by_iso(5, 21, 79, 25, 0.25, 0, 80), 590, 3000, 9, 1.25);
    soften(mixed, false);
    const In light = under(pair_by_iso(3, 25, 60, 0, 0, 0, 24), 8, 1450, 8, 1.25);
    const In fine = under(pair_by_iso(2.5, 31, 47, 20, 0.1, 0.05, 30), 200, 9000, 5, 1.1);
    const In coarse = under(pair_by_iso(4, 20, 60, 10, 0.2, -0.1, 160), 300, 500, 10, 1);
    for (const Row& row :
         {Row{light, 7.798126198, 2.106844639, 3.724824711, 4.267584438, 2.905691193, 1.303318148, 1.396178129},
          Row{soft, 13.946399879, 1.064122397, 10.536455945, 1.640537903, 1.532036252, 1.247711710, 1.247711710},
          Row{mixed, 13.323245901, 1.398048298, 11.648648649, 2.112181285, 1.904776784, 1.339227296, 1.339227296},
          Row{fine, 13.357337063, 1.504251465, 1.489297203, 1.250528253, 1.200637608, 1.042566767, 1.042566767},
          Row{coarse, 11.064335603, 1.168206933, 6.0, 5.885727909, 5.328785578, 1.745570829, 1.745570829}}) {
      const auto r = rated_by_iso(row.in);
      CHECK(rel(r.c_prime, row.c_prime) < 1e-8);
      CHECK(rel(r.K_V, row.K_V) < 1e-8);
      CHECK(rel(r.y_beta / um, row.y_beta) < 1e-8);
      CHECK(rel(r.K_Hbeta, row.K_Hbeta) < 1e-8);
      CHECK(rel(r.K_Fbeta1, row.K_Fbeta) < 1e-8);
      CHECK(r.K_Fbeta2 == r.K_Fbeta1);
      CHECK(rel(r.K_Halpha, row.K_Halpha) < 1e-8);
      CHECK(rel(r.K_Falpha, row.K_Falpha) < 1e-8);
    }
  }

  TEST_CASE("every factor is finite and at least 1; root and transverse factors keep their bounds") {
    std::mt19937_64 random(34);
    for (int i = 0; i < 300; ++i) {
      In in = any_pair(random);
      const double load = std::pow(10.0, std::uniform_real_distribution<double>(-4, 2)(random));
      in.T_1 = load * in.T_1, in.n_1 = (0.1 + 40.0 / (1.0 + load)) * in.n_1;
      const auto r = rated_by_iso(in);
      for (const double K : {r.K_V, r.K_Hbeta, r.K_Fbeta1, r.K_Halpha, r.K_Falpha}) {
        CHECK(std::isfinite(K));
        CHECK(K >= 1.0);
      }
      CHECK(r.K_Fbeta1 <= r.K_Hbeta);
      CHECK(r.K_Halpha <= std::max(1.0, (1 + 1e-12) * 4.0 / (r.Z_eps * r.Z_eps)));
      CHECK(r.y_beta < r.F_betax);
    }
  }

  TEST_CASE("a pair with its gears interchanged keeps stiffness, resonance and dynamic factor") {
    std::mt19937_64 random(35);
    for (int i = 0; i < 100; ++i) {
      const In in = any_pair(random);
      const double u = in.z_2 / static_cast<double>(in.z_1);
      In back = in;
      back.z_1 = in.z_2, back.z_2 = in.z_1, back.x_1 = in.x_2, back.x_2 = in.x_1;
      back.T_1 = u * in.T_1, back.n_1 = in.n_1 / u;
      const auto r = rated_by_iso(in), s = rated_by_iso(back);
      CHECK(rel(s.c_prime, r.c_prime) < 1e-11);
      CHECK(rel(s.c_gamma_alpha, r.c_gamma_alpha) < 1e-11);
      CHECK(rel(s.N_res, r.N_res) < 1e-11);
      CHECK(rel(s.K_V, r.K_V) < 1e-11);
    }
  }

  TEST_CASE("equal gears are loaded equally") {
    const auto r = rated_by_iso(under(pair_by_iso(4, 40, 40, 12, 0.1, 0.1, 50), 500, 700, 7, 1.25));
    CHECK(r.sigma_H1 == r.sigma_H2);
    CHECK(rel(r.S_H1, r.S_H2) < 1e-12);
    CHECK(rel(r.sigma_F1, r.sigma_F2) < 1e-12);
    CHECK(rel(r.S_F1, r.S_F2) < 1e-12);
  }

  TEST_CASE("coarser teeth and harder flanks increase the load; more torque adds to it") {
    std::mt19937_64 random(36);
    for (int i = 0; i < 100; ++i) {
      In in = any_pair(random);
      const auto first = rated_by_iso(in);
      if (first.F_t * in.K_A / in.b < 100.0 * N_per_mm.one || first.N_res > 0.8) continue;
      In coarser = in;
      coarser.grade = static_cast<int>(in.grade) + 1;
      const auto coarse = rated_by_iso(coarser);
      CHECK(coarse.K_V >= first.K_V);
      CHECK(all_of(coarse) >= all_of(first) * (1 - 1e-12));
      In loaded = in;
      loaded.T_1 = 1.3 * in.T_1;
      const auto more = rated_by_iso(loaded);
      CHECK(more.K_V <= first.K_V);
      CHECK(1.3 * all_of(more) >= all_of(first) * (1 - 1e-12));
      soften(in, true);
      In harder = in;
      harder.sigma_Hlim_1 = harder.sigma_Hlim_2 = 900.0 * MPa;
      CHECK(all_of(rated_by_iso(harder)) >= all_of(rated_by_iso(in)) * (1 - 1e-12));
    }
  }

  TEST_CASE("a wider face at the same torque spreads its load less evenly") {
    double K = 1.0;
    for (const double b : {2.0, 5.0, 12.0, 25.0, 48.0, 79.0}) {
      In in = reducer();
      in.b = b * mm;
      const auto r = rated_by_iso(in);
      CHECK(r.K_Hbeta >= K);
      K = r.K_Hbeta;
    }
  }

  TEST_CASE("a narrow face under a large line load has the minimum misalignment") {
    In in = reducer();
    in.b = 1e-3 * mm, in.f_ma = 0.0 * mm;
    const auto r = rated_by_iso(in);
    CHECK(std::abs(r.K_Hbeta - (1 + 0.0025 * r.c_gamma_beta)) < 1e-5);
  }

  TEST_CASE("a pinion near the middle, or on a stiff shaft, deflects like one in the middle") {
    In in = reducer();
    const auto middle = rated_by_iso(in);
    in.place = gear::Place::a, in.l = 200.0 * mm, in.d_sh = 50.0 * mm, in.s = 1e-9 * mm;
    CHECK(rel(rated_by_iso(in).K_Hbeta, middle.K_Hbeta) < 1e-8);
    in.s = 40.0 * mm;
    double K = rated_by_iso(in).K_Hbeta;
    for (const double d_sh : {52.0, 56.0, 60.0, 66.0}) {
      in.d_sh = d_sh * mm;
      const double stiffer = rated_by_iso(in).K_Hbeta;
      CHECK(stiffer < K);
      CHECK(stiffer > middle.K_Hbeta);
      K = stiffer;
    }
  }

  TEST_CASE("lead modification and contact pattern: shares of deflection and deviation") {
    In in = reducer();
    in.f_ma = 40.0 * um;
    const auto plain = rated_by_iso(in);
    CHECK(rel(plain.F_betax / um, 1.33 * (plain.f_sh / um) + 40) < 1e-12);
    in.crowning = Crowning::crowned;
    CHECK(rel(rated_by_iso(in).F_betax, 0.5 * plain.F_betax) < 1e-12);
    in.crowning = Crowning::end_relief;
    CHECK(rel(rated_by_iso(in).F_betax, 0.7 * plain.F_betax) < 1e-12);
    in.crowning = Crowning::none, in.pattern = Pattern::favourable;
    // grade 5: 8 um of the wheel; grade 6: 11 um, of which half remains
    CHECK(rel(rated_by_iso(in).F_betax / um, 5.5) < 1e-12);
    in.T_1 = 4000.0 * N_m;
    const auto heavy = rated_by_iso(in);
    CHECK(rel(heavy.F_betax / um, 1.33 * (heavy.f_sh / um) - 8) < 1e-12);
  }

  TEST_CASE("a bore within the rim makes gears lighter, and their resonance higher") {
    In in = reducer();
    const double solid = rated_by_iso(in).N_res;
    in.s_R1 = 10.0 * mm, in.s_R2 = 12.0 * mm;
    CHECK(rated_by_iso(in).N_res < solid);
    in.s_R1 = 33.0 * mm, in.s_R2 = unset<Length>;  // of a root radius of 35 mm
    CHECK(rel(rated_by_iso(in).N_res, solid) < 1e-5);
  }

  TEST_CASE("tip relief counts up to grade 5, belongs to ISO 6336, and is best where it equals the deflection") {
    In in = reducer();
    in.grade = 5;
    const auto run_in = rated_by_iso(in);
    const double w = run_in.F_t * in.K_A / in.b / N_per_mm;
    in.C_a = w / run_in.c_prime * um;
    const auto best = rated_by_iso(in);
    CHECK(best.B_k < 1e-12);
    CHECK(best.K_V < run_in.K_V);
    in.C_a = 0.0 * um;
    CHECK(rated_by_iso(in).B_k == 1.0);
    in.standard = RatingStandard::din3990;
    bool refused = false;
    for (const auto& rule : Rating::rules) refused = refused || !rule.holds(in);
    CHECK(refused);
  }
}
