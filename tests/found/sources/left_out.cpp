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
    CHECK(state(shaft_beside("T_test = \"900 N*m\"")) == "not-judged");
    CHECK(state(shaft_beside("T_t = \"900 N*m\"")) == "not-judged");
    CHECK(state(shaft_beside("T_idle = \"90 N*m\"")) == "pass");
    CHECK(state(shaft_beside("T_of_the_screws = \"900 N*m\"")) == "pass");
    CHECK(state(shaft_beside("T_start = \"1.2 kJ\"")) == "pass");
    CHECK(state(shaft_beside("F_start = \"900 N\"")) == "pass");
    CHECK(state(shaft_beside("T_of_another_machine = \"90 kN*m\"")) == "pass");
  }

  TEST_CASE("a factor of [values] under a name that no step has") {
    const auto state = [](const std::string& text) { return mode_of(solved_as_found(text), "shaft", "yield"); };
    CHECK(state(shaft_beside("K_A = 1.4")) == "not-judged");
    CHECK(state(shaft_beside("K_A = 1.4", "K_A = 1.5\n")) == "pass");
    CHECK(state(shaft_beside("K_A = 1.4", "K_A = \"=values.K_A\"\n")) == "pass");
    CHECK(state(shaft_beside("K_A = 1.4", "because.K_A = \"T holds it\"\n")) == "pass");
    CHECK(state(shaft_beside("teeth = 17")) == "pass");
  }

  TEST_CASE("the application factor of [values] under the symbol of another standard") {
    const auto state = [](const std::string& text) { return mode_of(solved_as_found(text), "shaft", "yield"); };
    for (const std::string name :
         {"K_o", "K_O", "k_A", "c_B", "f_B", "service_factor", "application_factor", "overload_factor"})
      CHECK_MESSAGE(state(shaft_beside(name + " = 1.4")) == "not-judged", name);
    CHECK(state(shaft_beside("K_o = 1.4", "K_A = 1.5\n")) == "pass");
    CHECK(state(shaft_beside("K_o = 1.4", "because.K_A = \"T holds it\"\n")) == "pass");
    CHECK(state(shaft_beside("K_oil = 1.4")) == "pass");
  }

  TEST_CASE("a higher safety factor of [values] than that of a chain") {
    const std::string chain =
        "[chain]\ncalculator = \"chain.inverted_tooth\"\np = \"12.7 mm\"\nb = \"50 mm\"\nz_1 = 25\nz_2 = 75\nn_1 = "
        "\"1000 rpm\"\nP = \"15 kW\"\nK_A = 1.4\na = \"500 mm\"\nP_b = \"5 kW\"\nq = \"2.5 kg/m\"\nF_u = \"54 "
        "kN\"\nS_min = 8\nv_max = \"25 m/s\"\n";
    const auto state = [&](const std::string& values, const std::string& more = "") {
      return mode_of(solved_as_found("[values]\n" + values + "\n\n" + chain + more), "chain", "breaking");
    };
    CHECK(state("S_min = 8") == "pass");
    CHECK(state("S_min = 15") == "not-judged");
    CHECK(state("S_min = 15", "because.S_min = \"of the hoist only\"\n") == "pass");
  }

  TEST_CASE("a strength of [values] is not the load of a stress") {
    const std::string cycle =
        "[values]\nR_m_of_the_bolts = \"800 MPa\"\n\n[life]\ncalculator = \"fatigue.cycle\"\n"
        "sigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"\nS_D = 1.5\nS_F = 1.5\nmaterial = "
        "\"C45E\"\nd_h = \"40 mm\"\nsigma_D = \"300 MPa\"\n";
    const std::string without = cycle.substr(cycle.find("[life]"));
    CHECK(mode_of(solved_as_found(cycle), "life", "fatigue") == mode_of(solved_as_found(without), "life", "fatigue"));
  }

  TEST_CASE("a load of [values] next to a drive whose load is another quantity") {
    const std::string belt =
        "[b]\ncalculator = \"belt.synchronous\"\nsynchronous_belt = \"H\"\nK_A = 1.5\nz_1 = 20\nz_2 = 40\n"
        "n_1 = \"1450 rpm\"\na = \"500 mm\"\nb = \"50.8 mm\"\n";
    const auto state = [&](const std::string& values, const std::string& load) {
      return mode_of(solved_as_found("[values]\n" + values + "\n\n" + belt + load + "\n"), "b", "power");
    };
    const std::string P = "P = \"4 kW\"", T_1 = "T_1 = \"26.34 N*m\"";  // 26.34 N m at 1450 rpm
    const std::string alone = state("note = 1", P);
    CHECK(alone != "not-judged");
    for (const char* const fits : {"T_1 = \"26.3 N*m\"", "T_2 = \"52.7 N*m\"", "T_max = \"50 N*m\""})
      CHECK(state(fits, P) == alone);
    for (const char* const more : {"T_1 = \"60 N*m\"", "T_2 = \"80 N*m\"", "T = \"60 N*m\"", "T_peak = \"200 N*m\""})
      CHECK(state(more, P) == "not-judged");
    CHECK(state("T_1 = \"60 N*m\"", P + "\nbecause.P = \"a second belt takes the rest\"") == alone);
    CHECK(state("P = \"4 kW\"", T_1) == alone);
    CHECK(state("P = \"8 kW\"", T_1) == "not-judged");
  }

  TEST_CASE("a component of [values] that a resultant does not include") {
    const auto state = [](const std::string& name, const std::string& lines) {
      return mode_of(solved_as_found("[values]\n" + name +
                                     " = \"900 N\"\n\n[f]\ncalculator = \"dynamics.force\"\n"
                                     "m = \"3 kg\"\nx = \"3 m*sin(pi*t/(1 s))\"\nt = \"0.2 s\"\n" +
                                     lines),
                     "f", "stated_values");
    };
    for (const std::string name : {"F_x", "F_y", "F_z"}) {
      CHECK_MESSAGE(state(name, "") == "not-judged", name);
      CHECK_MESSAGE(state(name, name + " = \"=values." + name + "\"\n") == "none", name);
      CHECK_MESSAGE(state(name, "because." + name + " = \"of the lever\"\n") == "none", name);
    }
  }

  TEST_CASE("an application factor that is divided out of a rated load of [values] and applied again") {
    const auto state = [](const std::string& P, const std::string& K_A) {
      return mode_of(solved_as_found("[values]\nP = \"4 kW\"\nP_design = \"6 kW\"\nK_A = 1.5\n\n[b]\ncalculator = "
                                     "\"belt.synchronous\"\nsynchronous_belt = \"H\"\nz_1 = 20\nz_2 = 40\nn_1 = "
                                     "\"1450 rpm\"\na = \"500 mm\"\nb = \"50.8 mm\"\nP = \"" +
                                     P + "\"\nK_A = " + K_A + "\n"),
                     "b", "power");
    };
    CHECK(state("=values.P", "\"=values.K_A\"") != "not-judged");
    CHECK(state("=values.P_design/values.K_A", "\"=values.K_A\"") != "not-judged");
    CHECK(state("=values.P/values.K_A", "\"=values.K_A\"") == "not-judged");
    CHECK(state("=values.P/values.K_A", "1") == "not-judged");
    CHECK(state("=values.P/1.5", "1.5") == "not-judged");
  }
}
