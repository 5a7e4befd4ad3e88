// Diameters of a shaft that are found together: everything passes, nothing can be smaller, and the shape is sound.
#include "lib/account/conclusion.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::Solved;

/// A gear between two bearings and a coupling on the end; five pieces by their diameters.
using Five = std::array<std::string, 5>;
const Five all_sought{"?", "?", "?", "?", "?"};
std::string shaft(const Five& d, const std::string& more = "") {
  const auto piece = [&](const char* name, const char* l, const std::string& size) {
    const std::string text = size.starts_with('{') ? size : "\"" + size + "\"";
    return std::string("{ name = \"") + name + "\", l = \"" + l + "\", d = " + text + " }, ";
  };
  return "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nn = \"500 rpm\"\n"
         "pieces = [" +
         piece("end", "60 mm", d[0]) + piece("left", "40 mm", d[1]) + piece("seat", "60 mm", d[2]) +
         piece("collar", "15 mm", d[3]) + piece("right", "40 mm", d[4]) +
         "]\nsupports = [{ name = \"A\", x = \"80 mm\", holds = \"both\", beta_adm = \"0.1 deg\" }, { name = \"B\", x "
         "= "
         "\"195 mm\", beta_adm = \"0.1 deg\" }]\n"
         "seats = [{ name = \"coupling\", x = \"30 mm\", way = \"balances\", mass = \"3 kg\", J = \"0.01 kg*m^2\", "
         "beta_adm = \"0.5 deg\" }, { name = \"gear\", x = \"130 mm\", T = \"200 N*m\", F_x = \"-1200 N\", F_y = "
         "\"3200 N\", x_w = \"62.5 mm\", mass = \"4 kg\", J = \"0.01 kg*m^2\", beta_adm = \"0.03 deg\" }]\n"
         "notches = [{ name = \"n1\", x = \"60 mm\", kind = \"shoulder\", r = \"1.5 mm\" }, { name = \"n2\", x = "
         "\"100 mm\", kind = \"shoulder\", r = \"1.5 mm\" }, { name = \"n3\", x = \"160 mm\", kind = \"shoulder\", r = "
         "\"2 mm\", h = \"3 mm\" }, { name = \"n4\", x = \"175 mm\", kind = \"shoulder\", r = \"2 mm\" }]\n"
         "S_F = 1.5\nS_D = 1.5\nr_T = 0\nv_adm = \"0.05 mm\"\ntheta_adm = \"0.5 deg/m\"\n" +
         more;
}

constexpr std::array names{"end", "left", "seat", "collar", "right"};
std::string origin(const Solved& solved, std::size_t piece) {
  return solved.origin("axle", std::string("pieces.") + names[piece] + ".d");
}

/// The diameters that were found, in mm.
std::array<double, 5> found(Solved& solved) {
  std::array<double, 5> d{};
  for (std::size_t i = 0; i < 5; ++i) d[i] = 1e3 * solved.value("axle.pieces[" + std::to_string(i + 1) + "].d");
  return d;
}

}  // namespace

