#include "lib/project/references/factors/given.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

const Value& value_at(const Project& project, const std::string& path) {
  static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
  const Value* const value = project.value(path);
  return value == nullptr ? none : *value;
}

}  // namespace

bool is_applied(double factor) { return !std::isnan(factor) && factor != 1.0; }

double applied_factor(const std::vector<double>& si) {
  const auto found = std::find_if(si.begin(), si.end(), is_applied);
  return found == si.end() ? 1.0 : *found;
}

double factor_of(const Step& step, const std::string& key) {
  const Value* const value = step.value(key);
  return value == nullptr ? 1.0 : applied_factor(value->si);
}

bool carries_factors(const FieldInfo& field) {
  return field.is_load || *field.factors != '\0' || field.dimension == Dimension::of(2, 1, -3);
}

bool is_peak(const Operand& operand) { return operand.path == "T_max"; }

bool is_given(const StepInput& step, const std::string& key) {
  return step.reading.typed.contains(key) || is_expression(step, key);
}

bool is_expression(const StepInput& step, const std::string& key) { return step.reading.operand(key) != nullptr; }

double given_factor(const Project& project, const StepInput& step, const std::string& key) {
  const auto known = [&](const std::string& path) -> const Value& { return value_at(project, path); };
  if (const Operand* const operand = step.reading.operand(key)) {
    const std::vector<double> si = operand->expression.evaluate(known).si;
    const bool waits = std::any_of(si.begin(), si.end(), [](double x) { return std::isnan(x); });
    return waits ? std::numeric_limits<double>::quiet_NaN() : applied_factor(si);
  }
  const Leaf leaf = find_leaf(step.reading.record, key);
  return leaf ? leaf.get() : 1.0;
}

double largest_of(const Project& project, const Operand& operand) {
  double most = 0.0;
  const auto known = [&](const std::string& path) -> const Value& { return value_at(project, path); };
  for (const double si : operand.expression.evaluate(known).si) most = std::max(most, std::abs(si));
  return most;
}

double largest_given(const Project& project, const StepInput& step, const std::string& key) {
  if (const Operand* const operand = step.reading.operand(key)) return largest_of(project, *operand);
  const double typed = find_leaf(step.reading.record, key).get();
  return std::isnan(typed) ? 0.0 : typed;
}

std::set<std::string> values_in(const Operand& operand, const Dimension& dimension, const Project& project) {
  std::set<std::string> values;
  for (const auto& reference : operand.expression.references()) {
    const Value* const value = reference.path.starts_with("values.") ? project.value(reference.path) : nullptr;
    if (value != nullptr && value->signature.dimension == dimension) values.insert(reference.path);
  }
  return values;
}

}  // namespace loadpath::project
