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

  TEST_CASE("a connection is assessed for the start of the shaft, its sense, its bore") {
    const auto with = [](const std::string& lines, const std::string& key) {
      return shaft_of(keyed, whole) + lines + key_for("100 N*m", "40 mm", key);
    };
    CHECK(mode_of(solved_as_found(with("k_max = 2\n", "T_max = \"200 N*m\"\n")), "shaft", "connection") == "pass");
    CHECK(mode_of(solved_as_found(with("k_max = 2\n", "T_max = \"150 N*m\"\n")), "shaft", "connection") == "fail");
    const std::string reversing = first_error_of(
        with("r_T = -1\nS_D = 1.5\ngroup = \"carbon-steel\"\nR_z = \"6.3 um\"\n", ""));  // the key says one_way
    CHECK_MESSAGE(reversing.find("and the shaft has r_T = -1") != std::string::npos, reversing);
    const std::string bored =
        first_error_of(replaced_in(with("", ""), "d = \"40 mm\" }", "d = \"40 mm\", d_bore = \"15 mm\" }"));
    CHECK_MESSAGE(bored.find("the shaft has one of 15 mm there") != std::string::npos, bored);
  }

  TEST_CASE("a connection has room on the shaft") {
    const std::string text = shaft_of(keyed, whole) + key_for("100 N*m", "40 mm");
    const auto error = [&](const std::string& word, const std::string& by) {
      return first_error_of(replaced_in(text, word, by));
    };
    CHECK(error("x = \"30 mm\"", "x = \"20 mm\"").find("beyond the end of the shaft") != std::string::npos);
    CHECK(error("x = \"30 mm\"", "x = \"95 mm\"").find("reaches over a bearing") != std::string::npos);
    const std::string stepped = "{ l = \"50 mm\", d = \"40 mm\" }, { l = \"250 mm\", d = \"45 mm\" }";
    CHECK(error("{ name = \"whole\", l = \"300 mm\", d = \"40 mm\" }", stepped).find("beyond its piece") !=
          std::string::npos);
  }

  TEST_CASE("a hub that is pushed along the shaft is held by more than a key") {
    const auto pushed = [](const std::string& more) {
      const std::string text = shaft_of(keyed + ", F_z = \"800 N\"" + more, whole) + key_for("100 N*m", "40 mm");
      return mode_of(solved_as_found(text), "shaft", "pushed");
    };
    CHECK(pushed("") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft_of(keyed, whole) + key_for("100 N*m", "40 mm")), "shaft", "pushed") == "none");
  }

  TEST_CASE("where fatigue is asked for, the end of a connection is a notch of the shaft") {
    const std::string fatigue = "S_D = 1.5\nr_T = 0\ngroup = \"carbon-steel\"\nR_z = \"6.3 um\"\n";
    const std::string bare = shaft_of(keyed, whole) + fatigue + key_for("100 N*m", "40 mm");
    CHECK(mode_of(solved_as_found(bare), "shaft", "seat_fatigue") == "not-judged");
    const std::string notch = "notches = [{ name = \"key_end\", x = \"55 mm\", part = \"=key.notch\" }]\n";
    const auto notched = solved_as_found(shaft_of(keyed, whole) + fatigue + notch + key_for("100 N*m", "40 mm"));
    CHECK(mode_of(notched, "shaft", "seat_fatigue") == "none");
  }

  TEST_CASE("a shaft does not go through the root of the gear that sits on it") {
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"3 mm\"\nb = \"30 mm\"\nT_1 = \"100 N*m\"\n\n";
    // d_f = 3 (20 - 2.5) = 52.5 mm; over 50 mm with 3.8 mm of keyway it is cut through
    std::string text = gears + key_for("100 N*m", "50 mm");
    text =
        replaced_in(replaced_in(text, "T = \"100 N*m\"\ntorque", "load = \"=gears.gear_1\"\ntorque"), "12x8", "14x9");
    CHECK(first_error_of(text).find("root circle") != std::string::npos);
    CHECK(first_error_of(replaced_in(replaced_in(text, "50 mm\"\nkey", "40 mm\"\nkey"), "14x9", "12x8")) == "");
  }

  TEST_CASE("a pin across the shaft keeps its shaft diameter, whatever the load has under that name") {
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"3 mm\"\nb = \"30 mm\"\nT_1 = \"20 N*m\"\n\n";
    const auto pin = [&](const std::string& more) {
      return first_error_of(
          gears +
          "[pin]\ncalculator = \"pin.cross\"\nload = \"=gears.gear_2\"\nd = \"8 mm\"\nD = \"64 mm\"\n"
          "tau_adm = \"60 MPa\"\np_adm_1 = \"70 MPa\"\np_adm_2 = \"35 MPa\"\ntau_adm_1 = \"40 MPa\"\n" +
          more);
    };
    CHECK(pin("").find("d_w") != std::string::npos);
    CHECK(pin("d_w = \"32 mm\"\n") == "");
  }
}
