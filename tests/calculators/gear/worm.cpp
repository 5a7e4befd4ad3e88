#include "calculators/gear/worm/worm.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using gear::Worm;
using test::rel;

constexpr auto solve = test::evaluated<Worm>;
constexpr double inch = 25.4, lbf = 4.4482216152605, fpm = 0.00508;

/// Module 3, 2 threads on 44 mm, 30 teeth ([KHK-worm]).
Worm::Input plain() {
  Worm::Input in;
  in.z_1 = 2, in.z_2 = 30;
  in.m_x = 3.0 * mm, in.d_1 = 44.0 * mm, in.b_2 = 25.0 * mm;
  in.n_1 = 1000.0 * rpm;
  return in;
}

struct Rated {
  int z_1, z_2;
  double D, d, b, alpha, n;  // in, in, in, deg, rpm
  Worm::Casting casting;
  double gamma, v_G, v_s, mu, C_m, C_s, C_v, W_tR, hp, eta;  // deg, ft/min, lbf
};

bool says(const std::string& lines, const std::string& part) {
  std::vector<Issue> issues;
  project::read_project("[w]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nb_2 = \"30 mm\"\n" + lines,
                        "w.toml", catalogue(), issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("gear worm") {
  TEST_CASE("the worm gear of [KHK-worm]") {
    const auto r = solve(plain());
    CHECK(std::abs(r.q - 14.666667) < 1e-6);
    CHECK(std::abs(r.gamma * 180 / pi - 7.765148) < 3e-5);  // the print has 3.1416 for pi
    CHECK(std::abs(in_si(r.p_z) * 1e3 - 18.8496) < 1e-4);
    CHECK(std::abs(in_si(r.L_1) * 1e3 - 48.06648) < 2e-4);
    CHECK(std::abs(in_si(r.b_2H) * 1e3 - 23.748684) < 1e-6);
    CHECK(rel(r.d_2, 90.0 * mm) < 1e-12);
    CHECK(rel(r.a, 67.0 * mm) < 1e-12);
    CHECK(rel(r.d_a1, 50.0 * mm) < 1e-12);
    CHECK(rel(r.d_f1, 36.5 * mm) < 1e-12);
  }

  TEST_CASE("a lead of 60 mm at 23 deg with friction of 0.05: 45 mm, 87.4 % ([Filo-worm])") {
    Worm::Input in;
    in.z_1 = 2, in.z_2 = 37, in.m_x = 30.0 / pi * mm, in.b_2 = 40.0 * mm;
    in.d_1 = 60.0 / pi / std::tan(23.0 * pi / 180) * mm;
    in.alpha_n = 14.5 * pi / 180, in.mu = 0.05;
    const auto r = solve(in);
    CHECK(std::abs(in_si(in.d_1) * 1e3 - 45) < 0.05);
    CHECK(std::abs(r.gamma * 180 / pi - 23) < 1e-9);
    CHECK(std::abs(r.eta - 0.874) < 0.0025);  // printed; exactly 0.87199
  }

  TEST_CASE("friction, factors, rated force and efficiency of three gears, computed independently in inches") {
    using C = Worm::Casting;
    const Rated all[] = {{2, 56, 7, 2, 1, 20, 1720, C::sand, 7.1250163, 112.573737, 907.598481, 0.021749988, 0.8239,
                          786.888235, 0.27240854, 837.696508, 2.85765534, 0.841321867},
                         {1, 30, 10, 2.5, 1.5, 14.5, 1750, C::chill, 7.59464337, 152.71631, 1155.50856, 0.019438258,
                          0.823622031, 956, 0.23732013, 1768.52696, 8.18433061, 0.866797649},
                         {4, 40, 12, 3, 1.75, 20, 900, C::centrifugal, 21.8014095, 282.743339, 761.309739, 0.023664397,
                          0.759332591, 1000, 0.301166391, 2921.60561, 25.0322584, 0.931294318}};
    for (const Rated& row : all) {
      Worm::Input in;
      in.z_1 = row.z_1, in.z_2 = row.z_2;
      in.m_x = row.D * inch / row.z_2 * mm, in.d_1 = row.d * inch * mm, in.b_2 = row.b * inch * mm;
      in.alpha_n = row.alpha * pi / 180, in.n_1 = row.n * rpm, in.casting = row.casting;
      const auto empty = solve(in);
      in.T_2 = empty.W_tR * empty.d_2 / 2.0;  // what it is rated for
      const auto r = solve(in);
      CHECK(rel(r.gamma * 180 / pi, row.gamma) < 1e-7);
      CHECK(rel(in_si(r.v_2) / fpm, row.v_G) < 1e-7);
      CHECK(rel(in_si(r.v_s) / fpm, row.v_s) < 1e-7);
      CHECK(rel(r.mu, row.mu) < 1e-6);
      CHECK(rel(r.C_m, row.C_m) < 1e-6);
      CHECK(rel(r.C_s, row.C_s) < 1e-6);
      CHECK(rel(r.C_v, row.C_v) < 1e-6);
      CHECK(rel(in_si(r.W_tR) / lbf, row.W_tR) < 2e-6);
      CHECK(rel(r.S_W, 1.0) < 1e-12);
      CHECK(rel(in_si(r.P_2), row.hp * 33000 * 0.3048 * lbf / 60) < 2e-6);
      CHECK(rel(r.eta, row.eta) < 1e-6);
      CHECK(rel(r.P_2 / r.P_1, r.eta) < 1e-9);
    }
  }

  TEST_CASE("the factors are continuous, and small gears are rated lower") {
    Worm::Input in = plain();
    in.casting = Worm::Casting::centrifugal;
    in.z_1 = 1, in.z_2 = 20;
    const double below = solve(in).C_m;
    in.z_1 = 10, in.d_1 = 60.0 * mm, in.z_2 = 201;
    CHECK(std::abs(solve(in).C_m - below) < 2e-3);
    CHECK(std::abs(below - 0.8195) < 1e-3);
    // 67 mm are 2.638 in: 720 + 10.37 * 2.638^3
    Worm::Input small = plain();
    small.casting = Worm::Casting::chill;
    CHECK(rel(solve(small).C_s, 720 + 10.37 * std::pow(67 / 25.4, 3)) < 1e-12);
  }

  TEST_CASE("the efficiencies are those of the forces, and a worm locks where the reverse efficiency is zero or less") {
    Worm::Input in = plain();
    in.T_1 = 10.0 * N_m;
    const auto r = solve(in);
    CHECK(rel(in_si(r.T_2), in_si(r.T_1) * 15 * r.eta) < 1e-12);
    CHECK(rel(in_si(r.F_n) * in_si(r.F_n), std::pow(in_si(r.F_t1), 2) + std::pow(in_si(r.F_t2), 2) +
                                               std::pow(in_si(r.F_r), 2) - std::pow(r.mu * in_si(r.F_n), 2)) <
          1e-12);                           // normal force and friction at right angles
    for (const double mu : {0.12, 0.14}) {  // tan(7.765 deg) cos(20 deg) = 0.1281
      in.mu = mu, in.locking = Worm::Locking::required;
      const auto at = solve(in);
      CHECK((at.eta_b < 0.0) == (mu > 0.128));
      CHECK((at.x_L < 1.0) == (mu > 0.128));
    }
  }

  TEST_CASE("forces on worm and worm wheel are opposite in space, for both hands and directions") {
    for (const auto hand : {gear::Hand::right, gear::Hand::left}) {
      for (const auto turns : {gear::Turns::ccw, gear::Turns::cw}) {
        Worm::Input in = plain();
        in.T_1 = 10.0 * N_m, in.hand = hand, in.turns = turns, in.K_A = 1.25;
        const auto r = solve(in);
        // x of the wheel is -x of the worm, its y is z of the worm, its z is y of the worm.
        CHECK(rel(in_si(r.worm.F_x), in_si(r.wheel.F_x)) < 1e-12);
        CHECK(rel(in_si(r.worm.F_z), -in_si(r.wheel.F_y)) < 1e-12);
        CHECK(rel(in_si(r.worm.F_y), -in_si(r.wheel.F_z)) < 1e-12);
        CHECK(in_si(r.worm.F_y) * in_si(r.worm.n) < 0.0);    // against its rotation
        CHECK(in_si(r.wheel.F_y) * in_si(r.wheel.n) > 0.0);  // with it
        CHECK(rel(in_si(r.worm.T), 12.5) < 1e-12);
      }
    }
    // A right-hand screw that turns counter-clockwise pulls its nut towards -z: it is pushed towards +z itself.
    Worm::Input in = plain();
    in.T_1 = 10.0 * N_m;
    CHECK(in_si(solve(in).worm.F_z) > 0.0);
  }

  TEST_CASE("bending by Buckingham and the heat balance, by hand") {
    Worm::Input in = plain();
    in.mu = 0.04, in.P = 0.5 * kW, in.K_A = 1.2;
    in.sigma_adm = 50.0 * MPa, in.A_h = 0.2 * gear::square_metre, in.dT_adm = 50.0 * kelvin;
    const auto r = solve(in);
    const double g = std::atan(6.0 / 44),
                 eta = (std::cos(pi / 9) - 0.04 * std::tan(g)) / (std::cos(pi / 9) + 0.04 / std::tan(g));
    const double v_2 = pi * 0.09 * 1000 / 15 / 60, F = 500 * eta / v_2;
    const double sigma = 1.2 * F * (1200 + v_2 / 0.00508) / 1200 / (0.125 * 0.025 * pi * 0.003 * std::cos(g));
    CHECK(rel(in_si(r.sigma_F), sigma) < 1e-9);
    CHECK(rel(r.u_F, sigma / 50e6) < 1e-9);
    const double heat = 63.05 * (1000.0 / 6494 + 0.13) * 0.2 * 50;
    CHECK(rel(r.u_T, 500 * (1 - eta) / heat) < 1e-9);
    CHECK(rel(in_si(r.dT), 50 * r.u_T) < 1e-12);
    in.cooling = Worm::Cooling::fan;
    CHECK(rel(solve(in).u_T * (1000.0 / 3939 + 0.13), r.u_T * (1000.0 / 6494 + 0.13)) < 1e-12);
  }

  TEST_CASE("wrong worm gears are reported with their remedy") {
    const std::string worm = "d_1 = \"40 mm\"\n", runs = worm + "n_1 = \"1400 rpm\"\n";
    says("d_1 = \"9 mm\"\nmu = 0.05\n", "the worm has no core");
    says(worm, "give n_1, or mu");
    says(runs + "T_1 = \"5 N*m\"\nT_2 = \"80 N*m\"\n", "give the load once");
    says(runs + "S_Wmin = 1.2\n", "needs casting");
    says(runs + "sigma_adm = \"50 MPa\"\n", "an allowable stress needs a load");
    says(runs + "T_1 = \"5 N*m\"\nA_h = \"0.2 m^2\"\n", "needs both its surface A_h and the allowable rise dT_adm");
    says(worm + "mu = 0.05\nT_1 = \"5 N*m\"\nP_cool = \"1 kW\"\n", "the power loss needs a load");
  }
}
