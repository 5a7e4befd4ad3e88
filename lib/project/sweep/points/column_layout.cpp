// The properties that a ColumnStep derives after its step was solved at one point.
#include "lib/account/rows.hpp"
#include "lib/project/accept.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/run/evaluation/searched_rules.hpp"
#include "lib/project/sweep/points/column_plan.hpp"
#include "lib/sweep/nan.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using account::State;

std::string head_of(std::string_view path) { return std::string(path.substr(0, path.find_first_of(".["))); }

/// A plan that is being made.
struct ColumnLayout : ColumnPlan {
  using ColumnPlan::ColumnPlan;

  bool lay_out(const std::set<std::string>& wanted, const PointColumns& points);
  [[nodiscard]] bool is_plain() const;
  bool add_fed(const PointColumns& points);
  [[nodiscard]] std::optional<std::size_t> place_of(const FieldInfo& field, const std::string& path) const;
  void bound_last(const std::string& path);
  bool add_companions(const PointColumns& points);
  bool add_absent(const Provided& provided, const PointColumns& points);
  [[nodiscard]] bool may_be_held(const LoadComponent& component) const;
  bool add_left(const PointColumns& points);
  bool add_values_of_rows();
  [[nodiscard]] std::string size_field() const;
  [[nodiscard]] Size size_of(const std::string& field) const;
  bool add_read(const std::set<std::string>& wanted);
  [[nodiscard]] bool is_fed(std::string_view field) const;
  bool add_bounds();
  void add_rules();
  void add_judging();
  bool add_search();
  void add_rules_of_search();
  void look_for_loads();
};

}  // namespace

bool is_fixed(std::span<const FieldInfo> fields, std::string_view path) {
  const FieldInfo* const head = find_field(fields, head_of(path));
  const FieldInfo* const field = find_field_at(fields, path);
  return head != nullptr && head->type != FieldInfo::Type::list && field != nullptr && field->address != nullptr;
}

std::size_t offset_in(const Record& record, const Leaf& leaf) {
  const char* const start = static_cast<const char*>(record.data.get());
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) - start);
}

bool ColumnLayout::lay_out(const std::set<std::string>& wanted, const PointColumns& points) {
  if (!is_plain() || !add_fed(points) || !add_companions(points) || !add_search() || !add_values_of_rows() ||
      !add_read(wanted) || !add_left(points) || !add_bounds())
    return false;
  add_rules();
  add_rules_of_search();
  add_judging();
  look_for_loads();
  return true;
}

/// Whether the step takes no complete objects, and its loads contain their factors.
bool ColumnLayout::is_plain() const {
  const Reading& reading = step.input().reading;
  return reading.taken.empty() && reading.whole.empty() && !step.goes_point_by_point() &&
         !step.account().results.empty() && step.loads().missing_factor.empty();
}

bool ColumnLayout::is_fed(std::string_view field) const {
  return std::any_of(fed.begin(), fed.end(), [&](const ColumnInput& f) {
    return std::string_view(f.path()).substr(step.name().size() + 1) == field;
  });
}

/// The offset of a varying input in the record; nothing if it is not fixed, or affects more than numbers.
std::optional<std::size_t> ColumnLayout::place_of(const FieldInfo& field, const std::string& path) const {
  const auto compared = step.compared().find(path);
  if (compared != step.compared().end() && std::isnan(compared->second)) return std::nullopt;
  if (field.is_factor || field.takes_whole() || !is_fixed(calculator.input->fields, path)) return std::nullopt;
  const Leaf leaf = find_leaf(record, path);
  const Value* const now = step.value(path);
  if (now != nullptr && !now->si.empty()) leaf.set(now->si[0]);  // inputs that activate checks have a value
  return offset_in(record, leaf);
}

