#include "lib/project/run/neighbours.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/project.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/table/largest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>

namespace loadpath::project {

double largest_magnitude(const Value& value) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const double x : value.si) {
    if (!std::isnan(x) && !(std::abs(x) <= std::abs(most))) most = x;
  }
  return most;
}

bool is_typed(const Reading& reading, const std::string& path) {
  return reading.typed.contains(path) && !is_of_record(reading, path);
}

bool is_found(const Reading& reading, const std::string& path) {
  return std::any_of(reading.operands.begin(), reading.operands.end(), [&](const Operand& operand) {
    const Expression& expression = operand.expression;
    return operand.path == path && expression.is_reference() &&
           !expression.references().front().path.starts_with("values.");
  });
}

namespace {

/// Whether results of other steps enter the value of an input.
bool is_of_steps(const Reading& reading, const std::string& path) {
  const auto is_of_step = [](const Expression::Reference& reference) {
    return !reference.path.starts_with("values.") && !reference.path.starts_with("tables.");
  };
  return std::any_of(reading.operands.begin(), reading.operands.end(), [&](const Operand& operand) {
    const auto& references = operand.expression.references();
    return operand.path == path && std::any_of(references.begin(), references.end(), is_of_step);
  });
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The least value of a row at any size; infinite if it has none.
double least_of_row(const table::Entry& row, std::string_view column) {
  double least = std::numeric_limits<double>::infinity();
  for (const table::SizedProperty& at : table::values_by_size(row, column)) least = std::fmin(least, at.value.si);
  return least;
}

/// Whether a typed value may be above the value of a row at one size and below it at another: not if the row is
/// larger at every size.
bool depends_on_size(const table::Entry& row, std::string_view column, double part, double typed) {
  return !(typed <= part * least_of_row(row, column));
}

/// The limit itself, less rounding.
double safe_below(double limit) {
  constexpr double rounding = 1e-12;
  return std::isfinite(limit) ? limit * (1.0 - rounding) : unknown;
}

bool is_comparable(const FieldInfo& field) {
  return field.get != nullptr && !field.takes_whole() && (field.is_number() || field.type == FieldInfo::Type::choice);
}

/// The resulting size for looking up a row: an input, or a result.
double size_of_row(const Inputs& inputs, const Results& results, const FieldInfo& field) {
  double size = table::no_size;
  for (const std::string& key : listed_keys(field.provider.size)) {
    const Leaf given = inputs.leaf(key);
    if (given && !std::isnan(given.get())) return given.get();
    for (const ResultSeries& series : results.series) {
      if (series.path == key) size = largest_magnitude(series.value);
    }
  }
  return size;
}

/// The strength bound of a field, by its meaning; null if there is none.
const StrengthBound* bound_of(const Evaluation& evaluation, const std::string& path) {
  for (const Meaning& meaning : evaluation.calculator().meanings) {
    const auto keys = listed_keys(meaning.fields);
    if (std::none_of(keys.begin(), keys.end(), [&](const std::string& key) { return names_row(key, path); })) continue;
    const StrengthBound* const bound = strength_bound_of(meaning.what);
    if (bound == nullptr) continue;  // at other words the same input is something else
    if (*meaning.choice == '\0') return bound;
    const Leaf choice = evaluation.inputs().leaf(meaning.choice);
    const auto words = listed_keys(meaning.words);
    if (std::find(words.begin(), words.end(), word_of(choice)) != words.end()) return bound;
  }
  return nullptr;
}

/// Adds typed fields that a row fills as well, and those that replace one that it would fill.
void add_row_values(const Evaluation& evaluation, const Results& results, std::vector<Neighbour>& all) {
  const Inputs& inputs = evaluation.inputs();
  const StepInput& step = evaluation.step().input();
  for (const FieldInfo& field : evaluation.calculator().input->fields) {
    const Provider& from = field.provider;
    const auto named = inputs.rows().find(from.table);
    if (from.kind != Provider::Kind::table || named == inputs.rows().end() || named->second.text.empty()) continue;
    const auto row = step.tables->find_row(from.table, named->second.text);
    if (!row) continue;
    const Message source = say("the {1} '{2}'", from.table, named->second.text);
    if (field.is_leaf() && is_typed(step.reading, field.key) && gives(*row, field)) {
      const double size = size_of_row(inputs, results, field);
      double si = look_up({field.key, &field, named->second.text, {}, *row}, size).si;
      if (std::isnan(si) && std::isnan(size)) si = table::largest_value(*row, from.column);
      all.push_back(
          {field.key, inputs.leaf(field.key), {{field.dimension, nullptr}, {si}}, source, role_of_field(field)});
      const bool is_capacity = all.back().kind == FieldRole::capacity;
      const double typed = largest_magnitude(inputs.value_of(field.key, all.back().leaf));
      all.back().by_size = *from.size != '\0' && (!is_capacity || depends_on_size(*row, from.column, 1.0, typed));
      all.back().row_of = from.table;
      if (is_capacity) all.back().safe = safe_below(*from.size == '\0' ? si : least_of_row(*row, from.column));
    }
    const Leaf instead = *from.unless == '\0' ? Leaf{} : inputs.leaf(from.unless);
    if (!instead || from.unless == std::string_view(field.key) || !is_typed(step.reading, from.unless) ||
        bound_of(evaluation, from.unless) != nullptr || role_of_field(*instead.field) != FieldRole::capacity)
      continue;
    const double most = table::largest_value(*row, from.column);
    all.push_back({from.unless, instead, {{instead.field->dimension, nullptr}, {most}}, source, FieldRole::capacity});
    all.back().safe = safe_below(most);
  }
}

/// A load of a record that includes a factor which this step applies itself: without it.
void divide_by_own_factors(const Inputs& inputs, const TypedOverride& kept, Value& value) {
  for (const std::string& key : listed_keys(kept.factors)) {
    const Leaf own = inputs.leaf(key);
    const double factor = own && own.field->is_factor ? largest_magnitude(inputs.value_of(key, own)) : unknown;
    if (!(factor > 1.0)) continue;
    for (double& si : value.si) si /= factor;
  }
}

/// Typed fields that a record has as well.
void add_record_values(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all) {
  for (const TypedOverride& kept : evaluation.step().input().reading.kept) {
    const Leaf leaf = evaluation.inputs().leaf(kept.path);
    if (!leaf || !is_comparable(*leaf.field)) continue;
    Value value{{leaf.field->dimension, nullptr}, {unknown}};
    if (kept.is_word) {
      const std::string word = known.word(kept.source);
      for (std::size_t k = 0; k < leaf.field->choices.size(); ++k) {
        if (word == leaf.field->choices[k].key) value.si = {static_cast<double>(k)};
      }
    } else {
      value = known(kept.source);
    }
    divide_by_own_factors(evaluation.inputs(), kept, value);
    all.push_back({kept.path, leaf, std::move(value), say("'{1}'", kept.source),
                   kept.is_load ? FieldRole::demand : role_of_field(*leaf.field)});
    all.back().by_size = true;  // at another point the record has another value
  }
}

/// The material that the step names; empty if it names none.
std::string named_material(const Inputs& inputs) {
  const auto named = inputs.rows().find("material");
  return named == inputs.rows().end() ? "" : named->second.text;
}

/// A strength of the part: of the input, else of the material that the step names.
double strength_of_part(const Evaluation& evaluation, const char* key) {
  const Inputs& inputs = evaluation.inputs();
  for (const char* const symbol : symbols_of_strength(key)) {
    const Leaf own = inputs.leaf(symbol);
    const double si = own && own.field->is_number() ? largest_magnitude(inputs.value_of(symbol, own)) : unknown;
    if (!std::isnan(si)) return si;
  }
  const std::string material = named_material(inputs);
  if (material.empty()) return unknown;
  const auto row = evaluation.step().input().tables->find_row("material", material);
  return row ? table::largest_value(*row, key) : unknown;
}

/// The strength of the material whose row the expression of an input refers to, "=tables.materials.S355.R_e/1.5".
double strength_referred_to(const Evaluation& evaluation, const std::string& path, const char* column) {
  constexpr std::string_view materials = "tables.materials.";
  const StepInput& step = evaluation.step().input();
  for (const Operand& operand : step.reading.operands) {
    if (operand.path != path) continue;
    for (const auto& reference : operand.expression.references()) {
      if (!reference.path.starts_with(materials)) continue;
      const auto value = step.tables->value_at(prefix_of(reference.path) + column);
      if (value) return value->value.si;
    }
  }
  return unknown;
}

/// Whether at another size, or with another strength of the part, a stress may be on the other side of its bound.
bool may_change(const Evaluation& evaluation, const char* column, double part, double typed) {
  const Inputs& inputs = evaluation.inputs();
  const Leaf own = inputs.leaf(column);
  // For an unknown size, the largest value of the row is used.
  if (!own || std::isnan(largest_magnitude(inputs.value_of(column, own)))) return false;
  const auto& provided = inputs.provided();
  const auto of_material = std::find_if(provided.begin(), provided.end(), [&](const Provided& p) {
    return p.path == column && p.field->provider.table == std::string_view("material");
  });
  return of_material == provided.end() || depends_on_size(of_material->entry, column, part, typed);
}

/// The least value that a strength of the part, `now`, has at any point of a sweep; NaN if it may have any.
double least_strength(const Evaluation& evaluation, const char* column, double now) {
  const Inputs& inputs = evaluation.inputs();
  const Reading& reading = evaluation.step().input().reading;
  for (const char* const symbol : symbols_of_strength(column)) {
    const Leaf own = inputs.leaf(symbol);
    if (!own || !own.field->is_number()) continue;
    const auto is_it = [&](const auto& one) { return one.path == symbol; };
    const auto& provided = inputs.provided();
    const auto by_row = std::find_if(provided.begin(), provided.end(), is_it);
    if (by_row != provided.end() && !by_row->row.empty())
      return least_of_row(by_row->entry, by_row->field->provider.column);
    const bool varies = by_row != provided.end() || inputs.find_computed(symbol) != nullptr ||
                        std::any_of(reading.varied.begin(), reading.varied.end(), is_it);
    if (varies) return unknown;
  }
  return now;
}

/// The least factor between the strength and an allowable stress: that which is customary for the safety factor that
/// the calculator takes in its place, within rounded digits of the stress.
double margin_of(const Evaluation& evaluation) {
  constexpr double digits = 0.99;
  const FieldInfo* const S = find_field(evaluation.calculator().input->fields, "S");
  return S == nullptr ? least_margin : std::max(least_margin, digits * S->customary.low);
}

/// Typed stresses that the strength of the material bounds.
void add_strength_bounds(const Evaluation& evaluation, std::vector<Neighbour>& all) {
  const Reading& reading = evaluation.step().input().reading;
  const std::string material = named_material(evaluation.inputs());
  const Message of = material.empty() ? say("the part") : say("the material '{1}'", material);
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    const StrengthBound* const bound = is_typed(reading, path) ? bound_of(evaluation, path) : nullptr;
    if (bound == nullptr || !is_comparable(*leaf.field)) return;
    const auto strength_in = [&](const char* column) {
      const double own = strength_of_part(evaluation, column);
      return std::isnan(own) ? strength_referred_to(evaluation, path, column) : own;
    };
    const bool lacks = std::isnan(strength_in(bound->share.column));
    const StrengthBound::Share& share = lacks ? bound->otherwise : bound->share;
    const double strength = strength_in(share.column);
    if (std::isnan(strength)) return;
    all.push_back({path,
                   leaf,
                   {{leaf.field->dimension, nullptr}, {share.part * strength}},
                   say("{1} of {2}", share.text, of),
                   FieldRole::capacity});
    const double typed = largest_magnitude(evaluation.inputs().value_of(path, leaf));
    const double margin = is_allowable(bound->meaning) ? margin_of(evaluation) : 0.0;
    const double part = margin > 0.0 ? share.part / margin : share.part;
    all.back().by_size = may_change(evaluation, share.column, part, typed);
    all.back().margin = margin;
    all.back().safe = safe_below(part * least_strength(evaluation, share.column, strength));
  });
}

