#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <string_view>

using namespace loadpath::formula;

TEST_SUITE("formula") {
  TEST_CASE("an angle is distinguished from a number by its formula") {
    struct Row {
      std::string_view formula;
      bool angle;
    };
    const Row rows[] = {{"asin(d / a)", true},
                        {"pi - 2.0 * gamma", true},
                        {"2.0 * pi - gamma / 2.0", true},
                        {"-gamma", true},
                        {"max(gamma, alpha)", true},
                        {"k > 1.0 ? gamma : alpha", true},
                        {"gamma", true},
                        {"tan(gamma) - gamma", false},  // an involute
                        {"mu * gamma", false},          // the exponent of Euler and Eytelwein
                        {"exp(mu * gamma)", false},
                        {"gamma * gamma", false},
                        {"sin(gamma)", false},
                        {"gamma / alpha", false},
                        {"2.0 * pi", false},
                        {"max(gamma, mu)", false},
                        {"k > 1.0 ? gamma : mu", false}};
    for (const Row& row : rows) {
      CAPTURE(row.formula);
      const auto tree = parse(row.formula);
      REQUIRE(tree);
      CHECK(is_angle(*tree, [](std::string_view name) { return name == "gamma" || name == "alpha"; }) == row.angle);
    }
  }
}
