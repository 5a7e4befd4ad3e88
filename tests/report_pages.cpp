// The pages of a report that decide, check and recompute, for every example.
#include "calculators/catalogue.hpp"
#include "lib/account/conclusion.hpp"
#include "lib/figure/figure.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"
#include "lib/toml/tree.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace loadpath;
using report::Document;
using report::Panel;

constexpr std::size_t most_rows = 10, most_lines = 30, most_pages = 3;

std::string text_of(const std::string& path) {
  std::string text;
  REQUIRE(toml::read_file(path, text));
  return text;
}

std::vector<std::string> examples() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(LOADPATH_ROOT) + "/examples")) {
    const std::string name = entry.path().filename().string();
    const bool is_project = std::filesystem::exists(entry.path() / "project.toml");
    if (is_project && name != "strut-sweep" && test::takes(name)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// An example with more in its [project], and without a line.
project::Project solved(const std::string& name, const std::string& more = {}, const std::string& without = {}) {
  const std::string file = std::string(LOADPATH_ROOT) + "/examples/" + name + "/project.toml";
  std::string text = text_of(file);
  const std::size_t heading = text.find("[project]\n");
  REQUIRE(heading != std::string::npos);
  text.insert(heading + 10, more);
  if (!without.empty()) text.erase(text.find(without), without.size());
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, file, catalogue(), issues);
  project::solve(project, issues);
  REQUIRE(issues.empty());
  return project;
}

/// An example as it is, solved once.
const project::Project& machine(const std::string& name) {
  static std::map<std::string, project::Project> solved_ones;
  const auto found = solved_ones.find(name);
  return found != solved_ones.end() ? found->second : solved_ones.emplace(name, solved(name)).first->second;
}

/// The example of a calculator.
project::Project described(std::string_view id) {
  const Calculator* const found = find_calculator(calculators(), id);
  REQUIRE(found != nullptr);
  std::vector<Issue> issues;
  project::Project project = project::read_project(found->example, "example.toml", catalogue(), issues);
  project::solve(project, issues);
  REQUIRE(issues.empty());
  return project;
}

Document brief_of(const project::Project& project) {
  return report::build(project, "loadpath", report::Detail::brief, "x");
}

std::vector<const Panel*> panels_of(const Document& document) {
  std::vector<const Panel*> panels;
  for (const report::Page& page : document.pages) {
    for (const report::Band& band : page.bands) {
      for (const report::Stack& stack : band) {
        for (const Panel& panel : stack.panels) panels.push_back(&panel);
      }
    }
  }
  return panels;
}

const Panel* panel_of(const Document& document, const std::string& title) {
  for (const Panel* panel : panels_of(document)) {
    if (panel->title.text() == title) return panel;
  }
  return nullptr;
}

const report::Table& table_of(const Document& document, const std::string& title) {
  const Panel* const panel = panel_of(document, title);
  REQUIRE(panel != nullptr);
  return std::get<report::Table>(panel->blocks.front());
}

std::string written(const Panel& panel) {
  Document document;
  document.pages = {{{{{1.0, {panel}}}}, false}};
  document.has_appendix = false;
  return report::markdown(document, "x").text;
}

/// With ordinary blanks.
std::string plain(std::string text) {
  const std::string hard = "\u00A0";
  for (std::size_t at = text.find(hard); at != std::string::npos; at = text.find(hard))
    text.replace(at, hard.size(), " ");
  return text;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("report pages" * test::by_example) {
  TEST_CASE("page 1 has everything needed to decide, and at most three pages come before the appendix") {
    for (const std::string& name : examples()) {
      CAPTURE(name);
      const project::Project& project = machine(name);
      const Document document = brief_of(project);
      CHECK(document.pages.size() <= most_pages);
      CHECK(document.heading.signatures.size() == 3);
      for (const char* title :
           {"Outside the scope of loadpath", "Accepted by user", "Not assessed", "Not considered", "Assumptions"}) {
        CAPTURE(title);
        CHECK(panel_of(document, title) != nullptr);
      }
      CHECK(document.finding.headline == account::conclude(project::modes(project)).headline);
      CHECK(document.blocks.empty());
    }
  }

  TEST_CASE("each figure has a caption of its own") {
    for (const std::string& name : examples()) {
      CAPTURE(name);
      std::set<std::string> captions;
      const Document document = brief_of(machine(name));
      for (const Panel* panel : panels_of(document)) {
        for (const report::Block& block : panel->blocks) {
          if (const auto* const figure = std::get_if<figure::Figure>(&block))
            CHECK_MESSAGE(captions.insert(figure->caption).second, figure->caption);
        }
      }
    }
  }

  TEST_CASE("a half-empty page 1 of a single step is filled with its inputs") {
    const Document document = brief_of(described("gear.cycloidal"));
    REQUIRE(document.pages.size() == 1);
    CHECK(panel_of(document, "Input data") != nullptr);
  }

  TEST_CASE("each governing mode has a number, the failing ones come first, then the highest utilisations") {
    for (const std::string& name : examples()) {
      CAPTURE(name);
      const Document document = brief_of(machine(name));
      if (panel_of(document, "Governing failure modes") == nullptr) continue;
      const auto& rows = table_of(document, "Governing failure modes").rows;
      CHECK(!rows.empty());
      CHECK(rows.size() <= most_rows);
      double before = 1e9;
      for (const auto& row : rows) {
        const auto* const used = std::get_if<report::Utilisation>(&row.back());
        if (used == nullptr) continue;
        CHECK(used->value <= before * (1.0 + 1e-9));
        before = used->value;
      }
    }
  }

  TEST_CASE("a derivation has at most 30 lines and ends with the utilisation of its mode") {
    for (const std::string& name : examples()) {
      CAPTURE(name);
      const Document document = brief_of(machine(name));
      for (const Panel* panel : panels_of(document)) {
        for (const report::Block& block : panel->blocks) {
          const auto* const derivation = std::get_if<report::Derivation>(&block);
          if (derivation == nullptr) continue;
          CHECK(derivation->steps.size() <= most_lines);
          CHECK(derivation->steps.back().symbol.starts_with("u"));
        }
      }
    }
  }

  TEST_CASE("the lines before those of a derivation are a text, each with its formula or its source") {
    const Document document = brief_of(machine("gearbox-shaft"));
    const Panel* const belts = panel_of(document, "From the motor to the shaft: power rating of the belts");
    REQUIRE(belts != nullptr);
    CHECK(belts->remark.empty());
    CHECK(belts->blocks.size() == 2);
    const std::string text = plain(written(*belts));
    CHECK(contains(text, "Preliminary values: P_B = K_A · P = 13.75 kW"));  // 1.25 * 11 kW
    CHECK(contains(text, "[Optibelt-V]"));
    CHECK_FALSE(contains(plain(written(*belts)), "appendix"));
  }

  TEST_CASE("page 1 of a machine with few sizes has its assumptions") {
    const Document document = brief_of(machine("gearbox-shaft"));
    const report::Band& last = document.pages.front().bands.back();
    CHECK(last.front().panels.front().title.text() == "Assumptions");
  }

  TEST_CASE("the links and points of a joint are named by it") {
    const Document document = brief_of(machine("geared-press"));
    const std::string inputs =
        written(*panel_of(document, "Input data")) + written(*panel_of(document, "Input data, continued"));
    CHECK(contains(inputs, "O: first link"));
    CHECK_FALSE(contains(inputs, "first link or point"));
  }

  TEST_CASE("no key of a result is on the pages, outside formulas") {
    const std::regex key("\\b[ux]_[A-Za-z]");
    for (const std::string& name : examples()) {
      CAPTURE(name);
      const Document document = brief_of(machine(name));
      CHECK_FALSE(std::regex_search(document.finding.text.text(), key));
      for (const char* title : {"Chosen sizes", "Governing failure modes"}) {
        const Panel* const panel = panel_of(document, title);
        if (panel != nullptr) CHECK_FALSE(std::regex_search(written(*panel), key));
      }
    }
  }

  TEST_CASE("the short report is the beginning of the full one") {
    for (const std::string& name : examples()) {
      CAPTURE(name);
      const project::Project& project = machine(name);
      const std::string brief = report::markdown(brief_of(project), name).text;
      const Document full = report::build(project, "loadpath", report::Detail::normal, "x");
      CHECK(report::markdown(full, name).text.starts_with(brief));
      CHECK(full.blocks.size() > 1);
    }
  }
}

TEST_SUITE("report of one machine") {
  TEST_CASE("found sizes are marked, with the next smaller ones below; given sizes follow") {
    const Document document = brief_of(machine("gearbox-shaft"));
    const auto& rows = table_of(document, "Chosen sizes").rows;
    const auto& size = std::get<report::Sized>(rows[0][1]);
    CHECK(plain(size.text) == "left seat 40 mm*, pinion seat 50 mm");
    CHECK(plain(size.rest).starts_with("pulley seat 32 mm"));
    std::string text;
    for (const Panel* panel : panels_of(document)) text += plain(written(*panel));
    CHECK(contains(text, "Next smaller size: left seat: 35 mm fails"));
  }

  TEST_CASE("demand, capacity and safety factors are those of the check") {
    const Document document = brief_of(machine("gearbox-shaft"));
    const auto row = [&](const std::string& component, const std::string& mode) {
      for (const auto& cells : table_of(document, "Governing failure modes").rows) {
        if (std::get<std::string>(cells[0]) == component && contains(std::get<std::string>(cells[1]), mode))
          return plain(std::get<std::string>(cells[2]) + "; " + std::get<std::string>(cells[3]));
      }
      return std::string("none");
    };
    CHECK(row("belts", "power rating of the belts") == "13.75 / 18.99 kW; 1.381 / 1");
    CHECK(row("Pinion and wheel", "tooth root bending") == "187.2 / 260 MPa; in σ_adm");
    CHECK(row("Driving shaft", "fatigue of sections and notches, key end") == "1.5 / 2.54; 2.54 / 1.5");
  }

  TEST_CASE("the title block has the texts of the project") {
    const Document document = brief_of(solved("line-shaft",
                                              "company = \"Seiler & Co\"\nload_case = \"start\"\nprepared = "
                                              "\"Lin\"\napproved = \"Ada\"\ndate = \"2026-11-28\"\n"));
    const auto text = [&](const char* name) {
      for (const auto* const fields : {&document.heading.subject, &document.heading.number}) {
        for (const auto& field : *fields) {
          if (field.name.text() == name) return field.text;
        }
      }
      return std::string("none");
    };
    CHECK(text("Company") == "Seiler & Co");
    CHECK(text("Load case") == "start");
    CHECK(text("Date") == "2026-11-28");
    CHECK(text("Project") == "");
    CHECK(text("File") == "project.toml");
    REQUIRE(document.heading.signatures.size() == 3);
    CHECK(document.heading.signatures[0].name == "Lin");
    CHECK(document.heading.signatures[0].date == "2026-11-28");
    CHECK(document.heading.signatures[1].name == "");
    CHECK(document.heading.signatures[2].name == "Ada");
    const std::string text_format = report::markdown(document, "x").text;
    CHECK(contains(text_format, "- Prepared: Lin\n- Checked: ____________________\n- Approved: Ada\n"));
    CHECK(contains(report::html(document), "<th scope=\"row\">Approved</th><td>Ada</td>"));
    CHECK(contains(report::latex(document), "Prepared & Lin & 2026-11-28 &"));
  }

  TEST_CASE("the first sentence names the modes that prevent the verdict") {
    const std::string text = brief_of(solved("gearbox-shaft", "", "S_Hmin = 1.1\n")).finding.text.text();
    CHECK(contains(plain(text), "pitting, gear 1 (gears); pitting, gear 2 (gears)"));
    CHECK(contains(text, "highest utilisation 0.961: key, bearing pressure, hub keyway."));
  }

  TEST_CASE("an input that would let a mode be assessed has its meaning and symbol on page 1") {
    const Document document = brief_of(machine("toggle-press"));
    const Panel* const open = panel_of(document, "Not considered");
    REQUIRE(open != nullptr);
    std::string all;
    for (const auto& block : open->blocks) all += std::get<account::Paragraph>(block).text.text() + " ";
    CHECK(contains(all, "Give the allowable shaft slope at the component \u03B2_adm (shaft, "));
    CHECK_FALSE(contains(all, "seats[]"));
  }

  TEST_CASE("one step with few formulas is one page") {
    const Document document = brief_of(machine("line-shaft"));
    REQUIRE(document.pages.size() == 1);
    CHECK(panel_of(document, "Line shaft: angle of twist per unit length") != nullptr);
  }

  TEST_CASE("the equivalent stress of a section follows from its row, its safety factor from that of the next list") {
    const Document document = brief_of(machine("fan-belt"));
    const report::Table& sections = table_of(document, "Sections");
    constexpr double k_max = 1.5;  // of the project
    const auto number = [](const report::Table& table, std::size_t row, std::string_view symbol) {
      const auto head = std::ranges::find_if(
          table.head, [&](const Message& h) { return !h.args.empty() && h.args[0].text() == symbol; });
      REQUIRE(head != table.head.end());
      return std::get<report::Quantity>(table.rows[row][static_cast<std::size_t>(head - table.head.begin())]).si;
    };
    for (std::size_t i = 0; i < sections.rows.size(); ++i) {
      const auto of = [&](std::string_view symbol) { return number(sections, i, symbol); };
      const double A = std::numbers::pi / 4.0 * of("d") * of("d");
      const double fibre = std::hypot(of("sigma_b") + std::abs(of("sigma_n")), std::sqrt(3.0) * of("tau"));
      const double axis = std::hypot(of("sigma_n"), std::sqrt(3.0) * (of("tau") + 4.0 / 3.0 * of("V") / A));
      CHECK(of("sigma_v") == doctest::Approx(k_max * std::max(fibre, axis)).epsilon(1e-3));
    }
    const report::Table& safeties = table_of(document, "Fatigue safety factors of the same sections");
    for (const char* const symbol : {"K_f", "K_fs", "S_e", "sigma_a", "sigma_m", "u_D"})
      CHECK(number(safeties, 0, symbol) > 0.0);
  }

  TEST_CASE("a formula set is printed once: the second bearing has its numbers only") {
    const Document full = report::build(solved("gearbox-shaft"), "loadpath");
    const std::string text = report::markdown(full, "x").text;
    CHECK(contains(text, "Formulas as for Locating bearing, 6308, with these numbers:"));
  }
}
