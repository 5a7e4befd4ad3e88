#include "lib/project/run/evaluation/prepared_step.hpp"

#include "lib/project/references/paths/result_paths.hpp"
#include "lib/project/run/evaluation/rule_help.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace loadpath::project {

namespace {

/// The size for looking up a row: the first given one of those that the provider names.
double size_of(const Provider& provider, const Record& record) {
  for (const std::string& key : listed_keys(provider.size)) {
    const Leaf size = find_leaf(record, key);
    if (size && !std::isnan(size.get())) return size.get();
  }
  return table::no_size;
}

std::string head(std::string_view path) { return std::string(path.substr(0, path.find_first_of(".["))); }

/// Paths of others that the step takes.
std::set<std::string> taken_paths(const Reading& reading, const std::vector<Provided>& all) {
  std::set<std::string> taken;
  for_each_reference(reading, [&](const std::string& path) { taken.insert(path); });
  for (const Provided& provided : all) taken.insert(provided.companions.begin(), provided.companions.end());
  return taken;
}

/// Components of the referenced loads that neither another input nor a provider takes.
std::vector<LoadComponent> further_components(const Reading& reading, const std::vector<Provided>& provided,
                                              const Companions& companions) {
  std::set<std::string> taken = taken_paths(reading, provided);
  std::vector<LoadComponent> rest;
  const auto add = [&](const std::string& reference, const std::string& input) {
    for (const std::string& path : companions(reference)) {
      if (taken.insert(path).second) rest.push_back({path, input});
    }
  };
  for (const Operand& operand : reading.operands) {
    if (!operand.leaf.field->is_load) continue;  // a length has no load components
    for (const auto& reference : operand.expression.references()) add(reference.path, operand.path);
  }
  for (const Taken& list : reading.taken) {
    if (list.field != nullptr && list.field->type == FieldInfo::Type::list) add(list.source, list.path);
  }
  return rest;
}

}  // namespace

void PreparedStep::prepare(const Declared& declared, const Companions& companions, std::vector<Issue>& issues) {
  axis_ = check_operands(input().reading, name(), input().calculator->takes_series, declared, issues);
  for (const Operand& operand : input().reading.operands) {
    if (const auto signature = operand.expression.check(declared); signature && signature->axis != nullptr)
      series_.insert(operand.path);
  }
  provided_ = provided_by_rows(input(), input().rows, issues);
  for (Provided& provided : provided_by_companions(input(), companions)) provided_.push_back(std::move(provided));
  rest_ = further_components(input().reading, provided_, companions);
  origins_ = fill_lists(input(), input().rows, input().reading.record);
  find_searches(issues);
  check_rules_of_literals(issues);
}

/// Searches that were written, and inputs that are searched for where they are missing.
void PreparedStep::find_searches(std::vector<Issue>& issues) {
  searches_ = input().reading.searches;
  void* data = input().reading.record.data.get();
  for (const FieldInfo& field : input().calculator->input->fields) {
    const bool is_missing = field.sought_unasked && input().reading.typed.count(field.key) == 0;
    if (is_missing && sizes_together())
      search_each_instead(field);
    else if (is_missing)
      searches_.push_back({field.key, {&field, data}, field.searched_in, input().place});
  }
  for (const Search& search : searches_) check_stock(search, issues);
  if (searches_.size() == 1 || sizes_together()) return;
  for (const Search& search : searches_) {
    const bool in_order = !search.leaf || (!search.stock.empty() && search.path == search.leaf.field->key);
    if (in_order) continue;
    const Search& other = searches_[&search == searches_.data() ? 1 : 0];
    return issues.push_back({search.place, name() + "." + search.path,
                             say("'{1}' cannot be searched for together with '{2}'", search.path, other.path),
                             say("give one of the two a value"), Severity::error});
  }
}

