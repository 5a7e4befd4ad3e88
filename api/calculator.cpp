#include "api/calling.hpp"
#include "api/given.hpp"
#include "calculators/catalogue.hpp"
#include "lib/calculator/choice_words.hpp"
#include "lib/project/solving/read_project.hpp"

#include <algorithm>
#include <array>
#include <loadpath/calculator.hpp>

namespace loadpath::api {

namespace {

std::string kind_of_field(const FieldInfo& field) {
  static constexpr std::array names{"number", "count", "word", "name", "formula", "group", "list", "record"};
  if (field.type == FieldInfo::Type::quantity) return kind_of(field.dimension, field.kind);
  return names[static_cast<std::size_t>(field.type)];
}

Field described(const std::string& name, const FieldInfo& field) {
  Field f;
  f.name = name;
  f.meaning = field.doc;
  f.role = role_of(field.role);
  f.kind = kind_of_field(field);
  if (field.is_number()) {
    f.si_unit = si_name(field.dimension);
    f.unit = field.unit;
  }
  f.optional = field.optional;
  if (field.type == FieldInfo::Type::choice) f.words = words_to_type(field);
  return f;
}

}  // namespace

Calculator Calculator::find(std::string_view id) {
  if (const auto* const found = find_calculator(calculators(), id)) return Calculator(*found);
  std::vector<std::string> ids;
  for (const loadpath::Calculator* calculator : calculators()) ids.emplace_back(calculator->id);
  refuse(say("unknown calculator '{1}'", id), did_you_mean(id, ids, say("`loadpath list` shows them")));
}

std::vector<Calculator> Calculator::all() {
  std::vector<Calculator> list;
  for (const loadpath::Calculator* calculator : calculators()) list.push_back(Calculator(*calculator));
  return list;
}

std::string Calculator::id() const { return calculator_->id; }
std::string Calculator::title() const { return calculator_->title; }
std::string Calculator::scope() const { return calculator_->scope; }
std::string Calculator::example() const { return calculator_->example; }

std::vector<Field> Calculator::inputs() const {
  std::vector<Field> list;
  for (const FieldInfo& field : calculator_->input->fields) list.push_back(described(field.key, field));
  return list;
}

std::vector<Field> Calculator::results() const {
  std::vector<Field> list;
  if (calculator_->result == nullptr) return list;  // names in the input make its results
  const Record blank(*calculator_->result);
  for_each_leaf(blank,
                [&](const std::string& path, const Leaf& leaf) { list.push_back(described(path, *leaf.field)); });
  return list;
}

Solution Calculator::solve(std::span<const Given> inputs, bool strict) const {
  const Call call = read_call(*calculator_, inputs);
  if (!call.columns.empty())
    refuse(say("'{1}' has many values, and one is taken here", call.columns.front().name), say("sweep takes columns"));
  std::vector<loadpath::Issue> issues;
  project::Project project = project::read_project(call.project, "call", catalogue(), issues);
  refuse_errors(issues, call.sources);
  project.strict = strict;
  return solution_of(project, std::move(issues), call.sources, call.step);
}

Sweep Calculator::sweep(std::span<const Given> inputs, const SweepOptions& options) const {
  return sweep_of(*calculator_, read_call(*calculator_, inputs), options);
}

}  // namespace loadpath::api
