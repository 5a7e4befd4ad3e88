#include "lib/project/run/derivation.hpp"

#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

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

/// Whether the executed branch adds nothing to the line: S_0 of S_0, if it is given, or 30.0 * m_per_s.
bool says_nothing(const formula::Node& tree, const Line& line, const Names& names) {
  using formula::Kind;
  const auto known = [&](std::string_view name) { return names.si_of(line.scope, name); };
  const formula::Node& ran = formula::chosen(tree, known);
  const bool in_unit = ran.kind == Kind::binary && ran.text == "*" && ran.kids[0].kind == Kind::number &&
                       ran.kids[1].kind == Kind::symbol && !known(ran.kids[1].text);
  return ran.kind == Kind::number || in_unit ||
         (ran.kind == Kind::symbol && formula::symbol_of(ran.text) == line.symbol);
}

std::optional<Names::Known> found_in(const Record& record, std::string_view path) {
  const std::size_t word = path.find("::");
  const Leaf leaf = find_leaf(record, path.substr(0, word));
  if (!leaf || leaf.field->get == nullptr) return std::nullopt;
  if (word == std::string_view::npos) return Names::Known{leaf.get(), leaf.field->unit};
  for (std::size_t i = 0; i < leaf.field->choices.size(); ++i) {
    if (leaf.field->choices[i].key == path.substr(word + 2)) return Names::Known{static_cast<double>(i), "-"};
  }
  return std::nullopt;
}

bool is_speed(std::string_view unit) { return unit == "rpm" || unit == "rad/s"; }

/// The unit in which the speeds of a formula are printed, so that it comes out as printed; empty: each in its own.
/// A formula that gives the same value with revolutions as with radians, a ratio or a multiple of speeds, keeps rpm;
/// another one is of angular velocities: P/n, n d/2, L_h n/(2 pi).
std::string unit_of_speeds(const formula::Node& tree, const Line& line, const Names& names, const std::string& unit,
                           const std::vector<account::Step::Given>& given) {
  if (std::ranges::none_of(given, [](const auto& known) { return known.unit == "rpm"; })) return {};
  constexpr double revolution = 2.0 * std::numbers::pi;
  bool any_rpm = false;
  const auto value_with = [&](double divisor) {
    return formula::value(tree, [&](std::string_view name) -> std::optional<double> {
      if (name == "rpm") return revolution / 60.0 / divisor;
      const auto known = names.find(line.scope, name);
      if (!known) return std::nullopt;
      any_rpm = any_rpm || known->unit == "rpm";
      return is_speed(known->unit) ? known->si / divisor : known->si;
    });
  };
  const double radians = value_with(1.0), revolutions = value_with(revolution) * (is_speed(unit) ? revolution : 1.0);
  if (!any_rpm || std::isnan(radians)) return {};
  if (std::abs(radians - revolutions) > 1e-9 * std::abs(radians)) return "rad/s";
  return is_speed(unit) ? "" : "rpm";
}

account::Step step_of(const Line& line, const Names& names, const std::string& unit) {
  account::Step step;
  step.symbol = line.symbol;
  step.value = {line.si, unit};
  step.why = say(line.why);
  const Names::Formula& formula = names.formula_of(line);
  if (formula.tree && says_nothing(*formula.tree, line, names)) return step;
  step.formula = formula.shown;
  for (const std::string& name : formula.names) {
    const auto known = names.find(line.scope, name);
    if (known) step.given.push_back({std::string(formula::symbol_of(name)), known->si, known->unit});
  }
  if (!formula.tree) return step;
  const std::string of_speeds = unit_of_speeds(*formula.tree, line, names, unit, step.given);
  for (account::Step::Given& known : step.given) {
    if (!of_speeds.empty() && is_speed(known.unit)) known.unit = of_speeds;
  }
  return step;
}

}  // namespace

