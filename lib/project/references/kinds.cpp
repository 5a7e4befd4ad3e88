#include "lib/project/references/kinds.hpp"

#include "lib/project/references/references.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace loadpath::project {

namespace {

constexpr Dimension turning = Dimension::of(0, 0, -1, 0, 1);

/// The word of a choice, as far as it is known before the step is solved; absent if it is a result.
std::optional<std::string> word_now(const Step& step, const Project& project, const std::string& choice) {
  for (const Taken& taken : step.input().reading.taken) {
    if (taken.path != choice) continue;
    const auto [name, rest] = split_step(taken.source);
    const Step* const source = project.find(name);
    if (source == nullptr || source == &step) return "";
    return word_now(*source, project, rest);
  }
  const Leaf leaf = find_leaf(step.input().reading.record, choice);
  if (!leaf) return std::nullopt;
  const double at = leaf.field->type == FieldInfo::Type::choice ? leaf.get() : -1.0;
  return at >= 0.0 ? leaf.field->choices[static_cast<std::size_t>(at)].key : "";
}

/// The kind of stress of a step, or a record of it: "normal", "shear"; empty if no choice defines it, absent if it is
/// not known yet.
std::optional<std::string> stress_of(const Step& step, const Project& project, const std::string& path) {
  for (const std::string& prefix : {path.substr(0, path.rfind('.') + 1), std::string()}) {
    const std::string choice = prefix + "stress";
    const FieldInfo* const field = step.field(choice);
    if (field == nullptr || field->type != FieldInfo::Type::choice) continue;
    const std::string word = step.word(choice);  // known for a result once the step is solved
    return word.empty() ? word_now(step, project, choice) : word;
  }
  return "";
}

/// The kind of a field of a step. If a choice defines the kind of stress of the step, that applies to its stresses
/// without a name of their own.
Meant kind_of(const Step& step, const Project& project, const std::string& path, const FieldInfo& field) {
  const Meant kind = kind_of_field({field.key, field.doc, field.unit, field.dimension, field.kind});
  if (kind != Meant::normal_stress) return kind;
  const std::optional<std::string> stress = stress_of(step, project, path);
  if (!stress) return Meant::nothing;
  return *stress == "shear" ? Meant::shear_stress : kind;
}

Meant kind_at(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  if (name == "tables") {
    const auto row = project.tables->value_at(path);
    return row && row->dimension == Dimension::of(-1, 1, -2) ? Meant::strength : Meant::nothing;
  }
  const Step* const step = project.find(name);
  if (step == nullptr) return project.values.kind(rest);
  const FieldInfo* const field = step->field(rest);
  return field == nullptr ? Meant::nothing : kind_of(*step, project, rest, *field);
}

struct WrongKind {
  Message message, hint;
};

/// The meaning of a value with another angle, and its conversion to the required one.
WrongKind wrong_angle(const Operand& operand, const Dimension& given) {
  const Dimension& wanted = operand.leaf.field->dimension;
  Message message = say("'{1}' takes a value of {2}, but this expression is one of {3}", operand.path, name_of(wanted),
                        name_of(given));
  if (wanted == turning)
    return {std::move(message),
            say("write rpm, rev/s or rad/s; rev*f for turns per time, 1 rad*x for radians per time")};
  if (wanted == Dimension::of(0, 0, 1)) return {std::move(message), say("multiply the number of turns by rev")};
  return {std::move(message), say("divide by rev to count turns, by 1 rad for an arc over its radius")};
}

WrongKind wrong_kind(const Operand& operand, Meant wanted, Meant given) {
  Message message = say("'{1}' is {2}, but this expression is {3}", operand.path, name_of(wanted), name_of(given));
  const bool is_part = given == Meant::shear_stress || given == Meant::equivalent_stress;
  if (is_part && wanted != Meant::strength) return {std::move(message), say("write mises(sigma, tau)")};
  if (given == Meant::work)
    return {std::move(message), say("a power over a frequency is the energy of one cycle: divide by a speed in rpm or "
                                    "rad/s, or by rev*f; an energy by its angle")};
  return {std::move(message), {}};
}

}  // namespace

void check_kinds(const Step& step, const Project& project, const Declared& declared, std::vector<Issue>& issues) {
  const auto of = [&](const std::string& path) { return kind_at(project, path); };
  const auto check = [&](const Operand& operand) {
    if (operand.of_record) return;  // its words come from the same record
    const FieldInfo& field = *operand.leaf.field;
    const auto refuse = [&](std::size_t at, std::size_t length, Message message, Message hint) {
      issues.push_back({place_in(operand.place, operand.text, at, length), step.name() + "." + operand.path,
                        std::move(message), std::move(hint), Severity::error});
    };
    const auto signature = operand.expression.check(declared);
    if (!signature || signature->dimension.without_angle() != field.dimension.without_angle()) return;  // reported
    const auto given = operand.expression.kind(of, declared);
    if (!given) return refuse(given.fault().at, given.fault().length, given.fault().message, given.fault().hint);
    const bool turns = operand.expression.holds_pi();
    if (!fits_but_for_angle(field.dimension, signature->dimension, *given, turns)) {
      auto [message, hint] = wrong_angle(operand, signature->dimension);
      return refuse(0, operand.text.size(), std::move(message), std::move(hint));
    }
    const Meant wanted = kind_of(step, project, operand.path, field);
    if (takes_kind(wanted, *given) || signature->dimension != field.dimension) return;
    auto [message, hint] = wrong_kind(operand, wanted, *given);
    refuse(0, operand.text.size(), std::move(message), std::move(hint));
  };
  std::for_each(step.input().reading.operands.begin(), step.input().reading.operands.end(), check);
  std::for_each(step.input().reading.whole.begin(), step.input().reading.whole.end(), check);
}

}  // namespace loadpath::project
