#include "lib/report/terminal/short.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/toml/tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace loadpath;
using terminal::Look;

namespace {

project::Project solved(const std::string& text, const std::string& file) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, file, catalogue(), issues);
  REQUIRE_FALSE(has_errors(issues));
  project::solve(project, issues, {.pictures = false, .formulas = true});
  REQUIRE_FALSE(has_errors(issues));
  return project;
}

/// Every example that is one machine: a sweep has no answer of this form.
std::vector<std::string> examples() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(LOADPATH_ROOT "/examples")) {
    const std::filesystem::path file = entry.path() / "project.toml";
    if (std::filesystem::exists(file) && entry.path().filename() != "strut-sweep") files.push_back(file.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

project::Project example(const std::string& file) {
  std::string text;
  REQUIRE(toml::read_file(file, text));
  return solved(text, file);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

bool begins_with_headline(const std::string& text) {
  const std::vector<std::string> words{"PASS (", "FAIL  ", "INCOMPLETE  ", "NO SOLUTION  "};
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return text.starts_with(word); });
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string failing = R"([axle]
calculator = "shaft.torsion"
T = "2700 N*m"
d = "70 mm"
tau_adm = "30 MPa"
)";

}  // namespace

TEST_SUITE("short answer") {
  TEST_CASE("every example: the verdict first, at most 25 lines of 80 columns, no line too wide") {
    CHECK(examples().size() >= 16);
    for (const std::string& file : examples()) {
      CAPTURE(file);
      const report::Summary summary = report::summarise(example(file));
      for (const std::size_t width : {60U, 80U, 100U, 120U}) {
        CAPTURE(width);
        const std::string text = terminal::short_answer(summary, {.width = width});
        const auto lines = lines_of(text);
        CHECK(begins_with_headline(text));
        if (width >= 80) CHECK(lines.size() <= 25);
        for (const std::string& line : lines) CHECK_MESSAGE(terminal::length_of(line) <= width, line);
        CHECK(contains(text, "Demand / capacity") == (width >= 100));
        CHECK(contains(text, "More: --full"));
      }
    }
  }

  TEST_CASE("where the locale has no UTF-8 all signs are ASCII") {
    for (const std::string& file : examples()) {
      CAPTURE(file);
      const std::string text = terminal::short_answer(report::summarise(example(file)), {.width = 80, .utf8 = false});
      const bool is_plain =
          std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
      CHECK_MESSAGE(is_plain, text);
    }
    CHECK(terminal::bar(0.859, {.utf8 = false}) == "########..");
    CHECK(terminal::bar(1.2, {.utf8 = false}) == "#########>");
  }

  TEST_CASE("a bar has ten cells: full at 1, not before, an arrow beyond") {
    CHECK(terminal::bar(0.859, {}) == "████████▋░");
    CHECK(terminal::bar(1.0, {}) == "██████████");
    CHECK(terminal::bar(0.9997, {}) == "█████████▉");
    CHECK(terminal::bar(1.0002, {}) == "█████████▶");
    CHECK(terminal::bar(0.0, {}) == "░░░░░░░░░░");
  }

  TEST_CASE("a failure names its mode, its utilisation, demand and capacity; the row comes first") {
    const std::string text = terminal::short_answer(report::summarise(solved(failing, "a.toml")), Look{});
    CHECK(text.starts_with("FAIL  "));
    CHECK(contains(lines_of(text)[0], ", utilisation 1.336 (40.1 / 30 MPa)"));
    CHECK(lines_of(text)[1].starts_with("1 of 1 fails, 0 pass"));
    CHECK(contains(text, "  axle       d = 70 mm  "));
    CHECK(contains(text, " 1.336 █████████▶\n"));
  }

  TEST_CASE("every calculator declares the contents of the size column, by fields that it has") {
    for (const Calculator* calculator : calculators()) {
      CAPTURE(std::string(calculator->id));
      CHECK(*calculator->headline != '\0');
      const std::string headline = std::string(calculator->headline) + calculator->details;
      for (std::size_t at = headline.find('{'); at != std::string::npos; at = headline.find('{', at + 1)) {
        std::string key = headline.substr(at + 1, headline.find('}', at) - at - 1);
        if (key.ends_with('#') || key.ends_with('!')) key.pop_back();
        if (calculator->result == nullptr) continue;  // a mechanism: names of the input make its results
        const auto groups = table_groups(*calculator);
        const bool known = find_field(calculator->input->fields, key) != nullptr ||
                           find_field_at(calculator->result->fields, key) != nullptr ||
                           std::find(groups.begin(), groups.end(), key) != groups.end();
        CHECK_MESSAGE(known, (std::string(calculator->id) + " " + key));
      }
    }
  }

  TEST_CASE("a number without a unit gets none") {
    CHECK(report::short_quantity(0.661, "") == "0.661");
    CHECK(report::short_quantity(0.661, "-") == "0.661");
    CHECK(report::short_quantity(12345.0, "N") == "12.35\u00A0kN");
  }

  TEST_CASE("the data of the answer: the next smaller size, demand and capacity, the step to add") {
    const report::Summary shaft = report::summarise(example(LOADPATH_ROOT "/examples/line-shaft/project.toml"));
    REQUIRE(shaft.next.size() == 1);
    CHECK(shaft.next[0].size.name == "95 mm");
    CHECK(shaft.next[0].size.mode == "twist");
    CHECK(shaft.next[0].size.fails == "u_theta");
    CHECK(shaft.next[0].size.number.value_or(0.0) == doctest::Approx(1.0552).epsilon(1e-4));
    REQUIRE(shaft.components.size() == 1);
    REQUIRE(shaft.components[0].governing);
    REQUIRE(shaft.components[0].governing->compared);
    CHECK(shaft.components[0].governing->compared->demand.unit == "deg/m");
    const report::Summary driven = report::summarise(solved(R"([train]
calculator = "drive.train"
P = "5 kW"
n_1 = "1450 rpm"
stages = [{ i = 4, eta = 0.97 }]
[shaft]
calculator = "shaft.torsion"
T = "=train.shafts[2].T"
tau_adm = "30 MPa"
)",
                                                            "a.toml"));
    const auto adds = [](const report::Gap& gap) {
      return gap.action.typed == "add a step of fatigue.cycle with cycle = \"=shaft.cycle\"";
    };
    CHECK(std::any_of(driven.gaps.begin(), driven.gaps.end(), adds));
  }

  TEST_CASE("a missing limit is shown with the result that it would limit") {
    const report::Summary bearing = report::summarise(solved(R"([ball]
calculator = "bearing.rolling"
bearing = "6208"
F_r = "2 kN"
n = "950 rpm"
)",
                                                             "a.toml"));
    const auto is_hint = [](const report::Gap& gap) { return gap.action.typed.starts_with("give L_h, L_m (L_nh = "); };
    CHECK(std::any_of(bearing.gaps.begin(), bearing.gaps.end(), is_hint));
  }

  TEST_CASE("a limit that fails is shown with the values compared") {
    const report::Summary seat = report::summarise(solved(R"([ball]
calculator = "bearing.rolling"
bearing = "6208"
F_r = "2 kN"
n = "950 rpm"
L_h = "20000 h"
s_0 = 1.5
d_s = "40 mm"
r_f = "0.8 mm"
d_f = "42 mm"
)",
                                                          "a.toml"));
    const auto is_hint = [](const std::string& failure) {
      return failure.find("of the shoulder (x_a = 1.119: 47") != std::string::npos;
    };
    REQUIRE(seat.failures.size() == 1);
    CHECK_MESSAGE(is_hint(seat.failures.front()), seat.failures.front());
  }

  TEST_CASE("a mode whose method is not valid is shown with its limit") {
    const report::Summary key = report::summarise(solved(R"([key]
calculator = "shaft.key"
T = "20 N*m"
torque = "one_way"
d = "20 mm"
key = "6x6"
l = "40 mm"
l_n = "45 mm"
S_F = 1.5
R_e_1 = "370 MPa"
R_e_2 = "300 MPa"
R_e_k = "420 MPa"
)",
                                                         "a.toml"));
    const auto is_hint = [](const report::Gap& gap) {
      return gap.action.typed.starts_with("method not valid: x_l = 1.7, covered from 0 to 1.3: effective key length");
    };
    CHECK(std::any_of(key.gaps.begin(), key.gaps.end(), is_hint));
  }
}
