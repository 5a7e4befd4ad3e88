// Bearings out of the table: what a row fills, what contradicts it, which row is found, and the seat that it must fit.
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A shaft of 40 mm at the bearing, with a shoulder of 50 mm and r = 1 mm at 60 mm.
const std::string shaft = R"(
[shaft]
calculator = "shaft.design"
material = "C45E"
group = "carbon-steel"
pieces = [{ l = "60 mm", d = "40 mm" }, { l = "200 mm", d = "50 mm" }, { l = "60 mm", d = "40 mm" }]
supports = [{ name = "left", x = "47 mm", holds = "both" }, { name = "right", x = "273 mm" }]
seats = [{ x = "160 mm", F_x = "4 kN", n = "900 rpm" }]
notches = [{ x = "60 mm", kind = "shoulder", r = "1 mm" }, { x = "260 mm", kind = "shoulder", r = "1 mm" }]
S_F = 1.5
R_z = "6.3 um"
)";

std::string on_shaft(const std::string& lines) {
  return shaft + "[left]\ncalculator = \"bearing.rolling\"\nload = \"=shaft.bearings.left\"\nL_h = \"10000 h\"\n" +
         lines;
}

std::string seat_of(const std::string& lines) { return mode_of(solved_as_found(on_shaft(lines)), "left", "seat"); }

std::string alone(const std::string& lines) {
  return "[b]\ncalculator = \"bearing.rolling\"\nF_r = \"2.5 kN\"\nF_a = \"1 kN\"\nn = \"900 rpm\"\nL_h = \"15000 "
         "h\"\n" +
         lines;
}

/// The row that the step has, and why: "6008: smallest of ...; 16008 fails: ...".
std::string row_of(const std::string& lines) {
  const auto project = solved_as_found(lines);
  for (const account::Entry& e : project.steps.back()->account().inputs) {
    if (e.path == "bearing") return e.word + ": " + e.origin.text.text();
  }
  return "";
}

}  // namespace

