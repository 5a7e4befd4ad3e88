// Regression tests of steps of one body that state different things about it.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string crankshaft(const std::string& torsion, const std::string& end) {
  return "[crankshaft]\ncalculator = \"shaft.torsion\"\nbody = \"crankshaft\"\ntau_adm = \"30 MPa\"\n" + torsion +
         "\n[crank_end]\ncalculator = \"shaft.overhung\"\nbody = \"crankshaft\"\nF = \"9 kN\"\na = \"40 mm\"\n"
         "sigma_adm = \"60 MPa\"\n" +
         end + "\n";
}

std::string arm(const std::string& member, const std::string& column) {
  return "[arm]\ncalculator = \"link.member\"\nbody = \"arm\"\nN = \"-20 kN\"\nV = \"3 kN\"\nM_b = \"60 N*m\"\nh = "
         "\"60 mm\"\nb = \"40 mm\"\nmaterial = \"S355\"\nmethod = \"johnson\"\nn_st = 3\nS = 1.5\n" +
         member +
         "\n[arm2]\ncalculator = \"column.buckling\"\nbody = \"arm\"\nh = \"60 mm\"\nb = \"40 mm\"\nmethod = "
         "\"johnson\"\nn_st = 2\n" +
         column + "\n";
}
const std::string pinned = "ends = \"pinned_pinned\"\nl = \"900 mm\"", steel = "\nmaterial = \"S355\"\n";

std::string state_of(const std::string& text, const char* step, const char* id) {
  return mode_of(solved_as_found(text), step, id);
}

std::string wall(const std::string& name, const std::string& lines) {
  return "[" + name + "]\np = \"=values.p\"\nmeasured = \"inner\"\nsigma_adm = \"170 MPa\"\ndelta = \"7 mm\"\n" +
         lines + "\n";
}
std::string vessel(const std::string& shell, const std::string& head, bool head_first = false) {
  const std::string a = wall("shell", "calculator = \"vessel.cylinder\"\nR = \"600 mm\"\n" + shell),
                    b = wall("head", "calculator = \"vessel.ellipsoid\"\na = \"600 mm\"\nb = \"300 mm\"\n" + head);
  return "[values]\np = \"1 MPa\"\n" + (head_first ? b + a : a + b);
}

}  // namespace

