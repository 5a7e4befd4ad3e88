// Shafts whose gears and pulleys nothing fastens, or something that is made for another torque or diameter.
#include "tests/found/modes.hpp"

#include <cmath>
#include <utility>

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

/// A pair of module 3 mm with a pinion of z teeth: its root circle has 3 mm times z - 2.5.
std::string gears_of(int z, const std::string& b, const std::string& more = "") {
  return "[gears]\ncalculator = \"gear.pair\"\nz_1 = " + std::to_string(z) + "\nz_2 = 60\nm_n = \"3 mm\"\nb = \"" + b +
         "\"\nT_1 = \"100 N*m\"\n" + more + "\n";
}

/// The key of a gear: `load` in place of its torque.
std::string keyed_gear(const std::string& load, const std::string& d, const std::string& more = "") {
  return replaced_in(key_for("1 N*m", d, more), "T = \"1 N*m\"", load);
}

const std::string fit_of_40 =
    "d = \"40 mm\"\nD = \"80 mm\"\nl = \"40 mm\"\nU_min = \"40 um\"\nU_max = \"60 um\"\nRz_1 = \"4 um\"\n"
    "Rz_2 = \"6.3 um\"\nmu = 0.14\nS_r = 1.5\nmaterial = \"C45E\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"370 MPa\"\nS_F = "
    "1.2\n";

/// Connections of a shaft of 40 mm and so, 40 mm long.
std::vector<std::pair<std::string, std::string>> hubs_of_40() {
  return {{"shaft.press_fit", fit_of_40}, {"shaft.spline", "spline = \"8x36x40\"\nl = \"40 mm\"\n"}};
}

}  // namespace

