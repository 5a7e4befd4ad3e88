#include "lib/project/run/evaluation/rule_help.hpp"

#include "lib/calculator/choice_words.hpp"
#include "lib/table/tables.hpp"

#include <cmath>
#include <cstddef>

namespace loadpath::project {

namespace {

/// The values of the choice that a rule of the form "give ..." is about, or the row that gives one.
Message values_to_give(const RuleInfo& rule, const Record& record) {
  const auto fields = listed_keys(rule.fields);
  const Leaf first = fields.empty() ? Leaf{} : find_leaf(record, fields.front());
  if (!std::string_view(rule.text).starts_with("give ") || !first || first.field->type != FieldInfo::Type::choice ||
      std::isnan(first.get()) || !states_nothing(first.field->choices[static_cast<std::size_t>(first.get())]))
    return {};
  std::string all;
  for (const ChoiceInfo& choice : first.field->choices) {
    if (!states_nothing(choice)) all += (all.empty() ? "\"" : ", \"") + std::string(choice.key) + "\"";
  }
  const Provider& from = first.field->provider;
  return from.kind == Provider::Kind::table
             ? say("{1} = {2}; or {3} = \"NAME\", rows: `loadpath tables`", first.field->key, all, from.table)
             : say("{1} = {2}", first.field->key, all);
}

/// A missing input that the row of the step does not have either: the row is named, and the rule is the remedy.
void name_row_without(const StepInput& input, const Record& record, FieldFault& fault) {
  const Leaf missing = find_leaf(record, fault.path);
  if (!missing || !missing.field->is_number() || !std::isnan(missing.get())) return;
  const Provider& from = missing.field->provider;
  const auto named = input.rows.find(from.table);
  if (from.kind != Provider::Kind::table || named == input.rows.end() || named->second.text.empty()) return;
  const auto row = input.tables->find_row(from.table, named->second.text);
  if (!row || table::covered_size(*row, from.column) > 0.0) return;
  fault.hint = fault.hint.empty() ? fault.message : say("{1}; {2}", fault.message, fault.hint);
  fault.message = say("the {1} '{2}' has no {3} {4}", from.table, named->second.text, noun_of(missing.field->doc),
                      missing.field->key);
}

}  // namespace

std::string noun_of(std::string_view doc) { return std::string(doc.substr(0, doc.find_first_of(",;:"))); }

void add_help(const StepInput& input, const RuleInfo& rule, const Record& record, FieldFault& fault) {
  name_row_without(input, record, fault);
  if (fault.hint.empty()) fault.hint = values_to_give(rule, record);
}

}  // namespace loadpath::project