TEST_SUITE("shaft sizing" * test::by_case) {
  TEST_CASE("all diameters together: all pass, the shape is valid, and each states why one size smaller fails") {
    Solved solved(shaft(all_sought));
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    for (const char* mode : {"yield", "fatigue", "deflection", "twist", "slope_seats", "critical_torsion"})
      CHECK_MESSAGE(solved.mode(std::string("axle.") + mode).state == State::pass, mode);
    const auto d = found(solved);
    CHECK(d[1] >= d[0] + 3.0 - 1e-9);
    CHECK(d[2] >= d[1] + 3.0 - 1e-9);
    CHECK(std::abs(d[3] - d[2]) >= 6.0 - 1e-9);
    CHECK(std::min(d[2], d[3]) >= d[4] + 4.0 - 1e-9);
    for (const std::size_t bearing : {std::size_t{1}, std::size_t{4}})
      CHECK(std::abs(d[bearing] / 5.0 - std::round(d[bearing] / 5.0)) < 1e-9);
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK_MESSAGE(contains(origin(solved, i), "in combination with the other sizes; "), origin(solved, i));
    }
  }

  TEST_CASE("no segment can be smaller: it fails, or its shoulder is lower than its fillet") {
    if (test::sanitized) return;  // the search of the case above once more
    Solved solved(shaft(all_sought));
    const auto d = found(solved);
    for (std::size_t i = 0; i < 5; ++i) {
      const double less = (i == 1 || i == 4) ? d[i] - 5.0 : 0.94 * d[i];  // a step of R40 is 6 %
      Five typed;
      for (std::size_t k = 0; k < 5; ++k) typed[k] = std::to_string(k == i ? less : d[k]) + " mm";
      Solved smaller(shaft(typed));
      const bool told = contains(origin(solved, i), "shoulder at x = ") || contains(origin(solved, i), "pushed over");
      bool fails = !smaller.errors().empty();
      for (const account::Mode& mode : smaller.all)
        fails = fails || mode.state == State::fail || mode.state == State::not_covered;
      CHECK_MESSAGE((told || fails), i, " ", less);
    }
  }

  TEST_CASE("two diameters: of all pairs that are no larger none passes, tried one by one") {
    const auto two = [](const std::string& a, const std::string& b) {
      return "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"700 MPa\"\nR_e = \"490 "
             "MPa\"\ngroup = \"carbon-steel\"\npieces = [{ l = \"80 mm\", d = \"" +
             a + "\" }, { l = \"150 mm\", d = \"" + b +
             "\" }]\nsupports = [{ x = \"90 mm\" }, { x = \"220 mm\" }]\nseats = [{ x = \"0 mm\", F_x = \"3 kN\", way "
             "= \"drives\", T = \"150 N*m\" }, { x = \"150 mm\", T = \"150 N*m\" }]\nnotches = [{ x = \"80 mm\", kind "
             "= \"shoulder\", r = \"2 mm\" }]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\n";
    };
    Solved solved(two("?", "?"));
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    const double a = 1e3 * solved.value("axle.pieces[1].d"), b = 1e3 * solved.value("axle.pieces[2].d");
    CHECK(solved.mode("axle.fatigue").state == State::pass);
    for (const double x : {1.0, 0.94, 0.89, 0.84}) {
      for (const double y : {0.0, 5.0, 10.0}) {
        if ((x == 1.0 && y == 0.0) || b - y < x * a + 4.0) continue;
        Solved other(two(std::to_string(x * a) + " mm", std::to_string(b - y) + " mm"));
        CHECK_MESSAGE(other.mode("axle.fatigue").state != State::pass, x * a, " ", b - y);
      }
    }
  }

  TEST_CASE("given sizes are kept, and the others are adapted to them") {
    Five collar = all_sought;
    collar[3] = "60 mm";
    Solved solved(shaft(collar));
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    const auto d = found(solved);
    CHECK(d[3] == Approx(60.0));
    CHECK(d[2] <= 54.0 + 1e-9);
    CHECK(d[4] <= 56.0 + 1e-9);
    CHECK(solved.mode("axle.fatigue").state == State::pass);
    if (test::sanitized) return;
    Five own = all_sought;
    own[1] = "{ stock = \"shaft\" }";
    Solved by_stock(shaft(own));
    REQUIRE_MESSAGE(!has_errors(by_stock.issues), by_stock.messages());
    CHECK(contains(origin(by_stock, 1), "smallest of shaft"));
  }

  TEST_CASE("segments without a notch between them are one cylinder, and fit a bearing bore together") {
    const std::string text =
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"700 MPa\"\nR_e = \"490 "
        "MPa\"\ngroup = \"carbon-steel\"\npieces = [{ l = \"100 mm\", d = \"?\" }, { l = \"100 mm\", d = \"?\" "
        "}]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ x = \"120 mm\", F_x = \"9 kN\" }]\nS_F = "
        "1.5\nS_D = 1.5\nr_T = 0\n";
    Solved solved(text);
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    CHECK(solved.value("axle.pieces[1].d") == solved.value("axle.pieces[2].d"));
    CHECK(contains(solved.origin("axle", "pieces[1].d"), "smallest of bearing"));
    Solved half(test::with(text, "pieces", "[{ l = \"100 mm\", d = \"48 mm\" }, { l = \"100 mm\", d = \"?\" }]"));
    CHECK(contains(half.errors(), "no combination of sizes"));  // 48 mm is not a bore of a bearing
  }

  TEST_CASE("without a check there is no size, and under too large a load none passes") {
    const std::string bare =
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\ngroup = \"carbon-steel\"\npieces = "
        "[{ l = \"100 mm\", d = \"?\" }, { l = \"100 mm\", d = \"?\" }]\nsupports = [{ x = \"0 mm\" }, { x = \"200 "
        "mm\" "
        "}]\nseats = [{ x = \"120 mm\", F_x = \"9 kN\" }]\n";
    CHECK(contains(Solved(bare).errors(), "cannot be sized"));
    CHECK(contains(Solved(bare).messages(), "S_F"));
    Solved heavy(bare + "R_e = \"300 MPa\"\nS_F = 1.5\nv_adm = \"1e-12 mm\"\n");
    REQUIRE_MESSAGE(!has_errors(heavy.issues), heavy.messages());
    CHECK(heavy.mode("axle.deflection").state == State::not_available);
    CHECK(heavy.has("axle.search"));
    CHECK(contains(heavy.origin("axle", "pieces[1].d"), "no sizes pass together"));
  }

  TEST_CASE("where no size has a strength, the search states which value the table does not give") {
    Solved solved(
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"18CrNiMo7-6\"\ngroup = \"carbon-steel\"\npieces = [{ l = "
        "\"100 mm\", d = \"?\" }, { l = \"100 mm\", d = \"?\" }]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" "
        "}]\nseats = [{ x = \"120 mm\", F_x = \"9 kN\" }]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\n");
    CHECK(contains(solved.origin("axle", "pieces[1].d"), "R_e"));
  }

  TEST_CASE("a bearing seat that can only be the thickest segment has no size, and the search states so") {
    const std::string text =
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\npieces = [{ name = "
        "\"left\", l = \"25 mm\", d = \"45 mm\" }, { name = \"wheel\", l = \"50 mm\", d = \"50 mm\" }, { name = "
        "\"right\", l = \"40 mm\", d = \"?\" }, { name = \"end\", l = \"80 mm\", d = \"45 mm\" }]\n"
        "supports = [{ x = \"12 mm\", holds = \"both\" }, { x = \"90 mm\" }]\n"
        "seats = [{ x = \"50 mm\", T = \"100 N*m\", F_x = \"2 kN\" }, { x = \"155 mm\", way = \"balances\" }]\n"
        "notches = [{ x = \"25 mm\", kind = \"shoulder\", r = \"1 mm\" }, { x = \"75 mm\", kind = \"shoulder\", r = "
        "\"1 mm\" }, { x = \"115 mm\", kind = \"shoulder\", r = \"1 mm\" }]\nS_F = 1.5\n";
    CHECK(contains(Solved(text).origin("axle", "pieces.right.d"), "a bearing seat is the thickest segment"));
  }

  const std::string four_pieces =
      "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"80 GPa\"\nrho = \"7850 kg/m^3\"\nR_e = "
      "\"370 MPa\"\nR_m = \"630 MPa\"\ngroup = \"carbon-steel\"\n";

  TEST_CASE("a segment of a given diameter that yields: no sizes pass, and the segment is named") {
    const std::string text =
        four_pieces +
        "S_F = 2\npieces = [{ l = \"120 mm\", d = \"20 mm\" }, { l = \"30 mm\", d = \"?\" }, { l = \"200 mm\", d = "
        "\"?\" }, { l = \"30 mm\", d = \"?\" }]\n"
        "notches = [{ x = \"120 mm\", kind = \"shoulder\", r = \"2.5 mm\", h = \"1.5 mm\" }, { x = \"150 mm\", kind "
        "= \"shoulder\", r = \"1 mm\" }, { x = \"350 mm\", kind = \"shoulder\", r = \"0.6 mm\" }]\n"
        "supports = [{ x = \"135 mm\", holds = \"both\" }, { x = \"365 mm\" }]\n"
        "seats = [{ x = \"60 mm\", integral = true, way = \"drives\", T = \"200 N*m\", F_x = \"10 kN\" }, { x = "
        "\"250 mm\", integral = true, T = \"200 N*m\", F_x = \"5941 N\" }]\n";
    const Solved solved(text);
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    const std::string why = solved.origin("axle", "pieces[2].d");
    CHECK_MESSAGE(contains(why, "no sizes pass together: sections["), why);
    CHECK_MESSAGE(contains(why, "because pieces[1].d is given as 20 mm; pieces[2].d = "), why);
    CHECK(account::conclude(solved.all).headline == account::Headline::no_solution);
    // R_e of 42CrMo4 is at most 900 MPa, below 795 MPa times S_F, and has no value beyond 250 mm
    const std::string row = "group = \"alloy-steel\"\nmaterial = \"42CrMo4\"\n" + text.substr(text.find("S_F = 2"));
    const std::string of_row = Solved("[axle]\ncalculator = \"shaft.design\"\n" + row).origin("axle", "pieces[2].d");
    CHECK_MESSAGE(contains(of_row, "because pieces[1].d is given as 20 mm; pieces[2].d = "), of_row);
    // 600 N*m and 200 N*m: sigma_v = 795 MPa at 20 mm, 70 MPa at 45 mm
    Solved thicker(test::with(text, "pieces",
                              "[{ l = \"120 mm\", d = \"45 mm\" }, { l = \"30 mm\", d = \"?\" }, { l = "
                              "\"200 mm\", d = \"?\" }, { l = \"30 mm\", d = \"?\" }]"));
    CHECK(thicker.mode("axle.yield").state == State::pass);
  }

  TEST_CASE("sizes between the thin and the thick ones that fail are found: the lightest of all in the stocks") {
    Solved solved(
        four_pieces +
        "S_F = 1.2\nS_D = 1.2\nr_T = -1\nn = \"3000 rpm\"\nv_adm = \"0.2 mm\"\npieces = [{ l = \"40 mm\", d = \"?\" "
        "}, { l = \"60 mm\", d = \"?\" }, { l = \"80 mm\", d = \"?\" }, { l = \"30 mm\", d = \"?\" }, { l = \"60 mm\", "
        "d = \"20 mm\" }]\nnotches = [{ x = \"40 mm\", kind = \"shoulder\", r = \"2.5 mm\" }, { x = \"100 mm\", kind "
        "= \"shoulder\", r = \"0.4 mm\", h = \"3 mm\" }, { x = \"180 mm\", kind = \"shoulder\", r = \"1 mm\" }, { x = "
        "\"34 mm\", kind = \"groove\", r = \"1 mm\", t = \"1 mm\" }]\nsupports = [{ x = \"70 mm\", holds = \"both\" "
        "}, { x = \"195 mm\" }]\nseats = [{ x = \"20 mm\", integral = true, way = \"drives\", T = \"20 N*m\", F_x = "
        "\"4983 N\", angle = \"114 deg\" }, { x = \"240 mm\", integral = true, T = \"20 N*m\", F_x = \"2328 N\", "
        "angle = \"285 deg\" }]\n");
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    constexpr std::array lightest{22.4, 28.0, 35.5, 20.0};  // of all combinations of the stocks, tried one by one
    for (std::size_t i = 0; i < lightest.size(); ++i)
      CHECK(1e3 * solved.value("axle.pieces[" + std::to_string(i + 1) + "].d") == Approx(lightest[i]));
  }

  TEST_CASE("sizes of other kinds are still searched for one at a time") {
    const std::string mixed = shaft({"?", "?", "?", "?", "?"}, "");
    CHECK(contains(Solved(test::with(mixed, "S_F", "\"?\"")).errors(), "cannot be searched for"));
  }
}