TEST_SUITE("found bodies") {
  TEST_CASE("all steps of a body transmit one torque, or state why not") {
    const std::string T = "T = \"300 N*m\"", less = "T = \"3 N*m\"";
    CHECK(state_of(crankshaft(T, T), "crankshaft", "yield") == "pass");
    CHECK(state_of(crankshaft(T, T), "crank_end", "yield") == "pass");
    CHECK(state_of(crankshaft(less, T), "crankshaft", "yield") == "not-judged");
    CHECK(state_of(crankshaft(less, T), "crank_end", "yield") == "pass");
    CHECK(state_of(crankshaft(T, less), "crank_end", "yield") == "not-judged");
    CHECK(state_of(crankshaft(T, "T = \"0 N*m\""), "crank_end", "yield") == "not-judged");
    CHECK(state_of(crankshaft(T, less + "\nbecause.T = \"behind the eccentric\""), "crank_end", "yield") == "pass");
  }

  TEST_CASE("the torque of a body is compared with its factor, also if it is that of a power") {
    const std::string of_power = "P = \"31.41593 kW\"\nn = \"1000 rpm\"";  // 300 N m
    CHECK(state_of(crankshaft("T = \"300 N*m\"", of_power), "crank_end", "yield") == "pass");
    CHECK(state_of(crankshaft("T = \"300 N*m\"\nK_A = 1.5", "T = \"450 N*m\""), "crank_end", "yield") == "pass");
    CHECK(state_of(crankshaft("T = \"300 N*m\"\nK_A = 1.5", of_power), "crank_end", "yield") == "not-judged");
    CHECK(state_of(crankshaft(of_power, "T = \"300 N*m\"\nK_A = 1.5"), "crankshaft", "yield") == "not-judged");
  }

  TEST_CASE("a body is bored in all its steps, or in none") {
    const std::string T = "T = \"300 N*m\"\n";
    CHECK(first_error_of(crankshaft(T + "chi = 0.5", T)).find("needs a single bore") != std::string::npos);
    CHECK(first_error_of(crankshaft(T + "chi = 0.5", T + "chi = 0.5")).empty());
    CHECK(first_error_of(crankshaft(T + "d_bore = \"20 mm\"", T + "d_bore = \"20 mm\"")).empty());
  }

  TEST_CASE("a bar has one length, one compression and one set of end conditions") {
    const std::string same = pinned + "\nP = \"20 kN\"" + steel;
    CHECK(state_of(arm(pinned, same), "arm2", "buckling") == "pass");
    const std::string shorter = "ends = \"pinned_pinned\"\nl = \"100 mm\"\nP = \"20 kN\"" + steel;
    CHECK(state_of(arm(pinned, shorter), "arm2", "buckling") == "not-judged");
    CHECK(state_of(arm(pinned, shorter + "because.l = \"between the braces\""), "arm2", "buckling") == "pass");
    const std::string fixed = "ends = \"fixed_fixed\"\nl = \"900 mm\"\nP = \"20 kN\"" + steel;
    CHECK(state_of(arm(pinned, fixed), "arm2", "buckling") == "not-judged");
    // A third step with the ends of the second confirms neither.
    const std::string column = arm(pinned, fixed).substr(arm(pinned, "").find("[arm2]"));
    const std::string third = column.substr(0, 4) + "3" + column.substr(5);
    CHECK(state_of(arm(pinned, fixed) + third, "arm2", "buckling") == "not-judged");
    CHECK(state_of(arm(pinned, fixed) + third, "arm3", "buckling") == "not-judged");
    CHECK(state_of(arm(pinned, pinned + "\nP = \"12 kN\"" + steel), "arm2", "buckling") == "not-judged");
    CHECK(state_of(arm(pinned, pinned + "\nN = \"-20 kN\"" + steel), "arm2", "buckling") == "pass");
    CHECK(state_of(arm(pinned, pinned + "\nN = \"15 kN\"\nn_t = 1.5" + steel), "arm2", "tension") == "pass");
  }

  TEST_CASE("a body has one strength and one metal") {
    const std::string typed = pinned + "\nP = \"20 kN\"\nE = \"210 GPa\"\nR_e = ";
    CHECK(state_of(arm(pinned, typed + "\"345 MPa\""), "arm2", "buckling") == "pass");
    CHECK(state_of(arm(pinned, typed + "\"700 MPa\""), "arm2", "buckling") == "not-judged");
    const std::string aluminium = pinned + "\nP = \"20 kN\"\nE = \"70 GPa\"\nR_e = \"200 MPa\"";
    CHECK(first_error_of(arm(pinned, aluminium)).find("contradicts") != std::string::npos);
  }

  TEST_CASE("an unnecessary reason for a value of a body is an error") {
    const std::string T = "T = \"300 N*m\"";
    CHECK(first_error_of(crankshaft(T, T + "\nbecause.T = \"rated\"")).find("not needed") != std::string::npos);
  }

  TEST_CASE("walls of one vessel have one corrosion allowance") {
    const std::string c = "c = \"1 mm\"";
    for (const bool head_first : {false, true}) {
      CHECK(state_of(vessel(c, c, head_first), "head", "strength") == "pass");
      CHECK(state_of(vessel(c, "", head_first), "head", "strength") == "not-judged");
      CHECK(state_of(vessel(c, "because.c = \"clad\"", head_first), "head", "strength") == "pass");
    }
    const std::string apart =
        wall("small", "calculator = \"vessel.sphere\"\nR = \"200 mm\"\nbecause.R = \"another vessel\"");
    CHECK(state_of(vessel(c, c) + apart, "small", "strength") == "pass");
  }
}
