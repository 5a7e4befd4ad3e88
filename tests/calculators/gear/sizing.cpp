// gear.sizing against all combinations of its range, rated one by one by gear.rating, and against the law of sliding.
#include "calculators/gear/sizing/sizing.hpp"

#include "calculators/gear/pair.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using test::mode_with;
using By = PairSizing::By;
using Shift = PairSizing::Shift;

constexpr auto solve = test::evaluated<PairSizing>;

/// A case-hardened pair in a narrow range.
PairSizing::Input hoist() {
  PairSizing::Input in;
  in.P = 15e3 * W, in.n_1 = 1450.0 * rpm, in.i_set = 4.0, in.K_A = 1.25;
  in.z_min = 17, in.z_max = 25, in.m_min = 1.5 * mm, in.m_max = 4.0 * mm;
  in.grade = 6, in.finish = Finish::ground, in.R_z1 = in.R_z2 = 5.0 * um;
  in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.quality_1 = in.quality_2 = Quality::MQ, in.H_1 = in.H_2 = 720, in.place = gear::Place::middle;
  in.S_Hmin = 1.1, in.S_Fmin = 1.4;
  return in;
}

bool passes(const Rating::Result& r) {
  return r.u_H1 <= 1.0 && r.u_H2 <= 1.0 && r.u_F1 <= 1.0 && r.u_F2 <= 1.0 && !(r.x_v > 10.0) && r.x_eps >= 1.0 &&
         r.x_eps <= 2.0 && r.x_free >= -0.02 && r.s_a >= 0.2 && r.f_int >= -0.01 && r.c_n / mm >= -1e-6;
}

/// The pair of a candidate with another shift of gear 1, the sum as it is.
Pair::Input pair_with(const PairSizing::Candidate& c, double x_1) {
  Pair::Input in;
  in.z_1 = c.z_1, in.z_2 = c.z_2, in.m_n = c.m_n, in.beta = c.beta, in.b = c.b;
  in.x_1 = x_1, in.x_2 = c.x_1 + c.x_2 - x_1;
  return in;
}

/// Difference of the specific sliding at both roots, from the radii of curvature at the ends of contact.
double imbalance(const Pair::Input& in) {
  const Pair::Result r = test::evaluated<Pair>(in);
  const double at = in_si(r.d_w1) / 2.0 * std::sin(r.alpha_wt), of = in_si(r.d_w2) / 2.0 * std::sin(r.alpha_wt);
  const double begin_1 = at - in_si(r.g_f), begin_2 = of + in_si(r.g_f);
  const double end_1 = at + in_si(r.g_a), end_2 = of - in_si(r.g_a), u = in.z_2 / in.z_1;
  return begin_2 / (u * begin_1) - u * end_1 / end_2;
}

std::vector<double> widths() {
  std::vector<double> all;
  for (const double decade : {1.0, 10.0, 100.0}) {
    for (const double number :
         {1.0, 1.12, 1.25, 1.4, 1.6, 1.8, 2.0, 2.24, 2.5, 2.8, 3.15, 3.55, 4.0, 4.5, 5.0, 5.6, 6.3, 7.1, 8.0, 9.0})
      all.push_back(decade * number);
  }
  return all;
}

/// Lightest pair without profile shift, spur, in kg: every combination of the range of `hoist`.
double least_mass(const PairSizing::Input& in) {
  double least = HUGE_VAL;
  for (const double m : {1.5, 2.0, 2.5, 3.0, 4.0}) {
    for (int z_1 = 17; z_1 <= 25; ++z_1) {
      for (const double b : widths()) {
        const double d_1 = m * z_1;
        if (b < 0.3 * d_1 || b > d_1 || b < 6.0 * m || b > 30.0 * m) continue;
        Rating::Input pair = in;
        pair.T_1 = in.P / in.n_1, pair.m_n = m * mm, pair.z_1 = z_1, pair.z_2 = 4 * z_1, pair.b = b * mm,
        pair.x_2 = 0.0;
        const double mass = 7850.0 * pi / 4.0 * d_1 * d_1 * 17.0 * b * 1e-9;
        if (mass < least && passes(test::evaluated<Rating>(pair))) least = mass;
      }
    }
  }
  return least;
}

}  // namespace

