// Sourced data: properties of materials by size, series of preferred sizes, and the citations behind both.
//
// A value names its sources, or it is recalled: known from a standard or a handbook, but not yet seen in a source.
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/text/issue.hpp"

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

struct Value {
  std::string key;
  double si = 0.0;
  std::vector<std::string> sources;  // keys of citations; none: recalled
};

/// Values that hold up to and including a size.
struct Step {
  double size_max = 0.0;
  std::vector<Value> values;
};

struct Row {
  std::string name;
  std::vector<std::string> aliases;
  std::vector<std::string> near;  // names of others that come close, and are not the same
  std::string standard;
  std::string kind;
  std::string note;
  std::vector<Value> values;                        // at any size
  std::vector<Step> by_size;                        // ascending
  bool own = false;                                 // project table: its sources are texts, not citation keys
  std::map<std::string, std::string> because = {};  // project table: why a value is better than a built-in one
};

struct Column {
  std::string key;
  std::string unit;  // for display; the values are SI
  Dimension dimension;
};

struct Table {
  std::string name;   // "materials/cast_iron"
  std::string group;  // key of its rows in a project file: "material"
  std::string title;
  std::vector<Column> columns;
  Column size;
  std::vector<Row> rows;

  [[nodiscard]] const Column* column(std::string_view key) const;
};

/// Sizes to choose from, ascending.
struct Series {
  std::string table;  // "preferred/numbers"
  std::string name;   // "R40"
  std::string title;
  std::string unit;
  std::vector<double> members;  // in the unit, each the double nearest to its decimal: 31.5
  std::vector<std::string> sources;
  std::vector<double> recalled;  // the listed numbers
  bool own = false;              // property of the project, as a row's
};

struct Citation {
  std::string text;
  bool of_method = false;  // cited by a calculator, not by a value
};

struct Library {
  std::vector<Table> tables;
  std::vector<Series> series;
  std::map<std::string, Citation, std::less<>> citations;
};

struct Entry {
  const Table* table = nullptr;
  const Row* row = nullptr;
};

/// A row by its name, else by an alias, ignoring case and spaces.
Outcome<Entry> find_row(const Library& library, std::string_view group, std::string_view name);
/// The fault of a row in none of the libraries: a close but different row, or a similar name.
Fault no_row(std::string_view group, std::string_view name, const std::vector<const Library*>& libraries);
struct Property {
  double si = 0.0;
  std::string unit;
  std::vector<std::string> sources;
  bool recalled = false;
  bool own = false;  // property of a row of the project
};

inline constexpr double no_size = std::numeric_limits<double>::quiet_NaN();

/// A property at a size (SI). A size beyond the last one of the row has none: its strength is not covered.
Outcome<Property> property(const Entry& entry, std::string_view key, double size = no_size);

/// A property at all sizes that the row distinguishes, each up to and including its own, ascending; empty if
/// independent of the size.
struct SizedProperty {
  double size_max = 0.0;
  Property value;
};
std::vector<SizedProperty> values_by_size(const Entry& entry, std::string_view key);

/// The largest size that a property is given for: infinite if it holds at any, zero if the row has no such value.
double covered_size(const Entry& entry, std::string_view key);

Outcome<const Series*> find_series(const Library& library, std::string_view name);
std::vector<double> members_in_si(const Series& series);

/// A value that no source was seen for.
struct Recalled {
  std::string table;
  std::string row;
  std::string key;  // empty for a member of a series
  double size_max = std::numeric_limits<double>::infinity();
  double si = 0.0;
  std::string unit;
};

std::vector<Recalled> audit(const Library& library);

}  // namespace loadpath::table