/// Adds values that differ from the step whose result is taken: the length of a bar whose effective length factor was
/// calculated for another one.
void add_origin_values(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all) {
  for (const Operand& operand : evaluation.step().input().reading.operands) {
    if (*operand.leaf.field->made_for == '\0' || !operand.expression.is_reference()) continue;
    const std::string source = split_step(operand.expression.references().front().path).first;
    for (const auto& [key, theirs] : inputs_made_for(*operand.leaf.field)) {
      const Leaf leaf = evaluation.inputs().leaf(key);
      const std::string path = std::string(source).append(".").append(theirs);
      if (!leaf || known(path).signature.dimension != leaf.field->dimension) continue;
      all.push_back({key, leaf, known(path), say("'{1}', the basis of {2}", path, operand.path), FieldRole::either});
      all.back().by_size = true;  // at another point the source has another value
    }
  }
}

/// Adds less favourable values in other steps of the same body.
void add_body_values(const Evaluation& evaluation, std::vector<Neighbour>& all) {
  const std::optional<BodyFacts>& facts = evaluation.step().body_facts();
  if (!facts) return;
  for (const auto& [path, fact] : *facts) {
    const Leaf leaf = evaluation.inputs().leaf(path);
    if (!leaf) continue;
    all.push_back({path,
                   leaf,
                   {{leaf.field->dimension, nullptr}, {fact.si}},
                   say("'{1}', a step of the same body", fact.by),
                   role_in_body(*leaf.field)});
    all.back().by_size = true;  // at another point the other step has another value
    all.back().is_of_body = true;
  }
}

