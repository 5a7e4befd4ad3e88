#include "lib/embedded.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/table/reader.hpp"

#include <optional>
#include <stdexcept>

namespace loadpath::table {

namespace {

Library read_embedded() {
  Library library;
  std::vector<Issue> issues;
  Reader reader(library, issues);
  for (const auto& file : embedded::tables()) reader.read(file.text, std::string(file.name));
  reader.check_citations();
  if (!issues.empty()) throw std::logic_error(render(issues, [](const std::string&) { return std::string(); }));
  return library;
}

std::optional<Library>& replacement() {
  static std::optional<Library> library;
  return library;
}

void audit_row(const Table& table, const Row& row, const std::vector<Value>& values, double size_max,
               std::vector<Recalled>& found) {
  for (const Value& value : values) {
    if (!value.sources.empty()) continue;
    found.push_back({table.name, row.name, value.key, size_max, value.si, table.column(value.key)->unit});
  }
}

}  // namespace

const Library& built_in() {
  static const Library library = read_embedded();
  return library;
}

Library overlaid(Library base, std::string_view text, const std::string& file, std::vector<Issue>& issues) {
  Reader reader(base, issues);
  reader.read(text, file);
  reader.check_citations();
  return base;
}

const Library& active() { return replacement() ? *replacement() : built_in(); }

void activate(Library library) { replacement() = std::move(library); }

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

std::string citation(std::string_view key) {
  const auto& citations = active().citations;
  const auto found = citations.find(key);
  return found == citations.end() ? std::string() : found->second.text;
}

}  // namespace loadpath::table
