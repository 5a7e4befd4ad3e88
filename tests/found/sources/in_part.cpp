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

/// A shaft with a drum, and another component on its free end, next to a chain with K_A.
std::string drum(const std::string& F, const std::string& other) {
  return "[chain]\ncalculator = \"chain.roller\"\nchain = \"20B\"\nz_1 = 19\nz_2 = 38\na = \"1000 mm\"\nn_1 = \"60 "
         "rpm\"\nP = \"1 kW\"\nK_A = 1.4\np_adm = \"30 MPa\"\nS_min = 8\n[shaft]\ncalculator = "
         "\"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nn = \"100 rpm\"\npieces = [{ l = \"300 "
         "mm\", d "
         "= \"60 mm\" }]\nsupports = [{ name = \"left\", x = \"20 mm\", holds = \"both\" }, { name = \"right\", x = "
         "\"220 "
         "mm\" }]\nseats = [{ name = \"drum\", x = \"120 mm\", integral = true, b = \"60 mm\", I_p = \"0.01 kg*m^2\", "
         "F_x = \"" +
         F + "\" }, { name = \"end\", x = \"270 mm\", integral = true, b = \"20 mm\", I_p = \"0.01 kg*m^2\", F_x = \"" +
         other + "\" }]\nS_F = 1.5\n";
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

  TEST_CASE("the force of a mounted component is not a part of a value, nor of one that is computed") {
    const auto state = [](const std::string& F, const std::string& other = "0 N") {
      return mode_of(
          solved_as_found(
              "[values]\nm = \"200 kg\"\nF = \"=values.m*9.81 m/s^2\"\nF_half = \"=values.F/2\"\nG = \"2 kN\"\n" +
              drum(F, other)),
          "shaft", "yield");
    };
    CHECK(state("=values.F") == "pass");
    CHECK(state("=-values.F") == "pass");
    CHECK(state("=values.F/2", "=values.F/2") == "pass");
    for (const char* const F : {"=values.F/2", "=-0.5*values.F", "=values.F/4", "=chain.K_A*(0.6*values.G)"})
      CHECK_MESSAGE(state(F) == "not-judged", F);
    CHECK(state("=chain.K_A*(1.6*values.G)") == "pass");
    CHECK(state("=values.F_half") == "pass");  // a value that states the share
  }

  TEST_CASE("a diameter is not half of the value under its name") {
    const auto state = [](const std::string& D) {
      return mode_of(solved_as_found("[values]\nD = \"400 mm\"\nR = \"400 mm\"\nD_o = \"=values.D/2\"\n[disc]\n"
                                     "calculator = \"machine.disc\"\nn = \"3000 rpm\"\nd_i = \"60 mm\"\nb = \"40 mm\"\n"
                                     "material = \"C45E\"\nS = 2\nD = \"" +
                                     D + "\"\n"),
                     "disc", "strength");
    };
    for (const char* const D : {"=values.D", "=0.98*values.D", "=values.R/2", "=values.D_o"})
      CHECK_MESSAGE(state(D) == "pass", D);
    for (const char* const D : {"=values.D/2", "=0.5*values.D"}) CHECK_MESSAGE(state(D) == "not-judged", D);
  }

  TEST_CASE("a radius is not a quarter of a diameter, nor a part of the value under its name") {
    const auto state = [](const std::string& R) {
      return mode_of(
          solved_as_found("[values]\nD = \"1200 mm\"\nR = \"600 mm\"\n[shell]\ncalculator = "
                          "\"vessel.cylinder\"\np = \"0.5 MPa\"\ndelta = \"12 mm\"\nsigma_adm = \"120 MPa\"\nR = \"" +
                          R + "\"\n"),
          "shell", "strength");
    };
    for (const char* const R : {"=values.D/2", "=values.R"}) CHECK_MESSAGE(state(R) == "pass", R);
    for (const char* const R : {"=values.D/4", "=values.R/2"}) CHECK_MESSAGE(state(R) == "not-judged", R);
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
