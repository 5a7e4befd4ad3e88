#include "lib/project/run/input_effects.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/because.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace loadpath::project {

namespace {

using Type = FieldInfo::Type;

constexpr std::size_t most_choices = 32;

/// Whether a number differs; NaN equals NaN.
bool differs(double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); }

/// Other values of a quantity, near and far; zero last, for it can turn a part into another one.
std::vector<double> other_quantities(double value, double unit) {
  if (value == 0.0) return {unit, 0.01 * unit, -0.01 * unit, 100.0 * unit, -unit, 1e-4 * unit};
  return {value * (1.0 + 1e-3), value * (1.0 - 1e-3), value * 1.5, value * 0.5, value * 30.0, value * 0.03, 0.0};
}

/// Not the choice without a word: the calculator then decides, perhaps for the same.
std::vector<double> other_choices(std::span<const ChoiceInfo> choices, double value) {
  std::vector<double> all;
  for (std::size_t i = 0; i < std::min(choices.size(), most_choices); ++i) {
    if (static_cast<double>(i) != value && *choices[i].key != '\0') all.push_back(static_cast<double>(i));
  }
  return all;
}

std::vector<double> others(const FieldInfo& field, double value) {
  if (field.type == Type::choice) return other_choices(field.choices, value);
  if (field.type == Type::count) return {value + 1.0, value - 1.0, 2.0 * value, value + 10.0};
  return other_quantities(value, field.factor);
}

bool may_be(const FieldInfo& field, double value) { return field.type == Type::choice || field.bounds.holds(value); }

/// The possible effects of an input: on results, applicability of failure modes, violated customs.
struct Effects {
  std::vector<double> numbers;
  std::string words;
};

/// Adds the values of the results.
void add_effects(std::span<const FieldInfo> fields, void* data, Effects& effects) {
  for (const FieldInfo& field : fields) {
    if (field.type == Type::record || field.is_handed_over) continue;  // repeats inputs
    if (field.has_fields()) {
      for (std::size_t i = 0; i < field.size(data); ++i) add_effects(field.fields, field.element(data, i), effects);
    } else if (field.get != nullptr) {
      effects.numbers.push_back(field.get(data));
    } else {
      effects.words += std::string(field.text(data)) + "\n";
    }
  }
}

bool equal(const Effects& a, const Effects& b) {
  return a.words == b.words && std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(),
                                          [](double x, double y) { return !differs(x, y); });
}

/// The effects of the inputs in the record.
Effects effects_of(Evaluation& evaluation) {
  const Calculator& calculator = evaluation.calculator();
  const void* const input = evaluation.record().data.get();
  Effects effects;
  evaluation.evaluate_record();
  add_effects(calculator.result->fields, evaluation.result().data.get(), effects);
  for (std::size_t k = 0; k < calculator.modes.size(); ++k)
    effects.numbers.push_back(static_cast<double>(calculator.applies(k, input)));
  for (std::size_t rule = 0; rule < calculator.rules.size(); ++rule)
    effects.numbers.push_back(evaluation.holds(rule) ? 1.0 : 0.0);
  return effects;
}

bool keeps_rules(const Evaluation& evaluation) {
  const auto& rules = evaluation.calculator().rules;
  for (std::size_t rule = 0; rule < rules.size(); ++rule) {
    if (!rules[rule].only_warns && !evaluation.holds(rule)) return false;
  }
  return true;
}

/// A position at which inputs are tried, with the effects of the inputs as given, found once for all of them.
struct Probe {
  std::size_t position;
  std::optional<Effects> given = std::nullopt;
};

/// Whether another value of the leaf changes anything at the position; also where it may have no other.
bool has_effect(Evaluation& evaluation, const Leaf& leaf, Probe& probe) {
  if (!evaluation.set_position(probe.position)) return false;
  if (!probe.given) probe.given = effects_of(evaluation);
  const Effects& before = *probe.given;
  const double given = leaf.get();
  bool tried = false, moved = false;
  for (const double value : others(*leaf.field, given)) {
    if (moved || !may_be(*leaf.field, value)) continue;
    leaf.set(value);
    if (!keeps_rules(evaluation)) continue;
    tried = true;
    moved = !equal(before, effects_of(evaluation));
  }
  leaf.set(given);
  return moved || !tried;
}

