#include "lib/project/sweep/axes.hpp"

#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <tuple>

namespace loadpath::project {

namespace {

/// The input of that name, or a new one.
SweptInput& input_of(std::vector<SweptInput>& all, const std::string& name) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const SweptInput& input) { return input.name == name; });
  if (known != all.end()) return *known;
  all.emplace_back().name = name;
  return all.back();
}

/// The values; for words 0, 1, 2..., independent of their numbers in the field.
sweep::Axis axis_of(const Varied& varied) {
  if (varied.words.size() < 2) return varied.words.empty() ? varied.axis : sweep::Axis();
  return *sweep::Axis::by_count(0.0, static_cast<double>(varied.words.size() - 1), varied.words.size());
}

void take(const Varied& varied, Step& step, std::size_t which, SweptInput& input) {
  input.targets.push_back({&step, which});
  input.axis = axis_of(varied);
  input.distribution = varied.distribution;
  input.words = varied.words;
  input.place = varied.place;
  if (!varied.leaf) return;
  input.unit = varied.leaf.field->unit;
  input.dimension = varied.leaf.field->dimension;
}

}  // namespace

std::vector<SweptInput> swept_inputs(Project& project) {
  std::vector<SweptInput> all;
  for (const Values::Several& several : project.values.several()) {
    SweptInput& input = input_of(all, "values." + several.name);
    input.is_literal = true;
    input.axis = several.axis;
    input.distribution = several.distribution;
    input.place = several.place;
    input.dimension = project.values.literal(several.name)->signature.dimension;
    input.unit = si_unit(input.dimension);
  }
  for (const auto& step : project.steps) {
    const auto& varied = step->input().reading.varied;
    for (std::size_t i = 0; i < varied.size(); ++i) {
      const std::string name = varied[i].shared.empty() ? step->name() + "." + varied[i].path : varied[i].shared;
      take(varied[i], *step, i, input_of(all, name));
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const SweptInput& a, const SweptInput& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return all;
}

bool set_input(Project& project, const SweptInput& input, double value, std::vector<Issue>& issues) {
  bool allowed = true;
  if (input.is_literal) project.values.set(input.name.substr(input.name.find('.') + 1), value);
  for (const SweptInput::Target& target : input.targets) {
    Varied& varied = target.step->input().reading.varied[target.varied];
    if (!varied.words.empty()) varied.at = static_cast<std::size_t>(value);
    if (!varied.leaf) continue;
    const FieldInfo& field = *varied.leaf.field;
    const double si = varied.words.empty() ? value : varied.axis.at(varied.at);
    if (field.type != FieldInfo::Type::choice && !field.bounds.holds(si)) {
      issues.push_back(
          issue_at(target.step->input(), varied.path,
                   say("{1} = {2}: {3}", varied.path, format_quantity(si, field.unit), bounds_message(field))));
      allowed = false;
    } else {
      varied.leaf.set(si);
    }
  }
  return allowed;
}

std::string written(const SweptInput& input, double value) {
  if (!input.words.empty()) return input.words[static_cast<std::size_t>(value)];
  return format_quantity(value, input.unit, 6);
}

std::set<std::string> affected_steps(const Project& project, const std::vector<SweptInput>& inputs) {
  std::set<std::string> affected;
  for (const SweptInput& input : inputs) {
    if (input.is_literal) affected.insert(split_step(input.name).first);  // "values"
    for (const SweptInput::Target& target : input.targets) affected.insert(target.step->name());
  }
  add_takers(project, affected);
  return affected;
}

void add_takers(const Project& project, std::set<std::string>& affected) {
  for (const std::size_t i : project.order) {  // each after those that it refers to
    const Step& step = *project.steps[i];
    const auto visit = [&](const std::string& path) {
      if (affected.contains(split_step(path).first)) affected.insert(step.name());
    };
    for_each_reference(step.input().reading, visit);
    for_each_compared(step.input(), visit);
  }
}

}  // namespace loadpath::project
