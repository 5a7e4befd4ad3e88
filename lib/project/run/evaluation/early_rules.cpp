// Rules over literals only, before any step is solved: values not known yet may remove a violation.
#include "lib/project/run/evaluation/prepared_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

/// Values that an input may turn out to have: its bounds, and one between.
std::array<double, 3> samples_of(const FieldInfo& field) {
  constexpr double far = 1e6;  // in the unit of the field, where it has no bound
  const auto& choices = field.choices;
  if (field.type == FieldInfo::Type::choice) {
    const std::size_t last = choices.size() - 1, half = choices.size() / 2;
    return {0.0, static_cast<double>(last), static_cast<double>(half)};
  }
  const auto within = [&](double bound, double other) { return std::isfinite(bound) ? bound : other; };
  const double most = field.type == FieldInfo::Type::count ? far : far * field.factor;
  double low = within(field.bounds.low, -most), high = within(field.bounds.high, most);
  if (field.bounds.low_open) low += 1e-9 * (high - low);
  if (field.bounds.high_open) high -= 1e-9 * (high - low);
  const double middle = 0.5 * (within(field.plausible.low, low) + within(field.plausible.high, high));
  return {low, high, field.type == FieldInfo::Type::count ? std::floor(middle) : middle};
}

/// Whether an input is known only when the project is solved, or has an error; expressions with a known value are not
/// pending.
bool is_pending(const PreparedStep& step, const std::string& field) {
  const auto concerns = [&](const auto& entry) {
    return entry.path.substr(0, entry.path.find_first_of(".[")) == field;
  };
  const auto& reading = step.input().reading;
  return reading.faulty.count(field) != 0 || step.names_row_for(field) ||
         std::any_of(reading.operands.begin(), reading.operands.end(),
                     [&](const Operand& operand) { return concerns(operand) && std::isnan(operand.early); }) ||
         std::any_of(reading.taken.begin(), reading.taken.end(), concerns) ||
         std::any_of(reading.varied.begin(), reading.varied.end(), concerns) ||
         std::any_of(step.searches().begin(), step.searches().end(), concerns) ||
         std::any_of(step.provided().begin(), step.provided().end(), concerns);
}

/// The leaves that have no value before the project is solved.
std::vector<std::string> pending_leaves(const PreparedStep& step) {
  std::vector<std::string> paths;
  for (const Operand& operand : step.input().reading.operands)
    if (std::isnan(operand.early)) paths.push_back(operand.path);
  for (const Taken& taken : step.input().reading.taken)
    if (taken.field != nullptr) paths.push_back(taken.path);
  for (const Varied& varied : step.input().reading.varied) paths.push_back(varied.path);
  for (const Search& search : step.searches()) paths.push_back(search.path);
  for (const Provided& provided : step.provided()) paths.push_back(provided.path);
  return paths;
}

}  // namespace

/// Values not known yet may remove a violation: a rule counts as violated only if it is for all of them, and all
/// rules are checked again when the project is solved.
void PreparedStep::check_rules_of_literals(std::vector<Issue>& issues) {
  const Calculator& calculator = *input().calculator;
  const auto is_list = [](const Taken& taken) {
    return taken.field != nullptr && taken.field->type == FieldInfo::Type::list;
  };
  const auto& taken = input().reading.taken;
  if (std::any_of(taken.begin(), taken.end(), is_list)) return;  // the number of elements is unknown
  const Record record = input().reading.record.clone();
  for (const Operand& operand : input().reading.operands)
    if (!std::isnan(operand.early)) find_leaf(record, operand.path).set(operand.early);
  std::vector<Leaf> pending;
  for (const std::string& path : pending_leaves(*this)) {
    const Leaf leaf = find_leaf(record, path);
    if (leaf && leaf.field->get != nullptr) pending.push_back(leaf);
  }
  const auto unset = [&](const Leaf& leaf) {
    return leaf.field->type == FieldInfo::Type::quantity ? std::nan("") : leaf.get();
  };
  const auto broken_whatever_comes = [&](std::size_t rule) {
    std::vector<double> as_read;
    as_read.reserve(pending.size());
    for (const Leaf& leaf : pending) as_read.push_back(leaf.get());
    bool broken = !calculator.holds(rule, record.data.get());
    for (std::size_t sample = 0; broken && !pending.empty() && sample < 4; ++sample) {
      for (const Leaf& leaf : pending) leaf.set(sample == 3 ? unset(leaf) : samples_of(*leaf.field)[sample]);
      broken = !calculator.holds(rule, record.data.get());
    }
    for (std::size_t i = 0; i < pending.size(); ++i) pending[i].set(as_read[i]);
    return broken;
  };
  for (std::size_t i = 0; i < calculator.rules.size(); ++i) {
    if (calculator.rules[i].only_warns) continue;  // reported once, when it is solved
    const auto fields = listed_keys(calculator.rules[i].fields);
    if (std::any_of(fields.begin(), fields.end(), [&](const std::string& f) { return is_pending(*this, f); })) continue;
    if (broken_whatever_comes(i)) issues.push_back(broken_rule(i, record, provided_));
  }
}

}  // namespace loadpath::project
