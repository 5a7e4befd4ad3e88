// Searches for one size or row, against brute force: every smaller one of the stock is typed, and fails.
#include "lib/account/conclusion.hpp"
#include "lib/project/run/evaluation/providers.hpp"
#include "lib/table/tables.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// What is searched for in the example of a calculator, with other lines, under a load from small to large.
struct Sized {
  std::string calculator, key, stock;  // of a row: a table, or empty for all of its group; of a name: "kinds of GROUP"
  std::string lines, load, unit;
  std::vector<double> values;

  [[nodiscard]] bool is_name() const { return stock.starts_with("kinds of "); }
  [[nodiscard]] bool is_row() const { return stock.empty() || is_name() || stock.find('/') != std::string::npos; }
};

const std::string round_bar = "section =\nmethod = \"johnson\"\nsigma_P =\n";
const std::string of_chain = "p_adm = \"35 MPa\"\nP_R =\nS_min = 7.6\n";
const std::string of_section = "d =\nmethod = \"euler\"\nl = \"3 m\"\n";
const std::string of_iso =
    "basis = \"iso\"\nbelt_class = \"III\"\nduty =\nmotor =\nh_day =\nK_A = 1.2\nz = 3\nd_1 = \"140 mm\"\nd_2 = \"280 "
    "mm\"\nL = \"2000 mm\"\n";
const std::string of_bearing =
    "kind =\nC =\nC_0 =\nf_0 =\nn_max =\nF_a =\nL_h = \"10000 h\"\ns_0 = 1\nn = \"900 rpm\"\n";

const std::vector<Sized> all_sized{
    {"shaft.torsion", "d", "R40", "torques =\ntheta_adm =\n", "T", "N*m", {3, 80, 900, 20000}},
    {"shaft.overhung", "d", "R40", "", "F", "N", {30, 800, 3654, 40000}},
    {"vessel.cylinder", "delta", "plate", "", "p", "MPa", {0.2, 1.6, 4}},
    {"vessel.sphere", "delta", "plate", "", "p", "MPa", {0.1, 0.8, 2}},
    {"vessel.end", "delta", "plate", "", "p", "MPa", {0.2, 1, 2}},
    {"vessel.flat_end", "delta", "plate", "", "p", "MPa", {0.2, 1, 2}},
    {"vessel.external", "delta", "plate", "", "p_e", "MPa", {0.02, 0.1, 0.3}},
    {"vessel.cone", "delta", "plate", "", "p", "MPa", {0.02, 0.1, 0.5}},
    {"column.buckling", "d", "R40", round_bar, "P", "kN", {2, 40, 600}},
    {"pin.joint", "d", "R40", "", "F", "kN", {1, 14.5, 30}},
    {"pin.lug", "t", "R40", "", "F", "kN", {5, 20, 50}},
    {"pin.en1993", "d", "R40", "", "F", "kN", {60, 150}},
    {"belt.flat", "b", "R20", "", "P", "kW", {2, 8, 15}},
    {"belt.synchronous", "b", "synchronous_widths", "", "P", "kW", {0.5, 4, 6}},
    {"chain.inverted_tooth", "b", "R20", "", "P", "kW", {4, 8, 15}},
    {"drive.friction_wheels", "b", "R20", "", "P", "kW", {0.2, 0.8, 1.5}},
    {"gear.pair", "m_n", "module", "a_w =\nx_1 =\n", "T_1", "N*m", {2, 60, 150}},
    {"shaft.press_fit", "l", "R20", "", "T", "N*m", {100, 400, 600}},
    {"shaft.key", "d", "R40", "", "T", "N*m", {100, 300, 450}},
    {"shaft.key", "l", "key", "", "T", "N*m", {350, 400, 450}},
    {"shaft.key", "key", "", "", "T", "N*m", {200, 450}},
    {"bearing.rolling", "bearing", "bearing/62", of_bearing, "F_r", "kN", {0.8, 2.5, 12}},
    {"bearing.rolling", "bearing", "bearing/NU2", of_bearing, "F_r", "kN", {2.5, 30}},
    {"column.buckling", "section", "sections/ipe", of_section, "P", "kN", {4, 40, 300}},
    {"column.buckling", "section", "sections/hea", of_section, "P", "kN", {40, 600}},
    {"chain.roller", "chain", "", of_chain, "P", "kW", {0.3, 3, 8}},
    {"shaft.circlip", "circlip", "", "", "F_a", "kN", {0.3, 1, 2.2}},
    {"shaft.spline", "spline", "", "", "T", "N*m", {60, 640, 2000}},
    {"shaft.set_screw", "set_screw", "", "d = \"60 mm\"\n", "T", "N*m", {4, 20, 100}},
    {"belt.synchronous", "synchronous_belt", "", "", "P", "kW", {0.5, 4, 12}},
    {"belt.v", "section", "kinds of v_belt", "z = 4\n", "P", "kW", {8, 20, 40, 80}},
    {"belt.v", "section", "kinds of v_belt", of_iso, "P", "kW", {1, 5, 14}},
};

