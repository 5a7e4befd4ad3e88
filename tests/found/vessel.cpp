// Regression tests of vessels: faults found in use.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string water = "p = \"0 MPa\"\nrho = \"1000 kg/m^3\"\nc = \"0 mm\"\nmeasured = \"mean\"\n";

std::string sphere(const std::string& R, const std::string& h_l, const std::string& more = "") {
  return water + "R = \"" + R + "\"\nh_l = \"" + h_l + "\"\nsigma_adm = \"140 MPa\"\nz_l = 1\nz_c = 1" + more;
}

/// A sphere of 6 m from its bottom up to a ring at this angle, by points, full of water.
std::string bowl(double ring) {
  std::string points;
  const int count = 40;
  for (int i = 0; i <= count; ++i) {
    const double phi = ring / 180.0 * std::numbers::pi * i / count;
    const double r = 6.0 * std::sin(phi), z = 6.0 * (1.0 - std::cos(phi));
    points += (i == 0 ? "[[\"" : ", [\"") + std::to_string(r) + " m\", \"" + std::to_string(z) + " m\"]";
  }
  return "points = " + points + "]\np = \"0 MPa\"\nrho = \"1000 kg/m^3\"\nh_l = \"12 m\"\nsigma_adm = \"140 MPa\"";
}

double per_mille(double value, double expected) { return 1000.0 * std::abs(value / expected - 1.0); }

/// Whether a wall of the least thickness is used to the full.
bool just_enough(const char* calculator, const std::string& lines) {
  const double least = ExampleStep(calculator, lines)("delta_min");
  std::ostringstream delta;
  delta << std::setprecision(16) << least << " m";
  const ExampleStep step(calculator, lines + "\ndelta = \"" + delta.str() + "\"");
  return std::abs(step("u_v") - 1.0) < 1e-9;
}

}  // namespace

