#include "lib/quantity/unit.hpp"
#include "lib/table/reader.hpp"
#include "lib/text/embedded.hpp"

#include <mutex>
#include <optional>
#include <stdexcept>

namespace loadpath::table {

namespace {

/// What is wrong with a built-in file is a fault of the program.
void insist(const std::vector<Issue>& issues) {
  if (!issues.empty()) throw std::logic_error(render(issues, [](const std::string&) { return std::string(); }));
}

Library read_all() {
  Library library;
  std::vector<Issue> issues;
  Reader reader(library, issues);
  for (const auto& file : embedded::tables()) reader.read(file.text, std::string(file.name));
  reader.check_citations();
  insist(issues);
  return library;
}

/// A built-in file by itself, read when a look-up first needs it: reading all of them takes longer than most projects.
struct OneFile {
  std::once_flag once;
  Library library;

  const Library& read(const embedded::File& file) {
    std::call_once(once, [&] {
      std::vector<Issue> issues;
      Reader(library, issues).read(file.text, std::string(file.name));
      insist(issues);
    });
    return library;
  }
};

std::optional<Library>& replacement() {
  static std::optional<Library> library;
  return library;
}

const Library& built_in_file(std::size_t i) {
  static std::vector<OneFile> read(embedded::tables().size());
  return read[i].read(embedded::tables()[i]);
}

/// What is found in the tables in use; of the built-in ones the files that have the word are read first.
template <class Find>
auto look_for(std::string_view word, Find find) {
  if (replacement()) return find(*replacement());
  const auto files = embedded::tables();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].text.find(word) == std::string_view::npos) continue;
    if (auto found = find(built_in_file(i))) return found;
  }
  return find(built_in());
}

/// The tables in use that are wanted; of the built-in files only those that have `text` are read.
template <class Wanted>
std::vector<const Table*> tables_where(const std::string& text, Wanted wanted) {
  std::vector<const Table*> found;
  const auto collect = [&](const Library& library) {
    for (const Table& table : library.tables) {
      if (wanted(table)) found.push_back(&table);
    }
  };
  if (replacement()) {
    collect(*replacement());
    return found;
  }
  const auto files = embedded::tables();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].text.find(text) != std::string_view::npos) collect(built_in_file(i));
  }
  return found;
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
  static const Library library = read_all();
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

Outcome<Entry> find_row(std::string_view group, std::string_view name) {
  return look_for(name, [&](const Library& library) { return find_row(library, group, name); });
}

Outcome<const Series*> find_series(std::string_view name) {
  return look_for(name, [&](const Library& library) { return find_series(library, name); });
}

std::vector<const Table*> tables_of(std::string_view group) {
  return tables_where("group = \"" + std::string(group) + "\"",
                      [&](const Table& table) { return table.group == group; });
}

std::vector<const Table*> tables_in(std::string_view name) {
  const auto named = [&](const Table& table) {
    return table.name == name || std::string_view(table.name).substr(0, table.name.find('/')) == name;
  };
  return tables_where("table = \"" + std::string(name), named);
}

std::string citation(std::string_view key) {
  const auto find = [&](const Library& library) {
    const auto found = library.citations.find(key);
    return found == library.citations.end() ? nullptr : &found->second;
  };
  const Citation* found = look_for(key, find);
  return found == nullptr ? std::string() : found->text;
}

}  // namespace loadpath::table
