#include "calculators/belt/flat.hpp"
#include "calculators/belt/quarter_turn.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using belt::Arrangement;
using belt::Pulleys;

belt::Flat::Result course(double d_1, double d_2, double a, Arrangement arrangement = Arrangement::open) {
  belt::Flat::Result r;
  NoTrace trace;
  belt::lay(Pulleys{d_1 * mm, d_2 * mm, a * mm, unset<Length>, arrangement}, r, trace);
  return r;
}

using test::rel;

}  // namespace

TEST_SUITE("belt geometry") {
  TEST_CASE("equal pulleys have half a turn of wrap and a belt of two centre distances and one circumference") {
    const auto c = course(200, 200, 500);
    CHECK(c.alpha_1 == pi);
    CHECK(c.alpha_2 == pi);
    CHECK(rel(in_si(c.L), 2 * 0.5 + pi * 0.2) < 1e-14);
  }

  TEST_CASE("the wraps of an open belt make a full turn, those of a crossed belt are equal") {
    const auto open = course(120, 430, 700), crossed = course(120, 430, 700, Arrangement::crossed);
    CHECK(rel(open.alpha_1 + open.alpha_2, 2 * pi) < 1e-14);
    CHECK(crossed.alpha_1 == crossed.alpha_2);
    CHECK(crossed.alpha_1 > pi);
    CHECK(crossed.L > open.L);
  }

  TEST_CASE("which pulley drives does not matter for the length") {
    for (const Arrangement arrangement : {Arrangement::open, Arrangement::crossed}) {
      CHECK(rel(in_si(course(120, 430, 700, arrangement).L), in_si(course(430, 120, 700, arrangement).L)) < 1e-14);
    }
  }

  TEST_CASE("the centre distance found for a length gives back that length") {
    for (const Arrangement arrangement : {Arrangement::open, Arrangement::crossed}) {
      for (const double a : {311.0, 400.0, 700.0, 5000.0, 1e6}) {
        CAPTURE(a);
        const Length L = course(120, 500, a, arrangement).L;
        const Length found = belt::centre_of_length({120.0 * mm, 500.0 * mm, unset<Length>, L, arrangement});
        CHECK(rel(in_si(found), a * 1e-3) < 1e-12);
      }
    }
  }

  TEST_CASE("the centre distance found for a quarter-turn belt gives back its length") {
    for (const double a : {311.0, 400.0, 1500.0, 1e6}) {
      CAPTURE(a);
      belt::Flat::Result r;
      NoTrace trace;
      const Arrangement turned = Arrangement::quarter_turn;
      belt::lay_quarter_turn({120.0 * mm, 500.0 * mm, a * mm, unset<Length>, turned}, r, trace);
      CHECK(rel(in_si(belt::centre_of_length({120.0 * mm, 500.0 * mm, unset<Length>, r.L, turned})), a * 1e-3) < 1e-12);
    }
    CHECK(!is_set(
        belt::centre_of_length({100.0 * mm, 500.0 * mm, unset<Length>, 900.0 * mm, Arrangement::quarter_turn})));
  }

  TEST_CASE("a length that no centre distance gives has no result") {
    CHECK(!is_set(belt::centre_of_length({100.0 * mm, 500.0 * mm, unset<Length>, 900.0 * mm})));
    CHECK(!is_set(belt::centre_of_length({100.0 * mm, 100.0 * mm, unset<Length>, 300.0 * mm})));
    CHECK(!is_set(belt::centre_of_length({100.0 * mm, 100.0 * mm, unset<Length>, unset<Length>})));
  }

  TEST_CASE("the centre distance rises with the length, by half of it where the pulleys are equal") {
    const Pulleys pulleys{150.0 * mm, 150.0 * mm, unset<Length>, 1500.0 * mm};
    Pulleys longer = pulleys;
    longer.L = 1520.0 * mm;
    CHECK(rel(in_si(belt::centre_of_length(longer) - belt::centre_of_length(pulleys)), 0.010) < 1e-12);
  }

  TEST_CASE("the usual approximation of the length agrees where the pulleys are far apart") {
    const auto c = course(100, 300, 5000);
    const double d_1 = 0.1, d_2 = 0.3, a = 5.0;
    CHECK(rel(in_si(c.L), 2 * a + pi / 2 * (d_1 + d_2) + (d_2 - d_1) * (d_2 - d_1) / (4 * a)) < 1e-7);
  }

  TEST_CASE("pulleys are clear of each other where their centres are more than half the sum of the diameters apart") {
    CHECK(belt::stand_clear({100.0 * mm, 300.0 * mm, 201.0 * mm, unset<Length>}));
    CHECK(!belt::stand_clear({100.0 * mm, 300.0 * mm, 200.0 * mm, unset<Length>}));
    const Length touching = course(100, 300, 200).L;
    CHECK(belt::stand_clear({100.0 * mm, 300.0 * mm, unset<Length>, touching + 1.0 * mm}));
    CHECK(!belt::stand_clear({100.0 * mm, 300.0 * mm, unset<Length>, touching - 1.0 * mm}));
  }
}
