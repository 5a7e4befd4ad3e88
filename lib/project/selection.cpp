#include "lib/project/selection.hpp"

#include "lib/quantity/expression/expression.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

using toml::Tree;

/// The steps that the expressions of a tree name. Invalid expressions are reported when the step is read.
void collect_steps(const Tree& tree, std::vector<std::string>& steps) {
  if (tree.type == Tree::Type::text && tree.text.starts_with('=')) {
    const auto parsed = Expression::parse(std::string_view(tree.text).substr(1));
    if (!parsed) return;
    for (const auto& reference : parsed->references())
      steps.push_back(reference.path.substr(0, reference.path.find('.')));
  }
  for (const Tree& item : tree.items) collect_steps(item, steps);
  for (const Tree::Entry& entry : tree.entries) collect_steps(entry.value, steps);
}

/// The steps that describe the same physical part: its size is the largest that they require.
void collect_body(const Tree& project, const Tree::Entry& step, std::vector<std::string>& steps) {
  const Tree::Entry* const body = step.value.find("body");
  if (body == nullptr) return;
  for (const Tree::Entry& other : project.entries) {
    const Tree::Entry* const same = other.value.find("body");
    if (same != nullptr && same->value.text == body->value.text) steps.push_back(other.key);
  }
}

/// Whether every part of a project needs the key.
bool is_of_all(std::string_view key) { return key == "project" || key == "values" || key == "tables"; }

std::set<std::string> needed_steps(const Tree& project, std::string_view calculator) {
  std::vector<std::string> open;
  for (const Tree::Entry& entry : project.entries) {
    if (runs(entry, calculator)) open.push_back(entry.key);
  }
  std::set<std::string> needed;
  while (!open.empty()) {
    const std::string name = std::move(open.back());
    open.pop_back();
    const Tree::Entry* step = needed.insert(name).second ? project.find(name) : nullptr;
    if (step == nullptr) continue;
    collect_steps(step->value, open);
    collect_body(project, *step, open);
  }
  return needed;
}

}  // namespace

bool runs(const Tree::Entry& entry, std::string_view calculator) {
  const Tree::Entry* id = entry.value.find("calculator");
  return id != nullptr && id->value.text == calculator;
}

Tree part_for(const Tree& project, std::string_view calculator) {
  const std::set<std::string> needed = needed_steps(project, calculator);
  Tree part;
  part.place = project.place;
  std::copy_if(project.entries.begin(), project.entries.end(), std::back_inserter(part.entries),
               [&](const Tree::Entry& e) { return needed.count(e.key) != 0 || (!needed.empty() && is_of_all(e.key)); });
  return part;
}

}  // namespace loadpath::project
