#include "lib/report/brief/sizes.hpp"

#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
std::vector<std::string> other_sizes(const Project& project, const Component& component, bool with_declared) {
  std::vector<std::string> all;
  for (const auto& step : project.steps) {
    if (component_name(*step) != component.name) continue;
    std::vector<std::string> sizes = is_sized(*step) ? given_sizes(*step) : std::vector<std::string>();
    if (with_declared) {
      for (std::string& size : declared_sizes(*step)) sizes.push_back(std::move(size));
    }
    for (std::string& size : sizes) {
      const auto known = [&](const auto& others) { return std::ranges::find(others, size) != others.end(); };
      if (!known(all) && !known(component.sizes)) all.push_back(std::move(size));
    }
  }
  return all;
}

/// Whether it is a length, an area or a moment of inertia among the results, or an input such as a designation.
bool is_of_length(const project::Step& step, std::string_view key) {
  const auto& inputs = step.account().inputs;
  const auto& results = step.account().results;
  const auto result = std::ranges::find(results, key, &account::Entry::path);
  if (result == results.end())
    return step.input().rows.contains(std::string(key)) ||
           std::ranges::find(inputs, key, &account::Entry::path) != inputs.end();
  constexpr std::array<std::string_view, 6> units{"mm", "m", "um", "mm^2", "cm^2", "kg*m^2"};
  return !result->word.empty() || std::ranges::find(units, result->unit) != units.end();
}

/// Whether the first value of a phrase of its headline, "J = {J}|J = {J_F}", is one.
bool is_of_lengths(const project::Step& step) {
  const std::string_view headline = step.input().calculator->headline;
  if (headline.find('{') == std::string_view::npos) return !headline.empty();
  for (std::size_t begin = 0; begin < headline.size();) {
    const std::size_t end = std::min(headline.find('|', begin), headline.size());
    const std::string_view phrase = headline.substr(begin, end - begin);
    const std::size_t open = std::min(phrase.find('{'), phrase.size());
    if (open < phrase.size() &&
        is_of_length(step, phrase.substr(open + 1, phrase.find_first_of("#!}", open) - open - 1)))
      return true;
    begin = end + 1;
  }
  return false;
}

/// Whether a step of the component has a size, or a result that stands for it where no component has a size.
bool has_size(const Project& project, const Component& component) {
  const bool has_any = has_sizes(project);
  return component.is_sized || std::ranges::any_of(project.steps, [&](const auto& step) {
           return component_name(*step) == component.name && (has_any ? is_of_lengths(*step) : describes_size(*step));
         });
}

std::string joined(const std::vector<std::string>& texts, const char* separator) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : separator) + with_greek(text);
  return all;
}

/// Whether the diameters of a component are in a figure of its shaft.
bool is_drawn(const Project& project, const Component& component) {
  return std::ranges::any_of(project.steps, [&](const auto& step) {
    return component_name(*step) == component.name &&
           std::ranges::any_of(step->account().figures, [](const figure::Figure& figure) {
             return std::holds_alternative<figure::Shaft>(figure.content);
           });
  });
}

/// What is given with a size: all, what a search might have found, that less where a figure has it, or nothing.
enum class Given { all, searchable, not_drawn, none };

/// What was found is marked size by size; what was given follows.
Cell size_cell(const Project& project, const Component& component, Given shown) {
  std::vector<std::string> others;
  if (shown != Given::none) others = other_sizes(project, component, shown == Given::all);
  if (!component.is_sized) {
    std::vector<std::string> all = component.sizes;
    all.insert(all.end(), others.begin(), others.end());
    return joined(all, ", ");
  }
  const std::string given = joined(others, ", ");
  return Sized{joined(component.sizes, "*, "), given};
}

const Calculator* calculator_of(const Project& project, const Component& component) {
  const auto step =
      std::ranges::find_if(project.steps, [&](const auto& s) { return component_name(*s) == component.name; });
  return step == project.steps.end() ? nullptr : (*step)->input().calculator;
}

/// Sized components first; bearings, keys and others of one kind follow the most utilised of them.
std::vector<Component> in_rows(const Project& project, const Summary& summary) {
  std::vector<Component> components = summary.components;
  const auto given = std::stable_partition(components.begin(), components.end(),
                                           [](const Component& component) { return component.is_sized; });
  for (auto first = given; first != components.end();) {
    const Calculator* const kind = calculator_of(project, *first);
    first = std::stable_partition(
        first, components.end(), [&](const Component& component) { return calculator_of(project, component) == kind; });
  }
  return components;
}

/// A row for each component.
std::vector<std::vector<Cell>> rows_of(const Project& project, const Summary& summary, Given given, bool has_titles) {
  constexpr double most_letters = 18.0;
  std::vector<std::vector<Cell>> rows;
  for (const Component& component : in_rows(project, summary)) {
    if (component.sizes.empty() || !has_size(project, component)) continue;
    const bool is_left_out = given == Given::not_drawn && is_drawn(project, component);
    Cell size = size_cell(project, component, is_left_out ? Given::none : given);
    std::string name = has_titles ? titled(project, component.name, most_letters) : component.name;
    rows.push_back({std::move(name), std::move(size), material_of(project, component.name)});
  }
  return rows;
}

/// The lines of a row in the narrow column of page 1, whose words are not broken.
std::size_t lines_of(const std::vector<Cell>& row) {
  constexpr std::array<double, 3> letters_in_line{15.0, 21.0, 12.0};
  double lines = 1.0;
  for (std::size_t i = 0; i < row.size() && i < letters_in_line.size(); ++i) {
    const auto* const sized = std::get_if<Sized>(&row[i]);
    const std::string text = sized != nullptr ? sized->text + sized->behind() : std::get<std::string>(row[i]);
    lines = std::max(lines, std::ceil(letters_of(text) / letters_in_line[i]));
  }
  return static_cast<std::size_t>(lines);
}

/// Drops the last rows beyond a number of lines.
std::size_t drop_rows(Table& table, std::size_t most_lines) {
  std::size_t lines = 0, kept = 0;
  while (kept < table.rows.size() && (lines += lines_of(table.rows[kept])) <= most_lines) ++kept;
  const std::size_t left = table.rows.size() - kept;
  table.rows.resize(kept);
  return left;
}

}  // namespace

bool has_sizes(const Project& project) {
  return std::ranges::any_of(project.steps, [](const auto& step) { return is_sized(*step) || is_of_lengths(*step); });
}

std::size_t lines_of(const Table& sizes) {
  std::size_t lines = 0;
  for (const auto& row : sizes.rows) lines += lines_of(row);
  return lines;
}

std::size_t fewest_lines(const Project& project, const Summary& summary) {
  return lines_of(Table{{}, {}, rows_of(project, summary, Given::none, titles_fit(project, summary))});
}

bool titles_fit(const Project& project, const Summary& summary) {
  constexpr std::size_t most_lines = 16;
  return lines_of(Table{{}, {}, rows_of(project, summary, Given::none, true)}) <= most_lines;
}

Table sizes_table(const Project& project, const Summary& summary, std::size_t most) {
  Table table{{}, {say("Component"), has_sizes(project) ? say("Size") : say("Result"), say("Material")}, {}};
  const bool has_titles = titles_fit(project, summary);
  for (const Given given : {Given::all, Given::searchable, Given::not_drawn, Given::none}) {
    table.rows = rows_of(project, summary, given, has_titles);
    if (lines_of(table) <= most) break;
  }
  const std::size_t left = drop_rows(table, most);
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
