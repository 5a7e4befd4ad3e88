// Expressions are literals that arrive later: what is written as "=30 mm" says what "30 mm" says.
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/read/spread.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "tests/contract/held.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using toml::Tree;

/// A number of a project: what leads to it, and the key that it stands under.
struct Number {
  std::vector<std::size_t> way;  // entries and items, from the top on
  std::string name;              // "shaft.pieces[2].l"
  bool at_once = false;          // of a range, a distribution, a history, a formula: it waits for no other step
};

Tree& tree_at(Tree& top, const std::vector<std::size_t>& way) {
  Tree* at = &top;
  for (const std::size_t i : way) at = at->type == Tree::Type::table ? &at->entries[i].value : &at->items[i];
  return *at;
}

bool is_number(const Tree& tree) {
  if (tree.type == Tree::Type::number) return std::isfinite(tree.number);
  return tree.type == Tree::Type::text && !tree.text.starts_with('=') && parse_literal(tree.text);
}

void find_numbers(const Tree& tree, const Number& here, std::vector<Number>& found) {
  if (is_number(tree)) found.push_back(here);
  const bool at_once = project::is_grid(tree) || project::is_uncertain(tree) || tree.find("values") != nullptr ||
                       tree.find("file") != nullptr;
  const auto enter = [&](const Tree& inner, std::size_t i, const std::string& name) {
    Number next = here;
    next.way.push_back(i);
    next.name += name;
    next.at_once = here.at_once || (tree.type == Tree::Type::table && at_once);
    find_numbers(inner, next, found);
  };
  for (std::size_t i = 0; i < tree.entries.size(); ++i) enter(tree.entries[i].value, i, "." + tree.entries[i].key);
  for (std::size_t i = 0; i < tree.items.size(); ++i) enter(tree.items[i], i, "[" + std::to_string(i + 1) + "]");
}

/// Whether a key of a step is no field of its calculator: a row may be called "6208".
bool is_beside_fields(const Calculator& calculator, const std::string& key) {
  constexpr std::string_view beside[] = {"calculator", "template", "title", "note", "display", "accept", "material"};
  const auto groups = table_groups(calculator);
  return std::find(std::begin(beside), std::end(beside), key) != std::end(beside) ||
         std::find(groups.begin(), groups.end(), key) != groups.end();
}

/// The numbers of all steps of a project.
std::vector<Number> numbers_of(const Tree& top, const project::Project& project) {
  std::vector<Number> found;
  for (std::size_t i = 0; i < top.entries.size(); ++i) {
    const project::Step* const step = project.find(top.entries[i].key);
    if (step == nullptr) continue;
    const Tree& table = top.entries[i].value;
    for (std::size_t k = 0; k < table.entries.size(); ++k) {
      const std::string& key = table.entries[k].key;
      const FieldInfo* const field = find_field(step->input().calculator->input->fields, key);
      const bool is_formula = field != nullptr && field->type == FieldInfo::Type::formula;
      if (!is_beside_fields(*step->input().calculator, key))
        find_numbers(table.entries[k].value, {{i, k}, step->name() + "." + key, is_formula}, found);
    }
  }
  return found;
}

void show(const Value& value, std::ostream& to) {
  for (const double si : value.si) {
    char bits[32];
    std::snprintf(bits, sizeof bits, " %a", si);
    to << bits;
  }
}

/// What was found, but for where it comes from.
std::string shown(const project::Project& project, const std::vector<Issue>& issues) {
  std::ostringstream to;
  std::vector<std::string> said;  // at once or later, of a step before another or behind it
  for (const Issue& issue : issues) said.push_back(issue.key + ": " + issue.message.text());
  std::sort(said.begin(), said.end());
  for (const std::string& line : said) to << line << "\n";
  for (const auto& step : project.steps) {
    const account::Account& account = step->account();
    for (const auto* entries : {&account.inputs, &account.results}) {
      for (const account::Entry& entry : *entries) {
        to << step->name() << "." << entry.path << " " << entry.word;
        show(entry.value, to);
        to << "\n";
      }
    }
    for (const account::Verdict& v : account.verdicts)
      to << step->name() << "." << v.symbol << " " << static_cast<int>(v.state) << " " << v.note.text() << "\n";
    for (const account::Mode& mode : account.modes)
      to << step->name() << "." << mode.id << " " << static_cast<int>(mode.state) << " " << mode.wants << " "
         << mode.note.text() << "\n";
    std::vector<std::string> warnings;
    for (const Message& warning : account.warnings) warnings.push_back(warning.text());
    std::sort(warnings.begin(), warnings.end());
    for (const std::string& warning : warnings) to << step->name() << " warns: " << warning << "\n";
  }
  return to.str();
}

