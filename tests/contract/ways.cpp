// A number concludes the same whichever way it comes: as a literal, an expression, a value of [values], a result, an
// input of another step, a point of a sweep. Numbers are taken far out of their range, where rules, bounds and checks
// refuse them: no way may pass what the literal does not.
#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/variants.hpp"
#include "lib/quantity/format.hpp"
#include "tests/contract/held.hpp"
#include "tests/contract/numbers.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using test::Number;
using toml::Tree;

/// The modes of failure that pass; nothing where the project is refused.
struct Outcome {
  bool is_refused = false;
  std::map<std::string, account::State> states = {};  // by "step.mode"
};

void keep_worst(Outcome& outcome, const std::string& mode, account::State state) {
  const auto [known, is_new] = outcome.states.emplace(mode, state);
  if (!is_new && known->second == account::State::pass) known->second = state;
}

project::Project read(const Tree& tree, const std::string& file, std::vector<Issue>& issues) {
  return project::read_project(tree, file, catalogue(), issues, project::Ranges::taken);
}

Outcome run(const Tree& tree, const std::string& file) {
  std::vector<Issue> issues;
  project::Project project = read(tree, file, issues);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false});
  Outcome outcome{has_errors(issues)};
  for (const account::Mode& mode : project::modes(project)) keep_worst(outcome, mode.step + "." + mode.id, mode.state);
  return outcome;
}

/// The second of two points.
Outcome sweep(const Tree& tree, const std::string& file) {
  std::vector<Issue> issues;
  project::Project project = read(tree, file, issues);
  const bool is_refused = has_errors(issues) || project::swept_inputs(project).size() != 1;
  if (is_refused) return {true};
  project::Variants variants(std::move(project), {});
  const std::vector<double> axis = {variants.axes()[0].axis.at(0), variants.axes()[0].axis.at(1)};
  std::vector<std::vector<double>> out(variants.outputs(), std::vector<double>(2));
  std::vector<double*> taken;
  for (std::vector<double>& column : out) taken.push_back(column.data());
  const double* const in = axis.data();
  variants.evaluate({&in, 1}, taken, 2);
  Outcome outcome{!variants.refusals().empty() && variants.refusals().back().row == 1};
  for (std::size_t k = 0; k < out.size(); ++k) {
    const project::SweptResult& column = variants.columns()[k];
    if (column.kind != project::SweptResult::Kind::state || column.mode.empty()) continue;
    if (out[k][1] >= 0.0 && out[k][1] < account::refused_state)
      keep_worst(outcome, column.step + "." + column.mode, static_cast<account::State>(static_cast<int>(out[k][1])));
  }
  return outcome;
}

/// A number times a factor, in its unit; nothing where it is not written as digits and a unit.
std::optional<Tree> scaled(const Tree& number, double factor) {
  Tree other = number;
  if (number.type == Tree::Type::number) {
    other.number *= factor;
    return other;
  }
  double digits = 0.0;
  const char *const begin = number.text.data(), *const end = begin + number.text.size();
  const auto [unit, fault] = std::from_chars(begin, end, digits);
  const std::string rest(unit, end);
  if (fault != std::errc() || rest.find_first_of(",0123456789") < 2) return std::nullopt;
  other.text = format_exact(digits * factor) + rest;
  return other;
}

Tree text_tree(std::string text) {
  Tree tree;
  tree.type = Tree::Type::text;
  tree.text = std::move(text);
  return tree;
}

Tree with(const Tree& tree, const Number& number, Tree written) {
  Tree other = tree;
  Tree& place = test::tree_at(other, number.way);
  written.place = place.place;
  place = std::move(written);
  return other;
}

/// With [values], of which the second refers to the first.
Tree with_values(const Tree& tree, const Tree& value) {
  Tree other = tree;
  Tree table;
  table.type = Tree::Type::table;
  table.entries.push_back({.key = "contract_a", .place = {}, .value = value});
  table.entries.push_back({.key = "contract_b", .place = {}, .value = text_tree("=values.contract_a")});
  for (Tree::Entry& entry : other.entries) {
    if (entry.key != "values") continue;
    for (Tree::Entry& more : table.entries) entry.value.entries.push_back(std::move(more));
    return other;
  }
  other.entries.push_back({.key = "values", .place = {}, .value = std::move(table)});
  return other;
}

/// Name of a mode that fails where the number is a literal, and passes otherwise; empty: none.
std::string passed_otherwise(const Outcome& literal, const Outcome& other) {
  if (other.is_refused) return "";
  if (literal.is_refused) return "all of it, which is refused";
  for (const auto& [mode, state] : other.states) {
    if (state != account::State::pass) continue;
    const auto known = literal.states.find(mode);
    if (known == literal.states.end() || known->second != account::State::pass) return mode;
  }
  return "";
}

struct Attacks {
  std::size_t at = 0, made = 0;
};

void attack(const test::Known& known, const Tree& tree, const Number& number, double factor) {
  const Tree written = test::tree_at(const_cast<Tree&>(tree), number.way);
  const auto far = scaled(written, factor);
  if (!far) return;
  const Outcome literal = run(with(tree, number, *far), known.file);
  const std::string expression = test::expression_of(*far);
  const auto holds = [&](const char* way, const Outcome& other) {
    const std::string passed = passed_otherwise(literal, other);
    CHECK_MESSAGE(passed.empty(), known.name, ": ", number.name, " = ", expression.substr(1), " ", std::string(way),
                  ": ", passed, " passes");
  };
  holds("as an expression", run(with(tree, number, text_tree(expression)), known.file));
  if (number.at_once) return;
  const Tree valued = with_values(tree, *far);
  holds("as a value", run(with(valued, number, text_tree("=values.contract_a")), known.file));
  holds("as a value of a value", run(with(valued, number, text_tree("=values.contract_b")), known.file));
  const Tree waiting = text_tree(test::waiting(expression));
  holds("as a result", run(with(test::with_other_step(tree), number, waiting), known.file));
  Tree both;
  both.type = Tree::Type::array;
  both.items = {written, *far};
  holds("in a sweep", sweep(with(tree, number, std::move(both)), known.file));
}

/// Titles that state loads are compared with what is typed in the file, which is not the same of every way.
Tree without_titles(Tree tree) {
  for (Tree::Entry& table : tree.entries)
    std::erase_if(table.value.entries, [](const Tree::Entry& entry) { return entry.key == "title"; });
  return tree;
}

void attack_all(const test::Known& known, Attacks& attacks) {
  std::vector<Issue> issues;
  const Tree tree = without_titles(toml::read_toml(known.text, known.file, issues));
  const project::Project project = read(tree, known.file, issues);
  const auto is_mechanism = [](const auto& step) {
    return std::string_view(step->input().calculator->id).starts_with("mechanism.");
  };
  const bool is_slow = std::any_of(project.steps.begin(), project.steps.end(), is_mechanism);
  const std::size_t every = test::one_of(is_slow ? 613 : 97);
  for (const Number& number : test::numbers_of(tree, project)) {
    for (const double factor : {9.87654, 0.123456, -1.0}) {
      if (attacks.at++ % every != 0) continue;
      attack(known, tree, number, factor);
      ++attacks.made;
    }
  }
}

}  // namespace

TEST_SUITE("contract ways" * test::by_element * test::takes_share) {
  TEST_CASE("no way to give a number passes where the number itself does not") {
    Attacks attacks;
    for (const test::Known& known : test::known_projects()) {
      if (test::takes(test::elements_of_project(known.text).front())) attack_all(known, attacks);
    }
    CHECK(attacks.made > 0);
  }
}
