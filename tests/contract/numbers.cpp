#include "tests/contract/numbers.hpp"

#include "lib/project/read/spread.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::test {

using toml::Tree;

namespace {

/// A step next to the others: a reference to it waits until it is solved.
constexpr std::string_view other_step = "contract_one";

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

/// Whether a key of a step is not a field of its calculator: a row may be called "6208".
bool is_general_key(const Calculator& calculator, const std::string& key) {
  constexpr std::string_view beside[] = {"calculator", "template", "title", "note", "display", "accept", "material"};
  const auto groups = table_groups(calculator);
  return std::find(std::begin(beside), std::end(beside), key) != std::end(beside) ||
         std::find(groups.begin(), groups.end(), key) != groups.end();
}

}  // namespace

Tree& tree_at(Tree& top, const std::vector<std::size_t>& way) {
  Tree* at = &top;
  for (const std::size_t i : way) at = at->type == Tree::Type::table ? &at->entries[i].value : &at->items[i];
  return *at;
}

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
      const bool is_word = field != nullptr && field->type == FieldInfo::Type::choice;  // "2019", an edition
      if (!is_word && !is_general_key(*step->input().calculator, key))
        find_numbers(table.entries[k].value, {{i, k}, step->name() + "." + key, is_formula}, found);
    }
  }
  return found;
}

std::string expression_of(const Tree& number) {
  const std::string text = number.type == Tree::Type::number ? format_exact(number.number) : number.text;
  if (Expression::parse(text)) return "=" + text;
  const auto literal = parse_literal(text);  // "1 200 mm", "2,5 kN" are not expressions
  const std::string unit = si_unit(literal->dimension);
  return "=" + format_exact(literal->si) + (unit.empty() ? "" : " " + unit);
}

Tree with_other_step(const Tree& tree) {
  std::vector<Issue> issues;
  Tree other =
      toml::read_toml("[contract_one]\ncalculator = \"section.rectangle\"\nb = \"1 mm\"\nh = \"1 mm\"\n", "", issues);
  Tree both = tree;
  both.entries.push_back(other.entries.front());
  return both;
}

std::string waiting(const std::string& expression) {
  const std::string h = std::string(other_step) + ".h";
  return "=(" + expression.substr(1) + ")*(" + h + "/" + h + ")";
}

}  // namespace loadpath::test