/// The common size of elements that are searched for one by one: each without a size of its own is searched for, too.
void PreparedStep::search_each_instead(const FieldInfo& common) {
  const std::string list = input().calculator->sizing.list;
  const FieldInfo* const elements = find_field(input().calculator->input->fields, list);
  const FieldInfo* const own = elements == nullptr ? nullptr : find_field(elements->fields, common.key);
  if (own == nullptr || *own->searched_in == '\0') return;
  void* const data = input().reading.record.data.get();
  for (std::size_t i = 0; i < elements->size(data); ++i) {
    const Leaf leaf{own, elements->element(data, i)};
    const auto is_it = [&](const auto& entry) { return entry.leaf.field == own && entry.leaf.owner == leaf.owner; };
    const bool is_given = !std::isnan(leaf.get()) ||
                          std::any_of(input().reading.operands.begin(), input().reading.operands.end(), is_it) ||
                          std::any_of(searches_.begin(), searches_.end(), is_it);
    if (is_given) continue;
    const std::string path = list + "[" + std::to_string(i + 1) + "]." + common.key;
    searches_.push_back({path, leaf, own->searched_in, input().place});
  }
}

bool PreparedStep::sizes_together() const {
  const Calculator& calculator = *input().calculator;
  return *calculator.sizing.list != '\0' && !searches_.empty() &&
         std::all_of(searches_.begin(), searches_.end(), [&](const Search& search) {
           return search.leaf && !search.stock.empty() && head(search.path) == calculator.sizing.list;
         });
}

/// How to search for the rows with a value that is typed: bearing = { where = "d = 40 mm" }.
static Message search_by(const Search& search, const FieldInfo& field, const std::string& typed) {
  const bool is_value = field.type == FieldInfo::Type::quantity && !typed.empty() && !typed.starts_with('=');
  if (!is_value || !search.where.empty())
    return say("leave out {1}, name the {2}, or search in a table without {1}", field.key, search.path);
  const std::string stock = search.stock.empty() ? "" : "stock = \"" + search.stock + "\", ";
  return say("leave out {1} and search by it: {2} = { {3}where = \"{4} = {5}\" }", field.key, search.path, stock,
             field.provider.column, typed);
}

/// Whether there is anything to search in.
void PreparedStep::check_stock(const Search& search, std::vector<Issue>& issues) const {
  const auto refuse = [&](Message message, Message hint) {
    issues.push_back({search.place, name() + "." + search.path, std::move(message), std::move(hint), Severity::error});
  };
  if (seeks_name(search)) return;
  if (search.leaf.field == nullptr) {
    if (table::order_of(search.path).empty())
      return refuse(say("'{1}' cannot be searched for: its rows have no order", search.path),
                    say("name one; `loadpath tables` lists them"));
    const auto all = input().tables->ordered_rows(search.path, search.stock);
    if (all.empty())
      return refuse(say("unknown table or kind of {1} '{2}'", search.path, search.stock),
                    did_you_mean(search.stock, input().tables->names_of(search.path)));
    const auto selected = input().tables->ordered_rows(search.path, search.stock, search.where);
    if (!selected) return refuse(selected.fault().message, selected.fault().hint);
    const auto& rows = *selected;
    if (rows.empty())
      return refuse(say("no row of {1} has {2}", search.stock.empty() ? search.path : search.stock, search.where),
                    say("`loadpath tables` shows their values"));
    for (const FieldInfo& field : input().calculator->input->fields) {
      if (field.provider.table != search.path || input().reading.typed.count(field.key) == 0) continue;
      // A number that no row has still belongs to one row: a rating, a warping constant.
      if (field.is_number() ||
          std::any_of(rows.begin(), rows.end(), [&](const table::Entry& row) { return gives(row, field); }))
        return refuse(say("'{1}' is given, and the {2} that is searched for gives it too", field.key, search.path),
                      search_by(search, field, input().reading.typed.at(field.key).text));
    }
  } else if (!search.stock.empty() && stock_values(*input().tables, search.stock).empty()) {
    refuse(say("unknown stock '{1}'", search.stock), did_you_mean(search.stock, input().tables->series_names()));
  }
}

bool PreparedStep::seeks_name(const Search& search) const {
  const FieldInfo* const field = find_field(input().calculator->input->fields, search.path);
  return !search.leaf && field != nullptr && field->type == FieldInfo::Type::name;
}

