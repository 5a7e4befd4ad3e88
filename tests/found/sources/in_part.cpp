// Regression tests of loads and speeds that are a part of values by a bare number, and of temperatures in expressions.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string values = "[values]\nP = \"9 kW\"\nn = \"1460 rpm\"\nT_3 = \"=values.P/values.n/3\"\n\n";

std::string key(const std::string& name, const std::string& T) {
  return "[" + name + "]\ncalculator = \"shaft.key\"\nT = \"" + T +
         "\"\ntorque = \"one_way\"\nd = \"42 mm\"\nkey = \"12x8\"\nl = \"56 mm\"\nl_n = \"70 mm\"\nR_e_1 = \"430 "
         "MPa\"\nS_F = 1.5\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n\n";
}

std::string hub(const std::string& steps) { return mode_of(solved_as_found(values + steps), "key", "hub"); }

std::string bearing(const std::string& n) {
  return mode_of(solved_as_found(values +
                                 "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6308\"\nF_r = \"1 kN\"\n"
                                 "n = \"" +
                                 n + "\"\nL_h = \"5000 h\"\ns_0 = 1.5\n"),
                 "b", "fatigue");
}

}  // namespace

TEST_SUITE("found parts of values") {
  TEST_CASE("a torque is no part of a power over a speed by a bare number") {
    CHECK(hub(key("key", "=values.P/values.n")) == "pass");
    CHECK(hub(key("key", "=1.2*values.P/values.n")) == "pass");
    CHECK(hub(key("key", "=0.9*values.P/values.n")) == "pass");  // losses
    for (const char* const T : {"=values.P/values.n/1.5", "=values.P/(2*values.n)", "=0.5*values.P/values.n"})
      CHECK_MESSAGE(hub(key("key", T)) == "not-judged", T);
    CHECK(hub(key("key", "=values.P/values.n/2") + "because.T = \"two outputs\"\n") == "pass");
    CHECK(hub(key("key", "=values.T_3")) == "pass");  // a value that states the share
  }

  TEST_CASE("parts of a torque may make up the whole, but a shaft with the whole is none of them") {
    CHECK(hub(key("key", "=values.P/values.n/2") + key("other", "=values.P/values.n/2")) == "pass");
    CHECK(hub(key("key", "=values.P/values.n/1.5") + key("other", "=values.P/values.n")) == "not-judged");
  }

  TEST_CASE("a speed is no part of another one by a bare number") {
    CHECK(bearing("=values.n") == "pass");
    CHECK(bearing("=0.97*values.n") == "pass");  // slip
    CHECK(bearing("=values.n/60") == "not-judged");
    CHECK(bearing("=0.1*values.n") == "not-judged");
  }

  TEST_CASE("a temperature of [values] is one in an expression, as that of a step is") {
    const auto error = [](const std::string& dT_adm) {
      return first_error_of(
          "[values]\nt_1 = \"90 degC\"\nt_0 = \"20 degC\"\ndT = \"40 K\"\n\n"
          "[worm]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\n"
          "b_2 = \"30 mm\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nK_A = 1.25\ncasting = \"chill\"\n"
          "S_Wmin = 1\nsigma_adm = \"60 MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"" +
          dT_adm + "\"\n");
    };
    for (const char* const dT : {"60 K", "=values.t_1 - values.t_0", "=values.t_1 - 293.15 K", "=1.5*values.dT",
                                 "=(values.t_1 + values.t_0)/2 - values.t_0"})
      CHECK_MESSAGE(error(dT).empty(), dT);
    for (const char* const dT : {"=values.t_1 - values.dT", "=values.t_1 - 40 K", "=1*values.t_1",
                                 "=max(values.t_1, values.t_0)", "=values.t_0 + values.dT"})
      CHECK_MESSAGE(error(dT).find("is a temperature") != std::string::npos, dT);
  }
}