bool ColumnLayout::add_fed(const PointColumns& points) {
  const Reading& reading = step.input().reading;
  for (const Varied& varied : reading.varied) {
    const auto place = varied.leaf && varied.words.empty() ? place_of(*varied.leaf.field, varied.path) : std::nullopt;
    if (!place) return false;
    fed.emplace_back(step.name() + "." + varied.path, *varied.leaf.field, *place);
    bound_last(varied.path);
  }
  for (const Operand& operand : reading.operands) {
    const auto place = place_of(*operand.leaf.field, operand.path);
    if (!place) return false;
    const Value* const now = step.value(operand.path);
    const bool is_open = operand.may_be_incomplete && (now == nullptr || std::isnan(now->si[0]));
    fed.emplace_back(step.name() + "." + operand.path, *operand.leaf.field, *place, operand.expression, is_open,
                     points);
    bound_last(operand.path);
  }
  return true;
}

/// Above this value the input that was added last is compared with rows and strengths as one of a single design.
void ColumnLayout::bound_last(const std::string& path) {
  const auto compared = step.compared().find(path);
  if (compared != step.compared().end()) fed.back().accept_up_to(compared->second);
}

/// Adds components absent at this point; false for a series.
bool ColumnLayout::add_absent(const Provided& provided, const PointColumns& points) {
  for (const std::string& path : provided.companions) {
    const auto signature = points.signatures.find(path);
    if (signature == points.signatures.end() || signature->second.dimension != provided.field->dimension) continue;
    if (signature->second.axis != nullptr) return false;
    absent.push_back(path);
  }
  return true;
}

/// Adds the components of loads, if any.
bool ColumnLayout::add_companions(const PointColumns& points) {
  for (const Provided& provided : step.provided()) {
    if (!provided.row.empty()) continue;
    if (step.value(provided.path) == nullptr) {
      if (!add_absent(provided, points)) return false;
      continue;
    }
    const auto place = place_of(*provided.field, provided.path);
    if (!place) return false;
    fed.emplace_back(step.name() + "." + provided.path, *provided.field, *place, provided.companions, points);
  }
  return true;
}

/// Whether an input other than the one that takes the load has this component, or may have it at another point.
bool ColumnLayout::may_be_held(const LoadComponent& component) const {
  const std::string own = prefix_of(component.input) + component.path.substr(component.path.rfind('.') + 1);
  const auto is_given = [&](const std::string& path) {
    const Leaf leaf = find_leaf(record, path);
    const bool is_load = leaf && leaf.field->is_load && leaf.field->is_number();
    return is_load && (is_fed(path) || !(std::isnan(leaf.get()) || leaf.get() == 0.0));
  };
  return is_given(own) || is_given(own + "_x") || is_given(own + "_y");
}

/// False if inputs may hold what is left out: that would have to be asked at each point.
bool ColumnLayout::add_left(const PointColumns& points) {
  const auto acting = listed_keys(step.loads().left);
  for (const LoadComponent& component : step.components_not_included()) {
    if (may_be_held(component)) return false;
    const std::string& path = component.path;
    const auto signature = points.signatures.find(path);
    if (signature == points.signatures.end()) continue;  // it has no value at any point
    const bool acts = std::find(acting.begin(), acting.end(), path) != acting.end();
    left_components.push_back({path, {signature->second, {}}, acts});
  }
  return true;
}

/// The first of the sizes that rows are asked at which is given, "d_h, d", else the last; empty if none is asked.
std::string ColumnLayout::size_field() const {
  for (const Provided& provided : step.provided()) {
    if (provided.row.empty() || *provided.field->provider.size == '\0') continue;
    const auto keys = listed_keys(provided.field->provider.size);
    for (const std::string& key : keys) {
      const Leaf leaf = find_leaf(record, key);
      if (is_fed(key) || (leaf && !std::isnan(leaf.get()))) return key;
    }
    return keys.back();
  }
  return {};
}

Size ColumnLayout::size_of(const std::string& field) const {
  const bool is_sought = sought && step.searches().front().path == field;
  if (const FieldInfo* const found = find_field(calculator.result->fields, field))
    return {.result = offset_in(result, find_leaf(result, field)), .field = found};
  for (std::size_t k = 0; k < fed.size(); ++k) {
    if (fed[k].path() == step.name() + "." + field) return {.fed = k};
  }
  const Leaf given = find_leaf(record, field);
  return {.is_sought = is_sought, .same = given ? given.get() : nan};
}

