#include "lib/project/run/run.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace loadpath::project {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Every leaf in the order of for_each_leaf, without making paths.
template <class Visit>
void walk(std::span<const FieldInfo> fields, void* data, const Visit& visit) {
  for (const FieldInfo& field : fields) {
    if (field.is_leaf()) visit(field, data);
    if (!field.has_fields()) continue;
    for (std::size_t i = 0; i < field.size(data); ++i) walk(field.fields, field.element(data, i), visit);
  }
}

/// How many elements each list has, in the order of a walk.
std::vector<std::size_t> list_sizes(std::span<const FieldInfo> fields, void* data) {
  std::vector<std::size_t> sizes;
  for (const FieldInfo& field : fields) {
    if (field.type == FieldInfo::Type::list) sizes.push_back(field.size(data));
  }
  return sizes;
}

/// Whether it has a value anywhere.
bool is_known(const Value& value) {
  return std::any_of(value.si.begin(), value.si.end(), [](double x) { return !std::isnan(x); });
}

bool is_known_throughout(const Value& value) {
  return std::none_of(value.si.begin(), value.si.end(), [](double x) { return std::isnan(x); });
}

/// Whether it is of the dimension, and has a value anywhere.
bool exists(const Value& value, const Dimension& dimension) {
  return value.signature.dimension == dimension && is_known(value);
}

/// The value as one of the step's axis: a series over it, or the largest magnitude of a foreign series.
Value fitted(const Value& value, const Axis* axis) {
  if (!value.is_series() || value.signature.axis == axis) return value;
  return {{value.signature.dimension, nullptr}, {std::abs(largest(value).value)}};
}

}  // namespace

Run::Run(const CalculatorStep& step, const Known& known, bool in_words)
    : in_words_(in_words),
      step_(step),
      calculator_(*step.input().calculator),
      known_(known),
      axis_(step.axis()),
      record_(step.input().reading.record.clone()),
      result_(*calculator_.result),
      rows_(step.input().rows),
      provided_(step.provided()),
      origins_(step.origins()),
      applies_(calculator_.modes.size(), Applies::no) {}

bool Run::evaluate_operands(std::vector<Issue>& issues, const std::set<std::string>& left_open) {
  bool sound = true;
  for (const Operand& operand : step_.input().reading.operands) {
    if (left_open.contains(operand.path)) continue;
    auto value = evaluate_operand(operand, step_.name(), known_, issues);
    sound = sound && value.has_value();
    if (!value || (operand.may_lack && !is_known(*value))) continue;
    add_input(
        {operand.path, map_leaf(operand.path), std::move(*value), expression_origin(*step_.input().tables, operand)});
  }
  for (const Provided& provided : provided_) {
    if (std::any_of(provided.companions.begin(), provided.companions.end(),
                    [&](const std::string& path) { return exists(known_(path), provided.field->dimension); })) {
      add_input(companion_input(provided));
    }
  }
  return sound;
}

void Run::add_input(Input input) {
  input.is_whole = input.leaf.field->takes_whole() && input.value.is_series();
  if (input.is_whole) input.leaf.field->set_series(input.leaf.owner, input.value);
  inputs_.push_back(std::move(input));
}

/// Of several things that come along, the largest at each position.
Run::Input Run::companion_input(const Provided& provided) const {
  Value most{{provided.field->dimension, nullptr}, {0.0}};
  std::string names;
  for (const std::string& path : provided.companions) {
    const Value value = fitted(known_(path), axis_);
    if (!exists(value, provided.field->dimension)) continue;  // a shaft with one wheel has one force
    if (value.is_series() && !most.is_series())
      most = {value.signature, std::vector<double>(value.si.size(), most.si[0])};
    for (std::size_t i = 0; i < most.si.size(); ++i) {
      const double size = std::abs(value.si[value.is_series() ? i : 0]);
      if (!(size <= most.si[i])) most.si[i] = size;  // what is not available stays so
    }
    names += (names.empty() ? "" : ", ") + path;
  }
  return {provided.path, map_leaf(provided.path), std::move(most), {say("comes with it: {1}", names), {}, false}};
}

