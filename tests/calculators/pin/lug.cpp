#include "calculators/pin/lug.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using pin::Lug;

constexpr auto solve = test::evaluated<Lug>;

using test::rel;

Lug::Input eye(double F, double d, double b, double t) {
  Lug::Input in;
  in.F = F * kN, in.d = d * mm, in.b = b * mm, in.a = (b - d) / 2.0 * mm, in.t = t * mm;
  return in;
}

}  // namespace

TEST_SUITE("pin lug") {
  TEST_CASE("[Knuckle-19427936]: 46.88 MPa next to the bore, to the crown and in the bore") {
    const auto r = solve(eye(15, 16, 32, 20));
    for (const Stress& s : {r.sigma_n, r.tau_s, r.p}) CHECK(rel(in_si(s), 46.88e6) < 2e-4);
    const auto cheek = solve(eye(7.5, 16, 32, 10));
    CHECK(rel(in_si(cheek.sigma_n), 46.88e6) < 2e-4);
  }

  TEST_CASE("[Bhandari-4] example 4.5: 31.25 MPa everywhere") {
    const auto r = solve(eye(50, 40, 80, 40));
    for (const Stress& s : {r.sigma_n, r.tau_s, r.p}) CHECK(rel(in_si(s), 31.25e6) < 1e-12);
  }

  TEST_CASE("from the yield strength, in shear by von Mises") {
    auto in = eye(50, 40, 80, 40);
    in.R_e = 250.0 * MPa, in.S = 2.0;
    CHECK(rel(solve(in).u_n, 2.0 * 31.25 / 250.0) < 1e-12);
    CHECK(rel(solve(in).u_s, 2.0 * std::sqrt(3.0) * 31.25 / 250.0) < 1e-12);
  }

  TEST_CASE("must not pass: shapes outside the nominal stresses, loads that are not assessed") {
    using loadpath::test::mode_with;
    for (const char* id : {"net", "shear_out", "crown", "bearing"}) CHECK(mode_with("pin.lug", "", id) == "pass");
    // 50 kN over (2.5 - 1) 40 mm x 40 mm: 20.8 MPa, however wide the eye is
    const std::string wide = "b = \"400 mm\"\na = \"180 mm\"\ntau_adm = \"20 MPa\"\nsigma_adm = ";
    CHECK(mode_with("pin.lug", wide + "\"20.8 MPa\"", "net") == "fail");
    CHECK(mode_with("pin.lug", wide + "\"20.9 MPa\"", "net") == "pass");
    CHECK(mode_with("pin.lug", "a = \"5 mm\"\ntau_adm = \"400 MPa\"", "crown") == "not-covered");
    CHECK(mode_with("pin.lug", "F = \"-5 MN\"", "net") == "fail");
    CHECK(mode_with("pin.lug", "K_A = 1.5", "fatigue") == "not-judged");
    CHECK(mode_with("pin.lug", "p_adm = ", "bearing") == "not-judged");
    CHECK(mode_with("pin.lug", "F = \"0 N\"", "net") == "none");
  }

  TEST_CASE("a pin leaves its eye and its fork cheeks to steps of pin.lug, which assess them") {
    const auto project = loadpath::test::solved_as_found(R"([joint]
calculator = "pin.joint"
F = "15 kN"
held = "loose"
d = "16 mm"
t_1 = "20 mm"
t_2 = "10 mm"
sigma_adm = "150 MPa"
tau_adm = "80 MPa"
[eye]
calculator = "pin.lug"
load = "=joint.eye"
b = "32 mm"
a = "8 mm"
sigma_adm = "80 MPa"
tau_adm = "60 MPa"
)");
    using loadpath::test::mode_of;
    CHECK(mode_of(project, "joint", "eye_wall") == "pass");
    CHECK(mode_of(project, "joint", "fork_wall") == "not-judged");
  }
}
