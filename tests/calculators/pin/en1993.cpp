#include "calculators/pin/en1993.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using pin::En1993;

constexpr auto solve = test::evaluated<En1993>;

using test::rel;

/// The sheet's pin of 16 mm; its thicknesses together give 27.1 N*m.
En1993::Input sheet() {
  En1993::Input in;
  in.F = 5.0 * kN, in.gamma_F = 1.0, in.gamma_M0 = 1.1, in.gamma_M2 = 1.25;
  in.d = 16.0 * mm, in.d_0 = 16.1 * mm, in.t_1 = 15.36 * mm, in.t_2 = 10.0 * mm, in.c = 2.0 * mm;
  in.f_yp = in.f_y_1 = in.f_y_2 = 235.0 * MPa, in.f_up = 360.0 * MPa;
  return in;
}

}  // namespace

TEST_SUITE("pin en1993") {
  TEST_CASE("[EC3-pin-sheet]: 35 kN in shear, safety factor of 4.75 in bending, 76 N*m in service") {
    En1993::Input in = sheet();
    in.replaceable = En1993::Replaceable::yes, in.gamma_M6 = 1.0;
    const auto r = solve(in);
    CHECK(rel(in_si(r.F_vRd), 34.74e3) < 2e-4);  // 6.95 times 5 kN
    CHECK(rel(in_si(r.M_Ed), 27.1) < 1e-3);
    CHECK(rel(1.0 / r.u_m, 4.75) < 2e-3);
    CHECK(rel(in_si(r.M_Rdser), 75.6) < 1e-3);  // 13.94 times 5.42 N*m
  }

  TEST_CASE("a book on bridges: bearing with the lower strength of pin and plate, in service 0.6 of 1.5") {
    En1993::Input in = sheet();
    in.f_y_1 = 355.0 * MPa;
    CHECK(rel(in_si(solve(in).F_bRd1), 1.5 * 15.36 * 16 * 235 / 1.1) < 1e-12);
    in.replaceable = En1993::Replaceable::yes, in.gamma_M6 = 1.1;
    CHECK(rel(solve(in).u_s1 / solve(in).u_b1, 2.5) < 1e-12);
  }

  TEST_CASE("shear and bending together fail where the sum of their squares is one") {
    En1993::Input in = sheet();
    in.F = in.F / solve(in).u_vm;
    const auto r = solve(in);
    CHECK(rel(r.u_m * r.u_m + r.u_v * r.u_v, 1.0) < 1e-12);
  }

  TEST_CASE("must not pass: plates without distances, a replaceable pin without its factor, a load that rotates") {
    using loadpath::test::mode_with;
    for (const char* id : {"shear", "bending", "bearing_1", "bearing_2", "plate_1", "plate_2"})
      CHECK(mode_with("pin.en1993", "", id) == "pass");
    CHECK(mode_with("pin.en1993", "e_a1 = ", "plate_1") == "not-judged");
    CHECK(mode_with("pin.en1993", "replaceable = \"yes\"", "replacing") == "not-judged");
    CHECK(mode_with("pin.en1993", "F = \"-15 MN\"", "bending") == "fail");
    CHECK(mode_with("pin.en1993", "F = \"0 kN\"", "shear") == "none");
    CHECK_FALSE(loadpath::test::ExampleStep("pin.en1993", "d_0 = \"49 mm\"").fault().empty());
  }
}
