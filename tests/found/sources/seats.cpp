// Regression tests of the seats of a shaft next to the records that they take.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <algorithm>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string gears = R"([gears]
calculator = "gear.pair"
z_1 = 21
z_2 = 84
m_n = "3 mm"
x_1 = 0.3
b = "45 mm"
T_1 = "140 N*m"
n_1 = "730 rpm"

)";

/// A pinion between two bearings, and a coupling on the end; `pinion` and `coupling` end their seats.
std::string shaft_with(const std::string& pinion, const std::string& coupling = "integral = true",
                       const std::string& d = "50 mm") {
  return R"([shaft]
calculator = "shaft.design"
material = "16MnCr5"
R_e = "440 MPa"
group = "carbon-steel"
pieces = [{ l = "220 mm", d = ")" +
         d + R"(" }]
supports = [{ name = "left", x = "20 mm", holds = "both" }, { name = "right", x = "140 mm" }]
seats = [
  { name = "pinion", x = "80 mm", I_p = "0.0012 kg*m^2", )" +
         pinion + R"( },
  { name = "coupling", x = "195 mm", way = "balances", b = "20 mm", I_p = "0.002 kg*m^2", )" +
         coupling + R"( },
]
S_F = 1.5
S_D = 1.5
r_T = 0

)";
}

const std::string taken = "load = \"=gears.gear_1\", integral = true, ";
const std::string typed = "T = \"140 N*m\", n = \"730 rpm\", integral = true, b = \"45 mm\", ";

/// Whether a mode of the shaft waits for a reason with these words.
bool is_doubted(const std::string& text, const std::string& words) {
  const auto modes = project::modes(solved_as_found(text));
  return std::any_of(modes.begin(), modes.end(), [&](const account::Mode& mode) {
    return mode.step == "shaft" && mode.note.text().find(words) != std::string::npos;
  });
}

std::string key_with(const std::string& K_A) {
  return "[key]\ncalculator = \"shaft.key\"\nT = \"140 N*m\"\ntorque = \"one_way\"\nd = \"50 mm\"\nkey = \"14x9\"\n"
         "l = \"36 mm\"\nR_e_1 = \"440 MPa\"\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\nS_F = 1.5\nK_A = " +
         K_A + "\n";
}

}  // namespace

