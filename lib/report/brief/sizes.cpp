#include "lib/report/brief/sizes.hpp"

#include "lib/report/brief/names.hpp"

#include <algorithm>

namespace loadpath::report {

namespace {

using project::Project;

/// Rows of tables that name the material and kind of a part: "C45E".
std::string material_of(const Project& project, const std::string& component) {
  std::vector<std::string> all;
  for (const auto& step : project.steps) {
    if (component_name(*step) != component) continue;
    for (const auto& [group, row] : step->input().rows) {
      const bool is_material = group.find("material") != std::string::npos;
      if (is_material && !row.text.empty() && std::ranges::find(all, row.text) == all.end()) all.push_back(row.text);
    }
  }
  std::string text;
  for (const std::string& name : all) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The sizes given for a component, besides those that its row has.
std::vector<std::string> other_sizes(const Project& project, const Component& component) {
  std::vector<std::string> all;
  for (const auto& step : project.steps) {
    if (component_name(*step) != component.name || !is_sized(*step)) continue;
    for (std::string& size : given_sizes(*step)) {
      const auto known = [&](const auto& sizes) { return std::ranges::find(sizes, size) != sizes.end(); };
      if (!known(all) && !known(component.sizes)) all.push_back(std::move(size));
    }
  }
  return all;
}

/// Whether a step of the component has a size: what is only computed of a stress cycle or a gear rating is none.
bool has_size(const Project& project, const Component& component) {
  return component.is_sized || std::ranges::any_of(project.steps, [&](const auto& step) {
           return component_name(*step) == component.name && describes_size(*step);
         });
}

void add_rows(const Project& project, const Component& component, Table& table) {
  const std::string material = material_of(project, component.name);
  const auto add = [&](Cell size, bool first) {
    table.rows.push_back({first ? component.name : std::string(), std::move(size), first ? material : std::string()});
  };
  bool first = true;
  for (const std::string& name : component.sizes) {
    const std::string size = with_greek(name);
    add(component.is_sized ? Cell(Sized{size}) : Cell(size), first);
    first = false;
  }
  if (!component.is_sized) return;
  for (const std::string& size : other_sizes(project, component)) add(with_greek(size), false);
}

}  // namespace

Table sizes_table(const Project& project, const Summary& summary, std::size_t most) {
  Table table{{}, {say("Component"), say("Size"), say("Material")}, {}};
  std::vector<Component> components = summary.components;
  std::stable_partition(components.begin(), components.end(),
                        [](const Component& component) { return component.is_sized; });
  std::size_t left = 0;
  for (const Component& component : components) {
    if (component.sizes.empty() || !has_size(project, component)) continue;
    if (table.rows.size() + component.sizes.size() > most)
      ++left;
    else
      add_rows(project, component, table);
  }
  const bool no_material = std::ranges::all_of(table.rows, [](const auto& row) {
    const auto* const text = std::get_if<std::string>(&row.back());
    return text != nullptr && text->empty();
  });
  if (no_material) {
    table.head.pop_back();
    for (auto& row : table.rows) row.pop_back();
  }
  if (left > 0) {
    table.rows.emplace_back(table.head.size(), std::string());
    table.rows.back()[0] = say("{1} more: appendix", std::to_string(left)).text();
  }
  return table;
}

std::vector<Block> next_size_notes(const Summary& summary, std::size_t most) {
  if (summary.next.empty()) return {};
  Message all = say("* sized. Next smaller size:");
  const char* separator = "{1} {2}: {3}";
  for (std::size_t i = 0; i < std::min(most, summary.next.size()); ++i) {
    all = say(separator, all, summary.next[i].name, failure_text(summary.next[i].size));
    separator = "{1}; {2}: {3}";
  }
  if (summary.next.size() > most) all = say("{1}; {2} more", all, std::to_string(summary.next.size() - most));
  return {Paragraph{say("{1}.", all), Paragraph::Tone::note}};
}

}  // namespace loadpath::report
