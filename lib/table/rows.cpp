#include "lib/table/rows.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace loadpath::table {

std::vector<Entry> entries_of(const std::vector<const Table*>& tables) {
  std::vector<Entry> entries;
  std::set<std::string_view> seen;
  for (auto table = tables.rbegin(); table != tables.rend(); ++table) {
    const auto& rows = (*table)->rows;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      if (seen.insert(row->name).second) entries.push_back({*table, &*row});
    }
  }
  std::reverse(entries.begin(), entries.end());
  return entries;
}

std::optional<double> kind_of(const Row& row, const FieldInfo& choice) {
  if (choice.type != FieldInfo::Type::choice || choice.provider.kind != Provider::Kind::table) return std::nullopt;
  const auto word = std::find_if(choice.choices.begin(), choice.choices.end(),
                                 [&](const ChoiceInfo& c) { return c.key == row.kind; });
  if (word == choice.choices.end()) return std::nullopt;
  return static_cast<double>(word - choice.choices.begin());
}

void fill(std::span<const FieldInfo> fields, const Entry& entry, void* values) {
  for (const Value& value : entry.row->values) {
    const FieldInfo* field = find_field(fields, value.key);
    if (field == nullptr) continue;
    if (!(entry.table->column(value.key)->dimension == field->dimension)) {
      throw std::logic_error("column " + value.key + " of table " + entry.table->name + " is of another dimension");
    }
    field->set(values, value.si);
  }
  for (const FieldInfo& field : fields) {
    if (const auto word = kind_of(*entry.row, field)) field.set(values, *word);
  }
}

}  // namespace loadpath::table
