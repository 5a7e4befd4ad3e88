// What a report prints as a formula is what the code computes: every line of every derivation that examples, reference
// cases and the tests' rows bring forth, and no formula of the sources that none of them reaches.
#include "lib/formula/formula.hpp"
#include "lib/formula/names.hpp"
#include "lib/report/build.hpp"
#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"
#include "tests/calculators/rows.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/contract/source_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

namespace {

using namespace loadpath;
using namespace loadpath::test;
namespace fs = std::filesystem;

using Use = std::function<void(const project::Project&)>;

void use_file(const fs::path& file, const Use& use) {
  std::string text;
  REQUIRE(toml::read_file(file.string(), text));
  std::vector<Issue> issues;
  project::Project p = project::read_project(text, file.string(), catalogue(), issues, project::Ranges::taken);
  if (!has_errors(issues)) project::solve(p, issues);
  INFO(file.string());
  REQUIRE(!has_errors(issues));
  use(p);
}

void use_runs(const std::vector<Run>& runs, const Use& use) {
  for (const Run& run : runs) {
    const ExampleStep step(run.calculator, run.lines);
    if (step.fault().empty()) use(step.project());  // a fault is for the test that owns the row to tell
  }
}

/// Every project of the examples and of the reference cases, and every row of the tests.
void for_each_project(const Use& use) {
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples")) {
    if (fs::exists(entry.path() / "project.toml")) use_file(entry.path() / "project.toml", use);
  }
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/reference")) {
    if (entry.path().extension() == ".toml") use_file(entry.path(), use);
  }
  for (const Calculator* c : calculators()) use_runs({{c->id, ""}}, use);
  use_runs(runs_of_laws(), use);
  use_runs(runs_of_limits(), use);
  use_runs(runs_of_limit_cases(), use);
}

/// The formula of a line over the numbers that are printed beside it.
double value_of(const account::Step& step) {
  const auto tree = formula::parse(step.formula);
  REQUIRE(tree);
  return formula::value(*tree, [&](std::string_view name) -> std::optional<double> {
    for (const auto& given : step.given) {
      if (given.name == name) return given.si;
    }
    return std::nullopt;
  });
}

/// Whether no two names of a formula are printed alike, as in.b and r.b would.
bool prints_apart(const account::Step& step) {
  std::set<std::string> names;
  return std::all_of(step.given.begin(), step.given.end(),
                     [&](const auto& given) { return names.insert(given.name).second; });
}

/// The names of a formula that nobody knows: a local that no STEP has made, or of a branch that did not run.
std::string unknown_names(const account::Step& step) {
  std::string unknown;
  const auto tree = formula::parse(step.formula);
  for (const std::string& name : tree ? formula::names(*tree) : std::vector<std::string>{}) {
    const auto is_it = [&](const auto& given) { return given.name == formula::symbol_of(name); };
    const bool known = std::any_of(step.given.begin(), step.given.end(), is_it) || formula::constant(name);
    if (!known) unknown += " " + name;
  }
  return unknown;
}

void check_line(const account::Step& step) {
  INFO(step.symbol, " = ", step.formula);
  if (!step.formula.empty()) {
    CHECK(prints_apart(step));
    const double value = value_of(step);
    const bool both_missing = std::isnan(value) && std::isnan(step.value.si);
    CHECK_MESSAGE((both_missing || std::abs(value - step.value.si) <= 1e-12 * std::abs(step.value.si)),
                  "the text gives ", value, ", the code ", step.value.si,
                  "; no input, no result and no earlier STEP:", unknown_names(step));
  }
  for (const std::string& key : report::keys_in(step.why.text()))
    CHECK_MESSAGE(!table::citation(key).empty(), key, " is no source: add a row to tables/sources.toml");
}

/// A formula of a folder; without a symbol one that several symbols share.
std::string name_of(const std::string& folder, const std::string& symbol, const std::string& text) {
  return folder + ": " + symbol + " = " + text;
}

/// The names under which the sources may have the formula of a line.
void add_names(std::string_view folder, const account::Step& step, std::set<std::string>& names) {
  for (const std::string& where :
       {std::string(folder), std::string("load")}) {  // what calculators of all folders share
    names.insert(name_of(where, step.symbol, step.formula));
    names.insert(name_of(where, "", step.formula));
  }
}

/// Whether a line may be printed without this formula: of "S_0 = is_set(in.S_0) ? in.S_0 : S_0_min" the branch S_0 says
/// nothing, and 1.0 no more than the value.
bool may_be_left_out(const std::string& text) {
  const auto tree = formula::parse(text);
  if (!tree) return false;
  const bool number_of_units = tree->kind == formula::Kind::binary && tree->text == "*" &&
                               tree->kids[0].kind == formula::Kind::number &&
                               !formula::unit_named(tree->kids[1].text).empty();
  return number_of_units || tree->kind == formula::Kind::choose || tree->kind == formula::Kind::number ||
         tree->kind == formula::Kind::symbol;
}

bool ran(const SourceFormula& f, const std::set<std::string>& names) {
  if (names.count(name_of(f.folder, f.symbol, f.text)) == 1) return true;
  return may_be_left_out(f.text) && names.count(name_of(f.folder, f.symbol, "")) == 1;
}

}  // namespace

TEST_SUITE("contract: formulas") {
  TEST_CASE(
      "the text of a step, over the printed symbols, is the value of the code; every formula of the sources runs") {
    std::set<std::string> names;
    for_each_project([&](const project::Project& p) {
      for (const auto& step : p.steps) {
        INFO(p.file, ": ", step->name());
        for (const account::Derived& line : step->account().derivation) {
          check_line(line.step);
          add_names(step->input().calculator->element(), line.step, names);
        }
      }
    });
    const auto formulas = source_formulas();
    CHECK(formulas.size() > 600);
    for (const SourceFormula& f : formulas) {
      CHECK_MESSAGE(ran(f, names), f.place, ": ", f.symbol, " = ", f.text,
                    ": nothing runs it: add a row to tests/calculators/limit_cases.cpp, or a case to reference/");
    }
  }
}
