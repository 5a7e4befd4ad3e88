#include "lib/project/run/evaluation/providers.hpp"

#include "lib/quantity/format.hpp"
#include "lib/table/rows.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

Origin origin_of(const std::string& row, const table::Property& property) {
  return {table::named_source(row, property), property.own ? std::vector<std::string>{} : property.sources,
          property.recalled};
}

/// Whether the row leaves the input as it is.
bool lacks(const table::Entry& entry, const FieldInfo& field) {
  if (field.type == FieldInfo::Type::choice) return !table::kind_of(*entry.row, field);
  return field.provider.may_be_incomplete && table::covered_size(entry, field.provider.column) == 0.0;
}

/// The rows of a step, each looked up once.
class RowsFound {
 public:
  explicit RowsFound(const table::Tables& tables) : tables_(tables) {}
  const Outcome<table::Entry>& of(const std::string& group, const std::string& name) {
    auto found = found_.find(group);
    if (found == found_.end()) found = found_.emplace(group, tables_.find_row(group, name)).first;
    return found->second;
  }

 private:
  const table::Tables& tables_;
  std::map<std::string, Outcome<table::Entry>> found_;  // by the group, of which a step names one
};

/// The row that the step names for this input; nothing if it names none, or where the row does not exist.
std::optional<Provided> from_table(const StepInput& input, const Rows& rows, const FieldInfo& field, RowsFound& found,
                                   std::vector<Issue>& issues) {
  const auto named = rows.find(field.provider.table);
  if (named == rows.end() || named->second.text.empty()) return std::nullopt;
  if (input.reading.typed.count(field.provider.unless) != 0) return std::nullopt;
  const std::string& row = named->second.text;
  const auto& entry = found.of(field.provider.table, row);
  if (entry && lacks(*entry, field)) return std::nullopt;
  if (entry) return Provided{field.key, &field, row, {}, *entry};
  const Place place = place_in(named->second.place, row, entry.fault().at, row.size());
  const bool said = std::any_of(issues.begin(), issues.end(), [&](const Issue& i) {
    return i.place.line == place.line && i.place.column == place.column && i.place.file == place.file;
  });
  if (!said)
    issues.push_back(
        {place, input.name + "." + field.provider.table, entry.fault().message, entry.fault().hint, Severity::error});
  return std::nullopt;
}

/// The components of everything that the expression of another input refers to.
std::optional<Provided> from_companion(const StepInput& input, const FieldInfo& field, const Companions& companions) {
  Provided provided{field.key, &field, "", {}, {}};
  for (const Operand& operand : input.reading.operands) {
    if (operand.path.substr(operand.path.rfind('.') + 1) != field.provider.column) continue;  // "T", "torques[2].T"
    for (const auto& reference : operand.expression.references()) {
      for (std::string& path : companions(reference.path)) provided.companions.push_back(std::move(path));
    }
  }
  return provided.companions.empty() ? std::nullopt : std::optional(std::move(provided));
}

}  // namespace

bool gives(const table::Entry& row, const FieldInfo& field) {
  if (field.type == FieldInfo::Type::choice) return table::kind_of(*row.row, field).has_value();
  return table::covered_size(row, field.provider.column) != 0.0;
}

std::vector<Provided> provided_by_rows(const StepInput& input, const Rows& rows, std::vector<Issue>& issues) {
  std::vector<Provided> found;
  RowsFound rows_found(*input.tables);
  for (const FieldInfo& field : input.calculator->input->fields) {
    const bool of_row = field.provider.kind == Provider::Kind::table && field.is_leaf();
    if (!of_row || input.reading.typed.count(field.key) != 0) continue;
    if (auto provided = from_table(input, rows, field, rows_found, issues)) found.push_back(std::move(*provided));
  }
  return found;
}

std::vector<Provided> provided_by_companions(const StepInput& input, const Companions& companions) {
  std::vector<Provided> found;
  for (const FieldInfo& field : input.calculator->input->fields) {
    if (field.provider.kind != Provider::Kind::companion || input.reading.typed.count(field.key) != 0) continue;
    if (auto provided = from_companion(input, field, companions)) found.push_back(std::move(*provided));
  }
  return found;
}

std::map<std::string, Origin> fill_lists(const StepInput& input, const Rows& rows, const Record& record) {
  std::map<std::string, Origin> origins;
  void* const data = record.data.get();
  for (const FieldInfo& field : input.calculator->input->fields) {
    const Provider& from = field.provider;
    const auto named = rows.find(from.table);
    const auto& typed = input.reading.typed;
    if (!field.has_fields() || named == rows.end() || named->second.text.empty()) continue;
    if (typed.contains(field.key) || typed.contains(from.unless)) continue;
    const auto entry = input.tables->find_row(from.table, named->second.text);
    if (!entry) continue;  // another input has reported it
    for (const auto& [size, value] : table::values_by_size(*entry, from.column)) {
      if (field.size(data) == field.capacity) break;
      const std::string path = std::string(field.key) + "[" + std::to_string(field.size(data) + 1) + "].";
      void* const element = field.push(data);
      field.fields[0].set(element, size), field.fields[1].set(element, value.si);
      const Origin origin = origin_of(named->second.text, value);
      origins[path + field.fields[0].key] = origins[path + field.fields[1].key] = origin;
    }
  }
  return origins;
}

Lookup look_up(const Provided& provided, double size) {
  const FieldInfo& field = *provided.field;
  const double at = *field.provider.size == '\0' ? table::no_size : size;
  const Origin row{say("{1}", provided.row), {}, false};
  if (const auto word = table::kind_of(*provided.entry.row, field)) return {*word, row, {}};
  const auto property = table::property(provided.entry, field.provider.column, at);
  if (!property) return {std::nan(""), row, property.fault().message};
  return {property->si, origin_of(provided.row, *property), {}};
}

std::vector<double> stock_values(const table::Tables& tables, const std::string& stock) {
  const auto series = tables.find_series(stock);
  return series ? table::members_in_si(**series) : std::vector<double>{};
}

Origin stock_origin(const table::Tables& tables, const std::string& stock, Message text) {
  const auto series = tables.find_series(stock);
  if (!series) return {std::move(text), {}, false};
  const bool own = (*series)->own;
  return {table::named_source(std::move(text), **series), own ? std::vector<std::string>{} : (*series)->sources,
          !(*series)->recalled.empty()};
}

Origin expression_origin(const table::Tables& tables, const Operand& operand) {
  Origin origin{say("= {1}", operand.text), {}, false};
  for (const auto& reference : operand.expression.references()) {
    const auto referred = reference.path.starts_with("tables.") ? tables.value_at(reference.path)
                                                                : Outcome<table::Tables::Referred>(Fault{});
    if (!referred) continue;
    Origin row = origin_of(operand.text, referred->value);
    origin.recalled = origin.recalled || row.recalled;
    origin.sources.insert(origin.sources.end(), row.sources.begin(), row.sources.end());
    if (referred->value.own) origin.text = table::named_source("= " + operand.text, referred->value);
  }
  return origin;
}

}  // namespace loadpath::project
