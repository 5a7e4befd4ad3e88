#include "lib/project/references/notches.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/modes.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace loadpath::project {

namespace {

/// Lowest notch sensitivity (cast iron); agreement of shape factors from charts and formulas.
constexpr double least_sensitivity = 0.2, agreement = 0.9;

/// A factor of a step by its full path; NaN if there is none.
struct Factor {
  std::string path;
  double value = std::nan("");
};

double value_at(const Project& project, const std::string& path) {
  const Value* const value = project.value(path);
  return value == nullptr || value->si.empty() ? std::nan("") : value->si.front();
}

/// The notch claim of a field; null if there is none.
const NotchClaim* claim_of(const Step& step, const std::string& path) {
  for (const NotchClaim& claim : step.input().calculator->notches) {
    const auto fields = listed_keys(claim.fields);
    if (std::find(fields.begin(), fields.end(), path) != fields.end()) return &claim;
  }
  return nullptr;
}

bool is_stress(const Operand& operand) { return operand.leaf.field->dimension == Dimension::of(-1, 1, -2); }

/// The largest K_t of the notches whose nominal stresses load the step, directly or through other steps.
Factor notch_of_loads(const Step& step, const Project& project, std::set<const Step*>& seen) {
  Factor most;
  if (!seen.insert(&step).second) return most;
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load || !is_stress(operand)) continue;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project.find(name);
      if (source == nullptr) continue;
      const NotchClaim* const claim = claim_of(*source, rest);
      const std::string path = claim == nullptr ? "" : std::string(name).append(".").append(claim->factor);
      const Factor found =
          claim == nullptr ? notch_of_loads(*source, project, seen) : Factor{path, value_at(project, path)};
      if (!(found.value <= most.value) && !std::isnan(found.value)) most = found;
    }
  }
  return most;
}

/// Whether the calculator declares the field as the fatigue limit of a part.
bool is_limit(const Calculator& calculator, const std::string& path) {
  return std::any_of(calculator.meanings.begin(), calculator.meanings.end(), [&](const Meaning& meaning) {
    const std::string_view what = meaning.what;
    const auto fields = listed_keys(meaning.fields);
    return (what == limit_in_normal || what == limit_in_shear) &&
           std::find(fields.begin(), fields.end(), path) != fields.end();
  });
}

/// Whether a fatigue limit includes less than the smallest effect of such a notch.
bool misses(const Project& project, const std::string& step, const NotchClaim& claim, double K_t) {
  const double K_f = value_at(project, step + "." + claim.factor), shape = value_at(project, step + "." + claim.shape);
  return !(K_f >= 1.0 + least_sensitivity * (K_t - 1.0)) || (shape > 1.0 && shape < agreement * K_t);
}

/// notch = smooth although values come from a key, press fit or pin of the same shaft.
std::optional<ReducedLoad> smooth_despite_notch(const Step& step, const Project& project) {
  const Leaf notch = find_leaf(step.input().reading.record, "notch");
  if (!notch || notch.field->type != FieldInfo::Type::choice || word_of(notch) != "smooth") return std::nullopt;
  for (const Operand& operand : step.input().reading.operands) {
    for (const auto& reference : operand.expression.references()) {
      const Step* const source = project.find(split_step(reference.path).first);
      if (!makes_notch(source) || source == &step) continue;
      return ReducedLoad{operand.path, say("notch = smooth, but {1} is '{2}' and '{3}' makes a notch in the shaft: "
                                           "give that notch, or because.{1} = \"...\"",
                                           operand.path, reference.path, source->name())};
    }
  }
  return std::nullopt;
}

}  // namespace

bool makes_notch(const Step* step) {
  if (step == nullptr || step->input().calculator->result == nullptr) return false;
  const FieldInfo* const notch = find_field(step->input().calculator->result->fields, "notch");
  return notch != nullptr && notch->is_handed_over;
}

std::vector<ReducedLoad> missed_notches(const Step& step, const Project& project) {
  std::vector<ReducedLoad> missed;
  if (auto smooth = smooth_despite_notch(step, project)) missed.push_back(std::move(*smooth));
  std::set<const Step*> seen;
  const Factor notch = notch_of_loads(step, project, seen);
  if (std::isnan(notch.value)) return missed;
  for (const Operand& operand : step.input().reading.operands) {
    if (!is_limit(*step.input().calculator, operand.path)) continue;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project.find(name);
      const NotchClaim* const claim = source == nullptr ? nullptr : claim_of(*source, rest);
      if (claim == nullptr || !misses(project, std::string(name), *claim, notch.value)) continue;
      missed.push_back(
          {operand.path, say("{1} is '{2}' with {3} = {4}, but the nominal stress acts at a notch with '{5}' = "
                             "{6}; give '{7}' the K_t of that notch, or because.{1} = \"...\"",
                             operand.path, reference.path, claim->factor,
                             format_number(value_at(project, std::string(name) + "." + claim->factor), 3), notch.path,
                             format_number(notch.value, 3), name)});
    }
  }
  return missed;
}

}  // namespace loadpath::project
