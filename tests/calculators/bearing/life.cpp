// Modified rating life, pairs of bearings, life without a speed.
#include "calculators/bearing/rolling.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using namespace loadpath::test;
using bearing::Carries;
using bearing::Rolling;

constexpr auto solve = evaluated<Rolling>;

/// A bearing under 10 kN with e_C C_u/P = 0.1.
Rolling::Input in_oil(bearing::Kind kind, double kappa) {
  Rolling::Input in;
  in.kind = kind;
  in.C = 60.0 * kN, in.C_u = 5.0 * kN, in.e_C = 0.2, in.kappa = kappa;
  in.F_r = 10.0 * kN, in.n = 1500.0 * rpm;
  return in;
}

double a_ISO(bearing::Kind kind, double kappa) { return solve(in_oil(kind, kappa)).a_ISO; }

/// 30206 with 30305 D, the pair of [NSK-E1102] example 4.
Rolling::Input of_pair(bool first) {
  Rolling::Input in;
  in.kind = bearing::Kind::tapered_roller;
  in.C = (first ? 38.0 : 43.0) * kN, in.n = 600.0 * rpm, in.c_i = 0.6;
  in.e = first ? 0.83 : 0.38, in.Y = first ? 0.73 : 1.6;
  in.F_r = (first ? 1569.0 : 3931.0) * N, in.mate.F_r = (first ? 3931.0 : 1569.0) * N;
  in.mate.Y = first ? 1.6 : 0.73;
  in.F_a = 2.0 * kN, in.carries = first ? Carries::right : Carries::left;
  return in;
}

}  // namespace