bool PreparedStep::names_row_for(const std::string& field) const {
  const FieldInfo* info = find_field(input().calculator->input->fields, field);
  const auto& typed = input().reading.typed;
  return info != nullptr && input().rows.count(info->provider.table) != 0 && typed.count(field) == 0 &&
         typed.count(info->provider.unless) == 0;
}

/// Whether an input is known only when the project is solved, or is wrong already.
bool PreparedStep::is_open(const std::string& field) const {
  const auto concerns = [&](const auto& entry) { return head(entry.path) == field; };
  const auto& reading = input().reading;
  return reading.faulty.count(field) != 0 || names_row_for(field) ||
         std::any_of(reading.operands.begin(), reading.operands.end(), concerns) ||
         std::any_of(reading.taken.begin(), reading.taken.end(), concerns) ||
         std::any_of(reading.varied.begin(), reading.varied.end(), concerns) ||
         std::any_of(searches_.begin(), searches_.end(), concerns) ||
         std::any_of(provided_.begin(), provided_.end(), concerns);
}

bool PreparedStep::is_asked(const FieldInfo& check, const Record& record) const {
  std::string_view inputs = check.asked_by;
  if (inputs.empty()) return true;
  // Whether a row that the step names is to give the input, and must have it.
  const auto comes_from_row = [&](std::string_view input, const FieldInfo& field) {
    return names_row_for(std::string(input)) && !field.provider.may_be_incomplete;
  };
  while (!inputs.empty()) {  // called for every candidate of a search: avoids a list of keys
    const std::string_view input = inputs.substr(0, inputs.find(", "));
    const Leaf asking = find_leaf(record, input);
    if (asking && (!std::isnan(asking.get()) || comes_from_row(input, *asking.field))) return true;
    inputs.remove_prefix(std::min(input.size() + 2, inputs.size()));
  }
  return false;
}

bool PreparedStep::is_about(std::size_t rule, const std::string& path) const {
  const auto fields = listed_keys(input().calculator->rules[rule].fields);
  return std::find(fields.begin(), fields.end(), head(path)) != fields.end();
}

namespace {

/// The input of a rule that a row was to fill, and the row has no such value; null if there is none.
const Provided* row_without_value(const RuleInfo& rule, const Record& record, const std::vector<Provided>& all) {
  const auto fields = listed_keys(rule.fields);
  for (const Provided& provided : all) {
    const bool concerned = std::find(fields.begin(), fields.end(), provided.path) != fields.end();
    if (concerned && !provided.row.empty() && std::isnan(find_leaf(record, provided.path).get())) return &provided;
  }
  return nullptr;
}

/// Whether a rule would hold if rows had all the values that they were to fill.
bool holds_with_rows(const Calculator& calculator, std::size_t rule, const Record& record,
                     const std::vector<Provided>& all) {
  const Record filled = record.clone();
  for (const Provided& provided : all) {
    const Leaf leaf = find_leaf(filled, provided.path);
    if (!provided.row.empty() && std::isnan(leaf.get())) leaf.set(100.0 * provided.field->factor);
  }
  return calculator.holds(rule, filled.data.get());
}

/// A row that has no value for an input, or none for the size of the part.
Issue issue_of_missing_value(const StepInput& input, const Provided& provided, const Record& record) {
  const FieldInfo& field = *provided.field;
  const Provider& from = field.provider;
  const std::string instead = *from.unless == '\0' ? field.key : from.unless;
  const auto issue = [&](Message message, Message hint) {
    return Issue{place_in(input.rows.at(from.table).place, provided.row, 0, provided.row.size()),
                 input.name + "." + from.table, std::move(message), std::move(hint), Severity::error};
  };
  const auto entry = input.tables->find_row(from.table, provided.row);
  if (entry && table::covered_size(*entry, from.column) > 0.0) {
    const double size = size_of(from, record);
    Lookup found = look_up(provided, size);
    const bool of_input = find_field(record.type->fields, std::string_view(from.size).substr(
                                                              0, std::string_view(from.size).find(','))) != nullptr;
    if (of_input && std::isnan(size))
      return issue(std::move(found.reason), say("give {1}, or {2}", listed_keys(from.size).back(), instead));
    return issue(std::move(found.reason), say("name another, or give {1}", instead));
  }
  return issue(say("the {1} '{2}' has no {3} {4}", from.table, provided.row, noun_of(field.doc), field.key),
               *from.unless == '\0' ? say("name another, or give {1}", field.key)
                                    : say("name another, or give {1} in its place", from.unless));
}

}  // namespace

