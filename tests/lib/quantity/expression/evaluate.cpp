#include "tests/lib/quantity/expression/world.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace loadpath;
using namespace loadpath::expression_test;

namespace {

struct Row {
  std::string_view text;
  double expected;
};

double number(std::string_view text) {
  const Value value = value_of(text);
  REQUIRE(value.si.size() == 1);
  return value.si.front();
}

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("constant expressions have known values") {
    const Row rows[] = {
        {"2 * pi", 2.0 * std::numbers::pi},
        {"sqrt(16 mm^2)", 0.004},
        {"cbrt(-27)", -3.0},
        {"abs(-3 N)", 3.0},
        {"exp(-1)", 1.0 / std::numbers::e},
        {"exp(0.3*(180 deg))", 2.5663323952081495},  // 0.3 pi as an exponent of Euler and Eytelwein
        {"ln(10)", std::numbers::ln10},
        {"sin(30 deg)", 0.5},
        {"cos(60 deg)", 0.5},
        {"tan(45 deg)", 1.0},
        {"asin(1)", 0.5 * std::numbers::pi},
        {"acos(0.5)", std::numbers::pi / 3.0},
        {"atan(1)", 0.25 * std::numbers::pi},
        {"atan2(-1 m, -1 m)", -0.75 * std::numbers::pi},
        {"hypot(3 N, -4 N)", 5.0},
        {"hypot(2 mm, 3 mm, 6 mm)", 0.007},
        {"max(3 mm, 1 cm, 2 mm)", 0.01},
        {"min(3 mm, 1 cm, 2 mm)", 0.002},
        {"16*120.52 N*m/(pi*(30 MPa))", 16.0 * 120.52 / (std::numbers::pi * 30e6)},
    };
    for (const auto& row : rows) {
      CAPTURE(row.text);
      CHECK(number(row.text) == doctest::Approx(row.expected).epsilon(1e-14));
    }
  }

  TEST_CASE("the design moment gives the diameter by strength") {
    // T = 1.4 * 86.085 N*m and 30 MPa: d = 27.35 mm by the formula of a solid circle, worked by hand
    CHECK(number("(16 * 1.4 * 86.085 N*m / (pi * 1 * 30 MPa))^(1/3)") == doctest::Approx(0.02735).epsilon(0.0002));
  }

  TEST_CASE("reductions of a series are those between its positions") {
    const Row rows[] = {
        {"max(lever.drive.M)", 80.0},
        {"min(lever.drive.M)", -40.0},
        {"peak(lever.drive.M)", 80.0},
        {"peak(-lever.drive.M)", 80.0},
        {"midrange(lever.drive.M)", 20.0},
        {"range(lever.drive.M)", 120.0},
        {"amplitude(lever.drive.M)", 60.0},
        {"mean(lever.drive.M)", 20.0},
        {"rms(lever.drive.M)", std::sqrt(20.0 * 20.0 + 0.5 * 60.0 * 60.0)},
        {"peak(column.N)", 125.0},
        {"max(column.N)", -100.0},
        {"at(column.N, 2.5 m)", -106.25},
        {"peak(lever.drive.M * 2 - 40 N*m)", 120.0},
    };
    for (const auto& row : rows) {
      CAPTURE(row.text);
      CHECK(number(row.text) == doctest::Approx(row.expected).epsilon(1e-11));
    }
    CHECK(number("at(lever.drive.M, 60.5 deg)") ==
          doctest::Approx(20.0 + 60.0 * std::cos(60.5 * std::numbers::pi / 180.0 - 0.3)).epsilon(1e-8));
    CHECK(number("at(lever.drive.M, 420 deg)") == doctest::Approx(number("at(lever.drive.M, 60 deg)")).epsilon(1e-12));
  }

  TEST_CASE("a series is calculated position by position") {
    const Value power = value_of("lever.drive.M * lever.omega");
    REQUIRE(power.si.size() == 360);
    CHECK(power.signature.axis == &crank());
    const auto& M = known("lever.drive.M").si;
    for (std::size_t i = 0; i < 360; ++i) CHECK(power.si[i] == M[i] * 45.0);

    const Value positive = value_of("max(0 N*m, lever.drive.M)");
    for (std::size_t i = 0; i < 360; ++i) CHECK(positive.si[i] == std::max(0.0, M[i]));
    const Value both = value_of("5 N*m - lever.drive.M / 2");
    for (std::size_t i = 0; i < 360; ++i) CHECK(both.si[i] == 5.0 - M[i] / 2.0);
  }

  TEST_CASE("two series of one cycle stay simultaneous") {
    const Value sum = value_of("lever.drive.M / (1 m) + lever.joints.A.F");
    const auto& M = known("lever.drive.M").si;
    const auto& F = known("lever.joints.A.F").si;
    for (std::size_t i = 0; i < 360; ++i) CHECK(sum.si[i] == M[i] + F[i]);
  }

  TEST_CASE("an undefined value is NaN, never an infinity") {
    for (const std::string_view text :
         {"1/0", "-1/0", "0/0", "sqrt(-1)", "asin(2)", "(-8)^(1/3)", "0^-1", "1e300*1e300", "atan(1/0)", "1/(1/0)",
          "max(1, 1/0)", "max(1/0, 1)", "min(1, 0/0)", "min(0/0, 1)", "shaft.missing/shaft.d", "10^400",
          "at(column.N, 6 m)", "at(column.N, -0.5 m)", "peak(lever.drive.M/0)"}) {
      CAPTURE(text);
      CHECK(std::isnan(number(text)));
    }
  }

  TEST_CASE("a position without a value does not affect the others") {
    const Value value = value_of("1 N / (lever.joints.A.F)");
    CHECK(std::isnan(value.si[0]));
    CHECK(value.si[90] == doctest::Approx(1.0 / 500.0));
  }

  TEST_CASE("a result that a step does not give is not available") {
    const auto parsed = Expression::parse("2 * s.a");
    REQUIRE(parsed);
    Value given{{Dimension::of(1, 0, 0), &crank()}, {}};
    const auto none = parsed->evaluate([&](const std::string&) -> const Value& { return given; });
    REQUIRE(none.si.size() == 360);
    CHECK(std::isnan(none.si.front()));
    given = {{}, {std::numeric_limits<double>::infinity()}};
    CHECK(std::isnan(parsed->evaluate([&](const std::string&) -> const Value& { return given; }).si.front()));
  }

  TEST_CASE("values that break the dimensions have no value") {
    const auto parsed = Expression::parse("s.a + 1 N");
    REQUIRE(parsed);
    const Value length{{Dimension::of(1, 0, 0), nullptr}, {1.0}};
    const auto value = parsed->evaluate([&](const std::string&) -> const Value& { return length; });
    REQUIRE(value.si.size() == 1);
    CHECK(std::isnan(value.si.front()));
  }
}
