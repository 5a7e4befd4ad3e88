#include "lib/quantity/format.hpp"

#include "lib/quantity/literal.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace loadpath;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Dimension of(std::string_view unit) { return parse_unit(unit)->dimension; }

/// Numbers of all magnitudes and both signs.
std::vector<double> numbers(std::size_t count, double decades) {
  std::mt19937_64 random(20240229);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0), ten(-decades, decades);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(mantissa(random) * std::pow(10.0, std::floor(ten(random))));
  return values;
}

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("a number has its significant digits and no more") {
    struct Row {
      double value;
      int digits;
      std::string_view text;
    };
    const Row rows[] = {{27.35, 6, "27.35"},
                        {-27.35, 6, "-27.35"},
                        {30.0, 6, "30"},
                        {1.0 / 3.0, 6, "0.333333"},
                        {0.0, 6, "0"},
                        {-0.0, 6, "0"},
                        {1e-4, 6, "0.0001"},
                        {9.99e-5, 6, "9.99e-5"},
                        {1234567.0, 6, "1234570"},
                        {9999999.0, 6, "1e7"},
                        {1e7, 6, "1e7"},
                        {2.1e11, 6, "2.1e11"},
                        {1234.5, 2, "1200"},
                        {999.96, 4, "1000"},
                        {0.00123456, 3, "0.00123"},
                        {123456.5, 17, "123456.5"},
                        {not_a_number, 6, "not available"},
                        {std::numeric_limits<double>::infinity(), 6, "infinite"}};
    for (const Row& row : rows) CHECK(format_number(row.value, row.digits) == row.text);
  }

  TEST_CASE("a quantity is written in its unit, with points and superscripts") {
    CHECK(format_quantity(0.0125, "mm") == "12.5 mm");
    CHECK(format_quantity(900.0, "N*m") == "900 N·m");
    CHECK(format_quantity(1e-6, "mm^2") == "1 mm²");
    CHECK(format_quantity(5.0, "m^-1") == "5 m⁻¹");
    CHECK(format_quantity(5.0, "1/s") == "5 1/s");
    CHECK(format_quantity(293.15, "°C") == "20 °C");
    CHECK(format_quantity(1.5, "-") == "1.5");
    CHECK(format_quantity(not_a_number, "mm") == "not available");
    CHECK(pretty_unit("kg*m^2/(s^3*K)") == "kg·m²/(s³·K)");
    CHECK(pretty_unit("MPa*m^(1/2)") == "MPa·m^(1/2)");
    CHECK(pretty_unit("um") == "µm");
    CHECK(pretty_unit("N/(mm*um)") == "N/(mm·µm)");
    CHECK(pretty_unit("lumen") == "lumen");
    CHECK(format_quantity(std::numbers::pi, "deg") == "180°");
    CHECK(format_quantity(std::numbers::pi, "deg/m") == "180°/m");
    CHECK(pretty_unit("N*m/deg") == "N·m/°");
    CHECK(pretty_unit("degree") == "degree");
    CHECK(!takes_space("°"));
    CHECK(takes_space("°C"));
    CHECK(with_unit("5", "") == "5");
  }

  TEST_CASE("the exact text of a number reads back to the same number") {
    for (const double value : numbers(20000, 290)) {
      const std::string text = format_exact(value);
      CAPTURE(text);
      REQUIRE(parse_literal(text, Expected{}));
      CHECK(parse_literal(text, Expected{})->si == value);
    }
  }

  TEST_CASE("a quantity in its readable unit reads back within its digits") {
    const std::pair<std::string_view, Kind> units[] = {
        {"MPa", Kind::plain},       {"N", Kind::plain},        {"mm", Kind::plain},      {"N*m", Kind::moment},
        {"J", Kind::energy},        {"kg", Kind::plain},       {"kg*m^2", Kind::plain},  {"deg", Kind::plain},
        {"rad/s", Kind::plain},     {"kW", Kind::plain},       {"mm^4", Kind::plain},    {"mm^3", Kind::plain},
        {"mm^2", Kind::plain},      {"s", Kind::plain},        {"m/s", Kind::plain},     {"m/s^2", Kind::plain},
        {"rad/s^2", Kind::plain},   {"deg/m", Kind::plain},    {"K", Kind::temperature}, {"K", Kind::difference},
        {"-", Kind::plain},         {"Hz", Kind::plain},       {"1/K", Kind::plain},     {"W/(m*K)", Kind::plain},
        {"MPa*m^0.5", Kind::plain}, {"N*m/rad", Kind::plain},  {"N/mm", Kind::plain},    {"kg/m^3", Kind::plain},
        {"Pa*s", Kind::plain},      {"N*s^2/m^3", Kind::plain}};
    for (const auto& [unit, kind] : units) {
      const Expected expected{of(unit), kind, unit};
      for (const double si : numbers(300, 12)) {
        const std::string text = format_quantity(si, readable_unit(si, expected.dimension, kind));
        CAPTURE(text);
        const Outcome<Literal> read = parse_literal(text, expected);
        REQUIRE(read);
        CHECK(std::fabs(read->si - si) <= 0.5000001e-5 * std::fabs(si));
      }
    }
  }

  TEST_CASE("readable units are those of textbooks") {
    struct Row {
      double si;
      std::string_view of, unit;
    };
    const Row rows[] = {{2.1e11, "Pa", "GPa"},
                        {3e7, "Pa", "MPa"},
                        {2e9, "Pa", "MPa"},
                        {5e4, "Pa", "kPa"},
                        {50, "Pa", "Pa"},
                        {0, "Pa", "MPa"},
                        {not_a_number, "Pa", "MPa"},
                        {500, "N", "N"},
                        {5e4, "N", "kN"},
                        {0.05, "m", "mm"},
                        {-12, "m", "m"},
                        {5e5, "N*m", "N*m"},
                        {500, "W", "W"},
                        {-5e3, "W", "kW"},
                        {0.1, "kg*m^2", "kg*m^2"},
                        {0.1, "rad", "deg"},
                        {10, "rad/s", "rad/s"},
                        {10, "1/s", "1/s"},
                        {0.01, "rad/m", "deg/m"},
                        {300, "K", "K"},
                        {9.81, "m/s^2", "m/s^2"},
                        {1, "kg/m^3", "kg/m^3"},
                        {1, "-", ""},
                        {1, "W/(m*K)", "kg*m/(s^3*K)"}};
    for (const Row& row : rows) {
      CAPTURE(row.of);
      CAPTURE(row.si);
      CHECK(readable_unit(row.si, of(row.of)) == row.unit);
    }
    CHECK(readable_unit(5.0, of("J"), Kind::energy) == "J");
  }
}