TEST_SUITE("gear sizing") {
  TEST_CASE("the best pair is the lightest of all combinations of the range") {
    for (const double kilowatts : {2.0, 15.0, 60.0}) {
      auto in = hoist();
      in.P = kilowatts * 1e3 * W, in.shift = Shift::none;
      const double least = least_mass(in);
      REQUIRE(std::isfinite(least));
      CHECK(in_si(solve(in).mass) == doctest::Approx(least).epsilon(1e-9));
    }
  }

  TEST_CASE("the best pair is as gear.rating assesses it") {
    for (const auto standard : {RatingStandard::din3990, RatingStandard::iso6336}) {
      auto in = hoist();
      in.betas = {{0.0}, {12.0 * deg.one}};
      in.standard = standard, in.nu_40 = 150.0 * mm2_per_s.one;
      const auto r = solve(in);
      REQUIRE(r.found > 0.0);
      const auto rated = test::evaluated<Rating>(r.best);
      CHECK(passes(rated));
      CHECK(rated.S_H1 == r.S_H1);
      CHECK(rated.S_F2 == r.S_F2);
      CHECK(r.best.m_n == r.m_n);
      CHECK(in_si(r.best.T_1) == doctest::Approx(in_si(in.P / in.n_1)));
    }
  }

  TEST_CASE("candidates are ranked, each passes and is within the range; the rejected ones rank before them and fail") {
    for (const auto by : {By::mass, By::centre}) {
      auto in = hoist();
      in.by = by;
      const auto r = solve(in);
      REQUIRE(r.candidates.size() == 10);
      REQUIRE(!r.rejected.empty());
      CHECK(r.candidates[0].excess == 0.0);
      for (std::size_t i = 0; i < r.candidates.size(); ++i) {
        const auto& c = r.candidates[i];
        CHECK(c.failure == PairSizing::Failure::none);
        CHECK(c.u <= 1.0);
        CHECK(std::abs(c.z_2 / c.z_1 / in.i_set - 1.0) <= in.tol_i);
        CHECK(c.z_1 >= 17.0);
        CHECK(c.z_1 <= 25.0);
        if (i > 0) CHECK(c.excess >= r.candidates[i - 1].excess);
      }
      for (const auto& c : r.rejected) {
        CHECK(c.failure != PairSizing::Failure::none);
        CHECK(c.excess <= 0.0);
      }
    }
  }

  TEST_CASE("no candidate passes with the next smaller width") {
    const auto in = hoist();
    const auto r = solve(in);
    const auto all = widths();
    for (const auto& c : r.candidates) {
      double smaller = 0.0;
      for (const double b : all) {
        if (b < c.b / mm * (1.0 - 1e-9)) smaller = b;
      }
      if (smaller < std::max(0.3 * c.z_1, 6.0) * (c.m_n / mm)) continue;
      Rating::Input pair = r.best;
      pair.m_n = c.m_n, pair.z_1 = c.z_1, pair.z_2 = c.z_2, pair.x_1 = c.x_1, pair.x_2 = c.x_2, pair.b = smaller * mm;
      CHECK(!passes(test::evaluated<Rating>(pair)));
    }
  }

  TEST_CASE("the profile shift balances the sliding: no other hundredth does it better") {
    auto in = hoist();
    in.betas = {{0.0}, {12.0 * deg.one}};
    for (const double x_sum : {0.0, 0.5}) {
      in.x_sum = x_sum;
      const auto r = solve(in);
      CHECK(r.zeta_1 == doctest::Approx(r.zeta_2).epsilon(0.1));
      REQUIRE(!r.candidates.empty());
      for (const auto& c : r.candidates) {
        CHECK(c.x_1 + c.x_2 == doctest::Approx(x_sum).epsilon(1e-9));
        const double here = std::abs(imbalance(pair_with(c, c.x_1)));
        CHECK(here <= std::abs(imbalance(pair_with(c, c.x_1 + 0.01))));
        CHECK(here <= std::abs(imbalance(pair_with(c, c.x_1 - 0.01))));
      }
    }
  }

  TEST_CASE("gears of one size share the profile shift equally") {
    auto in = hoist();
    in.i_set = 1.0, in.x_sum = 0.4;
    for (const auto& c : solve(in).candidates) {
      if (c.z_1 == c.z_2) CHECK(c.x_1 == doctest::Approx(0.2));
    }
  }

  TEST_CASE("every candidate has the fixed centre distance") {
    auto in = hoist();
    in.a_set = 125.0 * mm;
    const auto r = solve(in);
    REQUIRE(r.found > 0.0);
    for (const auto& c : r.candidates) CHECK(c.a_w / mm == doctest::Approx(125.0).epsilon(1e-12));
    CHECK(r.best.a_w / mm == doctest::Approx(125.0));
  }

  TEST_CASE("more power never makes a lighter pair, a wider range never a heavier one") {
    auto in = hoist();
    double before = 0.0;
    for (const double kilowatts : {1.0, 3.0, 10.0, 30.0, 60.0}) {
      in.P = kilowatts * 1e3 * W;
      const double mass = in_si(solve(in).mass);
      CHECK(mass >= before);
      before = mass;
      auto wide = in;
      wide.z_max = 30, wide.m_min = 1.0 * mm;
      CHECK(in_si(solve(wide).mass) <= mass);
    }
  }

  TEST_CASE("where no pair carries the load, the nearest one is shown with the failure mode") {
    auto in = hoist();
    in.P = 2e6 * W;
    const auto r = solve(in);
    CHECK(r.found == 0.0);
    CHECK(r.candidates.empty());
    REQUIRE(!r.rejected.empty());
    CHECK(r.u_H1 > 1.0);
    CHECK(r.m_n == 4.0 * mm);
    CHECK(r.z_1 == 25);
    CHECK(mode_with("gear.sizing", "P = \"5000 kW\"", "pairs") == "fail");
    CHECK(mode_with("gear.sizing", "P = \"5000 kW\"", "pitting_1") == "fail");
    CHECK(mode_with("gear.sizing", "", "pairs") == "pass");
    CHECK(mode_with("gear.sizing", "", "root_2") == "pass");
  }

  TEST_CASE("where none passes, the rejected pairs are those nearest to passing, the shown one first") {
    auto in = hoist();
    in.P = 2e6 * W;
    const auto r = solve(in);
    REQUIRE(r.rejected.size() == 10);
    CHECK(r.rejected[0].m_n == r.m_n);
    CHECK(r.rejected[0].b == r.b);
    CHECK(r.rejected[0].excess == 0.0);
    for (std::size_t i = 1; i < r.rejected.size(); ++i) CHECK(r.rejected[i].u >= r.rejected[i - 1].u);
  }

  TEST_CASE("pairs that do not fit the shaft or its bearings are rejected with this reason") {
    auto in = hoist();
    in.place = gear::Place::a, in.l = 200.0 * mm, in.s = 10.0 * mm, in.d_sh = 60.0 * mm;
    const auto r = solve(in);
    REQUIRE(r.found > 0.0);
    CHECK(r.d_1 - 2.0 * (1.25 - r.x_1) * r.m_n >= in.d_sh);
    REQUIRE(!r.rejected.empty());
    CHECK(r.rejected[0].failure == PairSizing::Failure::fit);
    in.d_sh = 600.0 * mm;
    const auto none = solve(in);
    CHECK(none.found == 0.0);
    CHECK(!is_set(none.m_n));
    REQUIRE(!none.rejected.empty());
    for (const auto& c : none.rejected) CHECK(c.failure == PairSizing::Failure::fit);
  }

  TEST_CASE("of pairs of one centre distance the lighter ones rank first") {
    auto in = hoist();
    in.by = By::centre, in.betas = {{0.0}, {10.0 * deg.one}};
    for (const double kilowatts : {2.0, 8.0, 15.0, 35.0}) {
      in.P = kilowatts * 1e3 * W;
      const auto r = solve(in);
      for (std::size_t i = 1; i < r.candidates.size(); ++i) {
        const auto &one = r.candidates[i - 1], &next = r.candidates[i];
        if (std::abs((next.a_w - one.a_w) / mm) < 1e-6) CHECK(one.mass <= next.mass);
      }
    }
  }

  TEST_CASE("a helix angle that is given twice is tried once, and no gear has more than 2000 teeth") {
    auto in = hoist();
    const auto once = solve(in);
    in.betas = {{0.0}, {0.0}};
    const auto twice = solve(in);
    CHECK(twice.tried == once.tried);
    CHECK(twice.candidates[1].excess == once.candidates[1].excess);
    in.i_set = 20.0, in.z_min = 100, in.z_max = 101, in.m_min = 1.0 * mm, in.m_max = 1.0 * mm;
    CHECK(solve(in).tried == 1.0);  // 100/2000, but not 101/2020
  }

  TEST_CASE("the figure shows the best pair") {
    auto in = hoist();
    CHECK(PairSizing::figures(in, solve(in)).size() == 1);
    in.a_set = 2000.0 * mm;
    CHECK(PairSizing::figures(in, solve(in)).empty());
  }

  TEST_CASE("a centre distance that no pair of the range has gives no result, and does not pass") {
    auto in = hoist();
    in.a_set = 2000.0 * mm;
    const auto r = solve(in);
    CHECK(r.tried == 0.0);
    CHECK(!is_set(r.m_n));
    CHECK(mode_with("gear.sizing", "a_set = \"2 m\"", "pairs") == "fail");
  }

  TEST_CASE("gear.rating and gear.pair take the best pair") {
    const std::string text = std::string(PairSizing::example) +
                             "\n[rating]\ncalculator = \"gear.rating\"\nmesh = \"=pick.best\"\n"
                             "\n[stage]\ncalculator = \"gear.pair\"\npair = \"=pick.best\"\ncutting = \"ground\"\n";
    const project::Project project = test::solved_as_found(text);
    CHECK(project.value("rating.S_H1")->si[0] == project.value("pick.S_H1")->si[0]);
    CHECK(project.value("rating.S_F2")->si[0] == project.value("pick.S_F2")->si[0]);
    CHECK(project.value("stage.a_w")->si[0] == project.value("pick.a_w")->si[0]);
    CHECK(project.value("stage.F_t")->si[0] == doctest::Approx(project.value("pick.F_t")->si[0]));
  }

  TEST_CASE("inputs beyond what gear.rating takes without a reason need one here, too") {
    for (const std::string lines : {"f_ma = \"1 um\"",
                                    "sigma_Hlim_1 = \"1800 MPa\"\nsigma_Flim_1 = "
                                    "\"500 MPa\"",
                                    "pattern = \"favourable\""}) {
      CHECK_MESSAGE(mode_with("gear.sizing", lines, "pitting_1") == "not-judged", lines);
    }
  }

  TEST_CASE("contradictory inputs are refused with the remedy") {
    const auto fault = [](const std::string& lines) { return test::ExampleStep("gear.sizing", lines).fault(); };
    const auto says = [&](const std::string& lines, const std::string& part) {
      const std::string answer = fault(lines);
      CHECK_MESSAGE(answer.find(part) != std::string::npos, answer);
    };
    says("T_1 = \"100 N*m\"", "either as T_1 or as P");
    says("S_Hmin = ", "give S_Hmin and S_Fmin");
    says("z_min = 30\nz_max = 20", "number of teeth");
    says("m_min = \"8 mm\"", "minimum module");
    says("psi_min = 0.9\npsi_max = 0.5", "minimum face width");
    says("a_set = \"120 mm\"\nx_sum = 0.2", "omit x_sum");
    says("shift = \"none\"\nx_sum = 0.2", "shift = \"balanced\"");
    says("quality_1 = ", "quality_1");
    says("place = ", "position of the pinion");
  }
}