std::optional<Names::Known> Names::find_line(const std::string& scope, std::string_view name) const {
  const auto line = lines_.find(joined(scope, name));
  return line != lines_.end() ? std::optional(line->second) : std::nullopt;
}

std::optional<Names::Known> Names::find_result(const std::string& scope, std::string_view name) const {
  const auto line = find_line(scope, name);
  return line ? line : found_in(result_, joined(scope, name));
}

std::optional<Names::Known> Names::find_any(const std::string& scope, std::string_view name) const {
  if (const auto line = find_line(scope, name)) return line;
  // A list of the input with the scope's name need not have the same elements as that of the result. At the top level
  // the calculator has replaced an input that was left open ("d").
  const auto found = found_in(result_, joined(scope, name));
  if (!scope.empty()) return found;
  const auto typed = found_in(input_, name);
  return (!typed || std::isnan(typed->si)) && found ? found : typed;
}

std::optional<Names::Known> Names::find_outwards(std::string scope, std::string_view name, Find in_scope) const {
  while (true) {
    if (const auto known = (this->*in_scope)(scope, name)) return known;
    if (scope.empty()) return std::nullopt;
    const std::size_t dot = scope.rfind('.');
    scope.resize(dot == std::string::npos ? 0 : dot);
  }
}

std::optional<Names::Known> Names::find(const std::string& scope, std::string_view name) const {
  if (name.starts_with("in.")) {  // a calculator that another one runs has an input that is not this one
    const auto known = found_in(input_, name.substr(3));
    if (known && !std::isnan(known->si)) return known;  // else the calculator has replaced an open input
  }
  if (name.starts_with("r.")) return find_outwards(scope, name.substr(2), &Names::find_result);
  return find_outwards(scope, formula::symbol_of(name), &Names::find_any);
}

std::optional<double> Names::si_of(const std::string& scope, std::string_view name) const {
  const auto known = find(scope, name);
  return known ? std::optional(known->si) : std::nullopt;
}

std::string Names::unit_of(const Line& line) const {
  for (const Record* record : {&result_, &input_}) {
    const Leaf leaf = find_leaf(*record, joined(line.scope, line.symbol));
    if (leaf && leaf.field->type == FieldInfo::Type::quantity &&
        leaf.field->dimension.without_angle() == line.dimension.without_angle()) {
      return leaf.field->unit;
    }
  }
  const std::string unit = unit_of_speed(line);
  if (!unit.empty()) return unit;
  return readable_unit(line.si, is_angle(line) ? Dimension::of(0, 0, 0, 0, 1) : line.dimension);
}

/// In C++ an angle is a plain number; its formula identifies it.
bool Names::is_angle(const Line& line) const {
  if (!line.dimension.is_number()) return false;
  const auto& tree = formula_of(line).tree;
  return tree && formula::is_angle(*tree, [&](std::string_view name) {
           const auto known = find(line.scope, name);
           return known && known->unit == "deg";
         });
}

/// In C++ an angular velocity has the dimension of a frequency; the quantity that it is a multiple of distinguishes
/// them: "rpm", "rad/s".
std::string Names::unit_of_speed(const Line& line) const {
  if (line.dimension != Dimension::of(0, 0, -1)) return {};
  std::string unit;
  for (const std::string& name : formula_of(line).names) {
    const auto known = find(line.scope, name);
    if (!known || known->unit == "-" || known->unit == "deg") continue;
    if (known->unit != "rpm" && known->unit != "rad/s") return {};
    if (unit.empty()) unit = known->unit;
  }
  return unit;
}

const Names::Formula& Names::formula_of(const Line& line) const {
  const auto [found, is_new] = formulas_.try_emplace(line.formula);
  Formula& formula = found->second;
  if (!is_new) return formula;
  formula.tree = formula::parse(line.formula);
  if (formula.tree) formula.names = formula::names(*formula.tree);
  formula.shown = formula::shown(line.formula);
  return formula;
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
