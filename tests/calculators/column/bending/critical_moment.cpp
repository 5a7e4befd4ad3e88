#include "calculators/column/bending/critical_moment.hpp"

#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::column;
using test::rel;

/// IPE 300 of 6 m between fork ends.
constexpr double length = 6.0;
const Lateral ipe_300{210.0 * GPa, 210.0 / 2.6 * GPa, from_si<SecondMoment>(603.8e-8), from_si<SecondMoment>(19.9e-8),
                      from_si<Warping>(125900e-12)};

/// End moments in N*m, a load in N/m, a force in N.
Moments moments(double M_1, double M_2, double q = 0.0, double F = 0.0) {
  return {from_si<Moment>(M_1), from_si<Moment>(M_2), from_si<Stiffness>(q), from_si<Force>(F),
          from_si<Length>(length)};
}

double critical(const Moments& m, double z_g = 0.0) { return in_si(critical_moment(ipe_300, m, from_si<Length>(z_g))); }

}  // namespace

TEST_SUITE("critical moment") {
  TEST_CASE("as by finite elements: forty cubic elements of the twist, computed independently") {
    CHECK(rel(critical(moments(1, 0)), 164578) < 1e-5);
    CHECK(rel(critical(moments(-1, 1)), 243662) < 1e-5);
    CHECK(rel(critical(moments(1, 0.5)), 118699) < 1e-5);
    CHECK(rel(critical(moments(0, 0, 8.0)), 101823) < 1e-5);
    CHECK(rel(critical(moments(0, 0, 0, 8.0)), 122540) < 1e-5);
    CHECK(rel(critical(moments(0, 0, 8.0), 0.15), 78355.9) < 1e-5);
    CHECK(rel(critical(moments(0, 0, 0, 8.0), 0.15), 88643.2) < 2e-4);  // the kink of the force takes more terms
    CHECK(rel(critical(moments(0, 0, 0, 8.0), -0.15), 168392) < 5e-4);
  }

  TEST_CASE("a uniform moment has the closed form") {
    CHECK(rel(critical(moments(1, 1)), in_si(critical_uniform_moment(ipe_300, from_si<Length>(length)))) < 1e-9);
  }

  TEST_CASE("the factors of the moment distribution are those of handbooks") {
    // SN003 and its kin print 1.127 to 1.132 for a distributed load, 1.348 to 1.365 for a force, 1.77 to 1.88 for a
    // moment at one end, 2.55 to 2.76 for equal moments of opposite bending.
    const double uniform = critical(moments(1, 1));
    const auto within = [&](const Moments& m, double low, double high) {
      const double C_1 = critical(m) / uniform;
      return C_1 >= low && C_1 <= high;
    };
    CHECK(within(moments(0, 0, 1), 1.127, 1.132));
    CHECK(within(moments(0, 0, 0, 1), 1.348, 1.365));
    CHECK(within(moments(1, 0), 1.77, 1.88));
    CHECK(within(moments(1, -1), 2.55, 2.76));
  }

  TEST_CASE("neither the sign of all loads nor the direction of the bar matters") {
    CHECK(rel(critical(moments(3, -2, 1)), critical(moments(-3, 2, -1))) < 1e-12);
    CHECK(rel(critical(moments(3, -2, 1)), critical(moments(-2, 3, 1))) < 1e-9);
    CHECK(rel(critical(moments(3, -2)), critical(moments(6, -4))) < 1e-12);
  }
}
