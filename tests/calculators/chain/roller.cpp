#include "calculators/chain/roller.hpp"

#include "calculators/catalogue.hpp"
#include "calculators/chain/links.hpp"
#include "lib/project/project.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;

constexpr auto solve = test::evaluated<chain::Roller>;

using test::rel;

chain::Roller::Input conveyor() {
  chain::Roller::Input in;
  in.p = 25.4 * mm, in.A = 211.0 * mm2, in.q = 2.71 * kg_per_m, in.F_uM = 60.0 * kN, in.F_u94 = 42.3 * kN;
  in.z_1 = 21, in.z_2 = 57;
  in.a = 1000.0 * mm;
  in.n_1 = 96.0 * rpm, in.P = 3.0 * kW;
  return in;
}

bool says(const std::string& lines, const std::string& part) {
  const std::vector<Issue> issues =
      loadpath::test::told("[g]\ncalculator = \"chain.roller\"\nz_1 = 21\nz_2 = 57\n" + lines).issues;
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("roller chain") {
  TEST_CASE("links and centre distance are the inverse of each other") {
    for (const double a : {12.0, 20.0, 35.5, 80.0}) {
      for (const auto& z : {std::pair{19, 57}, {57, 19}, {20, 20}, {17, 80}}) {
        CAPTURE(a);
        CHECK(rel(chain::pitches_of(chain::links_at(a, z.first, z.second), z.first, z.second), a) < 1e-12);
      }
    }
    CHECK(std::isnan(chain::pitches_of(30.0, 20.0, 60.0)));
    CHECK(std::isnan(chain::pitches_of(20.0, 20.0, 20.0)));
  }

  TEST_CASE("an independent bisection over the lengths of strands and arcs") {
    CHECK(rel(chain::links_at(36, 20, 63), 114.80495332988767) < 1e-12);
    CHECK(rel(chain::pitches_of(114, 20, 63), 35.589959029290064) < 1e-12);
    CHECK(rel(chain::pitches_of(120, 19, 57), 40.54812691815793) < 1e-12);
  }

  TEST_CASE("the factors f_4 of [ISO10823], recalled: a = p f_4 (2 X - z_1 - z_2)") {
    for (const auto& row : {std::pair{12.0, 0.24990}, {2.0, 0.24421}, {1.25, 0.22442}}) {
      const double X = 20.0 + row.first * 40.0;
      CHECK(std::abs(chain::pitches_of(X, 20, 60) / (2.0 * X - 80.0) - row.second) < 1e-5);
    }
  }

  TEST_CASE("the chain has an even number of links, and the centre distance is that of the chain") {
    const auto r = solve(conveyor());
    CHECK(std::fmod(r.X, 2.0) == 0.0);
    CHECK(std::abs(r.X - r.X_0) <= 1.0);
    CHECK(rel(chain::links_at(r.a / (25.4 * mm), 21, 57), r.X) < 1e-12);
    chain::Roller::Input in = conveyor();
    in.a = unset<Length>, in.X = 119;
    CHECK(solve(in).odd == 1.0);
  }

  TEST_CASE("power, pull and speed agree; the service factor acts once and not on the sag") {
    const auto one = solve(conveyor());
    CHECK(rel(in_si(one.F_t) * in_si(one.v), 3000) < 1e-12);
    chain::Roller::Input in = conveyor();
    in.K_A = 1.5;
    const auto shock = solve(in);
    CHECK(shock.F_t == one.F_t);
    CHECK(rel(in_si(shock.F - one.F), 0.5 * in_si(one.F_t)) < 1e-9);
    CHECK(rel(in_si(shock.F_W - one.F_W), 0.5 * in_si(one.F_t)) < 1e-9);
    CHECK(rel(shock.p_r / one.p_r, 1.5) < 1e-14);
    CHECK(shock.S_stat == one.S_stat);
    CHECK(shock.S_dyn < one.S_dyn);
  }

  TEST_CASE("both shafts are pulled to each other, with the torque of each") {
    chain::Roller::Input in = conveyor();
    in.K_A = 1.5;
    const auto r = solve(in);
    for (const ShaftLoad& load : {r.shaft_1, r.shaft_2}) {
      CHECK(load.F_x == r.F_W);
      CHECK(load.F == r.F_W);
      CHECK(in_si(load.F_y) == 0.0);
    }
    CHECK(rel(in_si(r.shaft_2.T), 1.5 * 3000 / (96 * pi / 30) * 57 / 21) < 1e-12);
  }

  TEST_CASE("two editions of ISO 606 differ by 42 % for 16B, and the field states which is meant") {
    chain::Roller::Input in = conveyor();
    const auto maker = solve(in);
    in.edition = chain::Roller::Edition::iso606_1994;
    CHECK(rel(maker.S_dyn / solve(in).S_dyn, 60.0 / 42.3) < 1e-14);
  }

  TEST_CASE("speed limits of the text by lubrication: 6 m/s, with an oil bath 12 m/s") {
    chain::Roller::Input in = conveyor();
    in.n_1 = 6.0 / (21 * 0.0254) * 60.0 * rpm;
    CHECK(rel(solve(in).v_share, 1.0) < 1e-12);
    in.lubrication = chain::Roller::Lubrication::bath;
    CHECK(rel(solve(in).v_share, 0.5) < 1e-12);
  }

  TEST_CASE("twice the strands carry twice the load at half the pressure") {
    chain::Roller::Input in = conveyor();
    const auto one = solve(in);
    in.strands = 2;
    CHECK(rel(one.p_r / solve(in).p_r, 2) < 1e-14);
    CHECK(rel(solve(in).F_u / one.F_u, 2) < 1e-14);
  }

  TEST_CASE("the slack strand sags as a parabola under its pull, and by 2 % of a horizontal drive") {
    chain::Roller::Input in = conveyor();
    in.theta = 0.0;
    const auto level = solve(in);
    const double a = in_si(level.a);
    CHECK(rel(in_si(level.f_s), 2.71 * 9.81 * a * a / (8.0 * in_si(level.F_f))) < 1e-12);
    CHECK(rel(in_si(level.f_s), a / 48.0) < 1e-12);
    for (const double side : {1.0, -1.0}) {  // the larger sag factor of K_f = 6 does not hold a steep drive up
      in.theta = side * pi / 3.0;
      CHECK(rel(in_si(solve(in).f_s), 28.199212280112e-3) < 1e-9);
      CHECK(rel(solve(in).theta_c, pi / 3.0) < 1e-15);
    }
    in.theta = pi / 2.0;
    CHECK(in_si(solve(in).f_s) < 1e-12);
  }

  TEST_CASE("only a slack strand above the loaded one has a clearance, less by sag and plates") {
    chain::Roller::Input in = conveyor();
    CHECK(!is_set(solve(in).f_s));
    in.theta = pi / 6.0;
    CHECK(!is_set(solve(in).g_s));
    in.loaded = chain::Roller::Loaded::lower;
    CHECK(rel(in_si(solve(in).g_s), 262.9677092938458e-3) < 1e-9);
  }

  TEST_CASE("wrong input is reported") {
    says("a = \"1 m\"\n", "give the pitch p, or a chain");
    says("p = \"25.4 mm\"\n", "either the centre distance a or the number of links X");
    says("p = \"25.4 mm\"\na = \"1 m\"\nX = 120\n", "either the centre distance a or the number of links X");
    says("p = \"25.4 mm\"\na = \"200 mm\"\n", "the sprockets touch each other");
    says("p = \"25.4 mm\"\nX = 50\n", "do not reach around");
    says("p = \"25.4 mm\"\na = \"1 m\"\nP = \"3 kW\"\n", "a power needs the speed");
    says("p = \"25.4 mm\"\na = \"1 m\"\np_adm = \"30 MPa\"\nT_1 = \"5 N*m\"\n", "the pressure needs the bearing area");
    says("p = \"25.4 mm\"\na = \"1 m\"\nS_min = 8\nT_1 = \"5 N*m\"\n", "breaking load of the edition");
    says("p = \"25.4 mm\"\nX = 121\n", "cranked link");
    says("p = \"25.4 mm\"\na = \"1 m\"\nloaded = \"lower\"\n", "needs the inclination theta");
    says("p = \"25.4 mm\"\na = \"1 m\"\ntheta = \"0 deg\"\nK_f = 0\n", "a sag factor K_f above 0");
    says("chain = \"16Z\"\na = \"1 m\"\n", "no chain '16Z' in the tables");
  }
}
