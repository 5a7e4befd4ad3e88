// Each condition of the rule for efficiencies that multiply the useful output.
#include "lib/project/references/drives/efficiencies.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string values =
    "[values]\neta = 0.7\neta_gear = 0.9\neta_seam = 0.85\nF = \"9 kN\"\nm = \"900 kg\"\nv = \"1 m/s\"\np = \"11 "
    "MPa\"\nQ = \"0.0003 m^3/s\"\nP_motor = \"7.5 kW\"\nT_drum = \"900 N*m\"\nT_motor = \"90 N*m\"\ni = 12\npitch = "
    "\"8 mm\"\nr = \"80 mm\"\n\n";

std::string of_power(const std::string& P, const std::string& title = "Drive") {
  INFO(P << " " << title);
  return inputs_found(&project::efficiencies_of_outputs, "[project]\ntitle = \"" + title + "\"\n\n" + values +
                                                             example_of("chain.roller", "P = \"" + P + "\""));
}

std::string of_torque(const std::string& T) {
  INFO(T);
  return inputs_found(
      &project::efficiencies_of_outputs,
      values + "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\nT = \"" + T + "\"\n");
}

}  // namespace

TEST_SUITE("project: efficiencies of outputs") {
  TEST_CASE("powers") {
    CHECK(of_power("=values.F*values.v*values.eta") == "P");
    CHECK(of_power("=values.m*9.81 m/s^2*values.v*values.eta_gear") == "P");
    CHECK(of_power("=values.F*values.v/values.eta").empty());
    CHECK(of_power("=values.F*values.v").empty());
    CHECK(of_power("=values.P_motor*values.eta").empty());
    CHECK(of_power("=5.5 kW*values.eta").empty());
    CHECK(of_power("=values.F*values.v*values.eta", "Drive of a turbine").empty());
  }

  TEST_CASE("a flow under pressure is the output of a pump, and the input of a hydraulic motor") {
    CHECK(of_power("=values.p*values.Q*values.eta", "Drive of a pump") == "P");
    CHECK(of_power("=values.eta*0.0003 m^3/s*11 MPa", "Drive of a pump") == "P");
    CHECK(of_power("=values.p*values.Q*values.eta", "Drive by a hydraulic motor").empty());
    CHECK(of_power("=values.p*values.Q/values.eta", "Drive of a pump").empty());
  }

  TEST_CASE("torques of screws and in front of a ratio") {
    CHECK(of_torque("=values.eta*values.F*values.pitch/(2*pi)") == "T");
    CHECK(of_torque("=values.F*values.pitch/(2*pi)/values.eta").empty());
    CHECK(of_torque("=values.F*values.r*values.eta").empty());  // the force may drive
    CHECK(of_torque("=values.T_drum/values.i*values.eta_gear") == "T");
    CHECK(of_torque("=values.T_drum/values.i/values.eta_gear").empty());
    CHECK(of_torque("=values.T_motor*values.i*values.eta_gear").empty());
  }
}
