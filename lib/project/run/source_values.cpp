#include "lib/project/run/source_values.hpp"

#include "lib/project/project.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace loadpath::project {

namespace {

/// The key of a source with the largest value among these, of the dimension of the field; empty if it has none.
std::string largest_in(const Source& source, const std::vector<std::string>& keys, const FieldInfo& field,
                       const Known& known) {
  std::string largest;
  for (const std::string& key : keys) {
    std::string path = path_in(source, key);
    if (path.empty()) continue;
    const Value& value = known(path);
    const double si = std::abs(largest_magnitude(value));
    // Zero means not given: teeth of a stage that is given by its ratio.
    if (std::isnan(si) || si == 0.0 || value.signature.dimension != field.dimension) continue;
    if (largest.empty() || si > std::abs(largest_magnitude(known(largest)))) largest = std::move(path);
  }
  return largest;
}

/// Whether a value is that of another element of the source, if no reference names one: the second stage of a train
/// whose power is the same at every shaft.
bool is_of_another_place(const Source& source, const std::vector<std::string>& keys, const FieldInfo& field,
                         const Known& known, double value) {
  constexpr double rounding = 0.01;
  if (!source.is_assumed) return false;
  const std::vector<Source> places = alternatives(source);
  return std::any_of(places.begin() + 1, places.end(), [&](const Source& place) {
    const std::string path = largest_in(place, keys, field, known);
    return !path.empty() && std::abs(std::abs(largest_magnitude(known(path))) - value) <= rounding * value;
  });
}

/// The value that an input is compared with: where a speed that varies is the least for an input, its mean, which wear
/// and heating follow.
Value compared_value(const FieldInfo& field, Comparison comparison, const Value& value) {
  const bool is_speed = field.dimension == Dimension::of(0, 0, -1, 0, 1);
  if (comparison != Comparison::at_least || !is_speed || !value.is_series()) return value;
  Value magnitude = value;
  for (double& si : magnitude.si) si = std::abs(si);
  const double over_time = mean(magnitude);
  return std::isnan(over_time) ? value : Value{{field.dimension, nullptr}, {over_time}, value.rounding};
}

FieldRole role_of_comparison(Comparison comparison) {
  switch (comparison) {
    case Comparison::same:
      return FieldRole::identity;
    case Comparison::near:
      return FieldRole::either;
    case Comparison::at_most:
      return FieldRole::capacity;
    case Comparison::at_least:
      break;
  }
  return FieldRole::demand;
}

/// Inputs that identify an element of a list, "stages[#].z_1", and how many of them agree with that of a place.
struct Agreement {
  int known = 0, equal = 0;
};
Agreement agreement_with(const Source& place, const Evaluation& evaluation, const Known& known) {
  Agreement all;
  for (const FieldInfo& field : evaluation.calculator().input->fields) {
    for (const std::string& key : listed_keys(field.same_as_source)) {
      if (key.find("[#]") == std::string::npos) continue;
      const Leaf leaf = evaluation.inputs().leaf(field.key);
      const double own = std::abs(largest_magnitude(evaluation.inputs().value_of(field.key, leaf)));
      const std::string path = largest_in(place, {key}, field, known);
      if (std::isnan(own) || path.empty()) continue;
      ++all.known;
      if (std::abs(own - std::abs(largest_magnitude(known(path)))) <= 1e-3 * own) ++all.equal;
    }
  }
  return all;
}

/// The stage that the step is by its teeth or diameters, if no reference names a place, or the stage at the place that
/// its load comes from is of another kind.
Source place_by_identity(const Source& source, const Evaluation& evaluation, const Known& known) {
  constexpr int least = 2;  // one number may agree by chance
  if (source.place.empty()) return source;
  if (!source.is_assumed && agreement_with(source, evaluation, known).known > 0) return source;
  for (Source place : places_of(source)) {
    const Agreement with = agreement_with(place, evaluation, known);
    if (with.known < least || with.equal < with.known) continue;
    place.is_assumed = false;
    return place;
  }
  return source;
}

/// The load that is taken from a step; empty if none is.
std::string load_from(const Reading& reading, const std::string& step) {
  for (const Operand& operand : reading.operands) {
    for (const auto& reference : operand.expression.references()) {
      if (operand.leaf.field->is_load && split_step(reference.path).first == step) return operand.path;
    }
  }
  return {};
}

}  // namespace

