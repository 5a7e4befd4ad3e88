#include "lib/project/run/providers.hpp"

#include "lib/quantity/format.hpp"
#include "lib/table/rows.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

/// Whether the row leaves the input as it is.
bool lacks(const table::Entry& entry, const FieldInfo& field) {
  if (field.type == FieldInfo::Type::choice) return !table::kind_of(*entry.row, field);
  return field.provider.may_lack && table::covered_size(entry, field.provider.column) == 0.0;
}

/// The row that the step names for this input; nothing where it names none, or where the row does not exist.
std::optional<Provided> from_table(const StepInput& input, const FieldInfo& field, void* data,
                                   std::vector<Issue>& issues) {
  const auto named = input.rows.find(field.provider.table);
  if (named == input.rows.end() || input.reading.typed.count(field.provider.unless) != 0) return std::nullopt;
  const std::string& row = named->second.text;
  const auto entry = table::find_row(field.provider.table, row);
  if (entry && lacks(*entry, field)) return std::nullopt;
  if (entry) return Provided{field.key, {&field, data}, row, {}};
  const Place place = place_in(named->second.place, row, entry.fault().at, row.size());
  const bool said = std::any_of(issues.begin(), issues.end(), [&](const Issue& i) {
    return i.place.line == place.line && i.place.column == place.column && i.place.file == place.file;
  });
  if (!said)
    issues.push_back(
        {place, input.name + "." + field.provider.table, entry.fault().message, entry.fault().hint, Severity::error});
  return std::nullopt;
}

/// What comes along with everything that the expression of another input refers to.
std::optional<Provided> from_companion(const StepInput& input, const FieldInfo& field, void* data,
                                       const Companions& companions) {
  Provided provided{field.key, {&field, data}, "", {}};
  for (const Operand& operand : input.reading.operands) {
    if (operand.path.substr(operand.path.rfind('.') + 1) != field.provider.column) continue;  // "T", "torques[2].T"
    for (const auto& reference : operand.expression.references()) {
      for (std::string& path : companions(reference.path)) provided.companions.push_back(std::move(path));
    }
  }
  return provided.companions.empty() ? std::nullopt : std::optional(std::move(provided));
}

}  // namespace

std::vector<Provided> find_provided(const StepInput& input, const Companions& companions, std::vector<Issue>& issues) {
  std::vector<Provided> found;
  void* data = input.reading.record.data.get();
  for (const FieldInfo& field : input.calculator->input->fields) {
    if (input.reading.typed.count(field.key) != 0) continue;
    std::optional<Provided> provided;
    if (field.provider.kind == Provider::Kind::table && field.is_leaf())
      provided = from_table(input, field, data, issues);
    if (field.provider.kind == Provider::Kind::companion) provided = from_companion(input, field, data, companions);
    if (provided) found.push_back(std::move(*provided));
  }
  return found;
}

std::map<std::string, Origin> fill_lists(const StepInput& input) {
  std::map<std::string, Origin> origins;
  void* const data = input.reading.record.data.get();
  for (const FieldInfo& field : input.calculator->input->fields) {
    const Provider& from = field.provider;
    const auto named = input.rows.find(from.table);
    const auto& typed = input.reading.typed;
    if (field.is_leaf() || named == input.rows.end()) continue;
    if (typed.contains(field.key) || typed.contains(from.unless)) continue;
    const auto entry = table::find_row(from.table, named->second.text);
    if (!entry) continue;  // another input has said so
    for (const auto& [size, value] : table::values_by_size(*entry, from.column)) {
      if (field.size(data) == field.capacity) break;
      const std::string path = std::string(field.key) + "[" + std::to_string(field.size(data) + 1) + "].";
      void* const element = field.push(data);
      field.fields[0].set(element, size), field.fields[1].set(element, value.si);
      const Origin origin{say("{1}", named->second.text), value.sources, value.recalled};
      origins[path + field.fields[0].key] = origins[path + field.fields[1].key] = origin;
    }
  }
  return origins;
}

Lookup look_up(const Provided& provided, double size) {
  const FieldInfo& field = *provided.leaf.field;
  const double at = *field.provider.size == '\0' ? table::no_size : size;
  const auto entry = table::find_row(field.provider.table, provided.row);
  if (!entry) return {std::nan(""), {}, false, entry.fault().message};
  if (const auto word = table::kind_of(*entry->row, field)) return {*word, {}, false, {}};
  const auto property = table::property(*entry, field.provider.column, at);
  if (!property) return {std::nan(""), {}, false, property.fault().message};
  return {property->si, property->sources, property->recalled, {}};
}

std::vector<double> stock_values(const std::string& stock) {
  const auto series = table::find_series(stock);
  return series ? table::members_in_si(**series) : std::vector<double>{};
}

std::vector<std::string> stock_names() {
  std::vector<std::string> names;
  for (const table::Series& series : table::built_in().series) names.push_back(series.name);
  return names;
}

Origin stock_origin(const std::string& stock, Message text) {
  const auto series = table::find_series(stock);
  if (!series) return {std::move(text), {}, false};
  return {std::move(text), (*series)->sources, !(*series)->recalled.empty()};
}

}  // namespace loadpath::project