TEST_SUITE("found seats") {
  TEST_CASE("a seat is not much narrower than its gear") {
    CHECK(is_doubted(gears + shaft_with(taken + "b = \"30 mm\""), "the rim of 'gears.gear_1' is 45 mm wide"));
    CHECK_FALSE(is_doubted(gears + shaft_with(taken + "b = \"40 mm\""), "wide"));
  }

  TEST_CASE("a force or a bending moment of [values] that no mounted part has") {
    const auto is_left_out = [](const std::string& value) {
      return is_doubted("[values]\n" + value + "\n" + shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\""),
                        "no mounted component has it");
    };
    for (const std::string value : {"F_z = \"2 kN\"", "M_b = \"90 N*m\""}) CHECK_MESSAGE(is_left_out(value), value);
    for (const std::string value : {"F_x = \"0 N\"", "F_y = 2", "F_w = \"2 kN\"", "M_b = \"2 kN\""})
      CHECK_MESSAGE(!is_left_out(value), value);
  }

  TEST_CASE("a component of a tooth force is taken unchanged") {
    const auto with = [](const std::string& F_x) {
      return gears + shaft_with(typed + "F_x = \"" + F_x + "\", F_y = \"=gears.gear_1.F_y\"");
    };
    CHECK(is_doubted(with("=-gears.gear_1.F_x"), "is not the component of 'gears.gear_1' as it is"));
    CHECK_FALSE(is_doubted(with("=gears.gear_1.F_x"), "is not the component"));
  }

  TEST_CASE("a gear is not pulled towards its mate") {
    const auto with = [](const std::string& F_x) {
      return shaft_with(typed + "kind = \"gear\", F_x = \"" + F_x + "\", F_y = \"4 kN\"");
    };
    CHECK(is_doubted(with("600 N"), "pushes apart"));
    CHECK_FALSE(is_doubted(with("-600 N"), "pushes apart"));
  }

  TEST_CASE("the shaft has the application factor of its connection, where both are typed") {
    const auto with = [](const std::string& K_A) {
      return key_with(K_A) + shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"", "connection = \"=key.connection\"");
    };
    CHECK(is_doubted(with("1.75"), "its connection 'key' has 1.75"));
    CHECK_FALSE(is_doubted(with("1"), "its connection 'key' has"));
  }

  TEST_CASE("a hub is as long on the shaft as in its connection") {
    const auto with = [](const std::string& l_n) {
      return key_with("1") + "l_n = \"" + l_n + "\"\n" +
             shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"", "connection = \"=key.connection\"");
    };
    CHECK(is_doubted(with("80 mm"), "the hub of 'key' is 80 mm long"));
    CHECK_FALSE(is_doubted(with("20 mm"), "mm long"));
  }

  TEST_CASE("a body has a mass that fits its moment of inertia") {
    const auto with = [](const std::string& mass) {
      return shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"",
                        "integral = true, J = \"0.5 kg*m^2\", mass = \"" + mass + "\"");
    };
    // A steel disc 20 mm wide with 0.5 kg m^2 has D = 0.425 m and 22.2 kg.
    CHECK(is_doubted(with("0.1 kg"), "a steel disc has 22.2 kg"));
    CHECK_FALSE(is_doubted(with("8 kg"), "a steel disc"));
  }

  TEST_CASE("a mass that is taken from a flywheel has its moment of inertia") {
    const std::string fly =
        "[fly]\ncalculator = \"machine.flywheel\"\npoints = [[\"0 deg\", \"100 N*m\"], [\"180 deg\", \"160 N*m\"], "
        "[\"360 deg\", \"100 N*m\"]]\nomega = \"730 rpm\"\ndelta = 0.02\nD = \"400 mm\"\nv_adm = \"30 m/s\"\n\n";
    const auto with = [&](const std::string& J) {
      std::string shaft = shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"",
                                     "integral = true, mass = \"=fly.m_rim\", J = \"" + J + "\"");
      return fly + shaft.replace(shaft.find("0.002 kg*m^2"), 12, J);
    };
    CHECK(is_doubted(with("0.02 kg*m^2"), "whose mass is taken"));
    CHECK_FALSE(is_doubted(with("=fly.J_F"), "whose mass is taken"));
  }

  TEST_CASE("a connection is calculated with the yield strength of its shaft") {
    const auto with = [](const std::string& R_e_1) {
      std::string key = key_with("1");
      key.replace(key.find("440 MPa"), 7, R_e_1);
      return key + shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"", "connection = \"=key.connection\"");
    };
    CHECK(is_doubted(with("800 MPa"), "this shaft has 440 MPa"));
    CHECK_FALSE(is_doubted(with("500 MPa"), "this shaft has"));
  }

  TEST_CASE("teeth that are cut into the shaft lie outside its surface") {
    const std::string seat = taken + "b = \"45 mm\"";
    CHECK(first_error_of(gears + shaft_with(seat, "integral = true", "60 mm")).find("lies inside the shaft") !=
          std::string::npos);  // d_f = 3 (21 - 2.5 + 0.6) = 57.3 mm
    CHECK(first_error_of(gears + shaft_with(seat, "integral = true", "57 mm")).empty());
  }

  TEST_CASE("a component integral with the shaft has no keyway under it") {
    const auto with = [](const std::string& notches, const std::string& coupling) {
      return key_with("1") + shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"", coupling) + "notches = [" + notches +
             "]\n";
    };
    const std::string keyway = "{ name = \"k\", x = \"195 mm\", part = \"=key.notch\" }";
    CHECK(is_doubted(with(keyway, "integral = true"), "the notch of 'key' lies under it"));
    CHECK_FALSE(is_doubted(with(keyway, "connection = \"=key.connection\""), "lies under it"));
  }

  TEST_CASE("a cross hole is as wide as the pin in it") {
    const auto with = [](const std::string& r) {
      return "[pin]\ncalculator = \"pin.cross\"\nT = \"140 N*m\"\nloading = \"pulsating\"\nd = \"12 mm\"\nd_w = \"50 "
             "mm\"\nD = \"100 mm\"\nR_m = \"800 MPa\"\np_adm_1 = \"120 MPa\"\np_adm_2 = \"90 MPa\"\ntau_adm_1 = \"60 "
             "MPa\"\n" +
             shaft_with(typed + "F_x = \"-1 kN\", F_y = \"3 kN\"", "connection = \"=pin.connection\"") +
             "notches = [{ name = \"k\", x = \"195 mm\", kind = \"cross-hole\", r = \"" + r + "\" }]\n";
    };
    CHECK(is_doubted(with("1 mm"), "is the radius of a hole of 2 mm"));
    CHECK_FALSE(is_doubted(with("6 mm"), "is the radius of a hole"));
  }
}
