#include "calculators/gear/bevel/bevel.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using gear::Bevel;
using test::rel;

constexpr auto solve = test::evaluated<Bevel>;

/// Module 3, 20 and 40 teeth, 22 mm wide, at right angles ([KHK-bevel]).
Bevel::Input plain() {
  Bevel::Input in;
  in.z_1 = 20, in.z_2 = 40;
  in.m_et = 3.0 * mm, in.b = 22.0 * mm;
  return in;
}

/// In inches: 6 teeth per inch, 18 and 54 teeth, a face of 1.25 in, 10 hp at 1200 rpm.
Bevel::Input rated() {
  Bevel::Input in;
  in.z_1 = 18, in.z_2 = 54;
  in.m_et = 25.4 / 6.0 * mm, in.b = 1.25 * 25.4 * mm;
  in.x_1 = 0.38, in.h_fP = 1.188;
  in.P = 7.456998715822702 * kW, in.n_1 = 1200.0 * rpm;
  in.K_A = 1.5, in.Q_v = 9;
  in.mounting = Bevel::Mounting::one_straddled, in.crowning = Bevel::Crowning::crowned;
  in.I = 0.08, in.J_1 = 0.25, in.J_2 = 0.2;
  in.H_B1 = 350, in.H_B2 = 300;
  in.N = 1e8, in.R = 0.999, in.service = Bevel::Service::general;
  return in;
}

bool is_deg(double angle, double expected) { return std::abs(angle * 180.0 / pi - expected) < 0.6e-5; }
bool is_mm(const Length& length, double expected) { return std::abs(in_si(length) * 1e3 - expected) < 0.6e-5; }