TEST_SUITE("found connections") {
  TEST_CASE("a part that transmits torque is fastened, or one piece with the shaft") {
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

  TEST_CASE("a manufacturer's rating is a connection, too") {
    const auto clamped = [](const char* T, const char* reason) {
      const std::string text = shaft_of(std::string(", T_c = \"") + T + "\"", whole) + reason;
      return mode_of(solved_as_found(text), "shaft", "connection");
    };
    const char* const rated = "because.seats = \"clamping set, data sheet\"\n";
    CHECK(clamped("120 N*m", rated) == "pass");
    CHECK(clamped("99 N*m", rated) == "fail");
    CHECK(clamped("120 N*m", "") == "not-judged");
    CHECK(clamped("9999 N*m", "") == "not-judged");
  }

  TEST_CASE("a connection for another diameter is refused if the seat states it") {
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

  TEST_CASE("a pulley or a wheel is larger than the shaft on which it sits") {
    const auto seat = [](const char* d_w) {
      return first_error_of(shaft_of(std::string(", d_w = \"") + d_w + "\"", whole));
    };
    CHECK(seat("35 mm").find("act at a diameter of 35 mm, and the shaft has 40 mm there") != std::string::npos);
    CHECK(seat("80 mm") == "");
  }

  TEST_CASE("a connection is assessed for the start of the shaft, its torque direction, its bore") {
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

  TEST_CASE("a connection has space on the shaft") {
    const std::string text = shaft_of(keyed, whole) + key_for("100 N*m", "40 mm");
    const auto error = [&](const std::string& word, const std::string& by) {
      return first_error_of(replaced_in(text, word, by));
    };
    CHECK(error("x = \"30 mm\"", "x = \"20 mm\"").find("beyond the end of the shaft") != std::string::npos);
    CHECK(error("x = \"30 mm\"", "x = \"95 mm\"").find("overlaps the bearing") != std::string::npos);
    const std::string stepped = "{ l = \"50 mm\", d = \"40 mm\" }, { l = \"250 mm\", d = \"45 mm\" }";
    CHECK(error("{ name = \"whole\", l = \"300 mm\", d = \"40 mm\" }", stepped).find("beyond its segment") !=
          std::string::npos);
  }

  TEST_CASE("a hub that is pushed along the shaft is located by more than a key") {
    const auto pushed = [](const std::string& more) {
      const std::string text = shaft_of(keyed + ", F_z = \"800 N\"" + more, whole) + key_for("100 N*m", "40 mm");
      return mode_of(solved_as_found(text), "shaft", "pushed");
    };
    CHECK(pushed("") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft_of(keyed, whole) + key_for("100 N*m", "40 mm")), "shaft", "pushed") == "none");
  }

  TEST_CASE("where fatigue is assessed, the end of a connection is a notch of the shaft") {
    const std::string fatigue = "S_D = 1.5\nr_T = 0\ngroup = \"carbon-steel\"\nR_z = \"6.3 um\"\n";
    const std::string bare = shaft_of(keyed, whole) + fatigue + key_for("100 N*m", "40 mm");
    CHECK(mode_of(solved_as_found(bare), "shaft", "seat_fatigue") == "not-judged");
    const std::string notch = "notches = [{ name = \"key_end\", x = \"55 mm\", part = \"=key.notch\" }]\n";
    const auto notched = solved_as_found(shaft_of(keyed, whole) + fatigue + notch + key_for("100 N*m", "40 mm"));
    CHECK(mode_of(notched, "shaft", "seat_fatigue") == "none");
  }

  TEST_CASE("a shaft does not cut into the root of the gear that sits on it") {
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"3 mm\"\nb = \"30 mm\"\nT_1 = \"100 N*m\"\n\n";
    // d_f = 3 (20 - 2.5) = 52.5 mm; over 50 mm with 3.8 mm of keyway it is cut through
    std::string text = gears + key_for("100 N*m", "50 mm");
    text =
        replaced_in(replaced_in(text, "T = \"100 N*m\"\ntorque", "load = \"=gears.gear_1\"\ntorque"), "12x8", "14x9");
    CHECK(first_error_of(text).find("root circle") != std::string::npos);
    CHECK(first_error_of(replaced_in(replaced_in(text, "50 mm\"\nkey", "40 mm\"\nkey"), "14x9", "12x8")) == "");
  }

  TEST_CASE("a connection is as long as the rim under which it lies, or the length of the hub is given") {
    const auto key = [](const std::string& b, const std::string& more = "") {
      return mode_of(solved_as_found(gears_of(40, b) + keyed_gear("load = \"=gears.gear_1\"", "40 mm", more)), "key",
                     "overhang");
    };
    CHECK(key("60 mm") == "none");
    CHECK(key("15 mm") == "not-judged");
    CHECK(key("15 mm", "accept.overhang = \"the hub is 60 mm long\"\n") == "accepted");
    const auto singly = [](const std::string& T) {
      return mode_of(solved_as_found(gears_of(40, "15 mm") + keyed_gear("T = \"" + T + "\"", "40 mm")), "key",
                     "overhang");
    };
    for (const char* T : {"=gears.gear_1.T", "=1.2*gears.gear_1.T", "=gears.T_1"}) CHECK(singly(T) == "not-judged");
    CHECK(singly("100 N*m") == "none");
    for (const auto& hub : hubs_of_40()) {
      const auto project = solved_as_found(gears_of(40, "15 mm") + "[hub]\ncalculator = \"" + hub.first +
                                           "\"\nload = \"=gears.gear_1\"\n" + hub.second);
      CHECK_MESSAGE(mode_of(project, "hub", "overhang") == "not-judged", hub.first);
    }
  }

  TEST_CASE("a component other than the gear whose torque is taken has a bore of its own, with a reason") {
    for (const std::string T : {"=gears.gear_1.T", "=gears.T_1"}) {
      const auto text = gears_of(40, "60 mm", "bore_1 = \"50 mm\"") + keyed_gear("T = \"" + T + "\"", "40 mm");
      CHECK(first_error_of(text).find("for another component give its bore, with because.bore") != std::string::npos);
      CHECK(first_error_of(text + "bore = \"40 mm\"\n").starts_with("bore = 40 mm contradicts 'gears.gear_1.bore'"));
      CHECK(first_error_of(text + "bore = \"40 mm\"\nbecause.bore = \"coupling\"\n") == "");
    }
  }

  TEST_CASE("the wall between a hub and the root circle of a gear, sprocket or pulley") {
    const std::string load = "load = \"=gears.gear_1\"";
    const auto wall = [&](int z, const std::string& d, const char* mode) {
      const std::string text = gears_of(z, "60 mm") + keyed_gear(load, d);
      return mode_of(solved_as_found(text), "key", mode);
    };
    CHECK(wall(40, "40 mm", "wall") == "pass");
    CHECK(wall(21, "40 mm", "wall") == "not-covered");  // 55.5 mm: 7.75 mm less 3.3 mm, 0.66 teeth
    const auto own = solved_as_found(gears_of(40, "60 mm") + keyed_gear("T = \"100 N*m\"", "40 mm"));
    CHECK(mode_of(own, "key", "wall") == "open");
    const auto screw = [&](int z) {
      return mode_of(solved_as_found(gears_of(z, "60 mm") + "[s]\ncalculator = \"shaft.set_screw\"\n" + load +
                                     "\nload_case = \"static\"\nset_screw = \"3/8\"\nd = \"40 mm\"\nS = 1.5\n"),
                     "s", "wall");
    };
    CHECK(screw(40) == "pass");
    CHECK(screw(20) == "not-covered");
    const std::string fit = "[f]\ncalculator = \"shaft.press_fit\"\n" + load + "\n" + fit_of_40;
    CHECK(mode_of(solved_as_found(gears_of(40, "60 mm") + fit), "f", "wall") == "pass");
    CHECK(first_error_of(gears_of(24, "60 mm") + fit).find("must not exceed the root diameter") != std::string::npos);
  }

  TEST_CASE("root circles of sprockets, groove bottoms of V-belt pulleys") {
    const std::string chain =
        "[c]\ncalculator = \"chain.roller\"\nchain = \"08B\"\nedition = \"maker\"\nz_1 = 17\nz_2 = 51\n"
        "n_1 = \"300 rpm\"\nP = \"1 kW\"\na = \"500 mm\"\n\n";
    const auto sprocket = solved_as_found(chain);
    CHECK(sprocket.value("c.shaft_1.d_f")->si[0] == doctest::Approx(12.7e-3 / std::sin(pi / 17) - 8.509e-3));
    const std::string spline =
        "[s]\ncalculator = \"shaft.spline\"\nload = \"=c.shaft_1\"\nspline = \"8x52x60\"\nl = \"40 mm\"\n";
    CHECK(mode_of(solved_as_found(chain + spline), "s", "wall") == "not-covered");
    const std::string key = keyed_gear("load = \"=c.shaft_1\"", "60 mm");
    CHECK(first_error_of(chain + replaced_in(key, "12x8", "18x11")).find("root circle") != std::string::npos);
    const std::string belt =
        "[b]\ncalculator = \"belt.v\"\nbasis = \"optibelt\"\nsection = \"SPZ\"\nP = \"1 kW\"\nK_A = 1.2\n"
        "n_1 = \"1460 rpm\"\nd_1 = \"71 mm\"\nd_2 = \"140 mm\"\nL = \"1000 mm\"\n\n";
    const auto pulley = solved_as_found(belt);
    CHECK(pulley.value("b.shaft_1.d_f")->si[0] == doctest::Approx(53e-3));
    CHECK(pulley.value("b.shaft_1.b_r")->si[0] == doctest::Approx(pulley.value("b.B")->si[0]));
    const std::string screw =
        "[s]\ncalculator = \"shaft.set_screw\"\nload = \"=b.shaft_1\"\nset_screw = \"1/2\"\nd = \"60 mm\"\nS = 4\n";
    CHECK(first_error_of(belt + screw).find("root diameter") != std::string::npos);
  }

  TEST_CASE("a connection is no longer than the body that it fastens") {
    const auto hub = [](const std::string& more) {
      return mode_of(solved_as_found(shaft_of(keyed + more, whole) + key_for("100 N*m", "40 mm")), "shaft",
                     "hub_length");
    };
    CHECK(hub("") == "none");
    CHECK(hub(", mass = \"1 kg\", I_p = \"0.001 kg*m^2\", b = \"50 mm\"") == "none");
    CHECK(hub(", mass = \"1 kg\", I_p = \"0.001 kg*m^2\", b = \"20 mm\"") == "not-judged");
    CHECK(hub(", b_r = \"20 mm\"") == "not-judged");
  }

  TEST_CASE("a part that is one piece with the shaft has no bore and no connection, and is not a pulley") {
    const auto with = [](const std::string& bore, const std::string& seat) {
      std::string text = replaced_in(shaft_of(whole, seat), "T = \"100 N*m\", F_x = \"-1 kN\", F_y = \"2 kN\"",
                                     "load = \"=gears.gear_1\"");
      return first_error_of(gears_of(40, "60 mm", bore) + replaced_in(text, "n = \"1000 rpm\"\n", ""));
    };
    CHECK(with("", whole) == "");
    CHECK(with("bore_1 = \"40 mm\"\n", whole).find("contradicts integral = true") != std::string::npos);
    CHECK(with("bore_1 = \"40 mm\"\n", ", T_c = \"150 N*m\"") == "");
    CHECK(with("bore_1 = \"35 mm\"\n", ", T_c = \"150 N*m\"").find("the shaft diameter there is 40 mm") !=
          std::string::npos);
    CHECK(first_error_of(shaft_of(whole + ", T_c = \"150 N*m\"", whole)).find("contradicts integral = true") !=
          std::string::npos);
    const auto pulley = [](const char* seat) {
      const std::string belt =
          "[b]\ncalculator = \"belt.flat\"\nP = \"10 kW\"\nn_1 = \"1000 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"500 mm\"\n"
          "a = \"1200 mm\"\nmu = 0.4\nkind = \"synthetic\"\ndelta = \"2.5 mm\"\nrho = \"1100 kg/m^3\"\n"
          "sigma_adm = \"6 MPa\"\n\n";
      std::string text = shaft_of(whole, whole);
      text = replaced_in(text, "way = \"takes\", T = \"100 N*m\", F_x = \"1 kN\"", seat);
      text = replaced_in(text, "way = \"drives\", T = \"100 N*m\"", "way = \"balances\"");
      return mode_of(solved_as_found(belt + text), "shaft", "one_piece");
    };
    CHECK(pulley("load = \"=b.shaft_1\"") == "not-judged");
    CHECK(pulley("T = \"=b.shaft_1.T\", F_x = \"=b.shaft_1.F_x\"") == "not-judged");
    CHECK(pulley("T = \"50 N*m\"") == "none");
  }

  TEST_CASE("a torque that is taken without its record still brings the root circle of its gear") {
    const auto seat = [](const std::string& more) {
      std::string text = shaft_of(whole, ", connection = \"=key.connection\"" + more);
      text = replaced_in(text, "T = \"100 N*m\", F_x = \"-1 kN\", F_y = \"2 kN\"",
                         "T = \"=gears.gear_1.T\", F_x = \"=gears.gear_1.F_x\"");
      return gears_of(21, "60 mm") + text + key_for("100 N*m", "40 mm");
    };
    CHECK(mode_of(solved_as_found(seat("")), "shaft", "rim") == "not-covered");
    CHECK(first_error_of(seat(", d_f = \"90 mm\"")).find("contradicts") != std::string::npos);
  }

  TEST_CASE("the key of another seat takes the torque of a gear without its root circle") {
    const auto rim = [](const std::string& pulley, const std::string& pinion) {
      const std::string seats = replaced_in(
          shaft_of(pulley, pinion), "T = \"100 N*m\", F_x = \"-1 kN\", F_y = \"2 kN\"", "load = \"=gears.gear_1\"");
      return mode_of(solved_as_found(gears_of(21, "60 mm") + seats + key_for("=gears.gear_1.T", "40 mm")), "key",
                     "wall");
    };
    CHECK(rim(keyed, whole) == "open");
    CHECK(rim(whole, keyed) == "not-covered");
    CHECK(rim(whole, "") == "not-covered");
  }

  TEST_CASE("a press fit loses interference at speed, and its shaft needs the speed") {
    const auto at = [](const std::string& lines) {
      return solved_as_found(
          "[f]\ncalculator = \"shaft.press_fit\"\nT = \"20 N*m\"\nd = \"40 mm\"\nD = \"200 mm\"\n"
          "l = \"40 mm\"\nU_min = \"40 um\"\nU_max = \"63 um\"\nRz_1 = \"4 um\"\nRz_2 = \"6.3 um\"\n"
          "mu = 0.14\nS_r = 1.5\nmaterial = \"C45E\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"370 MPa\"\n"
          "S_F = 1.2\n" +
          lines);
    };
    CHECK(mode_of(at(""), "f", "speed") == "open");
    CHECK(mode_of(at("n = \"10000 rpm\"\n"), "f", "speed") == "pass");
    CHECK(mode_of(at("n = \"20000 rpm\"\n"), "f", "speed") == "fail");
    // Closed form of both discs with 7840 kg/m^3; finite elements with 7850 kg/m^3: 30.9462 MPa, the same.
    CHECK(at("n = \"12000 rpm\"\n").value("f.p_min")->si[0] == doctest::Approx(31.0087e6).epsilon(1e-5));
    const auto shaft_at = [](const std::string& n, const std::string& lines) {
      const std::string text = shaft_of(", connection = \"=f.connection\"", whole) +
                               "\n[f]\ncalculator = \"shaft.press_fit\"\nT = \"100 N*m\"\n" + fit_of_40 + lines;
      return mode_of(solved_as_found(replaced_in(text, "1000 rpm", n)), "shaft", "fit_speed");
    };
    CHECK(shaft_at("1000 rpm", "") == "pass");
    CHECK(shaft_at("15000 rpm", "") == "not-covered");
    CHECK(shaft_at("15000 rpm", "n = \"15000 rpm\"\n") == "pass");
  }

  TEST_CASE("the notch of a connection is of its kind, and not milder") {
    const auto notched = [](const std::string& kind, const std::string& key, const char* mode) {
      const std::string fatigue = "S_D = 1\nr_T = 0\ngroup = \"carbon-steel\"\nR_z = \"6.3 um\"\n";
      const std::string notch = "notches = [{ name = \"end\", x = \"55 mm\", kind = " + kind + " }]\n";
      return mode_of(solved_as_found(shaft_of(keyed, whole) + fatigue + notch + key_for("100 N*m", "40 mm", key)),
                     "shaft", mode);
    };
    CHECK(notched("\"keyway\"", "", "seat_fatigue") == "none");
    CHECK(notched("\"keyway\"", "i = 2\n", "seat_fatigue") == "not-judged");
    CHECK(notched("\"two-keyways\"", "i = 2\n", "seat_fatigue") == "none");
    CHECK(notched("\"beta\", beta_b = 1, beta_t = 1", "", "notch_factors") == "not-judged");
    CHECK(notched("\"beta\", beta_b = 2.2, beta_t = 1.6", "", "notch_factors") == "none");
    const std::string spline = "beta_b = 1\nbeta_t = 1";
    CHECK(mode_with("shaft.spline", spline, "notch_factors") == "not-judged");
    CHECK(mode_with("shaft.spline", "beta_b = 1.6\nbeta_t = 2.4", "notch_factors") == "none");
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