TEST_SUITE("rolling bearing") {
  TEST_CASE("a_ISO at the anchors of an independent computation, balls and rollers") {
    CHECK(a_ISO(bearing::Kind::deep_groove_ball, 0.2) == doctest::Approx(0.188).epsilon(0.003));
    CHECK(a_ISO(bearing::Kind::deep_groove_ball, 0.4) == doctest::Approx(0.312).epsilon(0.003));
    CHECK(a_ISO(bearing::Kind::deep_groove_ball, 1.0) == doctest::Approx(2.43).epsilon(0.003));
    CHECK(a_ISO(bearing::Kind::deep_groove_ball, 4.0) == doctest::Approx(7.20).epsilon(0.003));
    CHECK(a_ISO(bearing::Kind::cylindrical_roller_NU, 0.2) == doctest::Approx(0.124).epsilon(0.004));
    CHECK(a_ISO(bearing::Kind::cylindrical_roller_NU, 0.4) == doctest::Approx(0.154).epsilon(0.004));
    CHECK(a_ISO(bearing::Kind::cylindrical_roller_NU, 1.0) == doctest::Approx(0.399).epsilon(0.003));
    CHECK(a_ISO(bearing::Kind::cylindrical_roller_NU, 4.0) == doctest::Approx(0.664).epsilon(0.003));
  }

  TEST_CASE("the equivalent load is shown by the formula that applies, [ISO281]: X = 1, Y = 0 up to e") {
    Rolling::Input in;
    in.kind = bearing::Kind::self_aligning_ball;
    in.C = 40.0 * kN, in.n = 1500.0 * rpm, in.e = 0.3, in.Y = 3.3, in.Y_1 = 2.1, in.F_r = 10.0 * kN;
    const auto shown = [&](double F_a_kN) {
      in.F_a = F_a_kN * kN;
      Trace trace;
      (void)Rolling::evaluate(in, trace);
      const auto line = std::ranges::find(trace.lines(), std::string("P"), &Line::symbol);
      return std::string(line->formula) + "; " + std::to_string(line->si / 1000.0);
    };
    CHECK(shown(2.0) == "F_rK + Y_1 * F_aK; 14.200000");    // 10 + 2.1 2
    CHECK(shown(4.0) == "X * F_rK + Y * F_aK; 19.700000");  // 0.65 10 + 3.3 4
    in.kind = bearing::Kind::deep_groove_ball;
    CHECK(shown(2.0) == "F_rK; 10.000000");
    CHECK(shown(4.0) == "X * F_rK + Y * F_aK; 18.800000");  // 0.56 10 + 3.3 4
  }

  TEST_CASE("a_ISO is continuous where its constants change, rises with the film up to 4, and never exceeds 50") {
    for (const bearing::Kind kind : {bearing::Kind::deep_groove_ball, bearing::Kind::spherical_roller}) {
      for (const double kappa : {0.4, 1.0})
        CHECK(a_ISO(kind, kappa) == doctest::Approx(a_ISO(kind, kappa * (1.0 - 1e-9))).epsilon(2e-3));
      double before = 0.0;
      for (double kappa = 0.1; kappa < 4.0; kappa *= 1.1) {
        CHECK(a_ISO(kind, kappa) > before);
        before = a_ISO(kind, kappa);
      }
      CHECK(a_ISO(kind, 9.0) == a_ISO(kind, 4.0));
      Rolling::Input clean = in_oil(kind, 4.0);
      clean.e_C = 1.0, clean.F_r = 0.1 * kN;
      CHECK(solve(clean).a_ISO == 50.0);
    }
  }

  TEST_CASE("[Shigley-11-18] inch tapered roller bearings: 0.47 F_r/K, 0.4 F_r + K F_a") {
    Rolling::Input in = of_pair(true);
    in.c_i = 0.47, in.e = 0.4, in.Y = 1.5, in.mate.Y = 1.5;
    in.F_r = 2170.0 * N, in.mate.F_r = 2654.0 * N, in.F_a = 1690.0 * N;
    const auto r = solve(in);
    CHECK(rel(r.F_i / N, 0.47 * 2170.0 / 1.5) < 1e-12);
    CHECK(rel(r.F_ax / N, 2521.587) < 1e-6);  // 1690 + 0.47 2654/1.5
    CHECK(rel(r.P / N, 4650.38) < 1e-6);
  }

  TEST_CASE("the viscosity ratio: 6208 at 900 rpm needs 20.5 mm^2/s, 45000 n^-0.83 D_pw^-0.5") {
    Rolling::Input in = in_oil(bearing::Kind::deep_groove_ball, unset<double>);
    in.d = 40.0 * mm, in.D = 80.0 * mm, in.n = 900.0 * rpm, in.nu = 20.52 * bearing::mm2_per_s;
    CHECK(solve(in).x_k == doctest::Approx(1.0).epsilon(0.001));
    in.n = 3000.0 * rpm, in.nu = 10.606 * bearing::mm2_per_s;  // 4500/sqrt(3000 60)
    CHECK(solve(in).x_k == doctest::Approx(1.0).epsilon(0.001));
  }

  TEST_CASE("blocks: the hours until the sum of q n/(a_i L_i) is 1") {
    Rolling::Input in = in_oil(bearing::Kind::deep_groove_ball, unset<double>);
    in.d = 40.0 * mm, in.D = 80.0 * mm, in.nu = 12.0 * bearing::mm2_per_s;
    in.blocks.push_back({Name(), 0.3, 1.0, 400.0 * rpm});
    in.blocks.push_back({Name(), 0.7, 0.5, 2000.0 * rpm});
    double damage_per_hour = 0.0;
    for (const Rolling::Block& block : in.blocks) {
      Rolling::Input alone = in;
      alone.blocks.clear();
      alone.n = block.n, alone.F_r = block.k * in.F_r;
      const auto r = solve(alone);
      damage_per_hour += block.q / (r.a_ISO * in_si(r.L_10h) / 3600.0);
    }
    CHECK(in_si(solve(in).L_nh) / 3600.0 == doctest::Approx(1.0 / damage_per_hour));
  }

  TEST_CASE("reliability: a_1 of the table of 2007, and the reliability that a life has") {
    Rolling::Input in = in_oil(bearing::Kind::deep_groove_ball, unset<double>);
    in.e_C = unset<double>, in.L_h = from_si<Time>(3600.0 * 1000.0);
    const double basic = in_si(solve(in).L_10h);
    const double table[][2] = {{0.9, 1.0},   {0.95, 0.64}, {0.96, 0.55},   {0.97, 0.47},
                               {0.98, 0.37}, {0.99, 0.25}, {0.995, 0.175}, {0.999, 0.093}};
    for (const auto& [R, a_1] : table) {
      in.R = R;
      CHECK(std::abs(in_si(solve(in).L_nh) / basic - a_1) < 0.0055);
      in.L_h = from_si<Time>(in_si(solve(in).L_nh));
      CHECK(solve(in).R_L == doctest::Approx(R));
    }
  }

  TEST_CASE("[NSK-E1102] example 4 (recalled): a pair back to back, 5500 N between them and 2000 N along the shaft") {
    const auto first = solve(of_pair(true)), second = solve(of_pair(false));
    CHECK(in_si(first.P) == doctest::Approx(0.4 * 1569.0 + 0.73 * (2000.0 + 0.6 * 3931.0 / 1.6)));
    CHECK(in_si(first.P) == doctest::Approx(3164.0).epsilon(0.001));
    CHECK(in_si(second.P) == doctest::Approx(3931.0));
    CHECK(in_si(first.L_10h) / 3600.0 == doctest::Approx(109750.0).epsilon(0.02));  // f_h there from a diagram
    CHECK(in_si(second.L_10h) / 3600.0 == doctest::Approx(80400.0).epsilon(0.02));
  }

  TEST_CASE("a pair is in balance: the axial loads differ by the external force, the smaller is induced") {
    for (const double external : {-6.0, -1.0, 0.0, 1.0, 6.0}) {
      Rolling::Input left = of_pair(true), right = of_pair(false);
      left.F_a = right.F_a = external * kN;
      left.s_0 = right.s_0 = 1.0, left.Y_0 = right.Y_0 = 0.8, left.C_0 = right.C_0 = 40.0 * kN;
      const auto load = [](const Rolling::Input& in) {
        NoTrace no_trace;
        return in_si(bearing::thrust(in, no_trace).F_a);
      };
      CHECK(load(left) - load(right) == doctest::Approx(1e3 * external));
      const double induced_left = 0.6 * 1569.0 / 0.73, induced_right = 0.6 * 3931.0 / 1.6;
      const bool left_floats = load(left) < induced_left * (1.0 + 1e-9);
      CHECK((left_floats || load(right) < induced_right * (1.0 + 1e-9)));
      CHECK(load(left) >= induced_left * (1.0 - 1e-9));
      CHECK(load(right) >= induced_right * (1.0 - 1e-9));
    }
  }

  TEST_CASE("an opposed bearing is refused for a bearing that induces no axial force, and without a direction") {
    const std::string deep = "[b]\ncalculator = \"bearing.rolling\"\nF_r = \"3 kN\"\nF_a = \"1 kN\"\nn = \"900 rpm\"\n";
    const std::string mate = "mate = { F_r = \"2 kN\", Y = 1.6 }\n";
    CHECK(says(deep + "bearing = \"6208\"\n" + mate + "carries = \"left\"", "a pair is of two single-row bearings"));
    CHECK(says(deep + "bearing = \"30208\"\n" + mate, "give arrangement = \"back_to_back\""));
    CHECK(mode_of(solved_as_found(deep + "bearing = \"30208\"\n" + mate + "carries = \"left\""), "b", "mate") ==
          "pass");
    CHECK(mode_of(solved_as_found(deep + "bearing = \"30208\"\n" + mate + "carries = \"left\""), "b", "axial") ==
          "pass");
  }

  TEST_CASE("without a speed the life is in revolutions, and is assessed only if a life is required") {
    const std::string still = "[b]\ncalculator = \"bearing.rolling\"\nF_r = \"3 kN\"\nbearing = \"6208\"\n";
    const auto project = solved_as_found(still);
    CHECK(mode_of(project, "b", "fatigue") == "not-judged");
    CHECK(mode_of(project, "b", "film") == "open");
    CHECK(mode_of(solved_as_found(still + "L_m = 100"), "b", "fatigue") == "pass");
    CHECK(says(still + "L_h = \"1000 h\"", "a bearing at standstill has no life in hours"));
    Rolling::Input in;
    in.kind = bearing::Kind::deep_groove_ball, in.C = 32.5 * kN, in.F_r = 3.25 * kN;
    CHECK(solve(in).L_10 == doctest::Approx(1000.0));
  }
}
