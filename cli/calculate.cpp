#include "cli/output.hpp"
#include "cli/solving.hpp"
#include "lib/io/tree.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::cli {

namespace {

using io::Tree;

bool takes_text(const FieldInfo* field) {
  return field == nullptr || field->type == FieldInfo::Type::quantity || field->type == FieldInfo::Type::choice ||
         field->type == FieldInfo::Type::name;
}

/// Back to the places of the flag's own text, which stood behind `length` characters of a line.
void move_back(Place& place, int length) {
  if (place.line == 1) place.column = std::max(1, place.column - length);
}
void move_back(Tree& tree, int length) {
  move_back(tree.place, length);
  for (Tree& item : tree.items) move_back(item, length);
  for (Tree::Entry& entry : tree.entries) {
    move_back(entry.place, length);
    move_back(entry.value, length);
  }
}

/// The value of a flag as a project file would have it: a text as it stands, anything else as TOML's inline text.
Tree value_of(const std::string& key, const std::string& text, const FieldInfo* field, std::vector<Issue>& issues) {
  const std::string flag = "--" + key;
  Tree value;
  value.type = Tree::Type::text;
  value.text = text;
  value.place = {flag, 1, 1, 1};
  const bool inline_table = text.starts_with('{');  // { stock = "R20" }
  if (takes_text(field) && !inline_table) return value;
  const std::string prefix = "value = ";
  const auto length = static_cast<int>(prefix.size());
  const std::size_t before = issues.size();
  Tree tree = io::read_toml(prefix + text, flag, issues);
  for (std::size_t i = before; i < issues.size(); ++i) move_back(issues[i].place, length);
  if (tree.entries.empty()) return value;
  move_back(tree, length);
  return std::move(tree.entries[0].value);
}

Tree project_tree(const CalculateOptions& options, std::vector<Issue>& issues) {
  Tree step;
  step.place = {"command line", 0, 0, 1};
  Tree id;
  id.type = Tree::Type::text;
  id.text = options.calculator->id;
  step.entries.push_back({"calculator", step.place, id});
  for (const auto& [key, text] : options.values) {
    const FieldInfo* field = find_field(options.calculator->input->fields, key);
    step.entries.push_back({key, {"--" + key, 1, 1, 1}, value_of(key, text, field, issues)});
  }
  const std::string_view all = options.calculator->id;
  Tree tree;
  tree.entries.push_back({std::string(all.substr(all.find('.') + 1)), step.place, std::move(step)});
  return tree;
}

}  // namespace

int calculate(const CalculateOptions& options) {
  if (!can_write(options.output)) return wrong_input;
  std::vector<SourceText> sources;
  for (const auto& [key, text] : options.values) sources.push_back({"--" + key, text});
  return solve_and_show(
      [&](std::vector<Issue>& issues) {
        const Tree tree = project_tree(options, issues);
        return has_errors(issues) ? project::Project{}
                                  : project::read_project(tree, "command line", catalogue(), issues);
      },
      sources, options.output, true);
}

}  // namespace loadpath::cli
