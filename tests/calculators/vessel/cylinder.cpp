#include "calculators/vessel/cylinder.hpp"

#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Hypothesis;
using vessel::Measured;
using Ends = vessel::Cylinder::Ends;

/// The vessel of [B24].
vessel::Cylinder::Input vessel_24() {
  vessel::Cylinder::Input in;
  in.p = 1.6 * MPa;
  in.R = 600.0 * mm;
  in.delta = 8.0 * mm;
  in.sigma_adm = 140.0 * MPa;
  return in;
}

vessel::Cylinder::Result cylinder(const vessel::Cylinder::Input& in) { return solve<vessel::Cylinder>(in); }

}  // namespace

TEST_SUITE("vessel.cylinder") {
  TEST_CASE("the vessel of the textbook: 120 and 60 MPa; 6.857 mm, and half of it with rings") {
    vessel::Cylinder::Input in = vessel_24();
    CHECK(rel(in_si(cylinder(in).sigma_o), 120e6) < 1e-12);
    CHECK(rel(in_si(cylinder(in).sigma_M), 60e6) < 1e-12);
    in.hypothesis = Hypothesis::membrane;
    CHECK(rel(in_si(cylinder(in).delta_min), 1.6 * 0.6 / 140) < 1e-12);
    in.ends = Ends::ringed;
    CHECK(rel(in_si(cylinder(in).delta_min), 0.8 * 0.6 / 140) < 1e-12);
    in.ends = Ends::open;
    CHECK(in_si(cylinder(in).sigma_M) == 0.0);
  }

  TEST_CASE("Tresca counts the radial stress: hoop stress and pressure together") {
    vessel::Cylinder::Input in = vessel_24();
    CHECK(rel(in_si(cylinder(in).sigma_v), 121.6e6) < 1e-12);
    CHECK(rel(in_si(cylinder(in).delta_min), 1.6 * 0.6 / (140 - 1.6)) < 1e-12);
    in.hypothesis = Hypothesis::mises;
    const double o = 120, M = 60, r = -1.6;
    CHECK(rel(in_si(cylinder(in).sigma_v),
              1e6 * std::sqrt(((o - M) * (o - M) + (M - r) * (M - r) + (o - r) * (o - r)) / 2)) < 1e-12);
  }

  TEST_CASE("the error against Lamé on the mean radius is -0.06 % at 1/20 and -0.2 % at 1/10 of the inner radius") {
    for (const auto& [ratio_i, percent] : {std::pair{0.05, -0.057}, std::pair{0.1, -0.207}, std::pair{0.2, -0.694}}) {
      vessel::Cylinder::Input in = vessel_24();
      in.measured = Measured::inner;
      in.delta = ratio_i * in.R;
      CHECK(std::abs(100 * cylinder(in).e_L - percent) < 0.0006);
    }
  }

  TEST_CASE("the thin and the thick solution lie close on both sides of 1/20, and up to 1/10") {
    for (const double share : {1.0 / 25, 0.0499, 0.0501, 1.0 / 15}) {
      vessel::Cylinder::Input in = vessel_24();
      in.delta = share * in.R;
      const auto r = cylinder(in);
      CHECK(rel(r.t_R, share) < 1e-12);
      CHECK(std::abs(r.e_L) < 0.0015);
      CHECK(rel(r.u_L, r.u_v) < 0.0015);
      CHECK(rel(in_si(r.delta_L), in_si(r.delta_min)) < 0.001);
    }
    const std::string step =
        "calculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"100 mm\"\nsigma_adm = \"140 MPa\"\n";
    for (const auto& [delta, covered] :
         {std::pair{"5.01 mm", true}, std::pair{"10 mm", true}, std::pair{"10.01 mm", false}}) {
      std::vector<Issue> issues;
      project::Project p =
          project::read_project("[v]\n" + step + "delta = \"" + delta + "\"\n", "case.toml", catalogue(), issues);
      project::solve(p, issues);
      CHECK((account::worst(project::verdicts(p)) == account::State::pass) == covered);
    }
  }

  TEST_CASE("at the minimum thickness the wall is just strong enough, for every radius and allowance") {
    for (const Measured measured : {Measured::mean, Measured::inner, Measured::outer}) {
      for (const Hypothesis h : {Hypothesis::tresca, Hypothesis::mises, Hypothesis::membrane}) {
        vessel::Cylinder::Input in = vessel_24();
        in.measured = measured, in.hypothesis = h;
        in.c = 1.5 * mm, in.f_t = 0.125, in.z_l = 0.85;
        in.delta = cylinder(in).delta_min;
        const auto r = cylinder(in);
        CHECK(rel(r.u_v, 1.0) < 1e-12);
        CHECK(rel(in_si(r.p_max), in_si(in.p)) < 1e-12);
      }
    }
  }

  TEST_CASE("the three radii of one wall give the same result") {
    vessel::Cylinder::Input in = vessel_24();
    in.c = 1.0 * mm;
    in.measured = Measured::inner, in.R = 600.0 * mm;
    const auto inner = cylinder(in);
    in.measured = Measured::mean, in.R = 604.0 * mm;
    CHECK(rel(cylinder(in).u_v, inner.u_v) < 1e-12);
    in.measured = Measured::outer, in.R = 608.0 * mm;
    CHECK(rel(cylinder(in).u_v, inner.u_v) < 1e-12);
    CHECK(rel(in_si(inner.R_m), 0.6045) < 1e-12);
  }

  TEST_CASE("mill tolerance and corrosion do not change the outside") {
    vessel::Cylinder::Input in = vessel_24();
    in.measured = Measured::outer, in.c = 1.6 * mm, in.f_t = 0.125, in.delta = 12.0 * mm;
    const auto r = cylinder(in);
    CHECK(rel(in_si(r.delta_c), 8.9e-3) < 1e-12);
    CHECK(rel(in_si(r.R_m + 0.5 * r.delta_c), in_si(in.R)) < 1e-12);
    in.measured = Measured::inner;
    const auto inner = cylinder(in);
    CHECK(rel(in_si(inner.R_m - 0.5 * inner.delta_c), in_si(in.R) + 1.6e-3) < 1e-12);
  }

  TEST_CASE("rings with liquid alone need a wall too") {
    vessel::Cylinder::Input in;
    in.ends = vessel::Cylinder::Ends::ringed;
    in.p = 0.0 * MPa, in.rho = from_si<vessel::Density>(1000.0), in.h_l = 10.0 * m, in.R = 5.0 * m;
    in.A_r = from_si<Area>(1e-3), in.l_r = 1.0 * m, in.sigma_adm = 100.0 * MPa;
    // p R/(delta + a_r) + p = sigma: delta = p R/(sigma - p) - a_r, with p = 1000 9.80665 10 Pa and a_r = 1 mm
    const double p = 98066.5, delta = p * 5.0 / (100e6 - p) - 1e-3;
    CHECK(rel(in_si(cylinder(in).delta_min), delta) < 1e-9);
    in.delta = from_si<Length>(delta);
    CHECK(rel(cylinder(in).u_v, 1.0) < 1e-9);
  }

  TEST_CASE("each seam weakens its own stress, once") {
    vessel::Cylinder::Input in = vessel_24();
    in.hypothesis = Hypothesis::membrane;
    const auto plain = cylinder(in);
    in.z_l = 0.8;
    CHECK(rel(cylinder(in).u_v, plain.u_v / 0.8) < 1e-12);
    in.z_l = 1.0, in.z_c = 0.8;
    CHECK(rel(cylinder(in).u_v, plain.u_v) < 1e-12);
    in.z_c = 0.4;
    CHECK(rel(cylinder(in).u_v, in_si(plain.sigma_M) / 0.4 / 140e6) < 1e-12);
  }

  TEST_CASE("the corrosion allowance is added once") {
    vessel::Cylinder::Input in = vessel_24();
    const double without = in_si(cylinder(in).delta_min);
    in.c = 2.0 * mm;
    CHECK(std::abs(in_si(cylinder(in).delta_min) - without - 0.002) < 2e-5);  // the radius grows by half of it
  }

  TEST_CASE("stresses increase with pressure and radius and decrease with thickness; scale does not matter") {
    const auto base = cylinder(vessel_24());
    vessel::Cylinder::Input in = vessel_24();
    in.p = 2.0 * in.p;
    CHECK(rel(in_si(cylinder(in).sigma_v), 2 * in_si(base.sigma_v)) < 1e-12);
    in = vessel_24();
    in.R = 3.0 * in.R, in.delta = 3.0 * in.delta;
    CHECK(rel(cylinder(in).u_v, base.u_v) < 1e-12);
    in.delta = 2.0 * in.delta;
    CHECK(cylinder(in).u_v < base.u_v);
  }

  TEST_CASE("a liquid loads the lowest point, and the meridional direction only where the vessel hangs") {
    vessel::Cylinder::Input in = vessel_24();
    in.p = 0.0 * MPa;
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = 10000.0 * mm;
    const double head = 1000 * 9.80665 * 10;
    CHECK(rel(in_si(cylinder(in).sigma_o), head * 0.6 / 0.008) < 1e-12);
    CHECK(in_si(cylinder(in).sigma_M) == 0.0);
    in.support = vessel::Cylinder::Support::top;
    CHECK(rel(in_si(cylinder(in).sigma_M), head * 0.6 / 0.016) < 1e-12);
  }

  TEST_CASE("rings share the hoop force, up to a limited spacing") {
    vessel::Cylinder::Input in = vessel_24();
    in.ends = Ends::ringed;
    in.A_r = 800.0 * mm2, in.l_r = 100.0 * mm;
    const auto r = cylinder(in);
    CHECK(rel(in_si(r.sigma_o), 60e6) < 1e-12);  // as much ring as wall
    CHECK(rel(r.w_r, 0.1 / (1.56 * std::sqrt(0.6 * 0.008))) < 1e-12);
    CHECK(r.w_r < 1.0);
    in.l_r = 120.0 * mm;
    CHECK(cylinder(in).w_r > 1.0);
  }

  TEST_CASE("where no wall is thick enough there is no thickness") {
    vessel::Cylinder::Input in = vessel_24();
    in.p = 150.0 * MPa;
    CHECK_FALSE(is_set(cylinder(in).delta_min));
    CHECK_FALSE(is_set(cylinder(in).delta_L));
  }

  TEST_CASE("the smallest plate of the stock is taken, with the strength of its thickness") {
    const std::string step = "calculator = \"vessel.cylinder\"\np = \"1.6 MPa\"\nR = \"600 mm\"\n";
    std::vector<Issue> issues;
    project::Project p = project::read_project("[v]\n" + step + "sigma_adm = \"140 MPa\"\nc = \"1 mm\"\n", "case.toml",
                                               catalogue(), issues);
    project::solve(p, issues);
    REQUIRE(issues.empty());
    CHECK(rel(p.value("v.delta")->si[0], 0.008) < 1e-12);
    p = project::read_project("[v]\n" + step + "material = \"S235\"\nS = 1.5\n", "case.toml", catalogue(), issues);
    project::solve(p, issues);
    REQUIRE(issues.empty());
    CHECK(rel(p.value("v.sigma_all")->si[0], 235e6 / 1.5) < 1e-12);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.cylinder\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\n";
    CHECK(says(step + "p = \"0 MPa\"\n", "give a pressure p, or a liquid"));
    CHECK(says(step + "p = \"-1 MPa\"\n", "must be"));
    CHECK(says(step + "p = \"1 MPa\"\nrho = \"1000 kg/m^3\"\n", "needs both its density"));
    CHECK(says(step + "p = \"1 MPa\"\nS = 1.5\n", "not both"));
    CHECK(says(step + "p = \"1 MPa\"\nc_t = \"0.3 mm\"\nf_t = 0.1\n", "not both"));
    CHECK(
        says(step + "p = \"1 MPa\"\ndelta = \"2 mm\"\nc = \"2 mm\"\n", "the wall must be thicker than its allowances"));
    CHECK(says(step + "p = \"1 MPa\"\nmeasured = \"outer\"\ndelta = \"600 mm\"\n",
               "the wall must be thinner than the radius"));
    CHECK(says(step + "p = \"1 MPa\"\nA_r = \"100 mm^2\"\nl_r = \"300 mm\"\n", "rings require ends = \"ringed\""));
    CHECK(says(step + "p = \"1 MPa\"\nends = \"ringed\"\nl_r = \"300 mm\"\n", "rings need both"));
    CHECK(says("calculator = \"vessel.cylinder\"\nR = \"600 mm\"\np = \"1 MPa\"\n", "give sigma_adm"));
  }

  TEST_CASE("the allowances must leave something of the wall") {
    const std::string pipe =
        "calculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"300 mm\"\nmeasured = \"mean\"\ndelta = \"10 mm\"\n"
        "sigma_adm = \"140 MPa\"\n";
    const std::string words = "the wall must be thicker than its allowances";
    for (const char* left : {"c = \"9.9 mm\"\n", "c = \"5 mm\"\nc_t = \"4.9 mm\"\n", "f_t = 0.4\nc = \"5.9 mm\"\n"})
      CHECK_FALSE(says(pipe + left, words));
    for (const char* none : {"c = \"10.1 mm\"\n", "c = \"5 mm\"\nc_t = \"5.1 mm\"\n", "f_t = 0.4\nc = \"6.1 mm\"\n"})
      CHECK(says(pipe + none, words));
  }
}
