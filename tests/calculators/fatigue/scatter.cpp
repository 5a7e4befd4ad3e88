#include "calculators/fatigue/scatter/staircase.hpp"
#include "calculators/fatigue/scatter/survival.hpp"
#include "tests/found/modes.hpp"

#include <cmath>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::fatigue;
using namespace loadpath::test;
using End = Staircase::End;

double rel(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }

/// Bars that fail are marked by a minus.
Staircase::Input tested(const std::vector<double>& in_MPa) {
  Staircase::Input in;
  for (const double S : in_MPa) in.tests.push_back({std::abs(S) * MPa, S < 0.0 ? End::failure : End::runout});
  return in;
}

Staircase::Result solved(const Staircase::Input& in) {
  for (const auto& rule : Staircase::rules) CHECK_MESSAGE(rule.holds(in), rule.text);
  NoTrace trace;
  return Staircase::evaluate(in, trace);
}

}  // namespace

TEST_SUITE("fatigue.scatter") {
  TEST_CASE("failures are the rarer outcome, and too close together for a scatter: [Ekaputra]") {
    const auto r = solved(tested({260, 280, -300, 280, -300, 280, -300, -280, 260, -280, 260, 280}));
    CHECK(r.N == 5.0);
    CHECK(r.A == 3.0);  // from 280 MPa on; the print counts from 260 MPa, 8 and 14
    CHECK(r.B == 3.0);
    CHECK(rel(in_si(r.S_50), 282e6) < 1e-12);
    CHECK(rel(r.D, 0.24) < 1e-12);
    CHECK(!is_set(r.s));
    CHECK(!is_set(r.S_P));
  }

  TEST_CASE("run-outs are the rarer outcome, and failures in an open program's check by hand") {
    const auto few = solved(tested({-280, -260, 240, 260, -280, -260, 240}));
    CHECK(rel(in_si(few.S_50), 240e6 + 20e6 * (1.0 / 3.0 + 0.5)) < 1e-12);
    const auto r = solved(tested({-260, -240, 220, 240, 260, -280, -260, 240, 260}));
    CHECK(rel(in_si(r.S_50), 250e6) < 1e-12);
    CHECK(rel(r.D, 0.5) < 1e-12);
    CHECK(rel(in_si(r.s), 1.62 * 20e6 * 0.529) < 1e-12);
    CHECK(rel(in_si(r.S_P), 250e6 - 1.2815515655446004 * 1.62 * 20e6 * 0.529) < 1e-12);
  }

  TEST_CASE("steps equal in ratio: the same in logarithms") {
    const std::vector<double> linear{-260, -240, 220, 240, 260, -280, -260, 240, 260};
    const auto plain = solved(tested(linear));
    std::vector<double> in_ratio;
    for (const double S : linear) in_ratio.push_back(std::copysign(std::pow(10.0, std::abs(S) / 1000.0), S));
    Staircase::Input in = tested(in_ratio);
    CHECK(!Staircase::goes_up_and_down(in));
    in.steps = Staircase::Steps::logarithmic;
    const auto r = solved(in);
    CHECK(rel(in_si(r.S_50), 1e6 * std::pow(10.0, in_si(plain.S_50) / 1e9)) < 1e-12);
    CHECK(rel(r.s_lg, in_si(plain.s) / 1e9) < 1e-9);
    CHECK(rel(r.T_S, std::pow(10.0, 2.0 * 1.2815515655446004 * r.s_lg)) < 1e-12);
    const double z_P = 1.2815515655446004;  // quantile of P_s = 0.9
    CHECK(rel(in_si(r.S_P), in_si(r.S_50) * std::pow(10.0, -z_P * r.s_lg)) < 1e-12);
    const double S_50 = in_si(plain.S_50), wide = z_P * in_si(plain.s);
    CHECK(rel(plain.T_S, (S_50 + wide) / (S_50 - wide)) < 1e-12);
  }

  TEST_CASE("data that are not a staircase are refused") {
    CHECK(!Staircase::goes_up_and_down(tested({260, 240, -260, 280})));  // a run-out, and lower
    CHECK(!Staircase::goes_up_and_down(tested({260, 280, -290, 270})));
    CHECK(!Staircase::goes_up_and_down(tested({260})));
    CHECK(!Staircase::goes_up_and_down(tested({260, 260})));
    CHECK(!Staircase::has_both(tested({260, 280, 300})));
  }

  TEST_CASE("a wide scatter gives no strength below zero") {
    const auto r = solved(tested({10, 40, -70, -40, 10, 40, 70, -100, 70, -100, -70, -40, 10, 40, -70}));
    CHECK(in_si(r.s) > 0.0);
    CHECK((!is_set(r.S_P) || in_si(r.S_P) > 0.0));
  }

  TEST_CASE("strength, life and knee at 10 and 90 % agree with the tests of pylife") {
    Survival::Input in;
    in.sigma_0 = 300.0 * std::sqrt(2.0) * MPa, in.N_0 = 3e6, in.T_S = 2.0, in.T_N = 9.0, in.k = 2.0;
    NoTrace trace;
    in.P = 0.9;
    auto r = Survival::evaluate(in, trace);
    CHECK(rel(in_si(r.sigma_P), 300e6) < 1e-12);
    CHECK(rel(r.N_P, 1e6) < 1e-12);
    CHECK(rel(r.N_D, 2e6) < 1e-12);
    in.P = 0.1;
    r = Survival::evaluate(in, trace);
    CHECK(rel(in_si(r.sigma_P), 600e6) < 1e-12);
    CHECK(rel(r.N_D, 4.5e6) < 1e-12);
    in.P_0 = 0.1;
    CHECK(rel(in_si(Survival::evaluate(in, trace).sigma_P), in_si(in.sigma_0)) < 1e-15);
  }

  TEST_CASE("one scatter gives the other along the line") {
    Survival::Input in;
    in.sigma_0 = 300.0 * MPa, in.T_N = 1.75, in.k = 7.0, in.P = 0.9;
    CHECK(Survival::has_scatter(in));
    NoTrace trace;
    CHECK(rel(Survival::evaluate(in, trace).T_S, std::pow(1.75, 1.0 / 7.0)) < 1e-14);
    in.k = unset<double>;
    CHECK(!Survival::has_scatter(in));
  }
}
