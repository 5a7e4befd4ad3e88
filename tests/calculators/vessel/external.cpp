#include "calculators/vessel/external/external.hpp"

#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::External;
using Shape = External::Shape;

External::Input cylinder(Length D_a, Length L, Length e, double E = 200.0) {
  External::Input in;
  in.p_e = 0.1 * MPa, in.D_a = D_a, in.L = L, in.delta = e;
  in.E = E * GPa, in.R_e = 265.0 * MPa;
  return in;
}

External::Result pressed(const External::Input& in) { return solve<External>(in); }

}  // namespace

TEST_SUITE("vessel.external") {
  TEST_CASE("[Roark-19a]: a long tube of 6.75 x 0.375 in, 29e6 psi: 1357 psi") {
    External::Input in = cylinder((2.0 * 6.75 + 0.375) * 25.4 * mm, 1e5 * 25.4 * mm, 0.375 * 25.4 * mm);
    in.E = 29e6 * 6894.757e-6 * MPa, in.nu = 0.29;
    const auto r = pressed(in);
    CHECK(std::abs(in_si(r.p_cr) / 6894.757 - 1357.0) < 0.5);
    CHECK(r.n == 2.0);
    CHECK(!is_set(r.p_WT));  // endless: not between the ends
  }

  TEST_CASE("[Holooly-5.9]: a cylinder of 60 in, 10 ft long, 0.375 in: 113 psi by a chart") {
    External::Input in = cylinder((60.0 + 0.375) * 25.4 * mm, 120.0 * 25.4 * mm, 0.375 * 25.4 * mm);
    in.E = 29e6 * 6894.757e-6 * MPa;
    CHECK(rel(in_si(pressed(in).p_cr), 113.0 * 6894.757) < 0.025);
    CHECK(pressed(in).n == 4.0);
  }

  TEST_CASE("critical pressures and lobes of the determinant of Flügge's stability equations") {
    // simply supported ends, hydrostatic pressure, E = 200 GPa, nu = 0.3; mean radius, length, thickness in mm
    struct Row {
      double R, L, t, p, n;
    };
    for (const Row& row :
         {Row{597, 2400, 6, 0.473200, 4}, Row{1000, 2000, 10, 0.935977, 6}, Row{1000, 500, 10, 4.198163, 11},
          Row{1000, 8000, 10, 0.220848, 3}, Row{500, 1e7, 20, 3.516484, 2}, Row{500, 500, 2, 0.194605, 11}}) {
      const auto r = pressed(cylinder((2.0 * row.R + row.t) * mm, row.L * mm, row.t * mm));
      CAPTURE(row.L);
      CHECK(rel(in_si(r.p_cr), row.p * 1e6) < 2e-3);
      CHECK(r.n == row.n);
      if (is_set(r.p_WT)) CHECK(rel(in_si(r.p_WT), row.p * 1e6) < 0.05);
    }
  }

  TEST_CASE("the buckling limit lies below the perfect shell, above the allowable pressure") {
    for (const double L : {300.0, 1000.0, 4000.0, 40000.0}) {
      for (const double e : {3.0, 6.0, 12.0, 25.0}) {
        const auto r = pressed(cylinder(1000.0 * mm, L * mm, e * mm));
        CHECK(r.p_k < r.p_cr);
        CHECK(r.p_a < r.p_k);
        CHECK(r.F_ic <= 265.0 * MPa);
      }
    }
    External::Input in = cylinder(1000.0 * mm, unset<Length>, 10.0 * mm);
    in.shape = Shape::sphere;
    const auto ball = pressed(in);
    CHECK(rel(in_si(ball.p_cr), 2.0 * 200e9 / std::sqrt(3.0 * 0.91) * std::pow(10.0 / 495.0, 2)) < 1e-12);
    CHECK(ball.p_k < 0.3 * ball.p_cr);
  }

  TEST_CASE("longer and thinner shells carry less, without a jump of more than 8 % between the ranges") {
    double last = 0.0;
    for (double L = 20.0; L < 50000.0; L *= 1.02) {
      const double p_a = in_si(pressed(cylinder(1000.0 * mm, L * mm, 6.0 * mm)).p_a);
      if (last > 0.0) CHECK(p_a <= last * (1.0 + 0.005));
      if (last > 0.0) CHECK(p_a >= last * 0.92);
      last = p_a;
    }
    last = 0.0;
    for (double e = 1.0; e < 45.0; e *= 1.02) {
      const double p_a = in_si(pressed(cylinder(1000.0 * mm, 1500.0 * mm, e * mm)).p_a);
      CHECK(p_a > last);
      last = p_a;
    }
  }

  TEST_CASE("the wall of a cylinder under vacuum is assessed by a step that takes it") {
    const std::string shell =
        "[tank]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\nc = \"1 mm\"\n"
        "delta = \"10 mm\"\nsigma_adm = \"140 MPa\"\n";
    const auto state = [](const std::string& text) {
      std::vector<Issue> issues;
      project::Project p = project::read_project(text, "case.toml", catalogue(), issues);
      REQUIRE(!has_errors(issues));
      project::solve(p, issues);
      for (const account::Mode& mode : project::modes(p)) {
        if (std::string_view(mode.id) == "vacuum") return std::string(account::slug(mode.state));
      }
      return std::string();
    };
    const std::string vacuum =
        "[vacuum]\ncalculator = \"vessel.external\"\nwall = \"=tank.wall\"\nmaterial = \"P265GH\"\nL = \"2 m\"\n";
    CHECK(state(shell) == "open");
    CHECK(state(shell + vacuum + "p_e = \"0.1 MPa\"\n") == "pass");
    CHECK(state(shell + vacuum + "p_e = \"3 MPa\"\n") == "fail");
  }

  TEST_CASE("wrong input is refused") {
    const std::string step =
        "calculator = \"vessel.external\"\np_e = \"0.1 MPa\"\nD_a = \"1 m\"\nmaterial = \"P265GH\"\ndelta = \"8 mm\"\n";
    CHECK(says(step, "a cylinder needs its length L"));
    CHECK(says(step + "L = \"1 m\"\nshape = \"sphere\"", "a sphere has none"));
    CHECK(says(step + "L = \"1 m\"\nc = \"9 mm\"", "thicker than its allowances"));
    CHECK(messages(step + "L = \"1 m\"").empty());
  }
}