Issue PreparedStep::broken_rule(std::size_t rule, const Record& record, const std::vector<Provided>& provided) const {
  const Calculator& calculator = *input().calculator;
  const Provided* const missing = row_without_value(calculator.rules[rule], record, provided);
  if (missing != nullptr && holds_with_rows(calculator, rule, record, provided))
    return issue_of_missing_value(input(), *missing, record);
  FieldFault fault = calculator.fault_of(rule, record.data.get());
  if (!calculator.rules[rule].only_warns) add_help(input(), calculator.rules[rule], record, fault);
  for (const std::string& field : listed_keys(calculator.rules[rule].fields)) {
    if (fault.path.empty() && input().reading.typed.count(field) != 0) fault.path = field;
  }
  Issue issue = issue_at(input(), fault.path, std::move(fault.message), std::move(fault.hint));
  if (calculator.rules[rule].only_warns) issue.severity = Severity::warning;
  return issue;
}

namespace {

/// Whether a path names an element that a list of the input does not have; of one that another step or a row fills that
/// is not known yet.
bool has_no_element(const StepInput& input, const std::string& path) {
  const FieldInfo* const list = find_field(input.calculator->input->fields, head(path));
  if (list == nullptr || list->type != FieldInfo::Type::list || list->provider.kind == Provider::Kind::table)
    return false;
  const auto& taken = input.reading.taken;
  const bool later = std::any_of(taken.begin(), taken.end(), [&](const Taken& t) { return t.path == list->key; });
  return !later && !find_leaf(input.reading.record, path);
}

Fault missing_element(const StepInput& input, const std::string& path) {
  const FieldInfo& list = *find_field(input.calculator->input->fields, head(path));
  const std::size_t count = list.size(input.reading.record.data.get());
  return {0, path.size(), say("'{1}' has no element '{2}'", input.name, path),
          say("{1} has {2}, counted from 1", list.key, std::to_string(count))};
}

}  // namespace

Outcome<Signature> PreparedStep::signature(const std::string& path) const {
  const FieldInfo* const found = field(path);
  if (found == nullptr || !found->is_number()) return unknown_path(input(), path);
  const bool is_result = find_field_at(input().calculator->result->fields, path) != nullptr;
  if (!is_result && has_no_element(input(), path)) return missing_element(input(), path);
  // A size that is found and a value of a row are the same at all positions.
  const auto is_it = [&](const auto& one) { return one.path == path; };
  const bool is_found = std::any_of(searches_.begin(), searches_.end(), is_it) || names_row_for(path);
  const auto& operands = input().reading.operands;
  const bool is_operand = std::any_of(operands.begin(), operands.end(), is_it);
  const bool may_vary = is_operand ? series_.contains(path) : is_open(head(path));
  const bool varies = is_result || (may_vary && !is_found);
  return Signature{found->dimension, varies ? axis_ : nullptr, found->is_load && !found->signed_load};
}

