// Regression tests of belts: faults found in use.
#include "calculators/belt/v/sizing.hpp"
#include "tests/found/modes.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string narrow =
    "section = \"SPZ\"\nduty = \nmotor = \nh_day = \nK_A = 1.2\nP = \"5 kW\"\nd_1 = \"90 mm\"\nd_2 = \"180 mm\"\nL = "
    "\n";

std::string course(const std::string& lines) {
  return "L = \nS_adm = \nmu = \n" + lines +
         "\npulleys = [{ x = \"0 mm\", y = \"0 mm\", d = \"160 mm\" }, "
         "{ x = \"500 mm\", y = \"0 mm\", d = \"160 mm\", P = \"5 kW\" }]";
}

/// Sections of the basis Optibelt: height of the groove above the datum diameter, datum width; mm.
struct Groove {
  double h_a, w_d;
};
Groove groove_of(belt::SectionWord section) {
  switch (section) {
    case belt::SectionWord::SPZ:
      return {2.0, 8.5};
    case belt::SectionWord::SPA:
      return {2.75, 11.0};
    case belt::SectionWord::SPB:
      return {3.5, 14.0};
    case belt::SectionWord::SPC:
      return {4.8, 19.0};
    default:
      return {};
  }
}

}  // namespace

TEST_SUITE("found belt") {
  TEST_CASE("A20: rims of 94 and 184 mm need 139 mm, and clearance for belt installation in addition") {
    CHECK(mode_with("belt.v", narrow + "a = \"136 mm\"", "room") == "fail");
    CHECK(mode_with("belt.v", narrow + "a = \"138.9 mm\"", "room") == "fail");
    CHECK(mode_with("belt.v", narrow + "a = \"139.1 mm\"", "room") == "pass");
    CHECK(mode_with("belt.v", narrow + "a = \"139.1 mm\"", "fitting") == "fail");
    CHECK(mode_with("belt.v", narrow + "a = \"400 mm\"", "fitting") == "pass");
  }

  TEST_CASE("A20: the best drive of a search keeps its rims apart, and can be fitted") {
    NoTrace trace;
    int found = 0;
    for (const double P : {1.0, 5.0, 20.0}) {
      for (const double a : {120.0, 150.0, 200.0, 300.0}) {
        for (const double i : {1.0, 1.5, 2.0, 3.0}) {
          belt::VSizing::Input in;
          in.basis = belt::Basis::optibelt, in.K_A = 1.2;
          in.P = P * kW, in.n_1 = 1460.0 * rpm, in.n_2_set = 1460.0 / i * rpm, in.a_set = a * mm;
          const auto r = belt::VSizing::evaluate(in, trace);
          const Groove groove = groove_of(r.section);
          if (!(r.drives > 0.0) || groove.h_a == 0.0) continue;
          const double room = r.a / mm - (r.d_1 / mm + r.d_2 / mm) / 2.0 - 2.0 * groove.h_a;
          CHECK(room - (0.009 * (r.L / mm) + 2.0 * groove.w_d) > -1e-9);
          ++found;
        }
      }
    }
    CHECK(found > 5);
  }

  TEST_CASE("A21: pulleys and lengths that are in no list are not covered, nor 58 belts side by side") {
    const std::string odd = "d_1 = \"283 mm\"\nd_2 = \"507 mm\"\nL = \na = \"1400 mm\"";
    CHECK(ExampleStep("belt.v", odd)("L") == doctest::Approx(4.0499).epsilon(1e-4));
    CHECK(mode_with("belt.v", odd, "sold_pulleys") == "not-covered");
    CHECK(mode_with("belt.v", odd, "sold_belts") == "open");  // a length is not chosen yet
    CHECK(mode_with("belt.v", "L = \"4049.9 mm\"", "sold_belts") == "not-covered");
    CHECK(mode_with("belt.v", "", "sold_belts") == "pass");
    CHECK(mode_with("belt.v", "", "sold_pulleys") == "pass");
    CHECK(mode_with("belt.v", narrow + "P = \"110 kW\"\nL = \"1250 mm\"", "sharing") == "not-covered");
    CHECK(mode_with("belt.v", "", "sharing") == "pass");
  }

  TEST_CASE("A22: initial tension without friction does not assess slip, and strength needs the allowable tension") {
    CHECK(mode_with("belt.course", course("S_0 = \"1 N\""), "grip") == "not-judged");
    CHECK(mode_with("belt.course", course("S_0 = \"1 N\"\nmu = 0.5"), "grip") == "fail");
    CHECK(mode_with("belt.course", course("mu = 0.5"), "grip") == "pass");
    CHECK(mode_with("belt.course", course("mu = 0.5"), "strength") == "not-judged");
    CHECK(mode_with("belt.course", course("mu = 0.5\nS_adm = \"5 kN\""), "strength") == "pass");
  }

  TEST_CASE("A22: a thick belt on a small pulley is assessed by its bending, and never without it") {
    const std::string thick = "delta = \"19 mm\"\nkind = \"conventional\"\nsigma_adm = \"3 MPa\"\n";
    CHECK(mode_with("belt.flat", thick + "E_b = ", "bending") == "not-judged");
    CHECK(mode_with("belt.flat", thick + "E_b = \"50 MPa\"", "bending") == "fail");  // 50 * 19/200 = 4.75 MPa
    CHECK(mode_with("belt.flat", "", "bending") == "pass");
  }

  TEST_CASE("A22: two spans cannot pass through 1 mm") {
    const std::string crossed = "arrangement = \"crossed\"\nE_b = \nb = \"60 mm\"\n";
    CHECK(mode_with("belt.flat", crossed + "a = \"351 mm\"", "room") == "fail");
    CHECK(mode_with("belt.flat", crossed + "a = \"1200 mm\"", "room") == "pass");
    CHECK(mode_with("belt.flat", crossed + "a = \"1200 mm\"", "twist") == "pass");
    CHECK(mode_with("belt.flat", crossed + "a = \"1190 mm\"", "twist") == "not-covered");
    CHECK(mode_with("belt.flat", "", "room") == "pass");
  }

  TEST_CASE("belts of two pulleys do not pass through each other") {
    CHECK(mode_with("belt.grooved", "a = \"121 mm\"", "room") == "fail");
    CHECK(mode_with("belt.grooved", "", "room") == "pass");
    CHECK(mode_with("belt.synchronous", "a = \nz_B = 51", "room") == "fail");
    CHECK(mode_with("belt.synchronous", "", "room") == "pass");
  }

  TEST_CASE("a synchronous belt is not narrower than those of its section") {
    CHECK(mode_with("belt.synchronous", "P = \"0.1 kW\"\nb = \"12.7 mm\"", "width") == "not-covered");
    CHECK(mode_with("belt.synchronous", "P = \"0.1 kW\"\nb = \"25.4 mm\"", "width") == "pass");
    CHECK(ExampleStep("belt.synchronous", "P = \"0.1 kW\"\nb = \"?\"")("b_s") == doctest::Approx(0.0191));
  }

  TEST_CASE("a synchronous belt has one of the widths that its section is made in") {
    CHECK(mode_with("belt.synchronous", "P = \"0.1 kW\"\nb = \"40 mm\"", "power") == "not-judged");
    CHECK(mode_with("belt.synchronous", "P = \"0.1 kW\"\nb = \"38 mm\"", "power") == "pass");  // 38.1 mm
    CHECK(mode_with("belt.synchronous", "P = \"0.1 kW\"\nb = \"40 mm\"\nbecause.b = \"cut to width\"", "power") ==
          "pass");
  }

  TEST_CASE("a curvilinear pitch, a pull beyond any belt and a wide or short synchronous belt drive need a reason") {
    const std::string own = "synchronous_belt = \nb_0 = \"76.2 mm\"\nm_0 = \"0.447 kg/m\"\n";
    CHECK(mode_with("belt.synchronous", own + "F_a = \"2091 N\"\np_b = \"12.7 mm\"", "power") == "pass");
    CHECK(mode_with("belt.synchronous", own + "F_a = \"2091 N\"\np_b = \"14 mm\"", "power") == "not-judged");
    CHECK(mode_with("belt.synchronous", own + "F_a = \"9000 N\"\np_b = \"12.7 mm\"", "power") == "not-judged");
    CHECK(mode_with("belt.synchronous", "z_1 = 20\nz_2 = 160\na = \"1 m\"", "room") == "not-judged");
  }

  TEST_CASE("a rating above what a rib or round belt can carry needs a reason") {
    const std::string ribs = "d_b = \nrho = \nsigma_adm = \nE_b = \nphi = \nd_min = \nribbed_belt = \"PK\"\n";
    CHECK(mode_with("belt.grooved", ribs + "P_R = \"4 kW\"", "rating") == "not-judged");
    CHECK(mode_with("belt.grooved", ribs + "P_R = \"0.5 kW\"", "rating") == "pass");
    CHECK(mode_with("belt.grooved", ribs + "P_R = \"0.5 kW\"\nphi = \"20 deg\"", "typed_values") == "not-judged");
    CHECK(mode_with("belt.grooved", ribs + "P_R = \"0.5 kW\"\nphi = \"40 deg\"", "grip") == "pass");
  }

  TEST_CASE("a round belt with an allowable tension is bent, too") {
    CHECK(mode_with("belt.grooved", "sigma_adm = \nE_b = \nS_adm = \"100 N\"", "bending") == "not-judged");
    CHECK(mode_with("belt.grooved", "sigma_adm = \nS_adm = \"100 N\"", "bending") == "pass");
    CHECK(mode_with("belt.grooved", "d_min = \"20 mm\"", "pulley") == "not-judged");
    CHECK(mode_with("belt.grooved", "d_min = \"40 mm\"", "pulley") == "pass");
    CHECK(mode_with("belt.grooved", "v_max = \"100 m/s\"", "speed") == "not-judged");
  }

  TEST_CASE("the life of a flat belt needs a required life, and a plausible S-N curve") {
    const std::string life = "m_f = 6\nL_req = \"100 h\"\n";
    CHECK(mode_with("belt.flat", "sigma_f = \"9 MPa\"\nm_f = 6", "fatigue") == "not-judged");
    CHECK(mode_with("belt.flat", life + "sigma_f = \"9 MPa\"", "fatigue") == "pass");
    CHECK(mode_with("belt.flat", life + "sigma_f = \"40 MPa\"", "fatigue") == "not-judged");
    CHECK(mode_with("belt.flat", "", "fatigue") == "open");
  }

  TEST_CASE("a pulley below the minimum diameter of its section fails, one above the rated ones is not covered") {
    CHECK(mode_with("belt.v", "d_1 = \"139 mm\"", "pulley") == "fail");
    CHECK(mode_with("belt.v", "d_1 = \"140 mm\"", "pulley") == "pass");
    CHECK(mode_with("belt.v", "d_1 = \"401 mm\"\nL = \"4000 mm\"\nd_2 = \"800 mm\"", "pulley") == "not-covered");
  }
}
