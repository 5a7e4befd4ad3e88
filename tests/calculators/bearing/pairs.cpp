// Two bearings at an angle that share the axial force of their shaft.
#include "calculators/bearing/rolling.hpp"
#include "lib/account/conclusion.hpp"
#include "lib/table/tables.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::test;
using bearing::Arrangement;
using bearing::Carries;
using bearing::Kind;
using bearing::Rolling;

constexpr auto solve = evaluated<Rolling>;

/// Radial loads in kN and factors of the left and the right bearing.
struct Pair {
  double F_rl, Y_l, F_rr, Y_r;
};

/// A bearing of the pair, 100 mm and 300 mm from the end of the shaft.
Rolling::Input one_of(const Pair& p, bool left, Arrangement arrangement, double K_a) {
  Rolling::Input in;
  in.kind = Kind::tapered_roller, in.C = 100.0 * kN, in.n = 300.0 * rpm, in.e = 0.4;
  in.Y = left ? p.Y_l : p.Y_r, in.F_r = (left ? p.F_rl : p.F_rr) * kN;
  in.mate.Y = left ? p.Y_r : p.Y_l, in.mate.F_r = (left ? p.F_rr : p.F_rl) * kN;
  in.x = (left ? 100.0 : 300.0) * mm, in.mate.x = (left ? 300.0 : 100.0) * mm;
  in.arrangement = arrangement, in.F_a = K_a * kN;
  return in;
}

/// Axial loads of A and B in kN.
using Loads = std::array<double, 2>;

/// The load cases as [SKF-pairs] prints them: in cases 1 the external force is directed to B, in cases 2 to A.
Loads load_cases(double F_A, double Y_A, double F_B, double Y_B, double K_a, bool to_B) {
  const double A = 0.5 * F_A / Y_A, B = 0.5 * F_B / Y_B;
  if (to_B) return A >= B || K_a >= B - A ? Loads{A, A + K_a} : Loads{B - K_a, B};
  return A <= B || K_a >= A - B ? Loads{B + K_a, B} : Loads{A, A - K_a};
}

/// A pair whose bearings take Y of each other; a row in quotes, or a search. Forces in kN.
std::string searched_pair(const std::string& left, const std::string& right, double F_left, double F_right,
                          double F_a) {
  const auto of = [&](const std::string& name, const std::string& row, const char* x, double F,
                      const std::string& mate) {
    return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = " + row + "\nF_r = \"" + std::to_string(F) +
           " kN\"\nF_a = \"" + std::to_string(F_a) +
           " kN\"\nn = \"900 rpm\"\nL_h = \"10000 h\"\ns_0 = 1.5\narrangement = \"back_to_back\"\nx = \"" + x +
           "\"\nmate = { " + mate + " }\n";
  };
  const auto mate = [](double F, const char* x, const char* other) {
    return "F_r = \"" + std::to_string(F) + " kN\", x = \"" + x + "\", Y = \"=" + other + ".Y\"";
  };
  return of("left", left, "10 mm", F_left, mate(F_right, "200 mm", "right")) +
         of("right", right, "200 mm", F_right, mate(F_left, "10 mm", "left"));
}

bool is_sound(const Solved& pair) {
  return pair.errors().empty() && std::none_of(pair.all.begin(), pair.all.end(), [](const account::Mode& mode) {
           using account::State;
           return mode.state == State::fail || mode.state == State::not_covered || mode.state == State::not_available;
         });
}

}  // namespace