std::string number(double value, const std::string& unit) {
  char text[40];
  std::snprintf(text, sizeof text, "\"%.9g %s\"", value, unit.c_str());
  return text;
}

/// The lines of the example under a load, with a value of what is searched for: "?" in quotes.
std::string lines_of(const Sized& sized, double load, const std::string& value) {
  return sized.lines + sized.load + " = " + number(load, sized.unit) + "\n" + sized.key + " = " + value + "\n";
}
std::string asked(const Sized& sized) {
  return sized.stock.empty() || sized.is_name() ? "\"?\"" : "{ stock = \"" + sized.stock + "\" }";
}

/// All that can be typed instead, from small to large: "45 mm" in quotes, or a row.
std::vector<std::string> candidates(const Sized& sized) {
  std::vector<std::string> all;
  if (sized.is_name()) {
    for (const table::Entry& row : table::Tables{}.ordered_rows(sized.stock.substr(9), "")) {
      const std::string kind = "\"" + row.row->kind + "\"";
      if (std::find(all.begin(), all.end(), kind) == all.end()) all.push_back(kind);
    }
  } else if (sized.is_row()) {
    for (const table::Entry& row : table::Tables{}.ordered_rows(sized.key, sized.stock))
      all.push_back("\"" + row.row->name + "\"");
  } else {
    for (const double si : project::stock_values({}, sized.stock)) all.push_back(number(1e3 * si, "mm"));
  }
  return all;
}

/// What was found, as it is typed; empty if there is nothing.
std::string found_by(const Sized& sized, const ExampleStep& step) {
  const project::Step& own = *step.project().steps[0];
  if (sized.is_row()) return own.word(sized.key).empty() ? "" : "\"" + own.word(sized.key) + "\"";
  const Value* const value = step.project().value(own.name() + "." + sized.key);
  return value == nullptr || std::isnan(value->si[0]) ? "" : number(1e3 * value->si[0], "mm");
}

/// Whether no assessed mode fails, and every method is valid.
bool passes(const ExampleStep& step) {
  if (!step.fault().empty()) return false;
  for (const account::Mode& mode : project::modes(step.project())) {
    using account::State;
    if (mode.state == State::fail || mode.state == State::not_covered || mode.state == State::not_available)
      return false;
  }
  return true;
}

/// The step that searches, and another that takes what it finds.
std::string with_one_that_takes(const Sized& sized, double load) {
  const std::string text =
      with_lines(find_calculator(calculators(), sized.calculator)->example, lines_of(sized, load, asked(sized)));
  const std::size_t at = text.rfind("\n[") + 2;
  const std::string name = text.substr(at, text.find(']', at) - at);
  return text + "\n[next" + with(text.substr(at + name.size()), sized.key, "\"=" + name + "." + sized.key + "\"");
}