TEST_SUITE("found vessel") {
  TEST_CASE("A15: a sphere with liquid that hangs from a high ring is in compression below it, and may buckle") {
    const std::string hung = sphere("6 m", "12 m", "\nphi_s = \"60 deg\"");
    CHECK(mode_with("vessel.sphere", hung, "buckling") == "not-judged");
    CHECK(mode_with("vessel.sphere", hung, "strength") == "pass");
    CHECK(mode_with("vessel.sphere", sphere("6 m", "12 m", "\nphi_s = \"90 deg\""), "buckling") == "none");
    CHECK(mode_with("vessel.sphere", hung + "\np = \"1 MPa\"", "buckling") == "none");
    CHECK(mode_with("vessel.sphere", sphere("6 m", "6 m", "\nphi_s = \"90 deg\""), "buckling") == "not-judged");
    CHECK(mode_with("vessel.sphere", "", "buckling") == "none");
    CHECK(mode_with("vessel.sphere", "", "strength") == "pass");
    CHECK(mode_with("vessel.sphere", "", "vacuum") == "open");
  }

  TEST_CASE("A15: the same shell by points") {
    CHECK(mode_with("vessel.shell", bowl(120.0), "buckling") == "not-judged");
    CHECK(mode_with("vessel.shell", bowl(90.0), "buckling") == "none");
  }

  TEST_CASE("A15: knuckles of flat heads are assessed, those of deep ones are not in compression") {
    CHECK(mode_with("vessel.ellipsoid", "delta = \"2.4 mm\"\nmeasured = \"mean\"", "knuckle") == "pass");
    CHECK(mode_with("vessel.ellipsoid", "delta = \"2.3 mm\"\nmeasured = \"mean\"", "knuckle") == "not-covered");
    CHECK(mode_with("vessel.ellipsoid", "b = \"500 mm\"", "knuckle") == "none");
  }

  TEST_CASE("A16: the edge of the liquid governs, and the thickness is sufficient for it") {
    const std::string lines = sphere("5 m", "1.354 m", "\nz_l = 0.7\nz_c = 0.7\nsigma_adm = \"10 MPa\"");
    const ExampleStep given("vessel.sphere", lines + "\ndelta = \"6 mm\"");
    CHECK(per_mille(given("sigma_v"), 8.316e6) < 0.1);
    CHECK(per_mille(given("delta_min"), 4.990e-3) < 0.1);
    CHECK(std::abs(given("phi") - std::acos(1.354 / 5.0 - 1.0)) < 1e-6);
    CHECK(given.verdict("u_v") == account::State::pass);
    CHECK(ExampleStep("vessel.sphere", lines + "\ndelta = \"4.98 mm\"").verdict("u_v") == account::State::fail);
    CHECK(given.project().value("sphere.delta_L") == nullptr);  // Lamé knows nothing of the weight on the ring
  }

  TEST_CASE("A16: the minimum thickness with liquid is just strong enough, wherever its edge lies") {
    for (const char* h_l : {"0.3 m", "1.354 m", "3.21 m", "5 m", "7.77 m", "9.9 m"}) {
      CAPTURE(std::string(h_l));
      CHECK(just_enough("vessel.sphere", sphere("5 m", h_l)));
    }
    for (const char* h_l : {"0.3 m", "1.01 m", "1.7 m"}) {
      CAPTURE(std::string(h_l));
      CHECK(just_enough("vessel.cone", "p = \"0 MPa\"\nh_l = \"" + std::string(h_l) + "\""));
    }
  }

  TEST_CASE("cycles of the pressure are fatigue; rings without data are not assessed") {
    CHECK(mode_with("vessel.cylinder", "", "fatigue") == "open");
    CHECK(mode_with("vessel.cylinder", "", "rings") == "none");
    CHECK(mode_with("vessel.cylinder", "ends = \"ringed\"", "rings") == "not-judged");
  }

  TEST_CASE("a head carries the liquid of its vessel, unless it is the upper one") {
    const std::string shell =
        "[shell]\ncalculator = \"vessel.cylinder\"\np = \"0.2 MPa\"\nR = \"3 m\"\nrho = \"1000 kg/m^3\"\n"
        "h_l = \"15 m\"\ndelta = \"12 mm\"\nsigma_adm = \"100 MPa\"\n[head]\ndelta = \"20 mm\"\n"
        "sigma_adm = \"100 MPa\"\n";
    const auto strength = [&](const std::string& head) {
      return mode_of(solved_as_found(shell + head), "head", "strength");
    };
    const std::string sphere = "calculator = \"vessel.sphere\"\np = \"=shell.p\"\nR = \"=shell.R\"\n";
    const std::string ellipsoid =
        "calculator = \"vessel.ellipsoid\"\np = \"=shell.p\"\na = \"=shell.R\"\nb = \"1.5 m\"\n";
    for (const std::string& head : {sphere, ellipsoid}) {
      CHECK(strength(head) == "not-judged");
      CHECK(strength(head + "because.p = \"upper head, gas only\"\n") == "pass");
      std::string with_liquid = head;
      with_liquid.replace(with_liquid.find("shell.p"), 7, "shell.p_i");
      CHECK(strength(with_liquid) == "pass");
    }
  }

  TEST_CASE("a head has the pressure of the shell with its radius") {
    const auto strength = [](const std::string& p, const std::string& a, const std::string& more = "") {
      return mode_of(solved_as_found("[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\n"
                                     "delta = \"10 mm\"\nsigma_adm = \"140 MPa\"\n[head]\ncalculator = "
                                     "\"vessel.ellipsoid\"\nb = \"300 mm\"\ndelta = \"7 mm\"\nsigma_adm = "
                                     "\"140 MPa\"\np = \"" +
                                     p + "\"\na = \"" + a + "\"\n" + more),
                     "head", "strength");
    };
    CHECK(strength("1 MPa", "600 mm") == "pass");
    CHECK(strength("0.1 MPa", "600 mm") == "not-judged");
    CHECK(strength("0.1 MPa", "600 mm", "because.p = \"of the jacket\"\n") == "pass");
    CHECK(strength("0.1 MPa", "500 mm") == "pass");
  }

  TEST_CASE("no head closes an open pipe") {
    const auto error = [](const std::string& ends) {
      return first_error_of("[shell]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nends = \"" +
                            ends +
                            "\"\ndelta = \"10 mm\"\nsigma_adm = \"100 MPa\"\n[head]\ncalculator = "
                            "\"vessel.ellipsoid\"\np = \"=shell.p\"\na = \"=shell.R\"\nb = \"300 mm\"\n"
                            "sigma_adm = \"100 MPa\"\n");
    };
    CHECK(error("open").find("'shell' has ends = \"open\"") != std::string::npos);
    CHECK(error("closed") == "");
  }

  TEST_CASE("a diameter, and other letters for the wall, name the input that is meant") {
    const auto said = [](const char* line) {
      return Solved("[v]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nsigma_adm = \"140 MPa\"\n" +
                    std::string(line) + "\n")
          .errors();
    };
    CHECK(contains(said("D = \"1200 mm\""), "v.D: 'D' is not a valid key here = write the radius: R = \"=1200 mm/2\""));
    CHECK(contains(said("d = \"1.2\""), "write the radius: R = \"... mm\""));
    for (const char* const wall : {"t = \"8 mm\"", "s = \"8 mm\"", "e = \"8 mm\""})
      CHECK(contains(said(wall), "did you mean 'delta' (nominal wall thickness)?"));
  }

  TEST_CASE("of a torus, the radius of the ring or of the tube is named, and no strength") {
    const auto said = [](const char* line) {
      return Solved(
                 "[v]\ncalculator = \"vessel.torus\"\np = \"1 MPa\"\nR_0 = \"1 m\"\nr = \"200 mm\"\nsigma_adm = \"140 "
                 "MPa\"\n" +
                 std::string(line) + "\n")
          .errors();
    };
    const std::string both = said("D = \"2 m\"");
    CHECK_MESSAGE(contains(both, "r = \"=2 m/2\" (radius of the tube"), both);
    CHECK_MESSAGE(contains(both, "R_0 = \"=2 m/2\" (radius of the ring"), both);
    CHECK(contains(said("d = \"400 mm\""), "write the radius: r = \"=400 mm/2\""));
    CHECK(contains(said("r_i = \"200 mm\""), "write r and measured = \"inner\""));
    for (const char* const radius : {"R = \"1 m\"", "R_m = \"1 m\"", "r_k = \"1 m\""}) {
      CHECK_MESSAGE(contains(said(radius), "'R_0' (radius of the ring"), said(radius));
      CHECK_MESSAGE(!contains(said(radius), "R_e"), said(radius));
    }
  }
}
