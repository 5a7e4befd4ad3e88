// Rows of tables as aggregates, for calculators that search a catalogue.
//
//   struct Profile {
//     static constexpr auto group = "section";
//     Length h = unset<Length>;
//     Area A = unset<Area>;
//     static constexpr Fields fields{Field{&Profile::h, "h", mm, "depth"}, Field{&Profile::A, "A", mm2, "area"}};
//   };
//   for (const auto& profile : table::rows_of<Profile>()) use(profile.A, profile.name());
//
// The key of a field is that of the column. Values that a row does not give, or gives by size, keep the aggregate's
// default.
#pragma once

#include "lib/calculator/record_of.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace loadpath::table {

/// The values of a row in SI, and the row itself: its kind, its note, and the sources of its values.
template <class Values>
struct Typed : Values {
  Entry entry;

  [[nodiscard]] std::string_view name() const { return entry.row->name; }
  [[nodiscard]] std::string_view kind() const { return entry.row->kind; }
};

/// All rows of tables of one group, in their order; of rows of one name the last table's, as in `find_row`.
std::vector<Entry> entries_of(const std::vector<const Table*>& tables);

/// The index, from 0, of the word of a choice that the row selects (lib/calculator/row_kind.hpp); nothing if its kind
/// is none of them.
std::optional<double> kind_of(const Row& row, const FieldInfo& choice);

/// Sets those fields of an aggregate that the row has a value for. A column of another dimension than its field is a
/// fault of the program: std::logic_error.
void fill(std::span<const FieldInfo> fields, const Entry& entry, void* values);

template <class Values>
std::vector<Typed<Values>> typed_rows(const std::vector<const Table*>& tables) {
  const auto fields = record_type<Values, Values::fields>.fields;
  std::vector<Typed<Values>> rows;
  for (const Entry& entry : entries_of(tables)) {
    Typed<Values>& row = rows.emplace_back();
    row.entry = entry;
    fill(fields, entry, static_cast<Values*>(&row));
  }
  return rows;
}

/// The rows of the group of an aggregate in the tables: read at first use, and kept.
template <class Values>
const std::vector<Typed<Values>>& rows_of() {
  static const auto rows = typed_rows<Values>(tables_of(Values::group));
  return rows;
}

}  // namespace loadpath::table
