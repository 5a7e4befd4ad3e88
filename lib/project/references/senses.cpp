#include "lib/project/references/senses.hpp"

#include "lib/project/modes.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::project {

namespace {

/// Less than this part of the other sense is a ripple.
constexpr double ripple = 0.05;

/// A series that takes both signs; the smaller extreme over the larger one, signed.
std::optional<Reversal> reversal_of(const std::string& path, const Value& value) {
  if (!value.is_series() || value.si.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(value.si.begin(), value.si.end());
  if (!(*low < 0.0 && *high > 0.0)) return std::nullopt;
  const double ratio = -std::min(-*low, *high) / std::max(-*low, *high);
  if (ratio > -ripple) return std::nullopt;
  const std::string unit = readable_unit(std::max(-*low, *high), value.signature.dimension);
  return Reversal{say("'{1}', from {2} to {3}", path, format_quantity(*low, unit, 4), format_quantity(*high, unit, 4)),
                  ratio};
}

/// A magnitude does not show that its direction reverses; the step that it comes from knows.
std::optional<Reversal> reversal_of_direction(const std::string& path, const Project& project) {
  const Value* const ratio = project.value(path_of_reversal(path));
  if (ratio == nullptr || ratio->si.size() != 1 || !(ratio->si.front() <= -ripple)) return std::nullopt;
  return Reversal{
      say("the direction of '{1}', with {2} % of its maximum", path, format_number(-100.0 * ratio->si.front(), 2)),
      ratio->si.front()};
}

bool is_moment_or_force(const Dimension& dimension) {
  return dimension.twelfths[Dimension::mass] == Dimension::one &&
         dimension.twelfths[Dimension::time] <= -2 * Dimension::one;
}

/// The first load among the references of an operand that reverses, there or at its own origin.
std::optional<Reversal> reversal_of(const Operand& operand, const Project& project) {
  for (const auto& reference : operand.expression.references()) {
    const Value* const value = project.value(reference.path);
    if (value == nullptr || !is_moment_or_force(value->signature.dimension)) continue;
    if (auto own = reversal_of(reference.path, *value)) return own;
    if (auto turned = reversal_of_direction(reference.path, project)) return turned;
    const auto [name, rest] = split_step(reference.path);
    const Step* const source = project.find(name);
    const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
    if (field != nullptr && field->is_load && source->loads().reversal) return source->loads().reversal;
  }
  return std::nullopt;
}

/// Whether the field takes the series itself: it then sees both senses.
bool is_whole(const Operand& operand, const Project& project) {
  static const Value none{{}, {std::nan("")}};
  if (!operand.leaf.field->takes_whole()) return false;
  const auto value_at = [&](const std::string& path) -> const Value& {
    const Value* const value = project.value(path);
    return value == nullptr ? none : *value;
  };
  return operand.expression.evaluate(value_at).is_series();
}

bool is_of(const SenseClaim& claim, const std::string& path) {
  const auto loads = listed_keys(claim.loads);
  return std::any_of(loads.begin(), loads.end(), [&](const std::string& load) { return names_row(load, path); });
}

/// The word of a choice in a step that is not solved yet.
std::string word_in(const Step& step, const char* choice) {
  const Leaf leaf = find_leaf(step.input().reading.record, choice);
  if (!leaf || leaf.field->type != FieldInfo::Type::choice) return {};
  return word_of(leaf);
}

Issue issue_of(const Step& step, const SenseClaim& claim, const std::string& load, Message message, Message hint) {
  const bool typed = step.input().reading.typed.contains(claim.field);
  return issue_at(step.input(), typed ? claim.field : load, std::move(message), std::move(hint));
}

void compare_word(const Step& step, const SenseClaim& claim, const std::string& load, const Reversal& reversal,
                  std::vector<Issue>& issues) {
  const std::string word = word_in(step, claim.field);
  const auto words = listed_keys(claim.words);
  if (std::find(words.begin(), words.end(), word) == words.end()) return;
  issues.push_back(issue_of(step, claim, load,
                            say("{1} = \"{2}\", but {3} reverses: {4}", claim.field, word, load, reversal.text),
                            say("write {1} = \"{2}\"", claim.field, claim.instead)));
}

void compare_number(const Step& step, const SenseClaim& claim, const std::string& load, const Reversal& reversal,
                    std::vector<Issue>& issues) {
  const Leaf leaf = find_leaf(step.input().reading.record, claim.field);
  if (!leaf || std::isnan(leaf.get()) || leaf.get() <= reversal.ratio + ripple) return;
  issues.push_back(
      issue_of(step, claim, load,
               say("{1} = {2}, but {3} reverses: {4}", claim.field, format_number(leaf.get(), 4), load, reversal.text),
               say("write {1} = {2}, or take the series itself", claim.field,
                   format_number(std::floor(reversal.ratio * 1000.0) / 1000.0, 3))));
}

}  // namespace

void check_senses(Step& step, const Project& project, std::vector<Issue>& issues) {
  step.loads().reversal.reset();
  const auto& claims = step.input().calculator->senses;
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load || is_whole(operand, project)) continue;
    const auto reversal = reversal_of(operand, project);
    if (!reversal) continue;
    step.loads().reversal = reversal;
    for (const SenseClaim& claim : claims) {
      if (!is_of(claim, operand.path)) continue;
      if (*claim.words != '\0')
        compare_word(step, claim, operand.path, *reversal, issues);
      else
        compare_number(step, claim, operand.path, *reversal, issues);
    }
  }
}

}  // namespace loadpath::project