/// False if a row has no value.
bool ColumnLayout::add_values_of_rows() {
  const std::string field = size_field();
  const Size all = field.empty() ? Size{} : size_of(field);
  const bool varies = all.result || all.fed || all.is_sought;
  for (const Provided& provided : step.provided()) {
    if (provided.row.empty()) continue;
    const Leaf leaf = find_leaf(record, provided.path);
    if (!varies || !Sized::is_one(provided)) {
      leaf.set(look_up(provided, all.same).si);
      if (std::isnan(leaf.get())) return false;
      continue;
    }
    const Value* const now = step.value(provided.path);
    leaf.set(now == nullptr || now->si.empty() ? nan : now->si[0]);  // inputs that activate checks have a value
    sized.emplace_back(provided, offset_in(record, leaf));
  }
  if (!sized.empty()) size = all;
  return true;
}

/// Adds active checks and limits, and values that others refer to. Lists must be empty, or without checks.
bool ColumnLayout::add_read(const std::set<std::string>& wanted) {
  std::set<std::string> left;
  for (const std::string& path : wanted) {
    if (path.starts_with(step.name() + ".") &&
        find_field_at(calculator.result->fields, path.substr(step.name().size() + 1)))
      left.insert(path);
  }
  for (const account::Verdict& row : step.account().verdicts) {
    if (row.symbol.find_first_of(".[") != std::string::npos) return false;
  }
  for (const FieldInfo& field : calculator.result->fields) {
    const std::string path = step.name() + "." + field.key;
    const bool judges = (field.role == Role::check || field.role == Role::limit) && field.is_leaf();
    const bool is_asked = step.is_asked(field, record);  // otherwise it has no value, even if the calculator sets one
    const bool is_row = judges && is_asked;
    const bool is_wanted = left.erase(path) != 0 && is_asked;
    if (!is_row && !is_wanted) continue;
    if (!is_fixed(calculator.result->fields, field.key)) return false;
    read.push_back({path, &field, offset_in(result, find_leaf(result, field.key)), is_row, is_wanted});
  }
  for (const std::string& path : left) {  // paths of groups
    const std::string within = path.substr(step.name().size() + 1);
    if (!is_fixed(calculator.result->fields, within)) return false;
    const Leaf leaf = find_leaf(result, within);
    read.push_back({path, leaf.field, offset_in(result, leaf), false, true});
  }
  return true;
}

/// False if bounds cannot be found from the record at a point: they are of all positions, or of the size that is found.
bool ColumnLayout::add_bounds() {
  bounds = step.kept_bounds();
  if (axis != nullptr || sought) {
    const bool has_none = std::ranges::all_of(bounds, [](const KeptBound& kept) { return std::isnan(kept.value); });
    bounds.clear();
    return has_none;
  }
  return std::ranges::all_of(bounds, [&](const KeptBound& kept) {
    const double value = calculator.bound(kept.bound, record.data.get(), kept.element);
    return value == kept.value || (std::isnan(value) && std::isnan(kept.value));
  });
}

void ColumnLayout::add_rules() {
  rules.assign(calculator.rules.size(), 0);
  no_rules = series_rules = rules;
  for (std::size_t rule = 0; rule < calculator.rules.size(); ++rule) {
    if (calculator.rules[rule].only_warns) continue;
    const auto fields = listed_keys(calculator.rules[rule].fields);
    const auto names = [&](const std::string& key) {
      return fields.empty() || std::find(fields.begin(), fields.end(), head_of(key)) != fields.end();
    };
    const auto takes = [&](const ColumnInput& f) { return names(f.path().substr(step.name().size() + 1)); };
    const bool concerned = std::ranges::any_of(fed, takes) ||
                           std::ranges::any_of(sized, [&](const Sized& value) { return names(value.field()); });
    rules[rule] = static_cast<char>(concerned);
    series_rules[rule] = static_cast<char>(
        std::ranges::any_of(fed, [&](const ColumnInput& f) { return f.may_vary_over_positions() && takes(f); }));
  }
  is_series_of_loads =
      std::ranges::none_of(fed, [](const ColumnInput& f) { return f.may_vary_over_positions() && !f.field().is_load; });
}

