// What a report prints as a formula is what the code computes: every line of every derivation that examples, reference
// cases and the tests' rows bring forth, and no formula of the sources that none of them reaches.
#include "lib/formula/formula.hpp"
#include "lib/formula/names.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/appendix.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"
#include "tests/calculators/rows.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/contract/source_formulas.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
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
  if (!has_errors(issues)) project::solve(p, issues, {.pictures = false, .unused = false});
  INFO(file.string());
  REQUIRE(!has_errors(issues));
  use(p);
}

void use_run(const Run& run, const Use& use) {
  const ExampleStep step(run.calculator, run.lines);
  if (step.fault().empty()) use(step.project());  // a fault is reported by the test that owns the row
}

/// A project that can be solved, and the elements of its steps.
struct Source {
  std::vector<std::string> elements;
  std::function<void(const Use&)> solve;
};

/// Every row of the tests, every project of the examples and of the reference cases.
std::vector<Source> sources() {
  std::vector<Source> all;
  const auto add_runs = [&](const std::vector<Run>& runs) {
    for (const Run& run : runs)
      all.push_back({{std::string(element_of(run.calculator))}, [run](const Use& use) { use_run(run, use); }});
  };
  for (const Calculator* c : calculators()) add_runs({{c->id, ""}});
  add_runs(runs_of_laws());
  add_runs(runs_of_limits());
  add_runs(runs_of_limit_cases());
  const auto add_file = [&](const fs::path& file) {
    std::string text;
    REQUIRE(toml::read_file(file.string(), text));
    all.push_back({elements_of_project(text), [file](const Use& use) { use_file(file, use); }});
  };
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples")) {
    if (fs::exists(entry.path() / "project.toml")) add_file(entry.path() / "project.toml");
  }
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/reference")) {
    if (entry.path().extension() == ".toml") add_file(entry.path());
  }
  return all;
}

/// The formula of a line over the numbers that are printed next to it; `revolution`: what a unit of rpm counts as one.
double value_of(const account::Step& step, double revolution = 1.0) {
  const auto tree = formula::parse(step.formula);
  REQUIRE(tree);
  return formula::value(*tree, [&](std::string_view name) -> std::optional<double> {
    for (const auto& given : step.given) {
      if (given.name == name) return given.unit == "rpm" ? given.si / revolution : given.si;
    }
    if (name == "rpm") return 2.0 * std::numbers::pi / 60.0 / revolution;
    return std::nullopt;
  });
}

/// Whether the value is the same with rpm as revolutions per minute, which have no factor 2 pi.
bool comes_out_in_rpm(const account::Step& step) {
  constexpr double revolution = 2.0 * std::numbers::pi;
  const bool is_speed = step.value.unit == "rpm" || step.value.unit == "rad/s";
  const double value = value_of(step), counted = value_of(step, revolution);
  return !(std::abs(counted - value) > 1e-9 * std::abs(value)) ||
         (is_speed && std::abs(counted * revolution - value) <= 1e-9 * std::abs(value));
}

/// Whether no two names of a formula are printed alike, as in.b and r.b would.
bool prints_apart(const account::Step& step) {
  std::set<std::string> names;
  return std::all_of(step.given.begin(), step.given.end(),
                     [&](const auto& given) { return names.insert(given.name).second; });
}

/// The unknown names of a formula: a local that no STEP has made, or of a branch that did not run.
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
    CHECK(comes_out_in_rpm(step));
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

const std::string shared_folder = "load";  // formulas that calculators of all folders share

/// The names under which the sources may have the formula of a line.
void add_names(std::string_view folder, const account::Step& step, std::set<std::string>& names) {
  for (const std::string& where : {std::string(folder), shared_folder}) {
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

/// Whether a project may run one of these formulas.
bool may_run(const Source& source, const std::vector<SourceFormula>& formulas) {
  return std::any_of(formulas.begin(), formulas.end(), [&](const SourceFormula& f) {
    return f.folder == shared_folder ||
           std::find(source.elements.begin(), source.elements.end(), f.folder) != source.elements.end();
  });
}

}  // namespace

TEST_SUITE("contract: formulas" * by_element) {
  TEST_CASE("the text of a step, with the printed symbols, has the value of the code; every source formula runs") {
    std::set<std::string> names;
    const auto check = [&](const project::Project& p) {
      for (const auto& step : p.steps) {
        INFO(p.file, ": ", step->name());
        for (const account::Derived& line : step->account().derivation) {
          check_line(line.step);
          add_names(step->input().calculator->element(), line.step, names);
        }
      }
    };
    auto missing = source_formulas([](std::string_view folder) { return takes(folder); });
    if (!is_part()) CHECK(missing.size() > 600);
    const auto all = sources();
    Share share(8);
    for (const Source& source : all) {
      if (takes(source.elements.front()) && !share.skips()) source.solve(check);
    }
    if (sanitized) return;  // which formulas run is the same
    const auto has_run = [&](const SourceFormula& f) { return ran(f, names); };
    std::erase_if(missing, has_run);
    for (const Source& source : all) {  // a formula of one element may run only in a project of another
      if (takes(source.elements.front()) || !may_run(source, missing)) continue;
      source.solve(check);
      std::erase_if(missing, has_run);
    }
    for (const SourceFormula& f : missing) {
      FAIL_CHECK(f.place, ": ", f.symbol, " = ", f.text,
                 ": nothing runs it: add a row to tests/calculators/limit_cases.cpp, or a case to reference/");
    }
  }
}
