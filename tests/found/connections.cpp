// Shafts whose gears and pulleys nothing fastens, or something that is made for another torque or diameter.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string shaft = R"([shaft]
calculator = "shaft.design"
material = "C45E"
n = "1000 rpm"
pieces = [{ name = "whole", l = "300 mm", d = "40 mm" }]
supports = [{ name = "left", x = "100 mm", holds = "both" }, { name = "right", x = "280 mm" }]
seats = [
  { name = "pulley", x = "30 mm", way = "takes", T = "100 N*m", F_x = "1 kN"PULLEY },
  { name = "pinion", x = "200 mm", way = "drives", T = "100 N*m", F_x = "-1 kN", F_y = "2 kN"PINION },
]
S_F = 1.5
)";

std::string replaced_in(std::string text, const std::string& word, const std::string& by) {
  return text.replace(text.find(word), word.size(), by);
}

/// A shaft of 40 mm with a pinion between its bearings that drives a pulley on its end. `pulley`, `pinion`: what the
/// seats say besides.
std::string shaft_of(const std::string& pulley, const std::string& pinion) {
  return replaced_in(replaced_in(shaft, "PULLEY", pulley), "PINION", pinion);
}

const std::string whole = ", integral = true";
const std::string keyed = ", connection = \"=key.connection\"";

/// A key for the torque and diameter.
std::string key_for(const std::string& T, const std::string& d, const std::string& more = "") {
  return "\n[key]\ncalculator = \"shaft.key\"\nT = \"" + T + "\"\ntorque = \"one_way\"\nd = \"" + d +
         "\"\nkey = \"12x8\"\nl = \"50 mm\"\nl_n = \"55 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\n"
         "R_e_k = \"420 MPa\"\n" +
         more;
}

}  // namespace

TEST_SUITE("found connections") {
  TEST_CASE("what transmits torque is fastened, or one piece with the shaft") {
    const auto bare = solved_as_found(shaft_of("", ""));
    CHECK(mode_of(bare, "shaft", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft_of(whole, "")), "shaft", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft_of(whole, whole)), "shaft", "hub") == "none");
    CHECK(mode_of(solved_as_found(shaft_of(", integral = false", whole)), "shaft", "hub") == "not-judged");
    const auto fastened = solved_as_found(shaft_of(keyed, whole) + key_for("100 N*m", "40 mm"));
    CHECK(mode_of(fastened, "shaft", "hub") == "none");
    CHECK(mode_of(fastened, "shaft", "connection") == "pass");
    CHECK(mode_of(fastened, "key", "hub") == "pass");
  }

  TEST_CASE("a connection for less torque fails, with and without service factors") {
    CHECK(mode_of(solved_as_found(shaft_of(keyed, whole) + key_for("90 N*m", "40 mm")), "shaft", "connection") ==
          "fail");
    const std::string varying = "K_A = 1.5\n";
    const auto of_shaft = solved_as_found(shaft_of(keyed, whole) + varying + key_for("100 N*m", "40 mm"));
    CHECK(mode_of(of_shaft, "shaft", "connection") == "fail");  // 150 N m against 100 N m
    const auto of_both = solved_as_found(shaft_of(keyed, whole) + varying + key_for("100 N*m", "40 mm", varying));
    CHECK(mode_of(of_both, "shaft", "connection") == "pass");
  }

  TEST_CASE("a rating of the maker is a connection, too") {
    const auto clamped = [](const char* T) {
      return mode_of(solved_as_found(shaft_of(std::string(", T_c = \"") + T + "\"", whole)), "shaft", "connection");
    };
    CHECK(clamped("120 N*m") == "pass");
    CHECK(clamped("99 N*m") == "fail");
  }

  TEST_CASE("a connection for another diameter is refused where the seat says so") {
    const std::string error = first_error_of(shaft_of(keyed, whole) + key_for("100 N*m", "42 mm"));
    CHECK_MESSAGE(error.find("made for a shaft of 42 mm, and the shaft has 40 mm") != std::string::npos, error);
  }

  TEST_CASE("splines, press fits, set screws and pins fasten as keys do") {
    const auto provides = [](const std::string& calculator) {
      const Calculator* const found = find_calculator(calculators(), calculator);
      REQUIRE(found != nullptr);
      return find_field(found->result->fields, "connection") != nullptr;
    };
    for (const char* calculator : {"shaft.key", "shaft.spline", "shaft.press_fit", "shaft.set_screw", "pin.cross"})
      CHECK_MESSAGE(provides(calculator), calculator);
  }

  TEST_CASE("a seat without torque needs no connection") {
    std::string disc = shaft_of("", "");
    for (const char* torque : {", T = \"100 N*m\"", ", T = \"100 N*m\""}) disc = replaced_in(disc, torque, "");
    CHECK(mode_of(solved_as_found(disc), "shaft", "hub") == "none");
  }

  TEST_CASE("the rim of a gear between root circle and shaft, over its keyway, is 1.2 teeth high at least") {
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 24\nz_2 = 60\nm_n = \"3 mm\"\nb = \"30 mm\"\nT_1 = \"100 N*m\"\n\n";
    // d_f = 3 (24 - 2.5) = 64.5 mm, h_t = 6.75 mm: (64.5 - 40)/2 = 12.25 mm is 1.815 teeth, less 3.3 mm 1.326
    const auto rim = [&](const std::string& more) {
      std::string text = replaced_in(shaft_of(whole, more), "T = \"100 N*m\", F_x = \"-1 kN\", F_y = \"2 kN\"",
                                     "load = \"=gears.gear_1\"");
      text = replaced_in(text, "n = \"1000 rpm\"\n", "");
      return gears + text;
    };
    const auto plain = solved_as_found(rim(""));
    CHECK(plain.value("shaft.seats.pinion.m_R")->si[0] == doctest::Approx(12.25 / 6.75));
    const auto over_key = solved_as_found(rim(keyed) + key_for("100 N*m", "40 mm"));
    CHECK(over_key.value("shaft.seats.pinion.m_R")->si[0] == doctest::Approx((12.25 - 3.3) / 6.75));
    CHECK(mode_of(over_key, "shaft", "rim") == "pass");
    CHECK(mode_of(solved_as_found(rim(whole)), "shaft", "rim") == "none");
    const std::string thick = replaced_in(rim(""), "d = \"40 mm\"", "d = \"50 mm\"");  // 7.25 mm: 1.07 teeth
    CHECK(mode_of(solved_as_found(thick), "shaft", "rim") == "not-covered");
  }

  TEST_CASE("a pulley or a wheel is larger than the shaft that it sits on") {
    const auto seat = [](const char* d_w) {
      return first_error_of(shaft_of(std::string(", d_w = \"") + d_w + "\"", whole));
    };
    CHECK(seat("35 mm").find("act at a diameter of 35 mm, and the shaft has 40 mm there") != std::string::npos);
    CHECK(seat("80 mm") == "");
  }
}
