#include "lib/project/run/calculator_step.hpp"

#include "lib/project/run/run.hpp"
#include "lib/table/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace loadpath::project {

namespace {

/// What a field is, from its meaning: "yield strength, with S in place of tau_adm".
std::string noun_of(std::string_view doc) { return std::string(doc.substr(0, doc.find_first_of(",;:"))); }

std::string head(std::string_view path) { return std::string(path.substr(0, path.find_first_of(".["))); }

}  // namespace

void CalculatorStep::prepare(const Declared& declared, const Companions& companions, std::vector<Issue>& issues) {
  axis_ = check_operands(input().reading, name(), input().calculator->takes_series, declared, issues);
  provided_ = find_provided(input(), companions, issues);
  leave_of_loads(rest_of_loads(companions));
  origins_ = fill_lists(input());
  find_searches(issues);
  check_rules_of_literals(issues);
}

/// Searches that were written, and inputs that are searched for where they are missing.
void CalculatorStep::find_searches(std::vector<Issue>& issues) {
  searches_ = input().reading.searches;
  void* data = input().reading.record.data.get();
  for (const FieldInfo& field : input().calculator->input->fields) {
    if (*field.searched_in != '\0' && input().reading.typed.count(field.key) == 0) {
      searches_.push_back({field.key, {&field, data}, field.searched_in, input().place});
    }
  }
  for (const Search& search : searches_) {
    if (!stock_values(search.stock).empty()) continue;
    issues.push_back({search.place, name() + "." + search.path, say("there is no stock '{1}'", search.stock),
                      did_you_mean(search.stock, stock_names()), Severity::error});
  }
  if (searches_.size() > 1 && !input().reading.searches.empty()) {
    issues.push_back({searches_[1].place, name() + "." + searches_[1].path,
                      say("one field at a time can be searched for"), say("give '{1}' a value", searches_[1].path),
                      Severity::error});
  }
}

bool CalculatorStep::names_row_for(const std::string& field) const {
  const FieldInfo* info = find_field(input().calculator->input->fields, field);
  const auto& typed = input().reading.typed;
  return info != nullptr && input().rows.count(info->provider.table) != 0 && typed.count(field) == 0 &&
         typed.count(info->provider.unless) == 0;
}

/// Whether an input is known only when the project is solved, or is wrong already.
bool CalculatorStep::is_open(const std::string& field) const {
  const auto concerns = [&](const auto& entry) { return head(entry.path) == field; };
  const auto& reading = input().reading;
  return reading.faulty.count(field) != 0 || names_row_for(field) ||
         std::any_of(reading.operands.begin(), reading.operands.end(), concerns) ||
         std::any_of(searches_.begin(), searches_.end(), concerns) ||
         std::any_of(provided_.begin(), provided_.end(), concerns);
}

void CalculatorStep::check_rules_of_literals(std::vector<Issue>& issues) {
  const Calculator& calculator = *input().calculator;
  for (std::size_t i = 0; i < calculator.rules.size(); ++i) {
    if (calculator.rules[i].only_warns) continue;  // said once, when it is solved
    const auto fields = listed_keys(calculator.rules[i].fields);
    if (std::any_of(fields.begin(), fields.end(), [&](const std::string& f) { return is_open(f); })) continue;
    const Record& record = input().reading.record;
    if (!calculator.holds(i, record.data.get())) issues.push_back(broken_rule(i, record));
  }
}

bool CalculatorStep::is_about(std::size_t rule, const std::string& path) const {
  const auto fields = listed_keys(input().calculator->rules[rule].fields);
  return std::find(fields.begin(), fields.end(), head(path)) != fields.end();
}

/// The input of a rule that a row was to fill, and the row has no such value; null where there is none.
const Provided* CalculatorStep::lacking_row(std::size_t rule, const Record& record) const {
  const auto fields = listed_keys(input().calculator->rules[rule].fields);
  for (const Provided& provided : provided_) {
    const bool concerned = std::find(fields.begin(), fields.end(), provided.path) != fields.end();
    if (concerned && !provided.row.empty() && std::isnan(find_leaf(record, provided.path).get())) return &provided;
  }
  return nullptr;
}

/// A row that has no value for an input, or none for the size of the part.
Issue CalculatorStep::lacking_value(const Provided& provided, const Record& record) const {
  const FieldInfo& field = *provided.leaf.field;
  const Provider& from = field.provider;
  const std::string instead = *from.unless == '\0' ? field.key : from.unless;
  const auto issue = [&](Message message, Message hint) {
    return Issue{place_in(input().rows.at(from.table).place, provided.row, 0, provided.row.size()),
                 name() + "." + from.table, std::move(message), std::move(hint), Severity::error};
  };
  const auto entry = table::find_row(from.table, provided.row);
  if (entry && table::covered_size(*entry, from.column) > 0.0) {
    const Leaf size = find_leaf(record, from.size);
    Lookup found = look_up(provided, size ? size.get() : table::no_size);
    if (size && std::isnan(size.get()))
      return issue(std::move(found.reason), say("give {1}, or {2}", from.size, instead));
    return issue(std::move(found.reason), say("name another, or give {1}", instead));
  }
  return issue(say("the {1} '{2}' has no {3} {4}", from.table, provided.row, noun_of(field.doc), field.key),
               *from.unless == '\0' ? say("name another, or give {1}", field.key)
                                    : say("name another, or give {1} in its place", from.unless));
}

