#include "lib/quantity/dimension.hpp"

#include "lib/quantity/literal.hpp"

#include <doctest/doctest.h>

using namespace loadpath;

TEST_SUITE("quantity") {
  TEST_CASE("a dimension is named in the words of a designer") {
    const std::pair<std::string_view, std::string_view> rows[] = {{"N*m", "moment"},
                                                                  {"MPa", "stress"},
                                                                  {"rad/s", "angular velocity"},
                                                                  {"deg/m", "angle per length"},
                                                                  {"-", "plain number"},
                                                                  {"mm^4", "second moment of area"},
                                                                  {"N*m/rad", "torsional stiffness"},
                                                                  {"W", "power"},
                                                                  {"kg*m^2", "moment of inertia"},
                                                                  {"MPa*m^0.5", "fracture toughness"},
                                                                  {"kg*m", "quantity in kg*m"}};
    for (const auto& [unit, name] : rows) CHECK(name_of(parse_unit(unit)->dimension) == name);
  }

  TEST_CASE("the SI unit of any dimension is a text that reads back") {
    for (int l = -4; l <= 4; ++l)
      for (int t = -3; t <= 3; ++t)
        for (int a = -1; a <= 1; ++a) {
          const Dimension dimension = Dimension::of(l, a, t, -a, a).power(1, 2);
          const std::string unit = si_unit(dimension);
          CAPTURE(unit);
          if (unit.empty()) continue;
          const Outcome<UnitValue> read = parse_unit(unit);
          REQUIRE(read);
          CHECK(read->dimension == dimension);
          CHECK(read->factor == 1.0);
        }
  }
}
