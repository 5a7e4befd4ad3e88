#include "lib/project/references/idlers.hpp"

#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace loadpath::project {

namespace {

/// A choice `idler` beside the numbers of teeth of two gears: of a pair.
const FieldInfo* idler_of(const Step& step) {
  const auto& fields = step.input().calculator->input->fields;
  const bool has_teeth = find_field(fields, "z_1") != nullptr && find_field(fields, "z_2") != nullptr;
  const FieldInfo* const idler = has_teeth ? find_field(fields, "idler") : nullptr;
  return idler != nullptr && idler->type == FieldInfo::Type::choice ? idler : nullptr;
}

/// Which gears of a pair are idlers, and what the other pair is called.
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
        step.input(), "idler", say("a gear of this pair is one of '{1}' too: its teeth bend both ways", found.other),
        say("write idler = \"{1}\", or leave it out", word)));
  leaf.set(static_cast<double>(number));
  step.remark(say("idler = {1}: that gear is one of '{2}' too", word, found.other));
}

}  // namespace

void find_idlers(Project& project, std::vector<Issue>& issues) {
  std::map<Step*, Found> all;
  for (const auto& step : project.steps) {
    if (idler_of(*step) == nullptr) continue;
    for (const Operand& operand : step->input().reading.operands) {
      if (operand.path != "z_1" || !operand.expression.is_reference()) continue;
      const auto [name, key] = split_step(operand.expression.references().front().path);
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
