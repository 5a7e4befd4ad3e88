#include "calculators/column/bending/classes.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::column;

const Plates ipe_300{SectionKind::rolled_I, Grade::to_S420, 300.0 * mm, 150.0 * mm, 10.7 * mm, 7.1 * mm, 15.0 * mm, {}};

/// IPE 300 of S355 under a compression in kN and a moment in kN*m.
SectionClass of(double N, double M) {
  const double A = 5381e-6, I = 8356e-8, c = 0.1243;
  return section_class(ipe_300, 355.0 * MPa,
                       {from_si<Force>(1e3 * N), from_si<Moment>(1e3 * M), from_si<Moment>(628.4e-6 * 355e6),
                        from_si<Stress>(1e3 * N / A), from_si<Stress>(1e3 * M * c / I)});
}

}  // namespace

TEST_SUITE("classes of sections") {
  TEST_CASE("the web of IPE 300 of S355 is of class 4 in compression and of class 1 in bending") {
    // c/t = 248.6/7.1 = 35.0; epsilon = 0.8136: 42 epsilon = 34.2, 72 epsilon = 58.6
    CHECK(of(100, 0).number == 4);
    CHECK(of(0, 100).number == 1);
    CHECK(of(100, 0).ratio > 1.0);
  }

  TEST_CASE("more compression next to the same moment never gives a better class") {
    int before = 1;
    for (const double N : {0.0, 50.0, 200.0, 400.0, 800.0, 1600.0, 1e5}) {
      const int number = of(N, 100).number;
      CHECK(number >= before);
      before = number;
    }
    CHECK(before == 4);
  }

  TEST_CASE("the class does not depend on the level of the load") {
    for (const double level : {0.01, 1.0, 100.0}) CHECK(of(300 * level, 100 * level).number == of(300, 100).number);
  }
}
