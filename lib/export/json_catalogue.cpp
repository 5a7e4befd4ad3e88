#include "lib/export/json_catalogue.hpp"

#include "lib/calculator/choice_words.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/export/unit_name.hpp"

#include <cmath>

namespace loadpath::exports {

namespace {

using Type = FieldInfo::Type;

const char* type_word(Type type) {
  switch (type) {
    case Type::quantity:
      return "quantity";
    case Type::count:
      return "count";
    case Type::choice:
      return "choice";
    case Type::name:
      return "name";
    case Type::formula:
      return "formula";
    case Type::group:
      return "group";
    case Type::list:
      return "list";
    case Type::record:
      return "record";
  }
  return "";
}

void write_bounds(const FieldInfo& field, JsonWriter& out) {
  if (!field.is_number()) return;
  if (std::isfinite(field.bounds.low)) out.member("from", field.bounds.low);
  if (std::isfinite(field.bounds.high)) out.member("to", field.bounds.high);
}

void write_default(const FieldInfo& field, void* owner, JsonWriter& out) {
  if (field.is_number() && !is_missing(field, owner)) out.member("default", field.get(owner));
  if (field.provider.kind == Provider::Kind::table) out.member("from_row_of", field.provider.table);
  if (*field.searched_in != '\0') out.member("searched_in", field.searched_in);
}

void write_fields(std::span<const FieldInfo> fields, void* owner, JsonWriter& out);

void write_field(const FieldInfo& field, void* owner, JsonWriter& out) {
  out.open_object();
  out.member("key", field.key);
  out.member("type", type_word(field.type));
  if (field.type == Type::quantity) {
    out.member("unit", unit_name(field.dimension));
    out.member("shown_in", field.unit);
  }
  out.member("meaning", field.doc);
  if (*field.also_called != '\0') out.member("also", field.also_called);
  if (field.role == Role::input && field.type != Type::record) {
    const bool filled = field.optional || field.provider.kind != Provider::Kind::none || field.sought_unasked ||
                        (field.is_number() && !is_missing(field, owner)) || field.type == Type::choice;
    out.member("required", !filled);
    write_default(field, owner, out);
  }
  if (field.type == Type::choice) {
    out.key("words").open_array();
    for (const std::string& word : words_to_type(field)) out.write(word);
    out.close_array();
  }
  write_bounds(field, out);
  if (field.has_fields()) {
    out.key("fields");
    write_fields(field.fields, field.type == Type::list ? field.push(owner) : field.element(owner, 0), out);
  }
  out.close_object();
}

void write_fields(std::span<const FieldInfo> fields, void* owner, JsonWriter& out) {
  out.open_array();
  for (const FieldInfo& field : fields) write_field(field, owner, out);
  out.close_array();
}

void write_type(const char* key, const RecordType* type, JsonWriter& out) {
  if (type == nullptr) return;
  const Record blank(*type);
  out.key(key);
  write_fields(type->fields, blank.data.get(), out);
}

void write_synonyms(const Calculator& calculator, JsonWriter& out) {
  out.key("synonyms").open_array();
  for (const std::string& synonym : listed_keys(calculator.synonyms)) out.write(std::string_view(synonym));
  out.close_array();
}

void write_modes(const Calculator& calculator, JsonWriter& out) {
  out.key("modes").open_array();
  for (const ModeInfo& mode : calculator.modes) {
    out.open_object();
    out.member("id", mode.id);
    out.member("title", mode.title);
    if (*mode.checks != '\0') out.member("checks", mode.checks);
    if (*mode.judge != '\0') out.member("left_to", mode.judge);
    if (*mode.use != '\0') out.member("use", mode.use);
    if (*mode.add != '\0') out.member("add", mode.add);
    out.close_object();
  }
  out.close_array();
}

void write_patterns(const Calculator& calculator, JsonWriter& out) {
  out.key("results_by_name").open_array();
  for (const ResultPattern& p : calculator.patterns()) {
    out.open_object();
    out.member("path", p.path);
    out.member("shown_in", p.unit);
    out.member("meaning", p.doc);
    out.close_object();
  }
  out.close_array();
}

void write_values(const table::Table& table, const std::vector<table::Value>& values, JsonWriter& out) {
  out.open_object();
  for (const table::Value& v : values) {
    const table::Column* const column = table.column(v.key);
    out.key(v.key).open_object();
    out.member("value", v.si);
    if (column != nullptr) out.member("unit", unit_name(column->dimension));
    if (v.sources.empty()) out.member("recalled", true);
    out.close_object();
  }
  out.close_object();
}

void write_row(const table::Entry& entry, JsonWriter& out) {
  const table::Row& row = *entry.row;
  out.open_object();
  out.member("name", row.name);
  out.member("table", entry.table->name);
  if (!row.standard.empty()) out.member("standard", row.standard);
  if (!row.kind.empty()) out.member("kind", row.kind);
  if (!row.note.empty()) out.member("note", row.note);
  out.key("values");
  write_values(*entry.table, row.values, out);
  if (!row.by_size.empty()) {
    out.key("by_size").open_array();
    for (const table::Step& step : row.by_size) {
      out.open_object();
      out.key("up_to");
      std::isfinite(step.size_max) ? out.write(step.size_max) : out.write_null();
      out.key("values");
      write_values(*entry.table, step.values, out);
      out.close_object();
    }
    out.close_array();
  }
  out.close_object();
}

}  // namespace

std::string json_of(const std::vector<Listed>& list, const std::vector<Beyond>& beyond) {
  JsonWriter out;
  out.open_object();
  out.key("calculators").open_array();
  for (const Listed& one : list) {
    out.open_object();
    out.member("id", one.id);
    out.member("title", one.title);
    out.member("scope", one.calculator->scope);
    write_synonyms(*one.calculator, out);
    out.member("found_by", one.found_by);
    if (!one.found_in.empty()) out.member("found_in", one.found_in);
    out.close_object();
  }
  out.close_array();
  out.key("not_included").open_array();
  for (const Beyond& one : beyond) {
    out.open_object();
    out.member("what", one.what);
    out.key("nearest").open_array();
    for (const std::string& id : one.nearest) out.write(std::string_view(id));
    out.close_array();
    out.close_object();
  }
  out.close_array();
  out.close_object();
  return out.take();
}

std::string json_of(const Calculator& calculator) {
  JsonWriter out;
  out.open_object();
  out.member("id", calculator.id);
  out.member("title", calculator.title);
  out.member("scope", calculator.scope);
  write_synonyms(calculator, out);
  out.key("templates").open_array();
  for (const Template* t : calculator.templates) out.write(std::string_view(t->id));
  out.close_array();
  write_type("inputs", calculator.input, out);
  write_type("results", calculator.result, out);
  write_patterns(calculator, out);
  out.key("rules").open_array();
  for (const RuleInfo& rule : calculator.rules) {
    out.open_object();
    out.member("fields", rule.fields);
    out.member("text", rule.text);
    out.close_object();
  }
  out.close_array();
  write_modes(calculator, out);
  out.member("source", calculator.source);
  out.member("example", calculator.example);
  out.close_object();
  return out.take();
}

std::string json_index(const table::Library& library) {
  JsonWriter out;
  out.open_object();
  out.key("tables").open_array();
  for (const table::Table& t : library.tables) {
    out.open_object();
    out.member("name", t.name);
    out.member("title", t.title);
    out.member("rows", static_cast<std::int64_t>(t.rows.size()));
    out.close_object();
  }
  out.close_array();
  out.key("series").open_array();
  for (const table::Series& s : library.series) {
    out.open_object();
    out.member("name", s.name);
    out.member("table", s.table);
    out.member("title", s.title);
    out.close_object();
  }
  out.close_array();
  out.close_object();
  return out.take();
}

std::string json_of(const std::vector<table::Entry>& rows) {
  JsonWriter out;
  out.open_object();
  out.key("rows").open_array();
  for (const table::Entry& row : rows) write_row(row, out);
  out.close_array();
  out.close_object();
  return out.take();
}

std::string json_of(const table::Series& series) {
  JsonWriter out;
  out.open_object();
  out.member("name", series.name);
  out.member("title", series.title);
  out.member("unit", series.unit);
  out.key("members").write(series.members);
  out.close_object();
  return out.take();
}

std::string json_of(const std::vector<table::Recalled>& values) {
  JsonWriter out;
  out.open_object();
  out.key("recalled").open_array();
  for (const table::Recalled& r : values) {
    out.open_object();
    out.member("table", r.table);
    out.member("row", r.row);
    out.member("key", r.key);
    out.member("value", r.si);
    out.close_object();
  }
  out.close_array();
  out.close_object();
  return out.take();
}

}  // namespace loadpath::exports
