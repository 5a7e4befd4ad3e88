#include "calculators/fatigue/wohler.hpp"

#include "lib/numerics/quantile.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using W = fatigue::Wohler;
using test::rel;

constexpr auto fitted = test::evaluated<W>;

/// Plastic strain amplitudes and lives of the example of [E739], a strain of 1 entered as 1 MPa.
W::Input example_of_e739() {
  W::Input in;
  const double points[][2] = {{0.01636, 168},  {0.01609, 200},  {0.00675, 1000},  {0.00682, 1180}, {0.00179, 4730},
                              {0.00160, 8035}, {0.00165, 5254}, {0.00053, 28617}, {0.00054, 32650}};
  for (const auto& p : points) in.tests.push_back({p[0] * MPa, p[1], W::End::failure});
  return in;
}

/// Points on the line N = 1e6 (400/S)^5, and at times a step off it.
W::Input on_a_line(double factor) {
  W::Input in;
  for (const double S : {400.0, 450.0, 500.0, 600.0}) {
    for (const double off : {factor, 1 / factor}) in.tests.push_back({S * MPa, 1e6 * std::pow(400 / S, 5) * off});
  }
  return in;
}

bool says(const std::string& lines, const std::string& words) {
  return test::says("[c]\ncalculator = \"fatigue.wohler\"\n" + lines, words);
}

}  // namespace