std::string solved(const Tree& tree, const std::string& file) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(tree, file, catalogue(), issues, project::Ranges::taken);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false});
  return shown(project, issues);
}

/// The text of an expression that is this number.
std::string expression_of(const Tree& number) {
  const std::string text = number.type == Tree::Type::number ? format_exact(number.number) : number.text;
  if (Expression::parse(text)) return "=" + text;
  const auto literal = parse_literal(text);  // "1 200 mm", "2,5 kN" are no expressions
  const std::string unit = si_unit(literal->dimension);
  return "=" + format_exact(literal->si) + (unit.empty() ? "" : " " + unit);
}

/// The first line in which two texts differ.
std::string difference(const std::string& a, const std::string& b) {
  std::istringstream in_a(a), in_b(b);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(in_a, line_a)),
               more_b = static_cast<bool>(std::getline(in_b, line_b));
    if (!more_a) line_a = "(end)";
    if (!more_b) line_b = "(end)";
    if (line_a != line_b || !more_a) return "'" + line_a + "', as an expression '" + line_b + "'";
  }
}

/// A step beside the others: what refers to it waits until it is solved.
constexpr std::string_view other_step = "contract_one";

Tree with_other_step(const Tree& tree) {
  std::vector<Issue> issues;
  Tree other = toml::read_toml("[contract_one]\ncalculator = \"section.circle\"\nd = \"1 mm\"\n", "", issues);
  Tree both = tree;
  both.entries.push_back(other.entries.front());
  return both;
}

/// "=30 mm", and as a value that is known later: "=(30 mm)*(contract_one.d/contract_one.d)".
std::string waiting(const std::string& expression) {
  const std::string d = std::string(other_step) + ".d";
  return "=(" + expression.substr(1) + ")*(" + d + "/" + d + ")";
}

struct Share {
  std::size_t at = 0, every = 1, replaced = 0;
};

/// Replaces some of the numbers, one at a time.
void replace_numbers(const test::Known& known, bool waits, Share& share) {
  std::vector<Issue> issues;
  Tree tree = toml::read_toml(known.text, known.file, issues);
  const project::Project project = project::read_project(tree, known.file, catalogue(), issues, project::Ranges::taken);
  if (waits) tree = with_other_step(tree);
  const std::string before = solved(tree, known.file);
  for (const Number& number : numbers_of(tree, project)) {
    if ((waits && number.at_once) || share.at++ % share.every != 0) continue;
    Tree other = tree;
    Tree& written = tree_at(other, number.way);
    const std::string expression = expression_of(written), text = waits ? waiting(expression) : expression;
    written.type = Tree::Type::text;
    written.text = text;
    const std::string after = solved(other, known.file);
    CHECK_MESSAGE(after == before, known.name, ": ", number.name, " = \"", text, "\": ", difference(before, after));
    ++share.replaced;
  }
}

void replace_in_all(bool waits) {
  Share share;
  share.every = static_cast<std::size_t>(test::in_full() ? 1 : 10);
  for (const test::Known& known : test::known_projects()) {
    if (test::takes(test::elements_of_project(known.text).front())) replace_numbers(known, waits, share);
  }
  CHECK(share.replaced > 0);
}

}  // namespace

TEST_SUITE("contract expressions" * test::by_element * test::takes_share) {
  TEST_CASE("every number of the examples and reference cases may be an expression") { replace_in_all(false); }

  TEST_CASE("every number of them may be one that is known when another step is solved") { replace_in_all(true); }
}
