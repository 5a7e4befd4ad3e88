#include "lib/project/parts/examples.hpp"

#include "lib/quantity/format.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::size_t longest_value = 90;  // characters of a value that a line of help holds

/// A value of the example in one line.
std::string in_one_line(const Tree& tree) {
  switch (tree.type) {
    case Tree::Type::number:
      return format_exact(tree.number);
    case Tree::Type::text:
      return tree.text.find('"') == std::string::npos ? "\"" + tree.text + "\"" : "'" + tree.text + "'";
    case Tree::Type::boolean:
      return tree.text;
    case Tree::Type::array:
      return tree.items.empty() ? "[]" : "[" + in_one_line(tree.items.front()) + "]";
    case Tree::Type::table: {
      std::string all;
      for (const Tree::Entry& entry : tree.entries)
        all += (all.empty() ? " " : ", ") + entry.key + " = " + in_one_line(entry.value);
      return "{" + all + " }";
    }
  }
  return {};
}

/// Whether the value refers to another step of the example.
bool refers(const std::string& text) { return text.find("\"=") != std::string::npos; }

}  // namespace

void show_missing(const Calculator& calculator, const std::string& step, std::size_t before,
                  std::vector<Issue>& issues) {
  const auto lacks_help = [&](const Issue& issue) {
    return issue.hint.empty() && issue.key_fault == KeyFault::missing && issue.key.starts_with(step + ".");
  };
  const auto begin = issues.begin() + static_cast<std::ptrdiff_t>(before);
  if (std::none_of(begin, issues.end(), lacks_help)) return;
  std::vector<Issue> none;
  const Tree example = toml::read_toml(calculator.example, calculator.id, none);
  const auto is_its = [&](const Tree::Entry& entry) {
    const Tree::Entry* const named = entry.value.find("calculator");
    return named != nullptr && named->value.text == calculator.id;
  };
  const auto own = std::find_if(example.entries.begin(), example.entries.end(), is_its);
  if (own == example.entries.end()) return;
  for (auto issue = begin; issue != issues.end(); ++issue) {
    const Tree::Entry* const entry = lacks_help(*issue) ? own->value.find(issue->key.substr(step.size() + 1)) : nullptr;
    const std::string value = entry == nullptr ? "" : in_one_line(entry->value);
    if (!value.empty() && value.size() <= longest_value && !refers(value))
      issue->hint = say("for example {1} = {2}", entry->key, value);
  }
  if (calculator.templates.empty() || std::count_if(begin, issues.end(), lacks_help) < 2) return;
  // Nothing of the model is given: a template makes it.
  std::find_if(begin, issues.end(), lacks_help)->hint =
      say("write template = \"{1}\"; `loadpath describe {2} templates` lists all templates",
          calculator.templates.front()->id, calculator.id);
}

}  // namespace loadpath::project
