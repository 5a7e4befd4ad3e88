// Titles that say something else than the numbers and choices of the file.
#include "lib/project/references/titles/titles.hpp"

#include "lib/project/references/titles/quantities.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string texts_of(std::string_view text) {
  std::string all;
  for (const project::Said& said : project::quantities_in(text)) all += (all.empty() ? "" : ", ") + said.text;
  return all;
}

std::string shaft(const std::string& title, const std::string& torque = "\"300 N*m\"") {
  return "[s]\ntitle = \"" + title + "\"\ncalculator = \"shaft.torsion\"\nT = " + torque +
         "\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";
}

/// The inputs of a step with this title that need a reason.
std::string loads(const std::string& title, const std::string& torque = "\"300 N*m\"") {
  return inputs_found(&project::titles_of_other_loads, shaft(title, torque));
}

std::string hoist(const std::string& title, const std::string& mass) {
  return inputs_found(
      &project::titles_of_other_loads,
      "[project]\ntitle = \"" + title + "\"\n[values]\nm = \"" + mass +
          "\"\ng = \"9.81 m/s^2\"\n[l]\ncalculator = \"pin.lug\"\nF = \"=values.m*values.g\"\nd = \"40 "
          "mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 mm\"\np_adm = \"90 MPa\"\nmaterial = \"S355\"\nS = 2\n");
}

std::string choices(const std::string& title, const std::string& calculator, const std::string& lines) {
  std::string step = example_of(calculator, lines);
  step.insert(step.find('\n') + 1, "title = \"" + title + "\"\n");
  return inputs_found(&project::titles_of_other_choices, step);
}

}  // namespace

TEST_SUITE("project: titles") {
  TEST_CASE("quantities in a text") {
    CHECK(texts_of("Hoist for 5 t, 4 falls") == "5 t");
    CHECK(texts_of("22-kN press, C45E, M20, DN 200, HEB 200") == "22 kN");
    CHECK(texts_of("the clutch slips at 900 N m.") == "900 N*m");
    CHECK(texts_of("under 1260 lbf in of bending and 1100 lbf*in of torsion") == "1260 lbf*in, 1100 lbf*in");
    CHECK(texts_of("250 strokes a minute; 30 lifts per minute, 12 blows/min, 40 strokes") == "250 rpm, 30 rpm, 12 rpm");
    CHECK(texts_of("2.5 kW (0.75 kW at 1450 rpm)") == "2.5 kW, 0.75 kW, 1450 rpm");
    CHECK(texts_of("1,000 kN and rev. 3").empty());  // a thousand, or a decimal comma
    CHECK(texts_of("").empty());
  }

  TEST_CASE("a load in the title of a step that no number is") {
    CHECK(loads("Shaft for 300 N m").empty());
    CHECK(loads("Shaft for 0.3 kN m").empty());
    CHECK(loads("Shaft for 308 N m").empty());
    CHECK(loads("Shaft for 480 N m") == "T");
    CHECK(loads("Shaft for 5 kN").empty());  // it has no force
    CHECK(loads("Shaft of 80 mm").empty());
    CHECK(loads("Shaft for 600 N m", "\"=2*(300 N*m)\"").empty());
    CHECK(loads("Shaft for 300 N m, half of 600 N m", "\"=(600 N*m)/2\"").empty());
    CHECK(loads("Shaft for 380 degC") == "T");
  }

  TEST_CASE("a load in the title of the project that no number is") {
    CHECK(hoist("Hoist for 5 t", "5000 kg").empty());
    CHECK(hoist("Hoist for 5 t", "5200 kg").empty());
    CHECK(hoist("Hoist for 49 kN", "5000 kg").empty());
    CHECK(hoist("Hoist for 5 t", "3200 kg") == "F");
    CHECK(hoist("Hoist for 5 t", "4000 kg") == "F");
    CHECK(hoist("Hoist with a motor of 4 kW", "4000 kg").empty());
  }

  TEST_CASE("choices that a title contradicts") {
    const std::string column = "column.buckling";
    CHECK(choices("Rod, eyes with pins at both ends", column, "ends = \"fixed_fixed\"") == "ends");
    CHECK(choices("Rod, pinned, its foot welded", column, "ends = \"fixed_fixed\"").empty());
    CHECK(choices("Spindle, head free to sway", column, "ends = \"fixed_pinned\"") == "ends");
    CHECK(choices("Spindle, head free to sway", column, "ends = \"fixed_free\"").empty());
    CHECK(choices("Spindle of a free length of 2 m", column, "ends = \"fixed_pinned\"").empty());
    CHECK(choices("Pin on one side only", "pin.joint", "held = \"in_fork\"") == "held");
    CHECK(choices("Pin on one side only", "pin.joint", "held = \"one_side\"").empty());
    CHECK(choices("Pin, 200 lifts a day", "pin.joint", "loading = \"steady\"") == "loading");
    CHECK(choices("Pin, 200 lifts a day", "pin.joint", "loading = \"pulsating\"").empty());
    CHECK(choices("Pin of a day shift", "pin.joint", "loading = \"steady\"").empty());
  }
}