/// Typed values outside their usual range, with the nearest usual values.
void add_usual_ranges(const Evaluation& evaluation, std::vector<Neighbour>& all) {
  const Reading& reading = evaluation.step().input().reading;
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    const FieldInfo& field = *leaf.field;
    if (field.get == nullptr || !is_empirical(field) || !is_typed(reading, path)) return;
    const Value typed = evaluation.inputs().value_of(path, leaf);
    const auto is_unusual = [&](double x) { return !std::isnan(x) && !field.plausible.holds(x); };
    if (std::none_of(typed.si.begin(), typed.si.end(), is_unusual)) return;
    Value usual = typed;
    for (double& x : usual.si) x = std::isnan(x) ? x : std::clamp(x, field.plausible.low, field.plausible.high);
    all.push_back({path, leaf, std::move(usual), say("the usual range"), FieldRole::usual});
    all.back().by_size = true;  // whether it decides depends on all other values
  });
}

/// Typed values on the favourable side of common practice, with its limits.
void add_customary_limits(const Evaluation& evaluation, std::vector<Neighbour>& all) {
  const Reading& reading = evaluation.step().input().reading;
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    const FieldInfo& field = *leaf.field;
    if (field.get == nullptr || !is_typed(reading, path)) return;
    const double typed = largest_magnitude(evaluation.inputs().value_of(path, leaf));
    if (std::isnan(typed) || field.customary.holds(typed)) return;
    const bool is_below = typed < field.customary.low;
    const double limit = is_below ? field.customary.low : field.customary.high;
    all.push_back({path,
                   leaf,
                   {{field.dimension, nullptr}, {limit}},
                   say("common practice"),
                   is_below ? FieldRole::demand : FieldRole::capacity});
    all.back().by_size = true;  // it may come from the point
  });
}

/// Typed values that the calculation of another part would give; half of it shows which checks it decides.
void add_unassessed_values(const Evaluation& evaluation, std::vector<Neighbour>& all) {
  const Reading& reading = evaluation.step().input().reading;
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    if (!leaf.field->is_of_step || !is_typed(reading, path) || is_of_steps(reading, path)) return;
    Value half = evaluation.inputs().value_of(path, leaf);
    for (double& x : half.si) x *= 0.5;
    all.push_back({path, leaf, std::move(half), say("a step"), FieldRole::capacity});
    all.back().is_unassessed = true;
  });
}

}  // namespace

std::vector<Neighbour> neighbours_of(const Evaluation& evaluation, const Results& results, const Known& known) {
  std::vector<Neighbour> all;
  add_row_values(evaluation, results, all);
  add_record_values(evaluation, known, all);
  add_strength_bounds(evaluation, all);
  add_origin_values(evaluation, known, all);
  add_body_values(evaluation, all);
  add_usual_ranges(evaluation, all);
  add_customary_limits(evaluation, all);
  add_unassessed_values(evaluation, all);
  return all;
}

}  // namespace loadpath::project
