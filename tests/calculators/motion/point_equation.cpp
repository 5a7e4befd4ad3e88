#include "calculators/motion/elimination/path_equation.hpp"
#include "tests/calculators/motion/solved.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>

using namespace loadpath::test;

namespace {

/// A law with T for the time in seconds.
std::string law_of(std::string text) {
  for (std::size_t at = text.find('T'); at != std::string::npos; at = text.find('T', at))
    text.replace(at, 1, "(t/(1 s))");
  return text;
}

SolvedStep path(const std::string& x, const std::string& y, const std::string& range, const std::string& z = "") {
  std::string lines = "x = \"" + law_of(x) + "\"\ny = \"" + law_of(y) + "\"\nt = \"0.5 s\"\n" + range;
  if (!z.empty()) lines += "z = \"" + law_of(z) + "\"\n";
  return {"motion.point", lines};
}

const std::string to_2_s = "t_1 = \"0 s\"\nt_2 = \"2 s\"\n";

struct PathRow {
  const char *x, *y;
  const char* equation;
  const char* form;
};

void check_paths(std::span<const PathRow> rows) {
  for (const PathRow& row : rows) {
    CAPTURE(row.x);
    CAPTURE(row.y);
    const auto p = path(row.x, row.y, to_2_s);
    CHECK(p.word("path") == row.equation);
    CHECK(p.word("form") == row.form);
    CHECK(p("e_path") < 1e-9);
  }
}

}  // namespace

