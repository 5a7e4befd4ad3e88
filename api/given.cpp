#include "api/given.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::api {

namespace {

using toml::Tree;
using Type = FieldInfo::Type;

[[noreturn]] void refuse_at(const std::string& name, const std::string& text, Message message, Message hint = {}) {
  refuse_errors({{{name, 1, 1, 1}, name, std::move(message), std::move(hint), Severity::error}}, {{name, text}});
  throw Error(name);
}

Tree text_tree(const std::string& name, std::string text) {
  Tree tree;
  tree.type = Tree::Type::text;
  tree.place = {name, 1, 1, 1};
  tree.text = std::move(text);
  return tree;
}

Tree number_tree(const std::string& name, double number) {
  Tree tree = text_tree(name, format_exact(number));
  tree.type = Tree::Type::number;
  tree.number = number;
  return tree;
}

/// A number as a project file would have it.
Tree literal_tree(const FieldInfo& field, const std::string& name, double number, const std::string& unit) {
  const bool plain = field.type == Type::count || (field.dimension.is_number() && (unit.empty() || unit == "-"));
  if (plain) return number_tree(name, number);
  return text_tree(name, format_exact(number) + " " + (unit.empty() ? si_text(field) : unit));
}

Tree array_tree(const std::string& name, std::vector<Tree> items) {
  Tree tree;
  tree.type = Tree::Type::array;
  tree.place = {name, 1, 1, 1};
  tree.items = std::move(items);
  return tree;
}

/// The fields of a calculator by their names; any other name is a table that rows are taken from.
class Calling {
 public:
  Calling(const loadpath::Calculator& calculator, Call& call) : calculator_(calculator), call_(call) {}

  void add(const Given& given);

 private:
  [[nodiscard]] const FieldInfo* field_of(const Given& given) const;
  Tree tree_of(const Given& given, const FieldInfo* field);
  Tree tree_of_numbers(const Given& given, const FieldInfo& field, std::span<const double> numbers);
  Tree tree_of_words(const Given& given, const FieldInfo* field, const std::vector<std::string>& words);
  Tree tree_of_inline(const Given& given, const std::string& toml);
  void set_rows(const std::string& name, std::size_t rows);
  static std::optional<ParsedUnit> unit_of(const Given& given, const FieldInfo& field);

