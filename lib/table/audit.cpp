// The values of a library that no source was seen for.
#include "lib/quantity/unit.hpp"
#include "lib/table/table.hpp"

namespace loadpath::table {

namespace {

void audit_row(const Table& table, const Row& row, const std::vector<Value>& values, double size_max,
               std::vector<Recalled>& found) {
  for (const Value& value : values) {
    if (!value.sources.empty()) continue;
    found.push_back({table.name, row.name, value.key, size_max, value.si, table.column(value.key)->unit});
  }
}

}  // namespace

std::vector<Recalled> audit(const Library& library) {
  std::vector<Recalled> found;
  for (const Table& table : library.tables) {
    for (const Row& row : table.rows) {
      audit_row(table, row, row.values, std::numeric_limits<double>::infinity(), found);
      for (const Step& step : row.by_size) audit_row(table, row, step.values, step.size_max, found);
    }
  }
  for (const Series& series : library.series) {
    const auto unit = read_unit(series.unit, 0);
    for (const double number : series.recalled) {
      found.push_back(
          {series.table, series.name, "", std::numeric_limits<double>::infinity(), unit->to_si(number), series.unit});
    }
  }
  return found;
}

}  // namespace loadpath::table
