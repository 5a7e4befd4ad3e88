#include "calculators/pin/cross.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using pin::Cross;

constexpr auto solve = test::evaluated<Cross>;

using test::rel;

Cross::Input lever() {
  Cross::Input in;
  in.T = 32.0 * N_m, in.d = 8.0 * mm, in.d_w = 32.0 * mm, in.D = 64.0 * mm;
  return in;
}

}  // namespace

TEST_SUITE("pin cross") {
  TEST_CASE("[BSWiki-pins]: 5.2 MPa in the hub, 23.44 MPa in the shaft") {
    const auto r = solve(lever());
    CHECK(std::abs(in_si(r.p_2) - 5.2e6) < 0.05e6);
    CHECK(std::abs(in_si(r.p_1) - 23.44e6) < 0.005e6);
  }

  TEST_CASE("[iBoats-791613]: a pin of 1/4 in on a shaft of 3/4 in carries about 2500 lbf*in at 67.5 ksi") {
    Cross::Input in = lever();
    in.T = 282.46 * N_m, in.d = 6.35 * mm, in.d_w = 19.05 * mm, in.D = 38.1 * mm;
    CHECK(rel(in_si(solve(in).tau), 67.5 * 6.894757e6) < 0.01);
  }

  TEST_CASE("[Inggo-31]: the pressures transmit the torque") {
    const auto r = solve(lever());
    double T_1 = 0.0;  // p grows from the axis: p_1 at the surface
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) {
      const double y = 0.016 * (i + 0.5) / steps;
      T_1 += 2.0 * in_si(r.p_1) * y / 0.016 * 0.008 * y * 0.016 / steps;
    }
    CHECK(rel(T_1, 32.0) < 1e-5);
    CHECK(rel(in_si(r.p_2) * 0.008 * (0.064 - 0.032) * 0.25 * (0.064 + 0.032), 32.0) < 1e-12);
  }

  TEST_CASE("must not pass: no allowable value, a thick pin, a torque that varies") {
    using loadpath::test::mode_with;
    for (const char* id : {"shear", "shaft_bore", "hub_bore", "shaft", "fatigue"})
      CHECK(mode_with("pin.cross", "", id) == "pass");
    CHECK(mode_with("pin.cross", "tau_adm_1 = ", "shaft") == "not-judged");
    CHECK(mode_with("pin.cross", "d = \"16 mm\"", "shaft") == "not-covered");
    CHECK(mode_with("pin.cross", "T = \"-900 N*m\"", "shear") == "fail");
    CHECK(mode_with("pin.cross", "loading = \"steady\"\nK_A = 1.5", "variation") == "not-judged");
    CHECK(mode_with("pin.cross", "K_A = 1.5", "shaft_fatigue") == "not-judged");
  }
}
