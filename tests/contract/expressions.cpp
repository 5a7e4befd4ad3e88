// Expressions are literals that arrive later: what is written as "=30 mm" says what "30 mm" says.
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/contract/held.hpp"
#include "tests/contract/numbers.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using test::Number;
using toml::Tree;

void show(const Value& value, std::ostream& to) {
  for (const double si : value.si) {
    char bits[32];
    std::snprintf(bits, sizeof bits, " %a", si);
    to << bits;
  }
}

/// Results, without their origin.
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
        show(entry.values(), to);
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

struct Share {
  std::size_t at = 0, every = 1, replaced = 0;
};

/// Replaces some of the numbers, one at a time.
void replace_numbers(const test::Known& known, bool waits, Share& share) {
  std::vector<Issue> issues;
  Tree tree = toml::read_toml(known.text, known.file, issues);
  const project::Project project = project::read_project(tree, known.file, catalogue(), issues, project::Ranges::taken);
  if (waits) tree = test::with_other_step(tree);
  const std::string before = solved(tree, known.file);
  for (const Number& number : test::numbers_of(tree, project)) {
    if ((waits && number.at_once) || share.at++ % share.every != 0) continue;
    Tree other = tree;
    Tree& written = test::tree_at(other, number.way);
    const std::string expression = test::expression_of(written), text = waits ? test::waiting(expression) : expression;
    written.type = Tree::Type::text;
    written.text = text;
    const std::string after = solved(other, known.file);
    CHECK_MESSAGE(after == before, known.name, ": ", number.name, " = \"", text, "\": ", difference(before, after));
    ++share.replaced;
  }
}

void replace_in_all(bool waits) {
  Share share;
  share.every = test::one_of(20);
  test::Share projects(4);
  for (const test::Known& known : test::known_projects()) {
    if (test::takes(test::elements_of_project(known.text).front()) && !projects.skips())
      replace_numbers(known, waits, share);
  }
  CHECK(share.replaced > 0);
}

}  // namespace

TEST_SUITE("contract expressions" * test::by_element * test::takes_share) {
  TEST_CASE("every number of the examples and reference cases may be an expression") { replace_in_all(false); }

  TEST_CASE("every number of them may be one that is known only when another step is solved") { replace_in_all(true); }
}