TEST_SUITE("fatigue.wohler") {
  TEST_CASE("the example of ASTM E739: A = -0.24474, B = -1.45144, and its interval") {
    const auto r = fitted(example_of_e739());
    CHECK(std::abs(r.A + 0.24474) < 5e-6);
    CHECK(std::abs(r.B + 1.45144) < 5e-6);
    CHECK(std::abs(r.B_low + 1.6054) < 1e-4);
    CHECK(std::abs(r.B_high + 1.2974) < 1e-4);
    CHECK(r.n == 9);
  }

  TEST_CASE("points on a line give the line, without scatter") {
    const auto r = fitted(on_a_line(1.0));
    CHECK(rel(r.k, 5.0) < 1e-12);
    CHECK(r.s < 1e-12);
    CHECK(rel(r.T_N, 1.0) < 1e-9);
  }

  TEST_CASE("pairs off the line by one factor do not change the line, and their scatter is that factor") {
    const auto r = fitted(on_a_line(1.5));
    CHECK(rel(r.k, 5.0) < 1e-12);
    CHECK(rel(r.s, std::log10(1.5) * std::sqrt(8.0 / 6.0)) < 1e-12);
    CHECK(rel(r.T_N, std::pow(10.0, 2 * 1.2815515655446 * r.s)) < 1e-9);
    CHECK(rel(std::pow(r.T_S, 5.0), r.T_N) < 1e-12);
  }

  TEST_CASE("run-outs and failures at their level are left out of the line; the limit is half-way") {
    auto in = on_a_line(1.2);
    const auto without = fitted(in);
    in.tests.push_back({340.0 * MPa, 1e7, W::End::runout});
    in.tests.push_back({360.0 * MPa, 1e7, W::End::runout});
    in.tests.push_back({350.0 * MPa, 4e6, W::End::failure});
    const auto r = fitted(in);
    CHECK(r.B == without.B);
    CHECK(r.n == 8);
    CHECK(rel(in_si(r.S_D), 355e6) < 1e-12);
    CHECK(rel(r.N_D, 1e6 * std::pow(400.0 / 355, 5)) < 1e-9);
  }

  TEST_CASE("lives at a stress, and none at or below the fatigue limit") {
    auto in = on_a_line(1.2);
    in.S = 500.0 * MPa;
    in.P_s = 0.9;
    auto r = fitted(in);
    CHECK(rel(r.N_50, 1e6 * std::pow(0.8, 5)) < 1e-9);
    CHECK(rel(r.N_50 / r.N_P, std::sqrt(r.T_N)) < 1e-9);
    in.S_D = 500.0 * MPa;
    CHECK_FALSE(is_set(fitted(in).N_50));
  }

  TEST_CASE("nothing is extrapolated: stresses, lives and percentiles on both sides of their limits") {
    auto in = on_a_line(1.0);
    in.N_0 = 1e6;
    for (const auto& [S, inside] :
         {std::pair{400.0, true}, std::pair{399.0, false}, std::pair{600.0, true}, std::pair{601.0, false}}) {
      in.S = S * MPa;
      const double x = fitted(in).x_S;
      CHECK((x >= -1e-9 && x <= 1 + 1e-9) == inside);
    }
    CHECK(rel(fitted(in).x_N, 1.0) < 1e-9);
    CHECK(rel(in_si(fitted(in).S_0), 400e6) < 1e-9);
    in.P_s = 0.95;
    CHECK(fitted(in).P_f >= 0.05 - 1e-12);
    in.P_s = 0.96;
    CHECK(fitted(in).P_f < 0.05 - 1e-12);
  }

  TEST_CASE("a knee beyond the longest test is not covered, wherever its fatigue limit comes from") {
    const std::string few = "tests = [[\"400 MPa\", 1e5], [\"395 MPa\", 2e5], [\"380 MPa\", 1.5e5], [\"100 MPa\", ";
    CHECK(test::ExampleStep("fatigue.wohler", few + "1e6, \"runout\"]]\nS = \n").verdict("x_D") ==
          account::State::not_covered);
    CHECK(test::ExampleStep("fatigue.wohler", few + "1e7, \"runout\"]]\nS = \n").verdict("x_D") ==
          account::State::pass);
  }

  TEST_CASE("stresses in another unit do not change the slope and the scatter") {
    auto in = on_a_line(1.3);
    const auto r = fitted(in);
    for (auto& t : in.tests) t.S = 6.894757 * t.S;
    CHECK(rel(fitted(in).k, r.k) < 1e-12);
    CHECK(rel(fitted(in).s, r.s) < 1e-12);
  }

  TEST_CASE("wrong input is reported") {
    CHECK(says("tests = [[\"400 MPa\", 1e5], [\"300 MPa\", 1e6]]\n", "at least three failures"));
    CHECK(says("tests = [[\"400 MPa\", 1e5], [\"350 MPa\", 5e5], [\"300 MPa\", 1e6], [\"350 MPa\", 1e7, \"runout\"]]\n",
               "at least three failures"));
    CHECK(says("tests = [[\"400 MPa\", 1e5], [\"400 MPa\", 2e5], [\"400 MPa\", 1e6]]\n",
               "a line needs failures at two stress levels at least, with lives that decrease with stress"));
    CHECK(says("tests = [[\"400 MPa\", 0], [\"400 MPa\", 2e5], [\"300 MPa\", 1e6]]\n", "must be"));
    CHECK(says("tests = [[\"400 MPa\", 1e6], [\"350 MPa\", 2e5], [\"300 MPa\", 1e5]]\n",
               "a line needs failures at two stress levels at least, with lives that decrease with stress"));
    CHECK(says("S_D = \"350 MPa\"\ntests = [[\"400 MPa\", 1e5], [\"350 MPa\", 5e5], [\"300 MPa\", 1e6]]\n",
               "S_D exceeds the lowest stress of the line, where specimens failed; reduce S_D"));
  }

  TEST_CASE("quantiles of tables, and none outside of 0 to 1") {
    CHECK(std::abs(numerics::normal_quantile(0.9) - 1.2815515655446) < 1e-12);
    CHECK(std::abs(numerics::student_quantile(0.975, 7) - 2.3646) < 5e-5);
    CHECK(std::abs(numerics::student_quantile(0.975, 1) - 12.7062) < 5e-5);
    CHECK(std::isnan(numerics::normal_quantile(1.0)));
    CHECK(std::isnan(numerics::student_quantile(0.5, 0)));
  }
}