namespace {

/// Whether other steps use more than the number: factors that it includes, its meaning.
bool is_more_than_number(const Calculator& calculator, const FieldInfo& field) {
  const auto means = [&](const Meaning& meaning) {
    const auto keys = listed_keys(meaning.fields);
    return std::find(keys.begin(), keys.end(), field.key) != keys.end();
  };
  return field.is_load || field.is_factor || std::any_of(calculator.meanings.begin(), calculator.meanings.end(), means);
}

/// The value of an expression over inputs that are known beforehand.
std::optional<Value> evaluate_beforehand(const Operand& operand, const Step::Beforehand& of) {
  std::map<std::string, Value> values;
  for (const auto& reference : operand.expression.references()) {
    auto value = of.value(reference.path);
    if (!value) return std::nullopt;
    values[reference.path] = std::move(*value);
  }
  return operand.expression.evaluate([&](const std::string& path) -> const Value& { return values.at(path); });
}

/// Whether a record or a list of another step, which the step has yet to take, may give this input.
bool may_be_filled(const Reading& reading, const std::string& path, const Step::Beforehand& of) {
  return std::any_of(reading.taken.begin(), reading.taken.end(), [&](const Taken& taken) {
    if (taken.field == nullptr || taken.field->is_word()) return false;
    if (taken.field->type == FieldInfo::Type::list) return path.starts_with(taken.path);
    const bool is_record = taken.field->type == FieldInfo::Type::record;
    const std::string base = is_record ? taken.path.substr(0, taken.path.rfind('.') + 1) : taken.path + ".";
    return path.starts_with(base) && of.may_have(taken.source + "." + path.substr(base.size()));
  });
}

}  // namespace

std::optional<Value> PreparedStep::value_beforehand(const std::string& path, bool settled, const Beforehand& of) const {
  const Calculator& calculator = *input().calculator;
  const Reading& reading = input().reading;
  const auto is_it = [&](const auto& entry) { return entry.path == path; };
  const Leaf leaf = find_leaf(reading.record, path);
  const FieldInfo* const result = find_field_at(calculator.result->fields, path);
  if ((result != nullptr && !result->is_as_given) || !leaf || !leaf.field->is_number() || leaf.field->takes_whole() ||
      is_more_than_number(calculator, *leaf.field))
    return std::nullopt;
  const bool varies = std::any_of(reading.varied.begin(), reading.varied.end(), is_it);
  if ((varies && settled) || std::any_of(reading.searches.begin(), reading.searches.end(), is_it)) return std::nullopt;
  const auto operand = std::find_if(reading.operands.begin(), reading.operands.end(), is_it);
  if (operand != reading.operands.end()) return operand->of_record ? std::nullopt : evaluate_beforehand(*operand, of);
  const bool typed = reading.typed.contains(path);
  if (!typed && (leaf.field->sought_unasked || may_be_filled(reading, path, of))) return std::nullopt;
  if (!typed && names_row_for(path)) return row_beforehand(*leaf.field, of);
  if (std::isnan(leaf.get())) return std::nullopt;
  return Value{{leaf.field->dimension, nullptr}, {leaf.get()}};
}

/// The value of a named row: at a size that is known too, or at none.
std::optional<Value> PreparedStep::row_beforehand(const FieldInfo& field, const Beforehand& of) const {
  const Provider& from = field.provider;
  const std::string& row = input().rows.at(from.table).text;
  const auto entry = row.empty() ? Outcome<table::Entry>(Fault{}) : input().tables->find_row(from.table, row);
  if (!entry) return std::nullopt;
  double size = table::no_size;
  for (const std::string& key : listed_keys(from.size)) {
    const auto given = value_beforehand(key, true, of);
    if (!given && (input().reading.typed.contains(key) || key == listed_keys(from.size).back())) return std::nullopt;
    if (!given) continue;
    size = given->si[0];
    break;
  }
  const double si = look_up({field.key, &field, row, {}, *entry}, size).si;
  return std::isnan(si) ? std::nullopt : std::optional(Value{{field.dimension, nullptr}, {si}});
}

std::vector<std::string> PreparedStep::companions_of(const std::string& path) const {
  std::vector<std::string> all;
  const std::string prefix = name() + "." + path.substr(0, path.rfind('.') + 1);  // "train.shafts[2]."
  if (const FieldInfo* const found = field(path)) {
    for (const std::string& key : listed_keys(found->companions)) all.push_back(prefix + key);
  }
  for (const Provided& provided : provided_)
    all.insert(all.end(), provided.companions.begin(), provided.companions.end());
  return all;
}

}  // namespace loadpath::project