Issue CalculatorStep::broken_rule(std::size_t rule, const Record& record) const {
  const Calculator& calculator = *input().calculator;
  if (const Provided* provided = lacking_row(rule, record)) return lacking_value(*provided, record);
  FieldFault fault = calculator.fault_of(rule, record.data.get());
  for (const std::string& field : listed_keys(calculator.rules[rule].fields)) {
    if (fault.path.empty() && input().reading.typed.count(field) != 0) fault.path = field;
  }
  Issue issue = issue_at(input(), fault.path, std::move(fault.message), std::move(fault.hint));
  if (calculator.rules[rule].only_warns) issue.severity = Severity::warning;
  return issue;
}

/// The field of a result or an input at a path; which elements a list has is known later. Null where there is none.
const FieldInfo* CalculatorStep::field_at(const std::string& path) const {
  for (const RecordType* type : {input().calculator->result, input().calculator->input}) {
    std::span<const FieldInfo> fields = type->fields;
    std::string rest = path;
    while (!rest.empty()) {
      const std::size_t end = rest.find_first_of(".[");
      const FieldInfo* field = find_field(fields, std::string_view(rest).substr(0, end));
      if (field == nullptr) break;
      rest = end == std::string::npos ? "" : rest.substr(end);
      if (rest.empty()) return field;
      if (field->is_leaf()) break;
      if (field->type == FieldInfo::Type::list) {  // an element by number or name
        const bool numbered = rest.starts_with('[');
        const int number = numbered ? std::atoi(rest.c_str() + 1) : 1;
        if (number < 1 || static_cast<std::size_t>(number) > field->capacity) break;
        if (!numbered && find_field(field->fields, "name") == nullptr) break;
        const std::size_t stop = numbered ? rest.find(']') + 1 : rest.find_first_of(".[", 1);
        rest = stop == std::string::npos || stop == 0 ? "" : rest.substr(stop);
      }
      if (!rest.starts_with('.')) break;
      rest.erase(0, 1);
      fields = field->fields;
    }
  }
  return nullptr;
}

Outcome<Signature> CalculatorStep::signature(const std::string& path) const {
  const FieldInfo* const field = field_at(path);
  const bool has_value =
      field != nullptr && (field->type == FieldInfo::Type::quantity || field->type == FieldInfo::Type::count);
  if (has_value) return Signature{field->dimension, axis_};
  return unknown_path(path);
}

Fault CalculatorStep::unknown_path(const std::string& path) const {
  std::vector<std::string> known;
  Record blank(*input().calculator->result);
  for_each_leaf(blank, [&](const std::string& leaf, const Leaf&) { known.push_back(leaf); });
  for (const FieldInfo& f : input().calculator->result->fields) {
    for (const FieldInfo& inner : f.fields) known.push_back(std::string(f.key) + "[1]." + inner.key);
  }
  return {0, path.size(), say("'{1}' has no result '{2}'", name(), path),
          did_you_mean(path, known, say("`loadpath describe {1}` lists them", input().calculator->id), name() + ".")};
}

std::vector<std::string> CalculatorStep::companions_of(const std::string& path) const {
  std::vector<std::string> all;
  const std::string beside = name() + "." + path.substr(0, path.rfind('.') + 1);  // "train.shafts[2]."
  if (const FieldInfo* const field = field_at(path)) {
    for (const std::string& key : listed_keys(field->companions)) all.push_back(beside + key);
  }
  for (const Provided& provided : provided_)
    all.insert(all.end(), provided.companions.begin(), provided.companions.end());
  return all;
}

/// What comes along with the loads that are referred to, and neither another input nor a provider takes.
std::string CalculatorStep::rest_of_loads(const Companions& companions) const {
  std::set<std::string> taken;
  for (const Operand& operand : input().reading.operands) {
    for (const auto& reference : operand.expression.references()) taken.insert(reference.path);
  }
  for (const Provided& provided : provided_) taken.insert(provided.companions.begin(), provided.companions.end());
  std::string rest;
  for (const Operand& operand : input().reading.operands) {
    for (const auto& reference : operand.expression.references()) {
      for (const std::string& path : companions(reference.path)) {
        if (taken.insert(path).second) rest += (rest.empty() ? "" : ", ") + path;
      }
    }
  }
  return rest;
}

void CalculatorStep::solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) {
  Run run(*this, known);
  if (!run.evaluate_operands(issues)) return;
  if (!run.check_rules(issues)) return;
  if (!run.search(issues)) return;
  run.evaluate();
  run.warn_of_unused(issues);
  run.fill(wanted, own_account());
}

std::unique_ptr<Step> make_calculator_step(StepInput&& input) {
  return std::make_unique<CalculatorStep>(std::move(input));
}

}  // namespace loadpath::project
