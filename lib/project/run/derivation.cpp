#include "lib/project/run/derivation.hpp"

#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace loadpath::project {

namespace {

std::string joined(const std::string& scope, std::string_view name) {
  return scope.empty() ? std::string(name) : scope + "." + std::string(name);
}

/// "methods[3]" as "methods.johnson", where the element has a name.
std::string named_element(const std::string& scope, const Record& input, const Record& result) {
  const std::size_t open = scope.find('['), close = scope.find(']');
  if (open == std::string::npos || scope.find('.') < open) return scope;
  const auto number = static_cast<std::size_t>(std::atoi(scope.c_str() + open + 1));
  for (const Record* record : {&result, &input}) {
    const FieldInfo* list = find_field(record->type->fields, scope.substr(0, open));
    if (list == nullptr || list->type != FieldInfo::Type::list || number > list->size(record->data.get())) continue;
    return scope.substr(0, open) + element_path(*list, record->data.get(), number - 1) + scope.substr(close + 1);
  }
  return scope;
}

void collect_names(const formula::Node& node, std::vector<std::string>& names) {
  if (node.kind == formula::Kind::symbol && std::find(names.begin(), names.end(), node.text) == names.end()) {
    names.push_back(node.text);
  }
  for (const formula::Node& kid : node.kids) collect_names(kid, names);
}

account::Step step_of(const Line& line, const Names& names, const std::string& unit) {
  account::Step step;
  step.symbol = line.symbol;
  step.formula = line.formula;
  step.value = {line.si, unit};
  step.why = say(line.why);
  std::vector<std::string> wanted;
  if (const auto tree = formula::parse(line.formula)) collect_names(*tree, wanted);
  for (const std::string& name : wanted) {
    if (const auto known = names.find(line.scope, name)) step.given.push_back({name, known->si, known->unit});
  }
  return step;
}

}  // namespace

std::optional<Names::Known> Names::find_here(const std::string& scope, std::string_view name) const {
  const auto line = lines_.find(joined(scope, name));
  if (line != lines_.end()) return line->second;
  const auto from = [&](const Record& record) -> std::optional<Known> {
    const Leaf leaf = find_leaf(record, joined(scope, name));
    if (!leaf || leaf.field->get == nullptr) return std::nullopt;
    return Known{leaf.get(), leaf.field->unit};
  };
  // A list of the input with the scope's name need not have the same elements as that of the result. At the top an
  // input that was left open ("d") is what the calculator has put in its place.
  if (!scope.empty()) return from(result_);
  const auto typed = from(input_);
  const auto found = from(result_);
  return (!typed || std::isnan(typed->si)) && found ? found : typed;
}

std::optional<Names::Known> Names::find(const std::string& scope, std::string_view name) const {
  std::string outer = scope;
  while (true) {
    if (const auto known = find_here(outer, name)) return known;
    if (outer.empty()) return std::nullopt;
    const std::size_t dot = outer.rfind('.');
    outer.resize(dot == std::string::npos ? 0 : dot);
  }
}

std::string Names::unit_of(const Line& line) const {
  for (const Record* record : {&result_, &input_}) {
    const Leaf leaf = find_leaf(*record, joined(line.scope, line.symbol));
    if (leaf && leaf.field->type == FieldInfo::Type::quantity &&
        leaf.field->dimension.without_angle() == line.dimension.without_angle()) {
      return leaf.field->unit;
    }
  }
  return readable_unit(line.si, is_angle(line) ? Dimension::of(0, 0, 0, 0, 1) : line.dimension);
}

/// In C++ an angle is a plain number; its formula tells it from one.
bool Names::is_angle(const Line& line) const {
  if (!line.dimension.is_number()) return false;
  const auto tree = formula::parse(line.formula);
  return tree && formula::is_angle(*tree, [&](std::string_view name) {
           const auto known = find(line.scope, name);
           return known && known->unit == "deg";
         });
}

void Names::add(const Line& line, const std::string& unit) {
  lines_[joined(line.scope, line.symbol)] = {line.si, unit};
}

std::vector<account::Derived> derive(const Trace& trace, const Record& input, const Record& result) {
  Names names(input, result);
  std::vector<account::Derived> derived;
  for (const Line& line : trace.lines()) {
    const std::string unit = names.unit_of(line);
    derived.push_back({line.scope, step_of(line, names, unit), named_element(line.scope, input, result)});
    names.add(line, unit);
  }
  return derived;
}

}  // namespace loadpath::project
