#include "lib/project/run/evaluation/inputs.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

bool is_known_somewhere(const Value& value) {
  return std::any_of(value.si.begin(), value.si.end(), [](double x) { return !std::isnan(x); });
}

bool is_known_throughout(const Value& value) {
  return std::none_of(value.si.begin(), value.si.end(), [](double x) { return std::isnan(x); });
}

/// Whether it is of the dimension, and has a value anywhere.
bool exists(const Value& value, const Dimension& dimension) {
  return value.signature.dimension == dimension && is_known_somewhere(value);
}

/// The value as one of the step's axis: a series over it, or the largest magnitude of a foreign series.
Value fitted(const Value& value, const Axis* axis) {
  if (!value.is_series() || value.signature.axis == axis) return value;
  return {{value.signature.dimension, nullptr}, {std::abs(largest(value).value)}};
}

bool is_of_row(const Provided& provided, const std::string& group) {
  return !provided.row.empty() && provided.field->provider.table == group;
}

}  // namespace

Inputs::Inputs(const PreparedStep& step, const Known& known)
    : step_(step),
      known_(known),
      record_(step.input().reading.record.clone()),
      rows_(step.input().rows),
      provided_(step.provided()),
      origins_(step.origins()) {}

bool Inputs::evaluate_operands(std::vector<Issue>& issues, const std::set<std::string>& left_open) {
  bool sound = true;
  for (const Operand& operand : step_.input().reading.operands) {
    if (left_open.contains(operand.path)) continue;
    auto value = evaluate_operand(operand, step_.name(), known_, issues);
    sound = sound && value.has_value();
    if (value && !operand.of_record && !is_known_somewhere(*value)) sound = has_elements(operand, issues) && sound;
    if (!value || (operand.may_be_incomplete && !is_known_somewhere(*value))) continue;
    add_computed(
        {operand.path, leaf(operand.path), std::move(*value), expression_origin(*step_.input().tables, operand)});
  }
  sound = find_records(left_open, issues) && sound;
  for (const Provided& provided : provided_) {
    if (std::any_of(provided.companions.begin(), provided.companions.end(),
                    [&](const std::string& path) { return exists(known_(path), provided.field->dimension); })) {
      add_computed(companion_input(provided));
    }
  }
  return sound;
}

void Inputs::add_computed(ComputedInput input) {
  input.is_whole = input.leaf.field->takes_whole() && input.value.is_series();
  if (input.is_whole) input.leaf.field->set_series(input.leaf.owner, input.value);
  computed_.push_back(std::move(input));
}

/// The largest of several load components at each position.
ComputedInput Inputs::companion_input(const Provided& provided) const {
  Value most{{provided.field->dimension, nullptr}, {0.0}};
  std::string names;
  for (const std::string& path : provided.companions) {
    const Value value = fitted(known_(path), step_.axis());
    if (!exists(value, provided.field->dimension)) continue;  // a shaft with one wheel has one force
    if (value.is_series() && !most.is_series())
      most = {value.signature, std::vector<double>(value.si.size(), most.si[0])};
    for (std::size_t i = 0; i < most.si.size(); ++i) {
      const double size = std::abs(value.si[value.is_series() ? i : 0]);
      if (size > most.si[i] || std::isnan(size)) most.si[i] = size;  // NaN stays
    }
    names += (names.empty() ? "" : ", ") + path;
  }
  return {provided.path, leaf(provided.path), std::move(most), {say("linked: {1}", names), {}, false}};
}

void Inputs::take_row(const std::string& group, const std::string& row, std::vector<Issue>& issues) {
  rows_[group].text = row;
  for (const Provided& provided : provided_) {  // the next row may not have other columns
    if (is_of_row(provided, group))
      leaf(provided.path).set(find_leaf(step_.input().reading.record, provided.path).get());
  }
  std::erase_if(provided_, [&](const Provided& provided) { return is_of_row(provided, group); });
  for (Provided& provided : provided_by_rows(step_.input(), {{group, rows_[group]}}, issues))
    provided_.push_back(std::move(provided));
  origins_.merge(fill_lists(step_.input(), {{group, rows_[group]}}, record_));
}

