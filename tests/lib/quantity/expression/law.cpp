// Laws of motion as formulas: values and exact derivatives by hand, and what is said of those that are none.
#include "lib/quantity/expression/law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace loadpath;

namespace {

constexpr double pi = std::numbers::pi;
const Dimension angle = Dimension::of(0, 0, 0, 0, 1), length = Dimension::of(1, 0, 0);

Outcome<Law> parsed(const std::string& text, const Dimension& result) {
  return Law::parse(text, {"t", Dimension::of(0, 0, 1)}, result);
}

void check(const std::string& text, const Dimension& result, double t, numerics::Jet expected) {
  CAPTURE(text);
  const auto law = parsed(text, result);
  REQUIRE(law);
  const numerics::Jet at = law->at(t);
  CHECK(at.value == doctest::Approx(expected.value).epsilon(1e-13));
  CHECK(at.first == doctest::Approx(expected.first).epsilon(1e-13));
  CHECK(at.second == doctest::Approx(expected.second).epsilon(1e-13));
}

std::string said(const std::string& text, const Dimension& result) {
  const auto law = parsed(text, result);
  REQUIRE_FALSE(law);
  return law.fault().message.text();
}

}  // namespace

TEST_SUITE("law") {
  TEST_CASE("a swinging crank, a rising cam, a braking cylinder") {
    const double a = pi / 2.0;
    check("30 deg + 90 deg*sin(2*pi*t/(2 s))", angle, 0.3,
          {pi / 6.0 + a * std::sin(0.3 * pi), a * pi * std::cos(0.3 * pi), -a * pi * pi * std::sin(0.3 * pi)});
    check("20 mm*(10*(t/(2 s))^3 - 15*(t/(2 s))^4 + 6*(t/(2 s))^5)", length, 1.0,
          {0.01, 0.02 * 30.0 / 16.0 / 2.0, 0.0});
    check("40 mm + 3 mm/s*t - 0.5*(2 mm/s^2)*t^2", length, 1.5, {0.04225, 0.0, -0.002});
    check("5 rad/s*t", angle, 2.0, {10.0, 5.0, 0.0});
  }

  TEST_CASE("every smooth function, by the derivatives of tables") {
    const double t = 0.4;
    check("1 mm*tan(t/(1 s))", length, t,
          {1e-3 * std::tan(t), 1e-3 / std::pow(std::cos(t), 2), 2e-3 * std::tan(t) / std::pow(std::cos(t), 2)});
    check("1 mm*sqrt(t/(1 s))", length, t, {1e-3 * std::sqrt(t), 0.5e-3 / std::sqrt(t), -0.25e-3 / (t * std::sqrt(t))});
    check("1 mm*cbrt(t/(1 s))", length, t,
          {1e-3 * std::cbrt(t), 1e-3 / 3.0 * std::pow(t, -2.0 / 3.0), -2e-3 / 9.0 * std::pow(t, -5.0 / 3.0)});
    check("1 mm*exp(-t/(2 s))", length, t, {1e-3 * std::exp(-0.2), -0.5e-3 * std::exp(-0.2), 0.25e-3 * std::exp(-0.2)});
    check("1 mm*ln(1 + t/(1 s))", length, t, {1e-3 * std::log(1.4), 1e-3 / 1.4, -1e-3 / 1.96});
    check("asin(t/(1 s))", angle, t, {std::asin(t), 1.0 / std::sqrt(1.0 - t * t), t / std::pow(1.0 - t * t, 1.5)});
    check("acos(t/(1 s))", angle, t, {std::acos(t), -1.0 / std::sqrt(1.0 - t * t), -t / std::pow(1.0 - t * t, 1.5)});
    check("atan(t/(1 s))", angle, t, {std::atan(t), 1.0 / (1.0 + t * t), -2.0 * t / std::pow(1.0 + t * t, 2)});
    check("atan2(t, 1 s)", angle, t, {std::atan(t), 1.0 / (1.0 + t * t), -2.0 * t / std::pow(1.0 + t * t, 2)});
    check("1 mm*cos(t/(1 s))/(1 + t/(1 s))", length, 0.0, {1e-3, -1e-3, 1e-3});
  }

  TEST_CASE("the variable is not a unit, and t alone is the time") {
    check("3 mm*t/(1 s)", length, 2.0, {0.006, 0.003, 0.0});
    CHECK(said("2 t*(1 mm/s)", length).find("'t'") != std::string::npos);
    CHECK(said("3 mm + x", length) == "'x' is not a variable");
    CHECK(said("3 mm*lever.drive.M", length) == "'lever.drive.M' is not known here");
  }

  TEST_CASE("t is the tonne where the time is not a variable, and the remedy states so") {
    for (const std::string text : {"0.5 + 0.1 1/s*t", "0.5 + 2 t", "2 t"}) {
      const auto law = Law::parse(text, {"phi", angle}, {});
      REQUIRE_FALSE(law);
      CHECK(law.fault().hint.text() ==
            "'t' is read as the unit tonne; the variable is phi; write other values as numbers with units");
    }
  }

  TEST_CASE("a law has the dimension of its drive, and no kinks") {
    CHECK(said("30 deg*t", angle) == "the law gives the kind 'quantity in s*rad', and 'angle' is expected");
    CHECK(said("30 deg + 5 mm", angle) == "angle and length cannot be added");
    CHECK(said("30 deg*abs(t/(1 s))", angle) == "'abs' has kinks, or uses a series");
    CHECK(said("1 deg*max(t/(1 s), 2)", angle) == "'max' has kinks, or uses a series");
    CHECK(said("30 deg*(t", angle) == "'(' is not closed");
  }

  TEST_CASE("where a law is not smooth its derivatives are not finite") {
    const auto law = parsed("1 mm*sqrt(t/(1 s))", length);
    REQUIRE(law);
    CHECK_FALSE(std::isfinite(law->at(0.0).first));
  }
}