/// Gives a value, as long as it lives, to loads that are zero while another load of their dimension is not: F_a of a
/// bearing under F_r only, without which its f_0 has no effect.
class WithAbsentLoads {
 public:
  explicit WithAbsentLoads(const Record& record) {
    std::vector<Leaf> absent;
    std::vector<std::pair<Dimension, double>> present;
    for_each_leaf(record, [&](const std::string& path, const Leaf& leaf) {
      const FieldInfo& field = *leaf.field;
      if (!field.is_load || field.get == nullptr || path.find('[') != std::string::npos) return;
      if (const double load = std::abs(leaf.get()); load > 0.0)
        present.emplace_back(field.dimension, load);
      else
        absent.push_back(leaf);
    });
    for (const Leaf& leaf : absent) {
      const auto like = std::find_if(present.begin(), present.end(),
                                     [&](const auto& one) { return one.first == leaf.field->dimension; });
      if (like == present.end()) continue;
      given_.emplace_back(leaf, leaf.get());
      leaf.set(0.5 * like->second);
    }
  }
  WithAbsentLoads(const WithAbsentLoads&) = delete;
  WithAbsentLoads& operator=(const WithAbsentLoads&) = delete;
  ~WithAbsentLoads() {
    for (const auto& [leaf, load] : given_) leaf.set(load);
  }
  [[nodiscard]] bool has_any() const { return !given_.empty(); }

 private:
  std::vector<std::pair<Leaf, double>> given_;
};

/// Whether the input has an effect under loads that are absent here: the datum of a part is then no mistake.
bool has_effect_with_absent_loads(Evaluation& evaluation, const Leaf& leaf, std::size_t position) {
  if (!evaluation.set_position(position)) return false;
  const WithAbsentLoads loaded(evaluation.record());
  if (!loaded.has_any() || !keeps_rules(evaluation)) return false;
  const Effects before = effects_of(evaluation);
  const double given = leaf.get();
  bool moved = false;
  for (const double value : others(*leaf.field, given)) {
    if (moved || !may_be(*leaf.field, value)) continue;
    leaf.set(value);
    moved = keeps_rules(evaluation) && !equal(before, effects_of(evaluation));
  }
  leaf.set(given);
  return moved;
}

/// Every so many positions of an axis, which together have its time.
Axis thinned_axis(const Axis& axis, std::size_t step) {
  Axis thinned = axis;
  thinned.at = {};
  thinned.share.clear();
  for (std::size_t i = 0; i < axis.at.size(); i += step) {
    thinned.at.add(axis.at[i]);
    if (axis.share.empty()) continue;
    const auto first = axis.share.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t covered = std::min(step, axis.share.size() - i);
    thinned.share.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(covered), 0.0));
  }
  return thinned;
}

/// The series of a record at a few positions while it lives: an input that changes a result there has an effect, at
/// a tenth of the cost. One without an effect there may have it in between.
class ThinnedSeries {
 public:
  explicit ThinnedSeries(const Record& record) {
    for_each_leaf(record, [&](const std::string&, const Leaf& leaf) {
      if (!leaf.field->takes_whole()) return;
      const Value* const series = leaf.field->series(leaf.owner);
      if (series != nullptr && series->si.size() >= 2 * kept) whole_.push_back({leaf, *series});
    });
    for (const Whole& whole : whole_) whole.leaf.field->set_series(whole.leaf.owner, thinned(whole.series));
  }
  ThinnedSeries(const ThinnedSeries&) = delete;
  ThinnedSeries& operator=(const ThinnedSeries&) = delete;
  ~ThinnedSeries() {
    for (Whole& whole : whole_) whole.leaf.field->set_series(whole.leaf.owner, std::move(whole.series));
  }
  [[nodiscard]] bool has_any() const { return !whole_.empty(); }

 private:
  static constexpr std::size_t kept = 36;
  struct Whole {
    Leaf leaf;
    Value series;
  };

  Value thinned(const Value& series) {
    const std::size_t step = series.si.size() / kept;
    const auto [axis, is_new] = axes_.try_emplace(series.signature.axis);
    if (is_new) axis->second = thinned_axis(*series.signature.axis, step);
    Value few{series.signature, {}, series.rounding};
    few.signature.axis = &axis->second;
    few.si.reserve(kept + 1);
    for (std::size_t i = 0; i < series.si.size(); i += step) few.si.push_back(series.si[i]);
    return few;
  }

  std::vector<Whole> whole_;
  std::map<const Axis*, Axis> axes_;  // their addresses stay
};

/// The positions for trying inputs: a few of a cycle, and the governing one.
std::vector<Probe> probes(const Evaluation& evaluation, const Governing& governing) {
  const std::size_t count = evaluation.positions();
  const std::set<std::size_t> positions{governing.position, 0, count / 4, count / 2, 3 * count / 4};
  std::vector<Probe> probes;
  probes.reserve(positions.size());
  for (const std::size_t position : positions) probes.push_back({position});
  return probes;
}

