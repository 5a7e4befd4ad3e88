#include "calculators/vessel/cylinder.hpp"
#include "calculators/vessel/ends/end.hpp"
#include "calculators/vessel/ends/flat.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::FlatEnd;

FlatEnd::Input plate() {
  FlatEnd::Input in;
  in.p = 1.0 * MPa, in.D_i = 600.0 * mm, in.delta = 34.0 * mm;
  in.R_e = 265.0 * MPa, in.R_m = 410.0 * MPa;
  return in;
}

FlatEnd::Result flat(const FlatEnd::Input& in) { return solve<FlatEnd>(in); }

/// The largest bending stress of a round plate by its theory, nu = 0.3: edge clamped or resting.
double clamped(double p, double d, double t) { return 0.1875 * p * d * d / (t * t); }
double resting(double p, double d, double t) { return 3.3 * 3.0 / 32.0 * p * d * d / (t * t); }

}  // namespace

TEST_SUITE("vessel.flat_end") {
  TEST_CASE("at the allowable pressure the plate bends up to yield, between a clamped and a simply supported edge") {
    // the factors hold 1.5 times the allowable stress in bending, which is the yield strength where that governs it
    for (const auto& [C, edge] : {std::pair{0.17, &clamped}, std::pair{0.33, &resting}}) {
      FlatEnd::Input in = plate();
      in.C = C, in.R_m = 900.0 * MPa;
      const auto r = flat(in);
      const double stress = edge(in_si(r.p_max), 0.6, 0.034);
      CHECK(stress < 1.15 * 1.5 * in_si(r.f));
    }
  }

  TEST_CASE("the minimum thickness is fully utilised, with its allowances") {
    FlatEnd::Input in = plate();
    in.c = 2.0 * mm, in.c_t = 0.5 * mm, in.z = 0.8;
    in.delta = flat(in).delta_min;
    CHECK(rel(flat(in).u_e, 1.0) < 1e-12);
  }

  TEST_CASE("the flat end takes pressure, diameter and corrosion of its shell, and is compared with it") {
    const std::string shell =
        "[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\nc = \"1 mm\"\n"
        "delta = \"10 mm\"\nsigma_adm = \"140 MPa\"\n[cover]\ncalculator = \"vessel.flat_end\"\nmaterial = \"P265GH\"\n"
        "delta = \"70 mm\"\n";
    std::vector<Issue> issues;
    project::Project p = project::read_project(shell + "shell = \"=shell.shell\"\n", "case.toml", catalogue(), issues);
    REQUIRE(!has_errors(issues));
    project::solve(p, issues);
    CHECK(rel(p.value("cover.D_c")->si[0], 1.202) < 1e-9);
    CHECK(p.value("cover.u_e")->si[0] < 1.0);
  }

  TEST_CASE("a test below the required pressure, or beyond the new wall, fails the ends and the shell") {
    FlatEnd::Input in = plate();
    in.p_t = 1.4 * MPa, in.h_t = 0.0 * mm;
    CHECK(flat(in).u_tr > 1.0);
    in.p_t = 5.0 * MPa;
    CHECK(flat(in).u_t > 1.0);
    vessel::End::Input end;
    end.p = 1.0 * MPa, end.D_i = 1980.0 * mm, end.delta = 12.0 * mm, end.R_e = 265.0 * MPa, end.R_m = 410.0 * MPa;
    end.p_t = 1.43 * MPa, end.h_t = 0.0 * mm;
    // crown, knuckle by yield and by buckling of the new end, computed independently: 215.58/265
    CHECK(rel(solve<vessel::End>(end).u_t, 215.58019975297407 / 265.0) < 1e-9);
    CHECK(rel(solve<vessel::End>(end).u_tr, 1.0) < 1e-12);
    end.c = 1.0 * mm;  // comes later
    CHECK(rel(solve<vessel::End>(end).u_t, 215.58019975297407 / 265.0) < 1e-9);
    end.p_t = 2.0 * MPa;
    CHECK(solve<vessel::End>(end).u_t > 1.0);
  }

  TEST_CASE("the test of the new cylinder: Tresca on the mean radius, however much will corrode") {
    vessel::Cylinder::Input shell;
    shell.p = 1.0 * MPa, shell.R = 600.0 * mm, shell.measured = vessel::Measured::inner, shell.delta = 10.0 * mm;
    shell.c = 2.0 * mm, shell.z_l = 0.85, shell.R_e = 265.0 * MPa, shell.S = 1.5;
    shell.p_t = 1.43 * MPa, shell.h_t = 0.0 * mm;
    CHECK(rel(solve<vessel::Cylinder>(shell).u_t, 1.43 * (60.5 / 0.85 + 1.0) / (265.0 / 1.05)) < 1e-12);
    shell.rho = 1000.0 * vessel::kg_per_m3, shell.h_l = 3.0 * m;  // the liquid in service is not there
    CHECK(rel(solve<vessel::Cylinder>(shell).u_t, 1.43 * (60.5 / 0.85 + 1.0) / (265.0 / 1.05)) < 1e-12);
    shell.h_t = 5.0 * m;
    CHECK(rel(solve<vessel::Cylinder>(shell).u_t, (1.43 + 0.04903325) * (60.5 / 0.85 + 1.0) / (265.0 / 1.05)) < 1e-9);
  }

  TEST_CASE("wrong input is refused") {
    const std::string step = "calculator = \"vessel.flat_end\"\np = \"1 MPa\"\nD_i = \"600 mm\"\ndelta = \"40 mm\"\n";
    CHECK(says(step, "give sigma_adm, or R_e and R_m"));
    CHECK(says(step + "sigma_adm = \"110 MPa\"\np_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "a test needs the yield strength"));
    CHECK(says(step + "material = \"P265GH\"\nR_e_t = \"265 MPa\"", "give its pressure p_t"));
    CHECK(says(step + "material = \"P265GH\"\np_t = \"1.5 MPa\"", "the height h_t of its water"));
    CHECK(says(step + "material = \"P265GH\"\nC = 0.3\nm_r = 0.8", "give one of them"));
    CHECK(messages(step + "material = \"P265GH\"").empty());
    const std::string ringed =
        "calculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nends = \"ringed\"\nR_e = \"265 MPa\"\nS = "
        "1.5\n";
    CHECK(says(ringed + "p_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "is not covered"));
  }
}