/// Whether the reader says this of the gears with these lines.
bool says(const std::string& lines, const std::string& part) {
  std::vector<Issue> issues;
  project::read_project("[g]\ncalculator = \"gear.bevel\"\nm_et = \"3 mm\"\n" + lines, "g.toml", catalogue(), issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("gear bevel") {
  TEST_CASE("cones and heights of the standard gears of [KHK-bevel]") {
    const auto r = solve(plain());
    CHECK(is_mm(r.d_1, 60));
    CHECK(is_mm(r.d_2, 120));
    CHECK(is_deg(r.delta_1, 26.56505));
    CHECK(is_deg(r.delta_2, 63.43495));
    CHECK(is_mm(r.R_e, 67.08204));
    CHECK(is_mm(r.h_a1, 3));
    CHECK(is_mm(r.h_f2, 3.75));
    CHECK(is_deg(r.theta_f1, 3.19960));
    CHECK(is_deg(r.delta_f1, 23.36545));
    CHECK(is_deg(r.delta_f2, 60.23535));
  }

  TEST_CASE("the Gleason gears of [KHK-bevel], of equal clearance along the teeth") {
    Bevel::Input in = plain();
    in.x_1 = 0.345, in.h_fP = 1.188;
    const auto r = solve(in);
    CHECK(is_mm(r.h_a1, 4.035));
    CHECK(is_mm(r.h_a2, 1.965));
    CHECK(is_mm(r.h_f1, 2.529));
    CHECK(is_mm(r.h_f2, 4.599));
    CHECK(is_deg(r.theta_f1, 2.15903));
    CHECK(is_deg(r.theta_f2, 3.92194));
    CHECK(is_deg(r.delta_a1 - r.delta_1, 3.92194));  // the addendum angles of the print
    CHECK(is_deg(r.delta_a2 - r.delta_2, 2.15903));
  }

  TEST_CASE("5 hp at 600 rev/min on a pinion of 3 in: 350.14 lbf at its outer end ([Sensei-34785])") {
    Bevel::Input in;
    in.z_1 = 15, in.z_2 = 45, in.m_et = 5.08 * mm, in.b = 30.0 * mm;
    in.P = 3.728499357911351 * kW, in.n_1 = 600.0 * rpm;
    const auto r = solve(in);
    CHECK(std::abs(in_si(r.W_t) / 4.4482216152605 - 350.14) < 0.02);  // the print has 63025, and not 63025.36
    CHECK(std::abs(r.delta_1 * 180 / pi - 18.435) < 0.0005);
  }

  TEST_CASE("the rating computed independently in inches and pounds") {
    const auto r = solve(rated());
    const double digits = 2e-6;  // 1 psi is 0.00689476 MPa
    CHECK(rel(r.K_v, 1.1909158) < 1e-7);
    CHECK(rel(r.x_v, 0.13720942) < 1e-7);
    CHECK(rel(r.K_s, 0.52223333) < 1e-7);
    CHECK(rel(r.K_m, 1.105625) < 1e-7);
    CHECK(rel(r.C_s, 0.59375) < 1e-7);
    CHECK(rel(r.C_p, 190.1983) < 1e-6);
    CHECK(rel(in_si(r.s_c) / 1e6, 715.59028) < digits);
    CHECK(rel(in_si(r.s_t1) / 1e6, 47.808794) < digits);
    CHECK(rel(in_si(r.s_t2) / 1e6, 59.760993) < digits);
    CHECK(rel(r.C_L1, 1.1488246) < 1e-7);
    CHECK(rel(r.K_L1, 0.97677746) < 1e-7);
    CHECK(rel(r.K_R, 1.25) < 1e-12);
    CHECK(rel(r.S_H1, 1.4154619) < digits);
    CHECK(rel(r.S_H2, 1.3318971) < digits);
    CHECK(rel(r.S_F1, 1.9721269) < digits);
    CHECK(rel(r.S_F2, 1.4066012) < digits);
  }

  TEST_CASE("forces of the two gears are opposite in space, at any shaft angle") {
    for (const double Sigma : {60.0, 90.0, 110.0}) {
      Bevel::Input in = rated();
      in.Sigma = Sigma * pi / 180;
      const auto r = solve(in);
      const double c = std::cos(in.Sigma), s = std::sin(in.Sigma);
      // Both shafts point away from the apex; each gear is pushed away from it and towards its own axis.
      CHECK(std::abs(in_si(r.F_a1 + r.F_a2 * c - r.F_r2 * s)) < 1e-9);
      CHECK(std::abs(in_si(-r.F_r1 + r.F_a2 * s + r.F_r2 * c)) < 1e-9);
      CHECK(rel(in_si(r.F_t) * in_si(r.d_m2) / 2, in_si(r.T_2)) < 1e-12);
    }
  }

  TEST_CASE("the loads of the shafts brake the driving pinion and drive the gear") {
    Bevel::Input in = rated();
    const auto r = solve(in);
    CHECK(rel(in_si(r.gear_1.F_y), -1.5 * in_si(r.F_t)) < 1e-12);  // counter-clockwise: +y at the mesh
    CHECK(rel(in_si(r.gear_1.F_x), -1.5 * in_si(r.F_r1)) < 1e-12);
    CHECK(rel(in_si(r.gear_1.F_z), 1.5 * in_si(r.F_a1)) < 1e-12);
    CHECK(in_si(r.gear_2.F_y) * in_si(r.gear_2.n) > 0.0);
    CHECK(in_si(r.gear_1.F_y) * in_si(r.gear_1.n) < 0.0);
    CHECK(rel(in_si(r.gear_2.T), 3 * in_si(r.gear_1.T)) < 1e-12);
    in.turns = gear::Turns::cw;
    CHECK(in_si(solve(in).gear_1.F_y) == -in_si(r.gear_1.F_y));
    in.turns = gear::Turns::ccw, in.P = unset<Power>, in.T_1 = -60.0 * N_m;
    CHECK(in_si(solve(in).gear_1.F_y) > 0.0);
    CHECK(in_si(solve(in).gear_2.F_y) > 0.0);
  }

  TEST_CASE("a crown gear of many teeth: the virtual gears of two equal ones at right angles have sqrt(2) z teeth") {
    Bevel::Input in = plain();
    in.z_2 = 20;
    const auto r = solve(in);
    CHECK(rel(r.z_v1, 20 * std::sqrt(2.0)) < 1e-12);
    CHECK(rel(r.z_v2, r.z_v1) < 1e-12);
  }

  TEST_CASE("life factors of few cycles, a hot gear, idlers and low reliability") {
    Bevel::Input in = rated();
    in.N = 900;
    auto r = solve(in);
    CHECK(r.C_L1 == 2.0);
    CHECK(r.K_L1 == 2.7);
    in.N = 1e5;
    CHECK(rel(solve(in).K_L1, 6.1514 * std::pow(1e5, -0.1192)) < 1e-12);
    in.R = 0.95;
    CHECK(rel(solve(in).K_R, 0.7 + 0.15 * 1.3010299957) < 1e-9);
    const double S_F1 = solve(in).S_F1;
    in.idler = gear::Idler::gear_1;
    CHECK(rel(solve(in).S_F1, 0.7 * S_F1) < 1e-12);
    in.T_G = 422.0388888888889 * kelvin;  // 300 deg F
    CHECK(rel(solve(in).K_T, 760.0 / 710.0) < 1e-12);
  }

  TEST_CASE("wrong gears are reported with their remedy") {
    const std::string teeth = "z_1 = 20\nz_2 = 40\nb = \"20 mm\"\n";
    says("z_1 = 40\nz_2 = 20\nb = \"20 mm\"\n", "gear 1 is the pinion");
    says("z_1 = 20\nz_2 = 40\nb = \"60 mm\"\n", "less than half the outer cone distance R_e = ");
    says(teeth + "Sigma = \"150 deg\"\n", "a pitch cone angle would exceed 90°");
    says(teeth + "bore_1 = \"900 mm\"\n", "the bore of gear 1 must be less than its pitch diameter");
    says(teeth + "bore_2 = \"900 mm\"\n", "the bore of gear 2 must be less than its pitch diameter");
    says(teeth + "h_fP = 1.09\n", "by at least 0.1, the tip clearance");
    says(teeth + "P = \"1 kW\"\n", "a power needs the speed n_1");
    says(teeth + "J_1 = 0.2\nH_B1 = 300\n", "the rating needs a load");
    says(teeth + "P = \"1 kW\"\nn_1 = \"900 rpm\"\nJ_1 = 0.2\nH_B1 = 300\n", "give either N or L_h");
    says(teeth + "P = \"1 kW\"\nn_1 = \"900 rpm\"\nI = 0.08\nH_B1 = 300\nN = 1e7\n", "H_B2 or s_ac2");
    says(teeth + "T_1 = \"0 N*m\"\nn_1 = \"900 rpm\"\nJ_1 = 0.2\nH_B1 = 300\nN = 1e7\n", "a torque other than zero");
    says(teeth + "S_Fmin = 1.5\n", "needs a geometry factor J_1 or J_2");
  }
}
