#include "calculators/shaft/spline.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using loadpath::test::mode_with;
using loadpath::test::rel;
using shaft::Spline;

constexpr auto solve = test::evaluated<Spline>;

/// 8x52x60 of ISO 14 with all of its flanks.
Spline::Input gear_of_lathe() {
  Spline::Input in;
  in.T = 636.61976 * N_m, in.z = 8.0, in.d_1 = 52.0 * mm, in.d_2 = 60.0 * mm, in.b = 10.0 * mm, in.l = 110.0 * mm;
  in.phi = 1.0;
  return in;
}

std::string told(const std::string& lines) {
  std::string all;
  for (const Issue& i :
       test::told("[s]\ncalculator = \"shaft.spline\"\nT = \"100 N*m\"\nl = \"50 mm\"\n" + lines).issues)
    all += i.message.text() + "\n";
  return all;
}

}  // namespace

TEST_SUITE("spline") {
  TEST_CASE("[Bhandari-9]: 20 kW at 300 rpm on 8x52x60") {
    const auto r = solve(gear_of_lathe());
    CHECK(rel(in_si(r.F_t), 22736.42) < 1e-6);
    CHECK(rel(in_si(r.p), 8 * 636.61976 / (8 * 0.110 * (0.060 * 0.060 - 0.052 * 0.052))) < 1e-12);
    CHECK(rel(in_si(r.tau), 22736.42 / (8 * 0.010 * 0.110)) < 1e-6);
  }

  TEST_CASE("[dsoftcon]: an involute spline by the factors of DIN 5466") {
    Spline::Input in;
    in.T = 2700.0 * N_m, in.z = 24.0, in.d_1 = 46.0 * mm, in.d_2 = 49.6 * mm, in.l = 15.0 * mm;
    in.phi = 1.0 / 3.0, in.k_l = 1.03;
    CHECK(rel(in_si(solve(in).p), 538.70e6) < 1e-5);
    in.T_max = -3500.0 * N_m, in.phi = 1.0 / 2.35;
    CHECK(rel(in_si(solve(in).p), 547.02e6) < 1e-5);
    CHECK_FALSE(is_set(solve(in).tau));
  }

  TEST_CASE("chamfers reduce the flank, and the centring determines how much of it carries") {
    Spline::Input in = gear_of_lathe();
    const double whole = in_si(solve(in).p);
    in.g = 0.5 * mm;
    CHECK(rel(in_si(solve(in).p), whole * 4.0 / 3.0) < 1e-12);
    in.g = 0.0 * mm, in.phi = unset<double>;
    CHECK(rel(in_si(solve(in).p), whole / 0.75) < 1e-12);
    in.centring = Spline::Centring::flanks;
    CHECK(rel(in_si(solve(in).p), whole / 0.9) < 1e-12);
  }

  TEST_CASE("designs that must not pass") {
    CHECK(mode_with("shaft.spline", "", "shaft") == "pass");
    CHECK(mode_with("shaft.spline", "T_max = \"-20 kN*m\"", "hub") == "fail");
    CHECK(mode_with("shaft.spline", "R_e_2 = ", "hub") == "not-judged");
    CHECK(mode_with("shaft.spline", "spline = \nz = 8\nd_1 = \"52 mm\"\nd_2 = \"60 mm\"", "teeth") == "not-judged");
    CHECK(mode_with("shaft.spline", "hub = \"slides\"", "wear") == "not-judged");
    CHECK(mode_with("shaft.spline", "hub = \"slides\"\np_adm_w = \"20 MPa\"", "wear") == "fail");
    CHECK(mode_with("shaft.spline", "torque = \"reversing\"", "reversal") == "not-judged");
    CHECK(mode_with("shaft.spline", "l = \"80 mm\"", "length") == "not-covered");
    CHECK(mode_with("shaft.spline", "l = \"80 mm\"\nk_l = 1.4", "length") == "none");
    CHECK(mode_with("shaft.spline", "T = \"0 N*m\"", "hub") == "none");
    // its flanks bear what twists the shaft off
    const std::string strong = "T = \"9 kN*m\"\nl = \"72 mm\"\nR_e_2 = \"370 MPa\"";
    CHECK(mode_with("shaft.spline", strong, "shaft") == "pass");
    CHECK(mode_with("shaft.spline", strong, "core") == "fail");
    CHECK(mode_with("shaft.spline", "T = \"3 kN*m\"", "core") == "pass");
    CHECK(mode_with("shaft.spline", "T = \"3 kN*m\"\nd_bore = \"46 mm\"", "core") == "fail");
    CHECK(mode_with("shaft.spline", "R_e_1 = \nS_F = \np_adm_1 = \"100 MPa\"", "core") == "not-judged");
  }

  TEST_CASE("contradictory inputs are reported") {
    CHECK(told("spline = \"8x52x61\"\n").find("no spline '8x52x61' in the tables") != std::string::npos);
    CHECK(told("z = 8.5\nd_1 = \"52 mm\"\nd_2 = \"60 mm\"\n")
              .find("the number of teeth of a spline must be an integer") != std::string::npos);
    CHECK(told("z = 8\nd_1 = \"60 mm\"\nd_2 = \"52 mm\"\n").find("d_2 must be larger than d_1") != std::string::npos);
    CHECK(told("spline = \"8x52x60\"\ng = \"2 mm\"\n").find("the chamfers must be smaller than the flank height") !=
          std::string::npos);
    CHECK(told("spline = \"8x52x60\"\nb = \"24 mm\"\n").find("the spline '8x52x60', which has 10 mm") !=
          std::string::npos);
    const std::string typed = "z = 8\nd_1 = \"52 mm\"\nd_2 = \"60 mm\"\nb = ";
    CHECK(told(typed + "\"24 mm\"\n").find("tooth thickness b leaves no hub teeth at this z and d_2; reduce b or z") !=
          std::string::npos);
    CHECK(told(typed + "\"10 mm\"\n").find("tooth thickness b leaves no hub teeth at this z and d_2; reduce b or z") ==
          std::string::npos);
    CHECK(told("spline = \"8x52x60\"\np_adm_w = \"5 MPa\"\n").find("requires a sliding hub") != std::string::npos);
    CHECK(told("spline = \"8x52x60\"\nbeta_b = 2\n").find("beta_b and beta_t") != std::string::npos);
  }
}