TEST_SUITE("motion point equation") {
  TEST_CASE("equations of worked examples, their numbers in m") {
    const PathRow rows[] = {
        {"3 m*sin(pi*T)", "5 m*cos(pi*T)", "(x/3)^2 + (y/5)^2 = 1", "ellipse"},  // [B32] problem 1
        {"3 cm - 2 cm*T^2", "-5 cm*T", "x = -8*y^2 + 0.03", "parabola"},  // [Allrefs-K1], 25 x + 2 y^2 = 75 in cm
        {"1 m*T^2 - 1 m", "2 m*T", "x = 0.25*y^2 - 1", "parabola"},       // [AssignmentExpert-31600]
        {"2 m*sin(3*T)", "2 m*(1 - cos(3*T))", "x^2 + (y - 2)^2 = 4", "circle"}};  // [Byjus-path]
    check_paths(rows);
  }

  TEST_CASE("straight lines, also of laws that are not linear") {
    const PathRow rows[] = {{"2 m", "3 m*T^2", "x = 2", "line"},
                            {"3 m*sin(T)", "-1 m", "y = -1", "line"},
                            {"2 m*T", "4 m*T - 3 m", "y = 2*x - 3", "line"},
                            {"2 m - 3 m*T - 6 m*T^2", "3 m - 1.5 m*T - 3 m*T^2", "y = 0.5*x + 2", "line"},
                            {"4 m*cos(T)", "2 m*cos(T + 180 deg) + 1 m", "y = -0.5*x + 1", "line"},
                            {"8 m*cos(T)^2 + 2 m", "-8 m*sin(T)^2 - 7 m", "y = x - 17", "line"}};
    check_paths(rows);
  }

  TEST_CASE("conics: with one linear law, with two powers, with waves, with exponentials") {
    const PathRow rows[] = {
        {"2 m*T - 1 m", "4 m*T^2", "y = (x + 1)^2", "parabola"},
        {"2 m*T", "6 m*T - 5 m*T^2", "y = -1.25*x^2 + 3*x", "parabola"},
        // (x - y)^2 = (2 T)^2 = 4 T^2 = 2 (x + y)
        {"1 m*T^2 + 1 m*T", "1 m*T^2 - 1 m*T", "x^2 - 2*x*y + y^2 - 2*x - 2*y = 0", "parabola"},
        {"2 m*sqrt(T + 1)", "4 m*T", "y = x^2 - 4", "parabola"},
        {"1 m*sin(T)", "2 m*cos(2*T)", "y = -4*x^2 + 2", "parabola"},
        {"7 m*sin(pi*T^2/6) - 5 m", "-7 m*cos(pi*T^2/6)", "(x + 5)^2 + y^2 = 49", "circle"},
        // x = cos, y = cos + sin: x^2 + (y - x)^2 = 1
        {"1 m*cos(T)", "1 m*cos(T) + 1 m*sin(T)", "2*x^2 - 2*x*y + y^2 = 1", "ellipse"},
        {"4 m*T + 4 m", "-4 m/(T + 1)", "x*y = -16", "hyperbola"},
        {"2 m*exp(T)", "3 m*exp(-T) + 1 m", "x*(y - 1) = 6", "hyperbola"},
        {"2 m*exp(T) + 2 m*exp(-T)", "3 m*exp(T) - 3 m*exp(-T)", "(x/4)^2 - (y/6)^2 = 1", "hyperbola"}};
    check_paths(rows);
  }

  TEST_CASE("other curves: powers, multiple waves, and one law solved for the time") {
    const PathRow rows[] = {
        {"1 m*T^2", "1 m*T^3", "y^2 = x^3", "other_curve"},
        {"1 m*T^2", "2 m*T^3 + 2 m", "(y - 2)^2 = 4*x^3", "other_curve"},
        {"2 m*exp(2*T)", "3 m*exp(-3*T) + 1 m", "x^3*(y - 1)^2 = 72", "other_curve"},
        {"4 m*sin(T)", "6 m*sin(2*T)", "y^2 = (3*x)^2*(1 - (x/4)^2)", "other_curve"},  // 12 sin cos, squared
        {"2 m*T", "3 m*ln(T + 1)", "y = 3*ln(x/2 + 1)", "other_curve"},
        {"2 m*T", "3 m*exp(-3*T) + 1 m", "y = 3*exp(-1.5*x) + 1", "other_curve"},
        {"1 m*T - 1 m*sin(T)", "1 m - 1 m*cos(T)", "x = acos(1 - y) - sin(acos(1 - y))", "other_curve"}};
    check_paths(rows);
  }

  TEST_CASE("laws without a common function, and branches beyond an inverse, have no equation") {
    const auto lissajous = path("4 m*sin(3*T)", "6 m*cos(2*T)", "t_1 = \"0 s\"\nt_2 = \"7 s\"\n");
    CHECK(lissajous.word("form") == "no_equation");
    CHECK(lissajous.word("path").empty());
    CHECK(std::isnan(lissajous("e_path")));
    const auto arch = path("1 m*T - 1 m*sin(T)", "1 m - 1 m*cos(T)", "t_1 = \"0 s\"\nt_2 = \"6 s\"\n");
    CHECK(arch.word("form") == "no_equation");
    CHECK(near(arch("y_max"), 2.0));
    CHECK(path("3 m", "1 m", to_2_s).word("form") == "point");
    CHECK(path("1 m*T", "1 m*T", "").word("form") == "no_range");
  }

  TEST_CASE("the limits are those of the branch, with the points where a coordinate turns back") {
    const auto quarter = path("3 m*sin(pi*T)", "5 m*cos(pi*T)", "t_1 = \"0.25 s\"\nt_2 = \"0.8 s\"\n");
    CHECK(quarter.word("path") == "(x/3)^2 + (y/5)^2 = 1");
    CHECK(near(quarter("x_min"), 3.0 * std::sin(0.8 * std::numbers::pi)));
    CHECK(near(quarter("x_max"), 3.0));
    CHECK(near(quarter("y_min"), 5.0 * std::cos(0.8 * std::numbers::pi)));
    CHECK(near(quarter("y_max"), 5.0 * std::sqrt(0.5)));
    CHECK(std::isnan(quarter("z_max")));
  }

  TEST_CASE("a path in space has a second equation, of the other coordinate where x is constant") {
    const auto helix = path("2 m*cos(T)", "2 m*sin(T)", to_2_s, "0.5 m*T");
    CHECK(helix.word("path") == "x^2 + y^2 = 4");
    CHECK(helix.word("path_z") == "x = 2*cos(2*z)");
    CHECK(near(helix("z_max"), 1.0));
    const auto upright = path("1 m", "2 m*T", to_2_s, "4 m*T^2");
    CHECK(upright.word("path") == "x = 1");
    CHECK(upright.word("path_z") == "z = y^2");
  }

  TEST_CASE("a curve that misses the points is detected, by its distance from them") {
    loadpath::motion::PathCoordinate x{"x", "", {}}, y{"y", "", {}};
    for (int i = 0; i < 100; ++i) {
      x.values.push_back(3.0 * std::cos(0.1 * i));
      y.values.push_back(3.0 * std::sin(0.1 * i));
    }
    using loadpath::motion::deviation_of;
    CHECK(deviation_of("x^2 + y^2 = 9", x, y) < 1e-14);
    CHECK(near(deviation_of("x^2 + y^2 = 9.06", x, y), 0.01 / (6.0 * std::sqrt(2.0)), 0.02));  // a radius of 3.01
    CHECK(deviation_of("y = sqrt(9 - x^2)", x, y) > 0.1);
    CHECK(std::isnan(deviation_of("y = ln(x)", x, y)));
    CHECK(std::isnan(deviation_of("x^2 + y^2", x, y)));
    CHECK(std::isnan(deviation_of("x^2 + = 9", x, y)));
  }
}