/// False unless it is a search for one size.
bool ColumnLayout::add_search() {
  const auto& searches = step.searches();
  if (searches.empty()) return true;
  const Search& wanted = searches.front();
  const bool is_size = searches.size() == 1 && wanted.leaf && !wanted.stock.empty() && !wanted.leaf.field->is_load;
  if (!is_size || step.sizes_together() || !is_fixed(calculator.input->fields, wanted.path)) return false;
  const Value* const now = step.value(wanted.path);
  if (now == nullptr || now->si.empty()) return false;
  SearchedSize own{.leaf = find_leaf(record, wanted.path), .stock = stock_values(*step.input().tables, wanted.stock)};
  const FieldInfo& searched = *own.leaf.field;
  std::erase_if(own.stock, [&](double si) { return !searched.bounds.holds(si) || !searched.plausible.holds(si); });
  own.offset = offset_in(record, own.leaf);
  own.leaf.set(now->si[0]);  // inputs that activate checks have a value
  if (const FieldInfo* const least = find_field(calculator.result->fields, wanted.path)) {
    if (!is_fixed(calculator.result->fields, wanted.path)) return false;
    own.least = least;
    own.least_offset = offset_in(result, find_leaf(result, wanted.path));
  }
  for (const FieldInfo& field : calculator.input->fields) {
    const FieldInfo* const found = find_field(calculator.result->fields, field.key);
    if (field.kept && found != nullptr && std::isnan(find_leaf(record, field.key).get()))
      own.kept.push_back(offset_in(result, find_leaf(result, field.key)));
  }
  sought = std::move(own);
  return true;
}

/// Adds the rules that a candidate has to satisfy, and those that must hold before there is one.
void ColumnLayout::add_rules_of_search() {
  if (!sought) return;
  sought->rules.assign(calculator.rules.size(), 0);
  for (std::size_t rule = 0; rule < calculator.rules.size(); ++rule) {
    if (!must_hold_in_search(step, rule)) continue;
    sought->rules[rule] = 1;
    rules[rule] = static_cast<char>(sought->leaf.field->sought_unasked ? rules[rule] : 0);
  }
}

void ColumnLayout::add_judging() {
  for (std::size_t k = 0; k < calculator.modes.size(); ++k) {
    const ModeInfo& mode = calculator.modes[k];
    const CheckNeeds needs =
        needs_of(mode, *calculator.result, [&](const FieldInfo& check) { return step.is_asked(check, record); });
    Judging judged{.mode = k, .unjudged = unjudged_of(step, mode, needs)};
    for (const std::string& key : listed_keys(mode.checks)) {
      for (std::size_t i = 0; i < read.size(); ++i) {
        if (read[i].is_row && names_row(key, read[i].field->key)) judged.rows.push_back(i);
      }
    }
    const auto accept = [&](double& state) {
      if (is_accepted(step.input(), mode.id, account::state_of(state))) state = account::number(State::accepted);
    };
    std::ranges::for_each(judged.unjudged.state, accept);
    accept(judged.unjudged.passed);
    judging.push_back(std::move(judged));
  }
}

void ColumnLayout::look_for_loads() {
  for_each_leaf(record, [&](const std::string& path, const Leaf& leaf) {
    if (!leaf.field->is_load) return;
    is_load_told = is_load_told || step.input().reading.typed.contains(path);
    if (!is_fed(path) && (leaf.field->get == nullptr || account::acts(leaf.get()))) is_loaded = true;
  });
}

std::optional<ColumnPlan> plan_columns(CalculatorStep& step, const std::set<std::string>& wanted,
                                       const PointColumns& points) {
  ColumnLayout layout(step);
  if (!layout.lay_out(wanted, points)) return std::nullopt;
  return std::optional<ColumnPlan>(std::move(layout));
}

}  // namespace loadpath::project