/// The value of the leaf if it is not typed; NaN if it is required, or its list is inside another one.
double untyped(const RecordType& input, const std::string& path, const FieldInfo& field) {
  const Record blank(input);
  const std::string head = path.substr(0, path.find_first_of(".["));
  const FieldInfo* const top = find_field(input.fields, head);
  std::string place = path;
  if (top != nullptr && top->type == Type::list) {
    top->push(blank.data.get());
    place = head + "[1]" + path.substr(path.find_first_of(".[", head.size() + 1));
  }
  const Leaf leaf = find_leaf(blank, place);
  const bool has_default = leaf && (field.optional || field.type == Type::quantity);
  return has_default ? leaf.get() : std::numeric_limits<double>::quiet_NaN();
}

/// Whether the user could have omitted the input: neither a field nor a rule requires it.
bool is_spare(Evaluation& evaluation, const std::string& path, const Leaf& leaf) {
  const double blank = untyped(*evaluation.calculator().input, path, *leaf.field), given = leaf.get();
  const bool may_be_incomplete = leaf.field->optional && leaf.field->type == Type::quantity;
  if (std::isnan(blank) && !may_be_incomplete) return false;
  const Effects before = effects_of(evaluation);
  leaf.set(blank);  // it may activate a check, even if it does not decide it
  const bool spare = keeps_rules(evaluation) && equal(before, effects_of(evaluation));
  leaf.set(given);
  return spare;
}

/// Whether a choice says what other values mean, "ground" flanks: comparisons between steps use it.
bool decides_meaning(const Evaluation& evaluation, const std::string& path) {
  return std::ranges::any_of(evaluation.calculator().meanings,
                             [&](const Meaning& meaning) { return meaning.choice == std::string_view(path); });
}

/// Whether an active check has no value, so that the inputs that affect it are unknown.
bool lacks_checks(const Evaluation& evaluation, const Results& results) {
  return std::any_of(results.series.begin(), results.series.end(), [&](const ResultSeries& series) {
    const bool is_check = series.field->role == Role::check && is_reported(evaluation, series);
    return is_check &&
           std::all_of(series.value.si.begin(), series.value.si.end(), [](double x) { return std::isnan(x); });
  });
}

/// Whether a series is so long that trying every input would take minutes.
bool takes_long(const Record& record) {
  constexpr std::size_t long_series = 100'000;
  bool found = false;
  for_each_leaf(record, [&](const std::string&, const Leaf& leaf) {
    const Value* const series = leaf.field->takes_whole() ? leaf.field->series(leaf.owner) : nullptr;
    found = found || (series != nullptr && series->si.size() > long_series);
  });
  return found;
}

using TypedInputs = std::vector<std::pair<std::string, Leaf>>;

/// The inputs with typed values that can be tried.
TypedInputs typed_inputs(const Evaluation& evaluation) {
  const StepInput& step = evaluation.step().input();
  TypedInputs inputs;
  for (const auto& entry : step.reading.typed) {
    const std::string& path = entry.first;
    const Leaf leaf = evaluation.inputs().leaf(path);
    if (!leaf || leaf.field->get == nullptr || !std::isfinite(leaf.get())) continue;
    if (path == evaluation.inputs().size_field()) continue;  // tables are looked up with the size
    if (!is_of_record(step.reading, path)) inputs.emplace_back(path, leaf);
  }
  return inputs;
}

/// The inputs without an effect on a few positions of the series; all if there are no series.
TypedInputs without_effect(Evaluation& evaluation, TypedInputs inputs, const Governing& governing) {
  if (!evaluation.set_position(governing.position)) return inputs;
  const ThinnedSeries thinned(evaluation.record());
  if (!thinned.has_any() || !keeps_rules(evaluation)) return inputs;
  Probe probe{governing.position};
  std::erase_if(inputs, [&](const auto& input) { return has_effect(evaluation, input.second, probe); });
  return inputs;
}

}  // namespace

void warn_of_unused(Evaluation& evaluation, const Results& results, const Governing& governing,
                    std::vector<Issue>& issues) {
  if (!governing.is_evaluated || lacks_checks(evaluation, results) || takes_long(evaluation.record())) return;
  const StepInput& step = evaluation.step().input();
  std::vector<Probe> places = probes(evaluation, governing);
  for (const auto& [path, leaf] : without_effect(evaluation, typed_inputs(evaluation), governing)) {
    const auto counts = [&evaluation, &input = leaf](Probe& probe) { return has_effect(evaluation, input, probe); };
    if (std::any_of(places.begin(), places.end(), counts) || !is_spare(evaluation, path, leaf)) continue;
    if (decides_meaning(evaluation, path) || reason_for(step, path) != nullptr) continue;
    if (has_effect_with_absent_loads(evaluation, leaf, governing.position)) continue;
    Issue issue = issue_at(step, path, say("'{1}' has no effect here: no result changes with it", path));
    issue.severity = Severity::warning;
    issues.push_back(std::move(issue));
  }
  evaluation.set_position(governing.position);
  evaluation.evaluate_record();  // restored
}

}  // namespace loadpath::project