TEST_SUITE("rolling bearing") {
  TEST_CASE("[Bhandari-15] example 15.9, load case 2a: 10 kN and 20 kN radially, 10 kN along the shaft to the first") {
    const Pair loads{10.0, 1.5, 20.0, 1.5};  // 30212 of its table: Y = 1.5, e = 0.4
    const auto A = solve(one_of(loads, true, Arrangement::back_to_back, 10.0));
    const auto B = solve(one_of(loads, false, Arrangement::back_to_back, 10.0));
    CHECK(in_si(B.F_ax) == doctest::Approx(20000.0 / 3.0));            // 0.5 F_rB/Y
    CHECK(in_si(A.F_ax) == doctest::Approx(10000.0 + 20000.0 / 3.0));  // F_aB + K_a
    CHECK(in_si(A.P) == doctest::Approx(0.4 * 10000.0 + 1.5 * (10000.0 + 20000.0 / 3.0)));
    CHECK(in_si(B.P) == doctest::Approx(20000.0));  // 0.333 is within e
  }

  TEST_CASE("the axial loads of a pair are those of the table of load cases, in both arrangements and directions") {
    for (const Pair& p : {Pair{8.0, 1.6, 3.0, 1.6}, Pair{3.0, 1.6, 8.0, 1.6}, Pair{5.0, 0.57, 5.0, 1.7}}) {
      for (const double K_a : {-9.0, -1.0, 0.0, 0.5, 1.5, 9.0}) {
        for (const Arrangement arrangement : {Arrangement::back_to_back, Arrangement::face_to_face}) {
          const double left = in_si(solve(one_of(p, true, arrangement, K_a)).F_ax) / 1e3;
          const double right = in_si(solve(one_of(p, false, arrangement, K_a)).F_ax) / 1e3;
          // Back to back the left bearing carries what is directed to the right.
          const bool to_left_bearing = (K_a > 0.0) == (arrangement == Arrangement::back_to_back);
          const Loads printed = load_cases(p.F_rl, p.Y_l, p.F_rr, p.Y_r, std::abs(K_a), !to_left_bearing);
          CHECK(left == doctest::Approx(printed[0]));
          CHECK(right == doctest::Approx(printed[1]));
        }
      }
    }
  }

  TEST_CASE("the arrangement gives the direction that each bearing carries, by the positions of both") {
    const Pair p{8.0, 1.6, 3.0, 1.6};
    for (const bool left : {true, false}) {
      CHECK(bearing::carried(one_of(p, left, Arrangement::back_to_back, 0.0)) ==
            (left ? Carries::right : Carries::left));
      CHECK(bearing::carried(one_of(p, left, Arrangement::face_to_face, 0.0)) ==
            (left ? Carries::left : Carries::right));
    }
  }

  TEST_CASE("what a pair needs or contradicts is reported with its remedy") {
    const std::string bare =
        "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"30208\"\nF_r = \"3 kN\"\nn = \"9 rpm\"\n";
    const std::string mate = "mate = { F_r = \"2 kN\", Y = 1.6 }\n";
    const std::string placed = "x = \"10 mm\"\nmate = { F_r = \"2 kN\", Y = 1.6, x = \"90 mm\" }\n";
    CHECK(says(bare + "arrangement = \"face_to_face\"", "a pair is of two single-row bearings"));
    CHECK(says(bare + mate + "arrangement = \"face_to_face\"", "give x and mate.x"));
    CHECK(says(bare + placed + "arrangement = \"face_to_face\"\ncarries = \"right\"", "omit carries"));
    CHECK(mode_of(solved_as_found(bare + placed + "arrangement = \"face_to_face\""), "b", "mate") == "pass");
    CHECK(mode_of(solved_as_found(bare + mate + "arrangement = \"face_to_face\"\ncarries = \"left\""), "b", "mate") ==
          "pass");
  }

  TEST_CASE("the row of one bearing of a pair may be searched") {
    const auto of = [](const std::string& name, const std::string& row, const char* x, const std::string& mate) {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = \"" + row +
             "\"\nF_r = \"5 kN\"\nF_a = \"0 kN\"\n" +
             "n = \"300 rpm\"\nL_h = \"10000 h\"\ns_0 = 1.5\narrangement = \"face_to_face\"\nx = \"" + x +
             "\"\nmate = { F_r = \"5 kN\", " + mate + " }\n";
    };
    const auto pair = [&](const std::string& left, const std::string& right) {
      return of("left", left, "10 mm", "x = \"200 mm\", Y = \"=right.Y\"") +
             of("right", right, "200 mm", "x = \"10 mm\", Y = \"=left.Y\"");
    };
    for (const auto& text : {pair("30208", "?"), pair("?", "30208")}) {
      const auto project = solved_as_found(text);
      for (const char* const step : {"left", "right"}) {
        CHECK(mode_of(project, step, "fatigue") == "pass");
        CHECK(mode_of(project, step, "mate") == "pass");
      }
    }
  }

  TEST_CASE("the rows of both bearings of a pair may be searched: no lighter pair passes") {
    constexpr std::string_view table = "bearing/302";
    const std::vector<table::Entry> rows = table::Tables{}.ordered_rows("bearing", table);
    const std::string search = "{ stock = \"bearing/302\" }";
    const auto mass = [](const table::Entry& row) { return table::property(row, "m")->si; };
    for (const auto& [F_left, F_right, F_a] : {std::array{5.0, 9.0, 2.0}, std::array{12.0, 3.0, -6.0}}) {
      const Solved found(searched_pair(search, search, F_left, F_right, F_a));
      REQUIRE_MESSAGE(is_sound(found), found.messages());
      std::string best_left, best_right;
      double least = std::numeric_limits<double>::infinity();
      for (const table::Entry& left : rows) {
        for (const table::Entry& right : rows) {
          if (mass(left) + mass(right) >= least) continue;
          const auto quoted = [](const table::Entry& row) { return "\"" + row.row->name + "\""; };
          if (!is_sound(Solved(searched_pair(quoted(left), quoted(right), F_left, F_right, F_a)))) continue;
          least = mass(left) + mass(right);
          best_left = left.row->name, best_right = right.row->name;
        }
      }
      CHECK(found.word("left.bearing") == best_left);
      CHECK(found.word("right.bearing") == best_right);
      CHECK(found.value("left.mate.Y") == found.value("right.Y"));
      CHECK(found.value("right.mate.Y") == found.value("left.Y"));
    }
  }

  TEST_CASE("a pair of which no rows pass together has no solution") {
    const std::string search = "{ stock = \"bearing/302\" }";
    const Solved none(searched_pair(search, search, 5.0, 5000.0, 0.0));
    CHECK(none.errors().empty());
    CHECK(account::conclude(none.all).headline == account::Headline::no_solution);
    CHECK(contains(none.origin("left", "bearing"), "none passes, nearest is"));
  }

  TEST_CASE("of bearings that do not pass, the nearest one has the bore of its seat") {
    const Solved none(
        "[left]\ncalculator = \"bearing.rolling\"\nbearing = { stock = \"bearing/62\" }\nF_r = \"10 kN\"\nn = \"500 "
        "rpm\"\n"
        "L_h = \"10000 h\"\ns_0 = 1\nd_s = \"35 mm\"\nd_f = \"40 mm\"\n");
    CHECK(none.errors().empty());
    CHECK(contains(none.origin("left", "bearing"), "none passes, nearest is 6207"));
  }

  TEST_CASE("two bearings of a shaft take Y from each other, and the shaft takes their pressure centres") {
    const auto of = [](const std::string& name, const std::string& other, const std::string& row) {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nload = \"=shaft.bearings." + name + "\"\nbearing = \"" +
             row + "\"\narrangement = \"face_to_face\"\nmate = { load = \"=shaft.bearings." + other +
             "\", Y = \"=" + other + ".Y\" }\n";
    };
    const auto on_shaft = [&](const std::string& left, const std::string& right) {
      return "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\n"
             "pieces = [{ l = \"400 mm\", d = \"40 mm\" }]\n"
             "supports = [{ name = \"left\", x = \"100 mm\", holds = \"both\"" +
             left + " }, { name = \"right\", x = \"300 mm\"" + right +
             " }]\nseats = [{ x = \"200 mm\", F_x = \"8 kN\", F_z = \"1 kN\", n = \"900 rpm\" },"
             " { x = \"350 mm\", F_x = \"1 kN\" }]\nS_F = 1.5\nR_z = \"6.3 um\"\n" +
             of("left", "right", "30208") + of("right", "left", "32308");
    };
    const Solved pair(on_shaft(", s_p = \"=left.a - left.B/2\"", ", s_p = \"=right.B/2 - right.a\""));
    REQUIRE_MESSAGE(!has_errors(pair.issues), pair.messages());
    // Pressure centres 16 - 9.875 and 23 - 17.625 mm inside: supports at 106.125 and 294.625 mm.
    const double between = 294.625 - 106.125;
    const double F_right = (8.0 * (200.0 - 106.125) + (350.0 - 106.125)) / between, F_left = 9.0 - F_right;
    CHECK(pair.value("shaft.bearings.right.F_r") == doctest::Approx(1e3 * F_right));
    CHECK(pair.value("shaft.bearings.left.F_r") == doctest::Approx(1e3 * F_left));
    // Face to face the right bearing carries the force to the right; Y as tabled.
    const double induced_left = 0.5 * F_left / 1.6, induced_right = 0.5 * F_right / 1.7;
    CHECK(pair.value("right.F_ax") == doctest::Approx(1e3 * std::max(induced_right, induced_left + 1.0)));
    CHECK(pair.value("left.F_ax") == doctest::Approx(1e3 * std::max(induced_left, induced_right - 1.0)));
    CHECK(pair.value("left.s_c") == doctest::Approx(6.125e-3));
    CHECK(pair.value("right.s_c") == doctest::Approx(-5.375e-3));
    CHECK(mode_of(pair.project, "left", "pressure_centre") == "pass");
    CHECK(mode_of(pair.project, "right", "pressure_centre") == "pass");
    const Solved outside(on_shaft(", s_p = \"=left.B/2 - left.a\"", ""));
    CHECK(mode_of(outside.project, "left", "pressure_centre") == "not-covered");
    CHECK(mode_of(outside.project, "right", "pressure_centre") == "not-covered");
  }

  TEST_CASE("a pressure centre beyond the shaft is refused with its remedy") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\n"
        "pieces = [{ l = \"400 mm\", d = \"40 mm\" }]\nseats = [{ x = \"200 mm\", F_x = \"8 kN\" }]\nS_F = 1.5\n";
    CHECK(says(shaft + "supports = [{ x = \"10 mm\", s_p = \"-20 mm\" }, { x = \"300 mm\" }]\n",
               "the pressure centre at -10 mm is beyond the end of the shaft"));
    CHECK(says(shaft + "supports = [{ x = \"10 mm\" }, { x = \"390 mm\", s_p = \"20 mm\" }]\n",
               "lengthen the end of the shaft"));
  }
}
