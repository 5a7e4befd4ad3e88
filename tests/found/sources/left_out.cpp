// Regression tests of loads in [values] that act on nothing.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string shaft_beside(const std::string& values, const std::string& lines = "") {
  return "[values]\n" + values +
         "\n[shaft]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n" + lines;
}

}  // namespace

TEST_SUITE("found loads left out") {
  TEST_CASE("a larger torque of [values] that no step takes keeps a shaft from passing") {
    const auto state = [](const std::string& text) { return mode_of(solved_as_found(text), "shaft", "yield"); };
    CHECK(state(shaft_beside("")) == "pass");
    CHECK(state(shaft_beside("T_start = \"900 N*m\"")) == "not-judged");
    CHECK(state(shaft_beside("T_start = \"-900 N*m\"")) == "not-judged");
    CHECK(state(shaft_beside("T_start = \"900 N*m\"", "because.T = \"a clutch limits it\"")) == "pass");
    CHECK(state(shaft_beside("T_idle = \"90 N*m\"")) == "pass");
    CHECK(state(shaft_beside("T_of_the_screws = \"900 N*m\"")) == "pass");
    CHECK(state(shaft_beside("T_start = \"1.2 kJ\"")) == "pass");
    CHECK(state(shaft_beside("F_start = \"900 N\"")) == "pass");
    CHECK(state(shaft_beside("T_of_another_machine = \"90 kN*m\"")) == "pass");
  }

  TEST_CASE("a factor of [values] that no step has by its name") {
    const auto state = [](const std::string& text) { return mode_of(solved_as_found(text), "shaft", "yield"); };
    CHECK(state(shaft_beside("K_A = 1.4")) == "not-judged");
    CHECK(state(shaft_beside("K_A = 1.4", "K_A = 1.5\n")) == "pass");
    CHECK(state(shaft_beside("K_A = 1.4", "K_A = \"=values.K_A\"\n")) == "pass");
    CHECK(state(shaft_beside("K_A = 1.4", "because.K_A = \"T holds it\"\n")) == "pass");
    CHECK(state(shaft_beside("teeth = 17")) == "pass");
  }

  TEST_CASE("a strength of [values] is no load of a stress") {
    const std::string cycle =
        "[values]\nR_m_of_the_bolts = \"800 MPa\"\n\n[life]\ncalculator = \"fatigue.cycle\"\n"
        "sigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"\nS_D = 1.5\nS_F = 1.5\nmaterial = "
        "\"C45E\"\nd_h = \"40 mm\"\nsigma_D = \"300 MPa\"\n";
    const std::string without = cycle.substr(cycle.find("[life]"));
    CHECK(mode_of(solved_as_found(cycle), "life", "fatigue") == mode_of(solved_as_found(without), "life", "fatigue"));
  }
}
