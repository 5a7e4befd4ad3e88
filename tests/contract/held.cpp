#include "tests/contract/held.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/format.hpp"
#include "lib/toml/tree.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace loadpath::test {

namespace {

namespace fs = std::filesystem;
using Type = FieldInfo::Type;

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string quantity_text(const FieldInfo& field, double si) {
  if (std::isnan(si)) return {};
  const std::string number = std::isinf(si) ? "inf" : format_exact(si / field.factor);
  return std::string_view(field.unit) == "-" ? number : in_quotes(number + " " + field.unit);
}

std::string word_text(const FieldInfo& field, double choice) {
  const std::string_view word = std::isnan(choice) ? "" : field.choices[static_cast<std::size_t>(choice)].key;
  return word.empty() ? "" : in_quotes(word);
}

std::string formula_text(const FieldInfo& field, std::string_view text, double load_factor) {
  if (text.empty() || !field.is_load || load_factor == 1.0) return text.empty() ? "" : in_quotes(text);
  return in_quotes(format_exact(load_factor) + "*(" + std::string(text) + ")");
}

std::string table_text(std::span<const FieldInfo> fields, void* owner, double load_factor);
std::string value_text(const FieldInfo& field, void* owner, double load_factor);

std::string list_text(const FieldInfo& list, void* owner, double load_factor) {
  std::string text;
  for (std::size_t i = 0; i < list.size(owner); ++i)
    text += (i == 0 ? "" : ", ") + table_text(list.fields, list.element(owner, i), load_factor);
  return text.empty() ? "" : "[" + text + "]";
}

/// A series that a step uses in full.
std::string series_text(const FieldInfo& field, const Value& series, double load_factor) {
  std::string values;
  for (const double si : series.si)
    values += (values.empty() ? "" : ", ") + format_exact(si / field.factor * (field.is_load ? load_factor : 1.0));
  return "{ values = [" + values + "], unit = " + in_quotes(field.unit) + " }";
}

bool has_values(const FieldInfo& group, void* owner) {
  return std::any_of(group.fields.begin(), group.fields.end(),
                     [&](const FieldInfo& field) { return !value_text(field, group.element(owner, 0), 1.0).empty(); });
}

/// The value of a field as a project has it; empty where there is none.
std::string value_text(const FieldInfo& field, void* owner, double load_factor) {
  if (const Value* const series = field.takes_whole() ? field.series(owner) : nullptr)
    return series_text(field, *series, load_factor);
  switch (field.type) {
    case Type::quantity:
      return quantity_text(field, field.get(owner) * (field.is_load ? load_factor : 1.0));
    case Type::count:
      return field.bounds.holds(field.get(owner)) ? format_exact(field.get(owner)) : "";
    case Type::choice:
      return word_text(field, field.get(owner));
    case Type::name:
      return field.text(owner).empty() ? "" : in_quotes(field.text(owner));
    case Type::formula:
      return formula_text(field, field.text(owner), load_factor);
    case Type::group:
      // a group of which nothing is given is left out: its presence would require its own inputs
      return has_values(field, owner) ? table_text(field.fields, field.element(owner, 0), load_factor) : "";
    case Type::list:
      return list_text(field, owner, load_factor);
    case Type::record:
      return {};  // its values are held one by one
  }
  return {};
}

std::string table_text(std::span<const FieldInfo> fields, void* owner, double load_factor) {
  std::string text;
  for (const FieldInfo& field : fields) {
    const std::string value = value_text(field, owner, load_factor);
    if (!value.empty()) text += (text.empty() ? " " : ", ") + std::string(field.key) + " = " + value;
  }
  return "{" + text + " }";
}

/// The position where a load that is a series is largest.
std::size_t most_loaded(const Record& record, const account::Account& account) {
  for (const account::Entry& entry : account.inputs) {
    const Leaf leaf = find_leaf(record, entry.path);
    if (!leaf || !leaf.field->is_load || entry.values().si.size() < 2) continue;
    const auto less = [](double a, double b) { return std::abs(a) < std::abs(b) || std::isnan(a); };
    const auto& si = entry.values().si;
    return static_cast<std::size_t>(std::max_element(si.begin(), si.end(), less) - si.begin());
  }
  return 0;
}

/// All project files in these folders of the repository, in the order of their names.
std::vector<fs::path> toml_files(const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LOADPATH_ROOT) / folder)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Record found_input(const project::Step& step) {
  Record record = step.input().reading.record.clone();
  const std::size_t position = most_loaded(record, step.account());
  for (const account::Entry& entry : step.account().inputs) {
    const Leaf leaf = find_leaf(record, entry.path);
    if (leaf && leaf.field->is_word()) set_word(leaf, entry.word);
    if (!leaf || leaf.field->get == nullptr || entry.values().si.empty()) continue;
    if (leaf.field->takes_whole() && entry.values().is_series())
      leaf.field->set_series(leaf.owner, entry.values());
    else
      leaf.set(entry.values().si[entry.values().si.size() > 1 ? position : 0]);
  }
  return record;
}

std::string held(const project::Step& step, double load_factor) {
  const Record record = found_input(step);
  std::string text = "[" + step.name() + "]\ncalculator = " + in_quotes(step.input().calculator->id) + "\n";
  const Leaf ratio = find_leaf(record, "chi");
  const bool has_ratio = ratio && !std::isnan(ratio.get());
  for (const FieldInfo& field : record.type->fields) {
    if (has_ratio && field.key == std::string_view("d_bore")) continue;  // it followed from the bore ratio
    const std::string value = value_text(field, record.data.get(), load_factor);
    if (!value.empty()) text += std::string(field.key) + " = " + value + "\n";
  }
  return text;
}

std::vector<Known> known_projects() {
  std::vector<Known> all;
  for (const Calculator* c : calculators()) {
    all.push_back({c->id, c->example, "known.toml"});
    for (const Template* t : c->templates) all.push_back({t->id, t->example, "known.toml"});
  }
  for (const fs::path& file : toml_files({"examples", "reference"})) {
    std::string text;
    REQUIRE(toml::read_file(file.string(), text));
    all.push_back({fs::relative(file, LOADPATH_ROOT).string(), std::move(text), file.string()});
  }
  return all;
}

void for_each_step(const std::function<void(const project::Step&, const std::string&)>& visit) {
  for (const Known& known : known_projects()) {
    const auto elements = elements_of_project(known.text);
    if (std::none_of(elements.begin(), elements.end(), takes)) continue;
    std::vector<Issue> issues;
    project::Project project =
        project::read_project(known.text, known.file, catalogue(), issues, project::Ranges::taken);
    REQUIRE_MESSAGE(!has_errors(issues), known.name);
    project::solve(project, issues, {.pictures = false, .formulas = false, .unused = false});
    REQUIRE_MESSAGE(!has_errors(issues), known.name);
    for (const auto& step : project.steps) {
      if (takes(step->input().calculator->element())) visit(*step, known.name + ", " + step->name());
    }
  }
}

}  // namespace loadpath::test