bool Run::set_position(std::size_t i) {
  bool available = not_given_.empty();
  for (const Input& input : inputs_) {
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

bool Run::check_rules(std::vector<Issue>& issues) {
  provide(first_size());
  std::set<std::size_t> warned;  // a warning is said once, not at every position
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    for (std::size_t rule = 0; rule < calculator_.rules.size(); ++rule) {
      if (waits_for_search(rule) || calculator_.holds(rule, record_.data.get())) continue;
      if (calculator_.rules[rule].only_warns && !warned.insert(rule).second) continue;
      issues.push_back(step_.broken_rule(rule, record_, provided_));
      if (!calculator_.rules[rule].only_warns) return false;
    }
  }
  return true;
}

void Run::provide(double size) {
  missing_ = {};
  for (const Provided& provided : provided_) {
    if (provided.row.empty()) continue;
    Lookup found = look_up(provided, size);
    map_leaf(provided.path).set(found.si);
    origins_[provided.path] = std::move(found.origin);
    if (std::isnan(found.si)) missing_ = found.reason;
  }
}

bool Run::is_given(std::string_view input) const {
  const Leaf leaf = find_leaf(record_, input);
  return (leaf && !std::isnan(leaf.get())) ||
         std::any_of(inputs_.begin(), inputs_.end(), [&](const Input& known) { return known.path == input; });
}

/// What the rows are asked at: the first of the sizes that is given, "d_h, d", else the last.
std::string_view Run::size_field() const {
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

double Run::size_now() {
  if (const FieldInfo* result = find_field(calculator_.result->fields, size_field())) return largest_result(*result);
  for (const Input& input : inputs_) {
    if (input.path == size_field()) return input.value.is_series() ? maximum(input.value).value : input.value.si[0];
  }
  const Leaf given = find_leaf(record_, size_field());
  return given ? given.get() : nan;
}

/// A size that follows from the values, or is searched for, starts at nothing.
double Run::first_size() {
  if (size_field().empty()) return nan;
  const bool found = find_field(calculator_.result->fields, size_field()) != nullptr ||
                     (!step_.searches().empty() && step_.searches().front().path == size_field());
  return found ? 0.0 : size_now();
}

/// A strength falls with the size that it is asked for, so the size only grows from one round to the next.
void Run::settle_sizes(double size) {
  if (size_field().empty()) return provide(nan);
  for (int round = 0; round < 20; ++round) {
    provide(size);
    settled_ = size;
    const double next = size_now();
    if (std::isnan(next) || next == size) return;  // without a size something is not available; the checks say so
    size = next;
  }
}

double Run::largest_result(const FieldInfo& field) {
  Value column{{field.dimension, axis_}, {}};
  for (std::size_t i = 0; i < positions(); ++i) {
    if (set_position(i)) {
      calculator_.evaluate(record_.data.get(), result_.data.get());
      column.si.push_back(field.get(result_.data.get()));
    } else {
      column.si.push_back(nan);
    }
  }
  return axis_ == nullptr ? column.si[0] : maximum(column).value;
}

void Run::evaluate() {
  settle_sizes();
  columns_.clear();
  std::vector<std::size_t> shape;  // of the result that the columns stand for
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) {
      doubt_modes();
      continue;
    }
    ask_modes();
    calculator_.evaluate(record_.data.get(), result_.data.get());
    std::vector<std::size_t> here = list_sizes(calculator_.result->fields, result_.data.get());
    if (columns_.empty() || here != shape) {
      add_columns();
      shape = std::move(here);
    }
    std::size_t column = 0;
    walk(calculator_.result->fields, result_.data.get(), [&](const FieldInfo& field, const void* owner) {
      if (field.get == nullptr) return;
      const double si = field.get(owner);  // what has left the range of numbers is not available
      columns_[order_[column++]].si[i] = std::isinf(si) && !field.infinite ? nan : si;
    });
  }
}

/// Columns for the leaves of the result as it is now, in the order of a walk; those that are known keep their values.
void Run::add_columns() {
  order_.clear();
  for_each_leaf(result_, [&](const std::string& path, const Leaf& leaf) {
    if (leaf.field->get == nullptr) return;
    const auto known = std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.path == path; });
    order_.push_back(static_cast<std::size_t>(known - columns_.begin()));
    if (known == columns_.end()) columns_.push_back({path, leaf.field, std::vector<double>(positions(), nan)});
  });
}

/// The position where the largest check is largest, or the first that is available.
std::size_t Run::governing_position() const {
  std::size_t best = 0;
  double most = -1.0;
  for (const Column& column : columns_) {
    if (column.field->role != Role::check || !is_asked(*column.field) || column.field->is_beside) continue;
    for (std::size_t i = 0; i < column.si.size(); ++i) {
      if (numerics::exceeds(column.si[i], most)) {
        most = column.si[i];
        best = i;
      }
    }
  }
  return best;
}

void Run::trace_governing() {
  governing_ = governing_position();
  traced_ = !columns_.empty() && set_position(governing_);
  if (traced_ && in_words_)
    calculator_.explain(record_.data.get(), result_.data.get(), trace_);
  else if (traced_ && positions() > 1)
    calculator_.evaluate(record_.data.get(), result_.data.get());
}

}  // namespace loadpath::project