std::string first_that_passes(const Sized& sized, double load) {
  for (const std::string& candidate : candidates(sized)) {
    if (passes(ExampleStep(sized.calculator, lines_of(sized, load, candidate)))) return candidate;
  }
  return "";
}

}  // namespace

TEST_SUITE("searches by brute force" * takes_share) {
  TEST_CASE("the result of a search is the first of its stock that passes when it is typed") {
    for (const Sized& sized : all_sized) {
      bool finds_any = false;
      for (std::size_t i = 0; i < sized.values.size(); ++i) {
        if (!is_tried(i, sized.values.size())) continue;
        const double load = sized.values[sized.values.size() - 1 - i];
        CAPTURE(sized.calculator);
        CAPTURE(sized.key);
        CAPTURE(load);
        const ExampleStep step(sized.calculator, lines_of(sized, load, asked(sized)));
        CHECK_MESSAGE(step.fault().empty(), step.fault());
        if (!step.fault().empty()) continue;
        const std::string found = found_by(sized, step);
        CHECK(found == first_that_passes(sized, load));
        finds_any = finds_any || !found.empty();
      }
      if (in_full()) CHECK_MESSAGE(finds_any, sized.calculator, ".", sized.key);
    }
  }
}

TEST_SUITE("searches without a result") {
  TEST_CASE("the nearest candidate and its failure are named, and nothing downstream is computed") {
    for (const Sized& sized : all_sized) {
      CAPTURE(sized.calculator);
      CAPTURE(sized.key);
      std::string told;
      for (const double times : {20.0, 100.0, 1e3, 1e7}) {  // until no size is large enough, but the method is valid
        const Solved solved(with_one_that_takes(sized, times * sized.values.back()));
        CHECK_MESSAGE(solved.errors().empty(), solved.errors());
        for (const account::Mode& mode : solved.all) {
          if (mode.subject == account::Subject::search) told += mode.note.text();
        }
        if (told.empty()) continue;
        for (const account::Mode& mode : solved.all) {
          CHECK_MESSAGE(mode.state != account::State::fail, mode.step, ".", mode.id);
          if (mode.step == "next") CHECK_MESSAGE(mode.state != account::State::pass, mode.id);
        }
        CHECK(account::conclude(solved.all).headline == account::Headline::no_solution);
        break;
      }
      CHECK_MESSAGE(contains(told, "none passes, nearest is "), told);
    }
  }

  TEST_CASE("of bearings without axial capacity none is taken, whatever their size") {
    const Sized sized{"bearing.rolling", "bearing", "bearing/NU2", of_bearing, "F_r", "kN", {}};
    const Solved solved(with_lines(find_calculator(calculators(), sized.calculator)->example,
                                   lines_of(sized, 2.5, asked(sized)) + "F_a = \"1 kN\"\nholds = \"both\"\n"));
    CHECK(account::conclude(solved.all).headline == account::Headline::no_solution);
    const std::string why = solved.origin("left", "bearing");  // NU 202 has a life of some 4000 h at this load
    CHECK_MESSAGE(contains(why, "none passes, nearest is NU 203 ECP: F_ao = 1000 N"), why);
  }
}

TEST_SUITE("missing inputs of searches") {
  TEST_CASE("all missing input next to the searched value is named at once") {
    Share share(4);
    for (const Sized& sized : all_sized) {
      if (share.skips()) continue;
      const std::string lines = lines_of(sized, sized.values.back(), asked(sized));
      const Solved bare("[part]\ncalculator = \"" + sized.calculator + "\"\n" + sized.key + " = " + asked(sized) +
                        "\n");
      const std::string named = bare.errors();
      for (const FieldInfo& field : find_calculator(calculators(), sized.calculator)->input->fields) {
        if (field.key == sized.key) continue;
        const ExampleStep without(sized.calculator, lines + field.key + " =\n");
        const std::string missing = "'" + std::string(field.key) + "' is missing";
        if (!contains(without.fault(), missing)) continue;
        CHECK_MESSAGE(contains(named, missing), sized.calculator, ".", sized.key, "\n", named);
      }
    }
  }
}
