// Functions of several variables: values by hand, and the messages about texts that are none.
#include "lib/quantity/expression/relation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

using namespace loadpath;

namespace {

const Dimension force = Dimension::of(1, 1, -2);
const std::array variables{Law::Variable{"x", Dimension::of(1, 0, 0)}, Law::Variable{"v_x", Dimension::of(1, 0, -1)},
                           Law::Variable{"t", Dimension::of(0, 0, 1)}};

double value(const std::string& text, double x, double v, double t) {
  CAPTURE(text);
  const auto relation = Relation::parse(text, variables, force);
  REQUIRE(relation);
  return relation->at(std::array{x, v, t});
}

std::string said(const std::string& text) {
  const auto relation = Relation::parse(text, variables, force);
  REQUIRE_FALSE(relation);
  return relation.fault().message.text() + "; " + relation.fault().hint.text();
}

}  // namespace

TEST_SUITE("relation") {
  TEST_CASE("values, with kinks") {
    CHECK(value("-2 N/m*x", 3.0, 0.0, 0.0) == -6.0);
    CHECK(value("-2 N/mm*x - 3 N*s^2/m^2*v_x*abs(v_x)", 0.5, -2.0, 0.0) == -1000.0 + 12.0);
    CHECK(value("max(1 N*t/(1 s), 5 N, 2 N*(v_x/(1 m/s))^2)", 0.0, 2.0, 9.0) == 9.0);
    CHECK(value("min(1 N*t/(1 s), 5 N)", 0.0, 2.0, 9.0) == 5.0);
    CHECK(value("3 N*sin(pi*t/(2 s))", 0.0, 0.0, 1.0) == 3.0);
    CHECK(value("g*1 kg", 0.0, 0.0, 0.0) == doctest::Approx(9.80665));
    CHECK(std::isnan(value("1 N*sqrt(x/(1 m))", -1.0, 0.0, 0.0)));
    CHECK(std::isnan(value("1 N*m/x", 0.0, 0.0, 0.0)));
  }

  TEST_CASE("any quantity, where none is required") {
    const auto relation = Relation::parse("x - 2 m", variables, std::nullopt);
    REQUIRE(relation);
    CHECK(relation->at(std::array{5.0, 0.0, 0.0}) == 3.0);
  }

  TEST_CASE("a relation that is not a function of the variables is reported with them") {
    CHECK(said("w + 2 N").find("the variables are x, v_x, t") != std::string::npos);
    CHECK(said("2 N/m*step.x").find("variables x, v_x, t") != std::string::npos);
    CHECK(said("3 m").find("length") != std::string::npos);
    CHECK(said("5 N*s/m*vx") ==
          "'vx' is neither a unit nor a variable; did you mean 'v_x'? the variables are x, v_x, "
          "t; write other values as numbers with units");
    CHECK(said("5 N*zorkmid") ==
          "'zorkmid' is neither a unit nor a variable; the variables are x, v_x, t; write other values as numbers with "
          "units");
    CHECK(said("5 mpa*x").find("; did you mean 'MPa'? the variables are x") != std::string::npos);
    CHECK(said("3 N + vx").starts_with("'vx' is not a variable; did you mean 'v_x'?"));
    CHECK(said("1 N + x").find("cannot be") != std::string::npos);
  }
}