void Inputs::clear_row(const std::string& group) {
  const Record untouched(*step_.input().calculator->input);
  for (const Provided& provided : provided_) {
    if (!is_of_row(provided, group)) continue;
    const Leaf given = leaf(provided.path);
    const bool is_quantity = given.field->type == FieldInfo::Type::quantity;
    const double si = is_quantity ? std::nan("") : find_leaf(untouched, provided.path).get();
    if (is_quantity || !std::isnan(si)) given.set(si);  // NaN is not a value of a choice
  }
  std::erase_if(provided_, [&](const Provided& provided) { return is_of_row(provided, group); });
  rows_[group].text.clear();
}

bool Inputs::set_values_of_rows(double size) {
  bool changed = false;
  table_gap_ = {};
  for (const Provided& provided : provided_) {
    if (provided.row.empty()) continue;
    Lookup found = look_up(provided, size);
    const Leaf value = leaf(provided.path);
    const double before = value.get();
    changed = changed || (before != found.si && !(std::isnan(before) && std::isnan(found.si)));
    value.set(found.si);
    origins_[provided.path] = std::move(found.origin);
    if (std::isnan(found.si)) table_gap_ = found.reason;
  }
  return changed;
}

bool Inputs::set_position(std::size_t i) {
  bool available = unavailable_.empty();
  for (const ComputedInput& input : computed_) {
    if (input.is_whole) {
      available = available && is_known_throughout(input.value);
      continue;
    }
    const double si = input.value.si[input.value.is_series() ? i : 0];
    available = available && !std::isnan(si);
    input.leaf.set(si);
  }
  return available;
}

void Inputs::set_value(const std::string& path, const Leaf& leaf, const Value& value) {
  const auto is_it = [&](const ComputedInput& input) { return input.path == path; };
  if (const auto found = std::find_if(computed_.begin(), computed_.end(), is_it); found != computed_.end())
    found->value = value;
  else
    leaf.set(value.si[0]);
}

const ComputedInput* Inputs::find_computed(std::string_view path) const {
  const auto is_it = [&](const ComputedInput& input) { return input.path == path; };
  const auto found = std::find_if(computed_.begin(), computed_.end(), is_it);
  return found == computed_.end() ? nullptr : &*found;
}

Value Inputs::value_of(const std::string& path, const Leaf& leaf) const {
  if (const ComputedInput* const computed = find_computed(path)) return computed->value;
  return {{leaf.field->dimension, nullptr}, {leaf.get()}};
}

bool Inputs::is_given(std::string_view input) const {
  const Leaf given = leaf(input);
  return (given && !std::isnan(given.get())) || find_computed(input) != nullptr;
}

std::string_view Inputs::size_field() const {
  for (const Provided& provided : provided_) {
    std::string_view sizes = provided.field->provider.size;
    if (sizes.empty()) continue;
    for (std::size_t end = sizes.find(", "); end != std::string_view::npos; end = sizes.find(", ")) {
      if (is_given(sizes.substr(0, end))) return sizes.substr(0, end);
      sizes.remove_prefix(end + 2);
    }
    return sizes;
  }
  return {};
}

Origin Inputs::origin_of(const std::string& path, const Leaf& leaf) const {
  const auto known = origins_.find(path);
  if (known != origins_.end()) return known->second;
  if (const ComputedInput* const computed = find_computed(path)) return computed->origin;
  return plain_origin(step_.input().reading, path, leaf);
}

const Origin* Inputs::origin_of_row(const std::string& group) const {
  const auto found = origins_.find(group);
  return found == origins_.end() ? nullptr : &found->second;
}

Message Inputs::missing() const {
  if (!unavailable_.empty()) return unavailable_;
  for (const ComputedInput& input : computed_) {
    if (!is_known_throughout(input.value)) return say("'{1}' is not available: {2}", input.path, input.origin.text);
  }
  return {};
}

}  // namespace loadpath::project
