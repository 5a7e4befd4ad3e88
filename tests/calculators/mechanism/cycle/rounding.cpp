#include "calculators/mechanism/cycle/rounding.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/quantity/units.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::planar;

namespace {

/// A link that rests, and one position of it.
struct Resting {
  mechanism::Model model;
  Cycle cycle;

  Resting() : model() {
    model.links.emplace_back();
    model.links[0].inertia = 0.033;
    cycle.positions = {mechanism::blank_position(model)};
    cycle.closed = {true};
  }
};

}  // namespace

TEST_SUITE("mechanism rounding") {
  TEST_CASE("a value far below those of the links is zero, also of a moment of inertia") {
    const Resting resting;
    Value inertia{{kg_m2.dimension(), nullptr}, {7.4e-69, 0.033, 1e-9}};
    ResultRounding(resting.model, magnitudes_of(resting.model, resting.cycle)).clear(inertia, false);
    CHECK(inertia.si == std::vector<double>{0.0, 0.033, 1e-9});
    CHECK(inertia.rounding > 0.0);
  }

  TEST_CASE("a direction along the axis is 0 or half a turn, whatever the sign of its rounding error") {
    for (const double off : {-1e-16, -0.0, 0.0, 1e-16}) {
      CHECK(direction_of({2.0, off}) == 0.0);
      CHECK(direction_of({-2.0, off}) == pi);
    }
    CHECK(direction_of({0.0, -1.0}) == -0.5 * pi);
    CHECK(direction_of({-1.0, -1.0}) == std::atan2(-1.0, -1.0));
  }

  TEST_CASE("the angle of a link at half a turn is positive, unless it is reached from below") {
    const Resting resting;
    const ResultRounding rounding(resting.model, magnitudes_of(resting.model, resting.cycle));
    Value phi{{deg.dimension(), nullptr}, {-pi, pi, -3.0, -pi + 1e-16}}, plain = phi;
    rounding.clear(phi, true);
    rounding.clear(plain, false);
    for (const std::size_t k : {0U, 1U}) CHECK(std::abs(phi.si[k] - pi) <= phi.rounding);
    CHECK(phi.si[2] == -3.0);
    CHECK(std::abs(phi.si[3] + pi) <= phi.rounding);  // a crank that turns clockwise does not leap
    CHECK(plain.si[0] < 0.0);
  }

  TEST_CASE("the symbol of the axis is that of its variable: time t, stroke s, crank angle phi") {
    const auto symbol = [](const char* quantity) {
      Axis axis;
      axis.quantity = quantity;
      return axis_symbol(axis);
    };
    CHECK(symbol("time") == "t");
    CHECK(symbol("stroke") == "s");
    CHECK(symbol("crank angle") == "phi");
  }
}
