#include "lib/table/library.hpp"

#include "lib/table/reader.hpp"
#include "lib/text/embedded.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

namespace loadpath::table {

namespace {

/// An error in a built-in file is a fault of the program.
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

const Library& built_in_file(std::size_t i) {
  static std::vector<OneFile> read(embedded::tables().size());
  return read[i].read(embedded::tables()[i]);
}

/// Visits the tables until that gives true; only the files that have `text` are read.
template <class Visit>
void visit_until(std::string_view text, Visit visit) {
  const auto files = embedded::tables();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].text.find(text) != std::string_view::npos && visit(built_in_file(i))) return;
  }
}

/// The requested tables; only the files that contain `text` are read.
template <class Wanted>
std::vector<const Table*> tables_where(const std::string& text, Wanted wanted) {
  std::vector<const Table*> found;
  visit_until(text, [&](const Library& library) {
    for (const Table& table : library.tables) {
      if (wanted(table)) found.push_back(&table);
    }
    return false;
  });
  return found;
}

/// Rows or series that were found, for a project looks up the same few again and again.
template <class One>
class FoundOnes {
 public:
  One find(const std::string& key) const {
    const std::lock_guard lock(mutex_);
    const auto found = all_.find(key);
    return found != all_.end() ? found->second : One();
  }

  const One& keep(const std::string& key, const One& one) {
    const std::lock_guard lock(mutex_);
    return all_.emplace(key, one).first->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, One> all_;
};

/// The line of a file with the name of its table, or its folder.
std::string table_line(std::string_view name) { return "table = \"" + std::string(name); }

/// The files that contain the words.
std::vector<std::string_view> texts_with(std::string_view words) {
  std::vector<std::string_view> texts;
  for (const auto& file : embedded::tables()) {
    if (file.text.find(words) != std::string_view::npos) texts.push_back(file.text);
  }
  return texts;
}

bool is_named(const Table& table, std::string_view name) {
  return table.name == name || std::string_view(table.name).substr(0, table.name.find('/')) == name;
}

}  // namespace

const Library& built_in() {
  static const Library library = read_all();
  return library;
}

Outcome<Entry> find_row(std::string_view group, std::string_view name) {
  if (name.empty()) return find_row(Library{}, group, name);  // nothing is near no name
  static FoundOnes<Entry> found_rows;
  const std::string key = std::string(group) + '\n' + std::string(name);
  Entry entry = found_rows.find(key);
  if (entry.row != nullptr) return entry;
  visit_until('"' + std::string(name) + '"', [&](const Library& library) {
    if (const auto found = find_row(library, group, name)) entry = *found;
    return entry.row != nullptr;
  });
  if (entry.row != nullptr) return found_rows.keep(key, entry);
  return find_row(built_in(), group, name);  // by other capitals, or reports near names
}

const Series* series_named(std::string_view name) {
  static FoundOnes<const Series*> found_series;
  const std::string key(name);
  const Series* named = found_series.find(key);
  if (named != nullptr) return named;
  visit_until("name = \"" + key + '"', [&](const Library& library) {
    if (const auto found = find_series(library, name)) named = *found;
    return named != nullptr;
  });
  return named == nullptr ? nullptr : found_series.keep(key, named);
}

Outcome<const Series*> find_series(std::string_view name) {
  if (const Series* series = series_named(name)) return series;
  return find_series(built_in(), name);  // reports near names
}

std::vector<const Table*> tables_of(std::string_view group) {
  return tables_where("group = \"" + std::string(group) + "\"",
                      [&](const Table& table) { return table.group == group; });
}

std::vector<const Table*> tables_in(std::string_view name) {
  return tables_where(table_line(name), [&](const Table& table) { return is_named(table, name); });
}

const Table* first_table_in(std::string_view name) {
  const Table* first = nullptr;
  visit_until(table_line(name), [&](const Library& library) {
    const auto found = std::find_if(library.tables.begin(), library.tables.end(),
                                    [&](const Table& table) { return is_named(table, name); });
    if (found != library.tables.end()) first = &*found;
    return first != nullptr;
  });
  return first;
}

/// One citation is read from its line: the file of all of them takes longer than most commands.
std::string citation(std::string_view key) {
  static const std::vector<std::string_view> cited = texts_with("[sources]");
  for (const std::string_view file : cited) {
    if (const auto text = plain_text(file, key)) return std::string(*text);
  }
  const auto& citations = built_in().citations;
  const auto found = citations.find(key);
  return found == citations.end() ? std::string() : found->second.text;
}

}  // namespace loadpath::table
