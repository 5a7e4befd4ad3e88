#include "calculators/bearing/rolling.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using bearing::Rolling;

constexpr auto solve = test::evaluated<Rolling>;

using test::rel;

Rolling::Input bearing_6208() {
  Rolling::Input in;
  in.kind = bearing::Kind::deep_groove_ball;
  in.C = 29.1 * kN, in.C_0 = 17.9 * kN, in.f_0 = 14.0;
  in.F_r = 2.5 * kN, in.n = 900.0 * rpm;
  return in;
}

/// Errors of a user are reported in these words.
void check_says(const std::string& lines, const std::string& words) {
  CHECK(test::says("[b]\ncalculator = \"bearing.rolling\"\n" + lines, words));
}

const std::string loads = "C = \"30 kN\"\nF_r = \"3 kN\"\nF_a = \"1 kN\"\nn = \"900 rpm\"\n";

}  // namespace

TEST_SUITE("rolling bearing") {
  TEST_CASE("[NSK-E1102] example 1: f_h = 0.333 C/P, and a life of 500 f_h^3 hours") {
    const auto r = solve(bearing_6208());
    CHECK(in_si(r.P) == 2500.0);
    CHECK(rel(in_si(r.L_10h) / 3600.0, 500.0 * std::pow(0.333 * 29.1 / 2.5, 3)) < 0.004);  // for a share of 0.333
  }

  TEST_CASE("[SKF-6309] example 1, and [FAG-lecture] example 1: 343 millions, 8795 h") {
    Rolling::Input in;
    in.kind = bearing::Kind::deep_groove_ball;
    in.C = 55.3 * kN, in.F_r = 10.0 * kN, in.n = 3000.0 * rpm;
    CHECK(std::abs(solve(in).L_10 - 169.0) < 0.5);
    CHECK(std::abs(in_si(solve(in).L_10h) / 3600.0 - 940.0) < 1.0);
    in.C = 22.4 * kN, in.F_r = 3.2 * kN, in.n = 650.0 * rpm;
    CHECK(rel(solve(in).L_10, 343.0) < 1e-12);
    CHECK(std::abs(in_si(solve(in).L_10h) / 3600.0 - 8795.0) < 0.5);
  }

  TEST_CASE("e and Y are as printed at the rows of [Koyo], and linear between them") {
    Rolling::Input in = bearing_6208();
    in.F_r = 0.1 * kN;
    const auto at = [&](double f) {
      in.F_a = f / 14.0 * in.C_0;
      return solve(in);
    };
    CHECK(at(0.345).Y == doctest::Approx(1.99));
    CHECK(at(6.89).e == doctest::Approx(0.44));
    CHECK(at(0.01).Y == doctest::Approx(2.30));
    CHECK(at(0.5 * (1.38 + 2.07)).Y == doctest::Approx(0.5 * (1.45 + 1.31)));
    CHECK(at(0.5 * (1.38 + 2.07)).e == doctest::Approx(0.32));
  }

  TEST_CASE("rollers have the life exponent 10/3: half of the load has 10.08 times the life") {
    Rolling::Input in = bearing_6208();
    in.kind = bearing::Kind::cylindrical_roller_NU, in.f_0 = unset<double>;
    const double full = solve(in).L_10;
    in.F_r = 1.25 * kN;
    CHECK(rel(solve(in).L_10 / full, std::pow(2.0, 10.0 / 3.0)) < 1e-12);
    CHECK(rel(full, std::pow(11.64, 10.0 / 3.0)) < 1e-12);
  }

  TEST_CASE("blocks count by their revolutions: the hours until the sum of n_i/N_i is 1, counted one by one") {
    Rolling::Input in = bearing_6208();
    in.blocks.push_back({Name("fast"), 0.3, 0.5, 3000.0 * rpm});
    in.blocks.push_back({Name("slow"), 0.6, 1.5, 300.0 * rpm});
    in.blocks.push_back({Name("rest"), 0.1, 4.0, 0.0 * rpm});
    const auto r = solve(in);
    const auto wear_per_hour = [](double q, double k, double n) {
      return q * n * 60.0 / (1e6 * std::pow(29.1 / (2.5 * k), 3));
    };
    const double fast = wear_per_hour(0.3, 0.5, 3000.0), slow = wear_per_hour(0.6, 1.5, 300.0);
    CHECK(rel(in_si(r.L_10h) / 3600.0, 1.0 / (fast + slow)) < 1e-12);
    CHECK(rel(r.blocks[0].D, fast / (fast + slow)) < 1e-12);
    CHECK(r.blocks[2].D == 0.0);
    CHECK(rel(in_si(r.P_0), 10e3) < 1e-12);  // at rest it still dents
  }

  TEST_CASE("a block may have loads of its own in place of a share of those of the step") {
    Rolling::Input in = bearing_6208();
    in.F_a = 1.0 * kN, in.K_A = 1.3, in.s_0 = 1.5;
    Rolling::Input shares = in;
    shares.blocks.push_back({Name("full"), 0.25, 1.0, 900.0 * rpm});
    shares.blocks.push_back({Name("half"), 0.75, 0.5, 1500.0 * rpm});
    Rolling::Input own = in;
    own.blocks.push_back({Name("full"), 0.25, 1.0, 900.0 * rpm, in.F_r, in.F_a});
    own.blocks.push_back({Name("half"), 0.75, 1.0, 1500.0 * rpm, 0.5 * in.F_r, 0.5 * in.F_a});
    const auto by_share = solve(shares), by_own = solve(own);
    CHECK(rel(in_si(by_own.P_m), in_si(by_share.P_m)) < 1e-12);
    CHECK(rel(by_own.u_0, by_share.u_0) < 1e-12);
    CHECK(rel(by_own.u_a, by_share.u_a) < 1e-12);
    CHECK(rel(by_own.x_f, by_share.x_f) < 1e-12);
  }

  TEST_CASE("an axial load of one block alone counts there, in life, limits and direction") {
    Rolling::Input in;
    in.kind = bearing::Kind::angular_contact_ball, in.C = 40.0 * kN, in.C_0 = 30.0 * kN, in.n = 1000.0 * rpm;
    in.F_r = 2.0 * kN, in.F_a = 1.0 * kN, in.e = 0.68, in.X = 0.41, in.Y = 0.87;
    in.blocks.push_back({Name("radial"), 0.5, 1.0});
    in.blocks.push_back({Name("thrust"), 0.5, 1.0, unset<AngularSpeed>, 1.0 * kN, 4.0 * kN});
    const double P = 0.41 * 1.0 + 0.87 * 4.0;  // kN; the other block: F_a/F_r = 0.5 < e, P = F_r = 2 kN
    CHECK(rel(in_si(solve(in).P_m), 1e3 * std::cbrt(0.5 * 8.0 + 0.5 * P * P * P)) < 1e-12);
    CHECK(solve(in).F_ao == 0.0 * N);
    in.blocks[1].F_a = -4.0 * kN;
    CHECK(rel(in_si(solve(in).F_ao), 4000.0) < 1e-12);
  }

  TEST_CASE("two rows of [NSK-E1102] example 3 take their load by Y_1 up to e and by X and Y beyond") {
    Rolling::Input in;
    in.kind = bearing::Kind::spherical_roller, in.C = 603.0 * kN, in.F_r = 45.0 * kN, in.F_a = 8.0 * kN,
    in.n = 500.0 * rpm;
    in.e = 0.3, in.Y_1 = 2.2, in.Y = 3.3;
    CHECK(rel(in_si(solve(in).P), 62600.0) < 1e-12);
    in.F_a = 20.0 * kN;
    CHECK(rel(in_si(solve(in).P), 0.67 * 45e3 + 3.3 * 20e3) < 1e-12);
  }

  TEST_CASE("a bearing at standstill has a static load and no life") {
    Rolling::Input in = bearing_6208();
    in.n = 0.0 * rpm, in.F_a = 5.0 * kN, in.s_0 = 2.0;
    const auto r = solve(in);
    CHECK_FALSE(is_set(r.L_10h));
    CHECK_FALSE(is_set(r.x_min));
    CHECK(rel(in_si(r.P_0), 0.6 * 2500.0 + 0.5 * 5000.0) < 1e-12);
    CHECK(rel(r.u_0, 2.0 * 4000.0 / 17900.0) < 1e-12);
  }

  TEST_CASE("without a load no infinite life is reported") {
    Rolling::Input in = bearing_6208();
    in.F_r = 0.0 * N.one, in.L_h = 10000.0 * hour;
    const auto r = solve(in);
    CHECK_FALSE(is_set(r.L_10));
    CHECK(r.u_L == 0.0);
    CHECK_FALSE(is_set(r.x_min));  // a rule of thumb
    in.P_min = 0.1 * kN;
    CHECK(solve(in).x_min == 0.0);
  }

  TEST_CASE("missing and contradictory inputs are reported") {
    check_says("kind = \"deep_groove_ball\"\n" + loads, "give f_0 and C_0 of the manufacturer's table");
    check_says("kind = \"deep_groove_ball\"\nf_0 = 14\n" + loads, "give the static load rating C_0");
    check_says("kind = \"tapered_roller\"\n" + loads, "give e, Y");
    check_says("kind = \"angular_contact_ball\"\n" + loads, "give e, X, Y");
    check_says("kind = \"spherical_roller\"\n" + loads, "give e, Y_1, Y (Y_2 of the table)");
    check_says("kind = \"cylindrical_roller_NU\"\nf_0 = 14\n" + loads, "give either f_0");
    check_says("kind = \"deep_groove_ball\"\nC_0 = \"18 kN\"\nf_0 = 14\nblocks = [{ q = 0.5 }, { q = 0.4 }]\n" + loads,
               "the shares q sum to 0.9, not to 1");
    const std::string typed = "kind = \"deep_groove_ball\"\nC_0 = \"18 kN\"\nf_0 = 14\n" + loads;
    check_says("blocks = [{ q = 1, F_r = \"1 N\" }]\n" + typed, "no block has the loads F_r and F_a");
    check_says("blocks = [{ q = 1, k = 2, F_r = \"90 kN\", F_a = \"90 kN\" }]\n" + typed,
               "is not scaled: omit k there");
    check_says("kind = \"deep_groove_ball\"\nC = \"30 kN\"\nF_r = \"3 kN\"\nn = \"0 rpm\"\nL_h = \"100 h\"\n",
               "a bearing at standstill has no life in hours: omit L_h, or give the speed");
    check_says(loads, "give the bearing type");
    check_says("kind = \"deep_groove_ball\"\nC = \"30 kN\"\nF_r = \"-3 kN\"\nn = \"900 rpm\"\n", "F_r");
  }
}
