#include "cli/lsp/hover.hpp"

#include "calculators/catalogue.hpp"
#include "cli/fields/words.hpp"
#include "cli/lsp/target.hpp"
#include "cli/lsp/words.hpp"
#include "lib/project/parts/heading.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>

namespace loadpath::cli::lsp {

namespace {

using Type = FieldInfo::Type;

std::string calculator_text(const Calculator& calculator) {
  return "**" + std::string(calculator.id) + "**: " + calculator.title + "\n\n" + calculator.scope;
}

/// "unit mm; must be > 0 mm; required"
std::string facts_of(const FieldInfo& field, void* owner) {
  std::string all = field.type == Type::quantity && std::string_view(field.unit) == "-" ? "number" : type_of(field);
  const auto add = [&](const std::string& fact) { all += fact.empty() ? "" : "; " + fact; };
  if (field.is_number()) add(bounds_of(field));
  if (field.type == Type::record || field.type == Type::group || field.type == Type::list)
    add(field.optional || field.type == Type::record ? "optional" : "required");
  else
    add(default_of(field, owner));
  return all + searched_of(field);
}

std::string field_text(const Target& target) {
  const FieldInfo& field = *target.field;
  std::string text = "**" + std::string(field.key) + "**: " + field.doc + "\n\n" + facts_of(field, target.owner);
  if (field.type == Type::choice) {
    for (const ChoiceInfo& c : field.choices) {
      if (*c.key != '\0' && *c.doc != '\0') text += "\n- `" + std::string(c.key) + "`: " + c.doc;
    }
  }
  return text;
}

/// The text for a key of a step other than a field.
std::string key_text(const Target& target, const std::string& key) {
  for (const StepKey& known : general_keys(*target.calculator)) {
    if (known.key == key) return "**" + key + "**: " + known.meaning;
  }
  return {};
}

std::string mode_text(const Target& target, const std::string& id) {
  for (const ModeInfo& mode : target.calculator->modes) {
    if (mode.id == id) return "**" + id + "**: " + mode.title + "\n\nthe text is the reason for accepting it";
  }
  return {};
}

std::string reason_text(const Target& target, const std::string& key) {
  const FieldInfo* const field = find_input(target.calculator->input->fields, key);
  if (field == nullptr) return {};
  return "**" + key + "**: " + field->doc +
         "\n\nthe text is the reason why it is more favourable than the row or record";
}

std::string heading_text(const std::string& key) {
  for (const project::HeadingKey& known : project::heading_keys()) {
    if (known.key == key) return "**" + key + "**: " + known.meaning;
  }
  return {};
}

std::string about(const Target& target, const Path& path) {
  if (path.size() == 2 && path[0] == "project") return heading_text(path[1]);
  if (target.field != nullptr) return field_text(target);
  if (target.calculator == nullptr || path.size() < 2) return {};
  if (target.in_because && path.size() > 2) return reason_text(target, path[2]);
  return target.in_accept && path.size() > 2 ? mode_text(target, path[2]) : key_text(target, path[1]);
}

/// The values of a column of a row: "R_e: 430 MPa up to 16 mm, 370 MPa up to 40 mm".
std::string column_text(const table::Entry& row, const table::Column& column) {
  std::string all;
  const auto values = table::values_by_size(row, column.key);
  for (const table::SizedProperty& sized : values)
    all += (all.empty() ? "" : ", ") + format_quantity(sized.value.si, column.unit) + " up to " +
           format_quantity(sized.size_max, row.table->size.unit);
  if (values.empty()) {
    const auto property = table::property(row, column.key);
    if (property) all = format_quantity(property->si, column.unit);
  }
  return all.empty() ? "" : "\n- `" + column.key + "`: " + all;
}

std::string row_text(const OpenFile& file, const std::string& group, std::string_view name) {
  const auto found = tables_of(file).find_row(group, name);
  if (!found) return {};
  const table::Row& row = *found->row;
  std::string text = "**" + row.name + "**: " + (row.own ? "own table of the project" : found->table->title);
  for (const std::string* word : {&row.standard, &row.kind, &row.note}) text += word->empty() ? "" : "; " + *word;
  text += "\n";
  for (const table::Column& column : found->table->columns) text += column_text(*found, column);
  return text;
}

std::string expression_text(const OpenFile& file, std::string_view text, std::string_view unit) {
  const auto expression = Expression::parse(text);
  if (!expression) return expression.fault().message.text();
  if (file.solved == nullptr) return {};
  project::Project& project = *file.solved;
  const std::string value = value_of(project, text, unit);
  std::string all = value.empty() ? "" : "**= " + value + "**";
  const auto signature = expression->check([&](const std::string& path) { return project.signature(path); });
  if (signature && !signature->dimension.is_number()) all += " (" + name_of(signature->dimension) + ")";
  all += "\n";
  std::vector<std::string> listed;
  for (const auto& reference : expression->references()) {
    if (std::find(listed.begin(), listed.end(), reference.path) != listed.end()) continue;
    listed.push_back(reference.path);
    const std::string meaning = meaning_of(project, reference.path);
    if (!meaning.empty()) all += "\n- `" + reference.path + "`: " + meaning;
  }
  return all;
}

std::string quantity_text(std::string_view text, const Expected* expected) {
  if (expected != nullptr) {
    const auto literal = parse_literal(text, *expected);
    return literal ? in_units(literal->si, *expected) : literal.fault().message.text();
  }
  const auto literal = parse_literal(text);
  return literal ? in_units(literal->si, {literal->dimension, Kind::plain, {}}) : std::string();
}

std::string choice_text(const FieldInfo& field, std::string_view word) {
  for (const ChoiceInfo& c : field.choices) {
    if (word == c.key) return "**" + std::string(word) + "**: " + c.doc;
  }
  return {};
}

/// The text for a value itself; empty if the meaning of its key suffices.
std::string value_text(const OpenFile& file, const Item& item, const Target& target) {
  const std::string_view text = item.in(file.document.text());
  const FieldInfo* const field = target.field;
  const bool is_quantity = field != nullptr && field->type == Type::quantity;
  if (!item.is_text) return {};
  if (text.starts_with('=')) return expression_text(file, text.substr(1), is_quantity ? field->unit : "");
  if (item.path.size() > 1 && item.path[1] == "calculator") {
    const Calculator* const named = find_calculator(calculators(), text);
    return named == nullptr ? "" : calculator_text(*named);
  }
  if (!target.group.empty()) return row_text(file, target.group, text);
  if (field != nullptr && field->type == Type::choice) return choice_text(*field, text);
  if (is_quantity && text != "?") {
    const Expected expected{field->dimension, field->kind, field->unit};
    return quantity_text(text, &expected);
  }
  if (item.path[0] == "expect" && item.path.back() == "value") return expression_text(file, text, {});
  return target.calculator == nullptr ? quantity_text(text, nullptr) : std::string();
}

std::optional<Hover> hover_on(const OpenFile& file, const Item& item, std::size_t offset) {
  const Target target = target_of(file.outline, file.document.text(), item.path);
  const bool on_key = offset < item.begin && item.key_begin <= offset && offset <= item.key_end;
  const std::string key = about(target, item.path);
  if (on_key) {
    if (key.empty()) return std::nullopt;
    return Hover{file.document.range_of(item.key_begin, item.key_end), key};
  }
  const std::string value = value_text(file, item, target);
  if (key.empty() && value.empty()) return std::nullopt;
  const bool both = !key.empty() && !value.empty();
  return Hover{file.document.range_of(item.begin, item.end), value + (both ? "\n\n---\n\n" : "") + key};
}

std::optional<Hover> hover_on(const OpenFile& file, const Header& header) {
  const Calculator* const calculator = calculator_of(file.outline, file.document.text(), header.path[0]);
  if (calculator == nullptr) return std::nullopt;
  std::string text = calculator_text(*calculator);
  if (header.path.size() > 1) {
    const Target target = target_of(file.outline, file.document.text(), header.path);
    if (target.field != nullptr) text = field_text(target);
  } else if (file.is_solved) {
    const project::Step* const step = file.project->find(header.path[0]);
    if (step != nullptr) text += "\n\n" + account::brief_scope(step->account().modes).text();
  }
  return Hover{file.document.range_of(header.begin, header.end), text};
}

}  // namespace

std::optional<Hover> hover_at(const OpenFile& file, std::size_t offset) {
  if (const Header* const header = file.outline.header_at(offset)) return hover_on(file, *header);
  const Item* const item = file.outline.at(offset);
  return item == nullptr ? std::nullopt : hover_on(file, *item, offset);
}

}  // namespace loadpath::cli::lsp
