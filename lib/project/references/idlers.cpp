#include "lib/project/references/idlers.hpp"

#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace loadpath::project {

namespace {

/// The choice `idler` of a gear pair, next to the numbers of teeth of two gears.
const FieldInfo* idler_of(const Step& step) {
  const auto& fields = step.input().calculator->input->fields;
  const bool has_teeth = find_field(fields, "z_1") != nullptr && find_field(fields, "z_2") != nullptr;
  const FieldInfo* const idler = has_teeth ? find_field(fields, "idler") : nullptr;
  return idler != nullptr && idler->type == FieldInfo::Type::choice ? idler : nullptr;
}

/// The idlers of a pair, and the name of the other pair or the planetary gear.
struct Found {
  bool first = false, second = false;
  std::string other;
};

void set(Step& step, const Found& found, std::vector<Issue>& issues) {
  const std::string word = found.first && found.second ? "both" : found.first ? "gear_1" : "gear_2";
  const Leaf leaf = find_leaf(step.input().reading.record, "idler");
  const auto& words = idler_of(step)->choices;
  const auto is_word = [&](const auto& choice) { return word == choice.key; };
  const auto number = std::find_if(words.begin(), words.end(), is_word) - words.begin();
  const bool typed = step.input().reading.typed.contains("idler");
  if (typed && leaf.get() != static_cast<double>(number))
    return issues.push_back(issue_at(
        step.input(), "idler", say("a gear of this pair also belongs to '{1}': reversed tooth bending", found.other),
        say("write idler = \"{1}\", or leave it out", word)));
  leaf.set(static_cast<double>(number));
  step.remark(say("idler = {1}: that gear also belongs to '{2}'", word, found.other));
}

/// A number as far as it is known before the project is solved; NaN if it is not.
double number_of(const Step& step, const std::string& key) {
  const Reading& reading = step.input().reading;
  for (const Operand& operand : reading.operands) {
    if (operand.path == key) return operand.early;
  }
  const Leaf leaf = find_leaf(reading.record, key);
  return leaf ? leaf.get() : std::nan("");
}

/// Whether the first gear of a pair may be the second of another: as many teeth of the same module.
bool may_be_one_gear(const Step& step, const Step& other) {
  return number_of(step, "z_1") == number_of(other, "z_2") && number_of(step, "m_n") == number_of(other, "m_n");
}

/// The pair whose second shaft drives the first gear of this one: the source of its speed, torque or load.
const Step* driver_of(const Step& step, const Project& project) {
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "n_1" && operand.path != "T_1") continue;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, key] = split_step(reference.path);
      const Step* const source = project.find(name);
      const bool is_second = key == "n_2" || key == "T_2";
      if (is_second && source != nullptr && source != &step && idler_of(*source) != nullptr) return source;
    }
  }
  return nullptr;
}

}  // namespace

void ask_for_idlers(const Project& project, std::vector<Issue>& issues) {
  for (const auto& step : project.steps) {
    const bool is_told = idler_of(*step) == nullptr || step->input().reading.typed.contains("idler");
    const Step* const other = is_told ? nullptr : driver_of(*step, project);
    if (other == nullptr || !may_be_one_gear(*step, *other)) continue;
    const bool is_referred = find_leaf(step->input().reading.record, "idler").get() != 0.0;  // set by find_idlers
    if (is_referred) continue;
    issues.push_back(
        issue_at(step->input(), "z_1",
                 say("gear 1 turns with gear 2 of '{1}' and has the same module and number of teeth", other->name()),
                 say("if it is the same gear, write z_1 = \"={1}.z_2\" (reversed tooth bending); if both are on one "
                     "shaft, write idler = \"none\"",
                     other->name())));
  }
}

void find_idlers(Project& project, std::vector<Issue>& issues) {
  std::map<Step*, Found> all;
  for (const auto& step : project.steps) {
    if (idler_of(*step) == nullptr) continue;
    for (const Operand& operand : step->input().reading.operands) {
      const bool is_first = operand.path == "z_1";
      if ((!is_first && operand.path != "z_2") || !operand.expression.is_reference()) continue;
      const auto [name, key] = split_step(operand.expression.references().front().path);
      if (key == "z_p") {  // a planet meshes with the sun and with the ring
        (is_first ? all[step.get()].first : all[step.get()].second) = true;
        all[step.get()].other = name;
        continue;
      }
      if (!is_first) continue;
      const auto first = std::find_if(project.steps.begin(), project.steps.end(),
                                      [&, wanted = name](const auto& s) { return s->name() == wanted; });
      if (key != "z_2" || first == project.steps.end() || *first == step || idler_of(**first) == nullptr) continue;
      all[step.get()].first = true;
      all[step.get()].other = (*first)->name();
      all[first->get()].second = true;
      all[first->get()].other = step->name();
    }
  }
  for (const auto& step : project.steps) {  // in the order of the file
    if (const auto found = all.find(step.get()); found != all.end()) set(*step, found->second, issues);
  }
}

}  // namespace loadpath::project
