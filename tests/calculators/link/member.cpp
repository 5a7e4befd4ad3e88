#include "calculators/link/member.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

namespace {

using namespace loadpath;
using loadpath::test::ExampleStep;
using loadpath::test::mode_with;
using test::rel;

/// The largest moment of a hinged bar of length l under a compression P and moments M(x), bending stiffness EI, by
/// small steps: w'' = -(M + P w)/EI with w = 0 at both ends, found by shooting.
double second_order(double l, double EI, double P, const std::function<double(double)>& M) {
  constexpr int steps = 4000;
  const double dx = l / steps;
  double largest = 0.0;
  const auto end = [&](double slope) {
    double w = 0.0, v = slope;
    largest = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double x = (i + 0.5) * dx, mid = w + 0.5 * dx * v;
      const double moment = M(x) + P * mid;
      largest = std::max(largest, std::abs(moment));
      w += dx * (v - 0.5 * dx * moment / EI), v -= dx * moment / EI;
    }
    return w;
  };
  const double at_0 = end(0.0), at_1 = end(1e-3);
  end(-at_0 * 1e-3 / (at_1 - at_0));
  return largest;
}

}  // namespace

TEST_SUITE("link member") {
  TEST_CASE("[Bhandari-4] example 4.9: 152 MPa in the plate of a press frame under 10 kN and 2750 N*m") {
    const ExampleStep frame("link.member",
                            "N = \"10 kN\"\nV = \"0 kN\"\nM_b = \"2750 N*m\"\nh = \"150 mm\"\nb = \"5.263158 mm\"");
    CHECK(rel(frame("sigma_o"), 152e6) < 1e-6);
    CHECK(frame("u_p") == 0.0);
  }

  TEST_CASE("[Gere] problem 11.6-11: at 664.7 kip on 1.471 in the fibre yields") {
    const ExampleStep column(
        "link.member",
        "N = \nP = \"664.7 kip\"\nV = \"0 kN\"\nM_b = \"977.7737 kip*in\"\nl = \"216 in\"\nh = \nb = "
        "\nA = \"25.6 in^2\"\nI_y = \"740 in^4\"\nI_z = \"241 in^4\"\nends_y = \nends_z = \nbeta_y "
        "= 1\nbeta_z = 0.5\nc_y = \"6.265 in\"\nE = \"29000 ksi\"\nR_e = \"36 ksi\"\nn_st = 1\nS = ");
    CHECK(rel(column("u_p"), 1.0) < 1e-3);
  }

  TEST_CASE("force and moment that the secant formula allows make the fibre yield, by small steps") {
    const double A = 800e-6, W = 0.02 * 0.04 * 0.04 / 6, EI = 210e9 * 0.02 * 0.04 * 0.04 * 0.04 / 12;
    const double u_p = ExampleStep("link.member", "")("u_p"), N = 3.0 / u_p * 18e3, M_b = 1.5 / u_p * 60.0;
    const double M = second_order(0.4, EI, N, [&](double) { return M_b; });
    CHECK(rel(N / A + M / W, 355e6) < 1e-5);
    const double of_all = 3.0 / ExampleStep("link.member", "S = ")("u_p");  // buckling safety factor of both
    const double most = second_order(0.4, EI, of_all * 18e3, [&](double) { return of_all * 60.0; });
    CHECK(rel(of_all * 18e3 / A + most / W, 355e6) < 1e-5);
  }

  TEST_CASE("a uniform moment is an upper bound of the others of hinged ends") {
    const double EI = 210e9 * 0.02 * 0.04 * 0.04 * 0.04 / 12, l = 1.6, P = 0.6 * pi * pi * EI / (l * l);
    const double even = second_order(l, EI, P, [](double) { return 100.0; });
    CHECK(rel(even, 100.0 / std::cos(pi / 2 * std::sqrt(0.6))) < 1e-4);
    CHECK(second_order(l, EI, P, [&](double x) { return 400.0 * x * (l - x) / (l * l); }) < even);
    CHECK(second_order(l, EI, P, [&](double x) { return 100.0 * x / l; }) < even);
    CHECK(second_order(l, EI, P, [&](double x) { return 100.0 * (1 - 2 * x / l); }) < even);
  }

  TEST_CASE("a section of the tables, a tube, a rectangle: the shear that they carry") {
    CHECK(rel(ExampleStep("link.member", "")("tau"), 1.5 * 400 / 800e-6) < 1e-9);
    CHECK(rel(ExampleStep("link.member", "h = \nb = \nd = \"40 mm\"")("tau"), 4.0 / 3 * 400 / (pi * 400e-6)) < 1e-9);
    CHECK(rel(ExampleStep("link.member", "A_v = \"200 mm^2\"")("tau"), 400 / 200e-6) < 1e-9);
    // EN 1993-1-1, 6.2.6 (5): even over the web between the flanges, 100 - 2 5.7 by 4.1 mm
    const std::string rolled = "h = \nb = \nsection = \"IPE 100\"";
    CHECK(rel(ExampleStep("link.member", rolled)("tau"), 400 / (88.6e-3 * 4.1e-3)) < 1e-9);
    CHECK(mode_with("link.member", rolled, "shear") == "pass");
    CHECK(mode_with("link.member", rolled + "\nV = \"60 kN\"", "shear") == "fail");
    // A and I by themselves give no web
    const std::string typed =
        "h = \nb = \nA = \"1032 mm^2\"\nI_y = \"171 cm^4\"\nI_z = \"15.92 cm^4\"\nc_y = \"50 mm\"";
    CHECK(mode_with("link.member", typed, "shear") == "not-judged");
    CHECK(mode_with("link.member", typed + "\nA_v = \"363 mm^2\"", "shear") == "pass");
  }

  TEST_CASE("a link under negligible compression is assessed like one without") {
    for (const char* M : {"60 N*m", "1200 N*m", "1270 N*m"}) {
      const std::string moment = "M_b = \"" + std::string(M) + "\"\n";
      const ExampleStep none("link.member", moment + "N = \"0 kN\""),
          hardly("link.member", moment + "N = \"-1e-12 N\"");
      CHECK(rel(hardly("u_p"), none("u_y")) < 1e-6);
      CHECK(rel(hardly("u_i"), none("u_y")) < 1e-6);
      CHECK(rel(hardly("u_t"), none("u_t")) < 1e-6);
    }
  }

  TEST_CASE("a rectangle on edge buckles laterally: EN 1993-1-1 6.3.2.2 with curve d, independently with mpmath") {
    const std::string plate =
        "N = \"0 kN\"\nV = \"0 kN\"\nh = \"200 mm\"\nb = \"5 mm\"\nl = \"2 m\"\nends_z = \"pinned_pinned\"\n";
    const ExampleStep step("link.member", plate + "M_b = \"400 N*m\"");
    CHECK(rel(step("M_cr"), 845.6537815669302) < 1e-9);
    CHECK(rel(step("lambda_t"), 3.7407376563594683) < 1e-9);
    CHECK(rel(step("chi_t"), 0.05933374842295401) < 1e-9);
    const auto state = [&](const std::string& lines) {
      return mode_with("link.member", plate + lines, "lateral_torsional");
    };
    CHECK(state("M_b = \"467 N*m\"") == "pass");
    CHECK(state("M_b = \"-469 N*m\"") == "fail");  // a twenty-fifth of what the fibre carries
    CHECK(mode_with("link.member", plate + "M_b = \"469 N*m\"", "yield") == "pass");
    CHECK(state("M_b = \"0 N*m\"") == "none");
    CHECK(state("h = \"5 mm\"\nb = \"200 mm\"") == "none");  // flat it does not
    CHECK(mode_with("link.member", "h = \nb = \nd = \"40 mm\"", "lateral_torsional") == "none");
    CHECK(mode_with("link.member", "", "lateral_torsional") == "pass");
  }

  TEST_CASE("must not pass: signs, no safety factor, sections that twist, ends that no link has") {
    for (const char* id : {"yield", "shear", "buckling", "bent", "slenderness"})
      CHECK(mode_with("link.member", "", id) == "pass");
    CHECK(mode_with("link.member", "", "tension") == "none");
    CHECK(mode_with("link.member", "M_b = \"-9 kN*m\"", "yield") == "fail");
    CHECK(mode_with("link.member", "M_b = \"-1300 N*m\"", "bent") == "fail");
    CHECK(mode_with("link.member", "S = ", "yield") == "not-judged");
    CHECK(mode_with("link.member", "N = \"18 kN\"", "bent") == "none");
    CHECK(mode_with("link.member", "N = \"0 kN\"", "yield") == "pass");
    CHECK(mode_with("link.member", "N = \"0 kN\"\nM_b = \"0 N*m\"\nV = \"0 kN\"", "yield") == "none");
    CHECK(mode_with("link.member", "N = \"-1e-12 N\"\nM_b = \"9 kN*m\"", "bent") == "fail");
    CHECK(mode_with("link.member", "N = \"-9 MN\"", "bent") == "fail");
    const std::string i = "h = \nb = \nA_v = \"400 mm^2\"\nsection = \"IPE 100\"\nkind = \"rolled_I\"";
    CHECK(mode_with("link.member", i, "lateral_torsional") == "not-judged");
    CHECK_FALSE(ExampleStep("link.member", "ends_y = \"fixed_fixed\"").fault().empty());
    CHECK_FALSE(ExampleStep("link.member", "R_e = ").fault().empty());
    CHECK_FALSE(ExampleStep("link.member", "method = \"secant\"").fault().empty());
    CHECK_FALSE(ExampleStep("link.member", "h = \nb = \nd = \nsection = \"L 50x5\"\nM_b = \"1 N*m\"").fault().empty());
  }
}