void add_source_values(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all) {
  const Reading& reading = evaluation.step().input().reading;
  std::optional<std::vector<Source>> sources;
  for (const FieldInfo& field : evaluation.calculator().input->fields) {
    const auto lists = keys_in_sources(field);
    if (lists.empty() || is_of_record(reading, field.key)) continue;
    const Leaf leaf = evaluation.inputs().leaf(field.key);
    const double value = std::abs(largest_magnitude(evaluation.inputs().value_of(field.key, leaf)));
    if (std::isnan(value)) continue;
    if (!sources) {
      sources = sources_of(reading);
      for (Source& source : *sources) source = place_by_identity(source, evaluation, known);
    }
    for (const ComparedKeys& list : lists) {
      const auto keys = keys_where_given(list.keys, evaluation.record());
      for (const Source& source : *sources) {
        const std::string path = largest_in(source, keys, field, known);
        if (path.empty() || is_of_another_place(source, keys, field, known, value)) continue;
        const Value compared = compared_value(field, list.comparison, known(path));
        const bool is_mean = known(path).is_series() && !compared.is_series();
        all.push_back({field.key, leaf, compared, is_mean ? say("the mean of '{1}'", path) : say("'{1}'", path),
                       role_of_comparison(list.comparison)});
        all.back().by_size = true;  // at another point the source has another value
      }
    }
  }
}

namespace {

/// Values that the step has found, next to its sources.
class FoundValues {
 public:
  FoundValues(const Evaluation& evaluation, const Known& known)
      : step_(evaluation.step().input()), known_(known), sources_(sources_of(step_.reading)) {}

  void compare(const FieldInfo& field, double own) {
    if (std::isnan(own)) return;
    for (const ComparedKeys& list : keys_in_sources(field)) {
      for (const Source& source : sources_) {
        const std::string path = largest_in(source, listed_keys(list.keys), field, known_);
        const std::string load = load_from(step_.reading, source.step);
        if (!path.empty() && !load.empty()) compare(field, list.comparison, own, path, load);
      }
    }
  }

  std::vector<Differing> take() { return std::move(differing_); }

 private:
  void compare(const FieldInfo& field, Comparison comparison, double own, const std::string& path,
               const std::string& load) {
    constexpr double apart = 5e-3;
    const double there = largest_magnitude(known_(path)), more = std::abs(own) - std::abs(there);
    const bool may_be_more = comparison == Comparison::at_least, may_be_less = comparison == Comparison::at_most;
    if (std::abs(more) <= apart * std::abs(there) || (may_be_more && more > 0.0) || (may_be_less && more < 0.0)) return;
    differing_.push_back({load, say("{1} = {2}, and '{3}' = {4}", field.key, format_quantity(own, field.unit, 4), path,
                                    format_quantity(there, field.unit, 4))});
  }

  const StepInput& step_;
  const Known& known_;
  std::vector<Source> sources_;
  std::vector<Differing> differing_;
};

}  // namespace

std::vector<Differing> differing_results(const Evaluation& evaluation, const Results& results, const Known& known) {
  FoundValues found(evaluation, known);
  for (const ResultSeries& series : results.series) found.compare(*series.field, largest_magnitude(series.value));
  const Inputs& inputs = evaluation.inputs();
  for (const Provided& of_row : inputs.provided()) {
    const Leaf leaf = inputs.leaf(of_row.path);
    if (!leaf || !leaf.field->is_number() || is_typed(evaluation.step().input().reading, of_row.path)) continue;
    found.compare(*leaf.field, largest_magnitude(inputs.value_of(of_row.path, leaf)));
  }
  return found.take();
}

}  // namespace loadpath::project