  const loadpath::Calculator& calculator_;
  Call& call_;
};

/// Null for keys that are not fields: a row of a table, `accept`, `because`.
const FieldInfo* Calling::field_of(const Given& given) const {
  if (const FieldInfo* const field = find_field(calculator_.input->fields, given.name)) return field;
  std::vector<std::string> known = table_groups(calculator_);
  if (std::find(known.begin(), known.end(), given.name) != known.end()) return nullptr;
  for (const char* const other : {"accept", "because", "template"}) {
    if (given.name == other) return nullptr;
  }
  for (const FieldInfo& field : calculator_.input->fields) known.emplace_back(field.key);
  if (!calculator_.templates.empty()) return nullptr;  // parameters of a template
  refuse(say("'{1}' is not an input of '{2}'", given.name, calculator_.id),
         did_you_mean(given.name, known, there_is(known)));
}

void Calling::set_rows(const std::string& name, std::size_t rows) {
  if (!call_.columns.empty() && call_.rows != rows)
    refuse(say("'{1}' has {2} values, '{3}' has {4}", call_.columns.front().name, std::to_string(call_.rows), name,
               std::to_string(rows)),
           say("columns must have the same length; a single value applies to all rows"));
  call_.rows = rows;
}

std::optional<ParsedUnit> Calling::unit_of(const Given& given, const FieldInfo& field) {
  if (given.unit.empty()) return std::nullopt;
  const bool plain = field.dimension.is_number() && (given.unit == "-" || given.unit == "1");
  if (plain) return std::nullopt;
  const auto one = parse_literal("1 " + given.unit, {field.dimension, field.kind, field.unit});
  if (!one) refuse_at(given.name, "1 " + given.unit, one.fault().message, one.fault().hint);
  auto unit = read_unit(given.unit, 0);
  if (unit->dimension == field.dimension) return *unit;
  return *read_unit("rpm", 0);  // 1/min, where the literal is an angular velocity
}

/// A value that the field takes.
double stand_in_for(const FieldInfo& field, const GivenColumn& column) {
  double si = 0.0;
  for (std::size_t row = 0; row < column.numbers.size(); ++row) {
    if (column.take(row, si) && field.bounds.holds(si)) return si;
  }
  const Range& b = field.bounds;
  for (const double candidate : {field.factor, 1.0, 0.0, 0.5 * (b.low + b.high), b.low, b.high, -field.factor}) {
    if (std::isfinite(candidate) && b.holds(candidate)) return candidate;
  }
  return 0.0;
}

Tree Calling::tree_of_numbers(const Given& given, const FieldInfo& field, std::span<const double> numbers) {
  if (!field.is_number())
    refuse(say("'{1}' takes no numbers", given.name), say("`loadpath describe {1}` lists them", calculator_.id));
  set_rows(given.name, numbers.size());
  GivenColumn column{given.name, numbers, {}, unit_of(given, field), &field};
  column.stand_in = stand_in_for(field, column);
  Tree tree = array_tree(given.name, {literal_tree(field, given.name, column.stand_in, {})});
  call_.columns.push_back(std::move(column));
  return tree;
}

Tree Calling::tree_of_words(const Given& given, const FieldInfo* field, const std::vector<std::string>& words) {
  if (field != nullptr && field->type != Type::choice)
    refuse(say("'{1}' takes no column of words", given.name),
           field->is_number() ? say("give numbers and their unit, {1}", field->unit)
                              : say("`loadpath describe {1}` lists them", calculator_.id));
  set_rows(given.name, words.size());
  std::vector<std::string> known;
  std::vector<double> numbers;
  std::vector<Tree> items;
  for (const std::string& word : words) {
    const auto found = std::find(known.begin(), known.end(), word);
    numbers.push_back(static_cast<double>(found - known.begin()));
    if (found != known.end()) continue;
    known.push_back(word);
    items.push_back(text_tree(given.name, word));
  }
  GivenColumn column{given.name, {}, std::move(numbers), {}, field};
  column.is_words = true;
  call_.columns.push_back(std::move(column));
  call_.columns.back().numbers = call_.columns.back().own;
  if (items.empty()) items.push_back(text_tree(given.name, field == nullptr ? "" : field->choices.front().key));
  return array_tree(given.name, std::move(items));
}

Tree Calling::tree_of_inline(const Given& given, const std::string& toml) {
  std::vector<loadpath::Issue> issues;
  const std::string text = "value = " + toml;
  Tree tree = toml::read_toml(text, given.name, issues);
  call_.sources[given.name] = text;
  refuse_errors(issues, call_.sources);
  if (tree.entries.size() != 1) refuse_at(given.name, text, say("one value is expected"));
  return std::move(tree.entries.front().value);
}

Tree Calling::tree_of(const Given& given, const FieldInfo* field) {
  if (const auto* text = std::get_if<std::string>(&given.value)) {
    call_.sources[given.name] = *text;
    return text_tree(given.name, *text);
  }
  if (const auto* toml = std::get_if<Inline>(&given.value)) return tree_of_inline(given, toml->toml);
  if (const auto* words = std::get_if<std::vector<std::string>>(&given.value))
    return tree_of_words(given, field, *words);
  static const FieldInfo number;  // for keys other than fields, the reader reports the keys that it accepts
  const auto* const one = std::get_if<double>(&given.value);
  if (one == nullptr)
    return tree_of_numbers(given, field == nullptr ? number : *field, std::get<std::span<const double>>(given.value));
  if (!std::isfinite(*one)) refuse(say("'{1}' is not a finite number", given.name));
  Tree tree = literal_tree(field == nullptr || !field->is_number() ? number : *field, given.name, *one, given.unit);
  call_.sources[given.name] = tree.text;
  return tree;
}

void Calling::add(const Given& given) {
  Tree& step = call_.project.entries.front().value;
  if (step.find(given.name) != nullptr) refuse(say("'{1}' is given twice", given.name));
  step.entries.push_back({given.name, {given.name, 1, 1, 1}, tree_of(given, field_of(given))});
}

}  // namespace

bool GivenColumn::take(std::size_t row, double& si) const {
  const double number = numbers[row];
  if (!std::isfinite(number)) return false;
  si = unit ? unit->to_si(number) : number;
  return std::isfinite(si) && (field == nullptr || field->type != Type::count || si == std::floor(si));
}

std::string si_text(const FieldInfo& field) { return si_unit(field.dimension); }

Call read_call(const loadpath::Calculator& calculator, std::span<const Given> inputs) {
  Call call;
  const std::string_view id = calculator.id;
  call.step = std::string(id.substr(id.find('.') + 1));
  const Place place{"call", 0, 0, 1};
  Tree step;
  step.place = place;
  step.entries.push_back({"calculator", place, text_tree("call", calculator.id)});
  call.project.entries.push_back({call.step, place, std::move(step)});
  Calling calling(calculator, call);
  for (const Given& given : inputs) calling.add(given);
  return call;
}

}  // namespace loadpath::api