TEST_SUITE("rolling bearing") {
  TEST_CASE("a row fills kind, ratings, factors and speed, as if they were typed") {
    const std::string typed =
        "kind = \"deep_groove_ball\"\nC = \"32.5 kN\"\nC_0 = \"19 kN\"\nf_0 = 14\nn_max = \"11000 rpm\"\ns_0 = 2";
    const auto by_row = solved_as_found(alone("bearing = \"6208\"\ns_0 = 2"));
    const auto by_hand = solved_as_found(alone(typed));
    for (const char* mode : {"fatigue", "static", "speed", "ribs", "axial"})
      CHECK(mode_of(by_row, "b", mode) == mode_of(by_hand, "b", mode));
    CHECK(mode_of(by_row, "b", "speed") == "pass");
  }

  TEST_CASE("a value next to the row: another factor means another bearing, a higher rating needs a reason") {
    CHECK(says(alone("bearing = \"6208\"\nf_0 = 12"), "f_0"));
    CHECK(mode_of(solved_as_found(alone("bearing = \"6208\"\nC = \"40 kN\"")), "b", "fatigue") == "not-judged");
    CHECK(mode_of(solved_as_found(alone("bearing = \"6208\"\nC = \"40 kN\"\nbecause.C = \"maker's list of 2026\"")),
                  "b", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(alone("bearing = \"6208\"\nC = \"30 kN\"")), "b", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(alone("bearing = \"6208\"\nn_max = \"6000 rpm\"")), "b", "speed") == "pass");
    CHECK(says(alone("bearing = \"6208\"\nkind = \"cylindrical_roller_NU\""), "kind"));
  }

  TEST_CASE("the lightest row that passes, of a series and a bore") {
    CHECK(row_of(on_shaft("bearing = { where = \"d = 40 mm\" }")).find("6008: ") == 0);
    CHECK(row_of(on_shaft("bearing = { where = \"d = 40 mm\" }")).find("16008 fails: u_L = 1.1") != std::string::npos);
    CHECK(row_of(on_shaft("bearing = \"?\"")).find("6008: ") == 0);  // the seat excludes other bores
    CHECK(row_of(alone("bearing = { stock = \"bearing/62\" }")).find("6208: ") == 0);
    CHECK(row_of(alone("bearing = { stock = \"deep_groove_ball\", where = \"d >= 40 mm and d <= 45 mm\" }"))
              .find("6208: ") == 0);
    CHECK(says(alone("bearing = { stock = \"bearing/62\", where = \"d = 41 mm\" }"),
               "no row of bearing/62 has d = 41 mm"));
    CHECK(says(alone("bearing = { where = \"bore = 40 mm\" }"), "unknown column 'bore'"));
    CHECK(says(alone("bearing = { where = \"d = 40 mm\", series = \"62\" }"), "'series' is not a valid key here"));
  }

  TEST_CASE("rows that an engineer rejects: no ribs under thrust, too fast, single at an angle, a typed rating") {
    const auto state = [](const std::string& lines, const char* mode) {
      return mode_of(solved_as_found(alone(lines)), "b", mode);
    };
    CHECK(state("bearing = \"NU 308\"", "axial") == "fail");
    CHECK(state("bearing = \"NJ 308\"", "ribs") == "not-judged");
    CHECK(state("bearing = \"51108\"", "radial") == "fail");
    CHECK(state("bearing = \"30208\"", "mate") == "pass");  // 1 kN covers its induced 2.5/(2 1.6)
    CHECK(state("bearing = \"32308\"", "mate") == "pass");
    CHECK(state("bearing = \"7208 B\"", "mate") == "not-covered");  // it induces 2.2 kN
    CHECK(mode_of(solved_as_found("[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6208\"\nF_r = \"2 kN\"\n"
                                  "n = \"12000 rpm\"\n"),
                  "b", "speed") == "fail");
    const std::string own =
        "[tables.bearings.6208]\nkind = \"deep_groove_ball\"\nd = \"40 mm\"\nC = \"50 kN\"\n"
        "C_0 = \"19 kN\"\nf_0 = 14\nsource = \"list\"\n";
    CHECK(says(own + alone("bearing = \"6208\""), "because"));
  }

  TEST_CASE("a row of any manufacturer, in the form of docs/own-tables.md, is found by its values") {
    const std::string own =
        "[tables.bearings.\"4711-208\"]\nkind = \"deep_groove_ball\"\nd = \"40 mm\"\n"
        "D = \"80 mm\"\nB = \"18 mm\"\nC = \"29.1 kN\"\nC_0 = \"17.9 kN\"\nf_0 = 14\n"
        "n_max = \"8500 rpm\"\nm = \"0.1 kg\"\nsource = \"list of the maker, 2026\"\n";
    CHECK(row_of(own + "[b]\ncalculator = \"bearing.rolling\"\nbearing = { where = \"d = 40 mm\" }\nF_r = \"2 kN\"\n"
                       "n = \"900 rpm\"\nL_h = \"10000 h\"\n")
              .find("4711-208: ") == 0);
  }

  TEST_CASE("the bearing seat: bore, width, fillet and shoulder of the row against the shaft") {
    CHECK(seat_of("bearing = \"6208\"") == "pass");
    CHECK(seat_of("bearing = \"6209\"") == "fail");                            // bore 45 mm
    CHECK(seat_of("bearing = \"NU 2308\"") == "fail");                         // 33 mm wide, 26 mm of room
    CHECK(seat_of("bearing = \"61908\"") == "fail");                           // chamfer 0.6 mm, fillet 1 mm
    CHECK(seat_of("bearing = \"6408\"") == "fail");                            // shoulder 53 mm at least
    CHECK(seat_of("kind = \"deep_groove_ball\"\nC = \"32.5 kN\"") == "open");  // the bore is not known
  }
}
