// Reads the tables of a project into a library: rows and series in its file, and files in the form of the built-in
// tables. Only groups and columns of the built-in tables can be given, in their dimensions.
//
//   [tables.materials.P265GH]            one row: columns with units; kind, standard, note, aliases; `source` is
//   required R_e = "265 MPa"                      at any size, or by_size = [{ size_max = "16 mm", R_e = "265 MPa" }]
//   source = "EN 10028-2, table 4"
//   [tables.series.bars]                 sizes = [20, 25, 32], unit = "mm"
#pragma once

#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

class OwnReader {
 public:
  /// `groups`: those whose rows a step can name.
  OwnReader(Library& own, std::vector<std::string> groups, std::vector<Issue>& issues)
      : own_(own), groups_(std::move(groups)), issues_(issues) {}

  /// Reads `[tables]` of a project file.
  void read_tables(const toml::Tree::Entry& tables);
  /// A file of the form of lib/table/reader.hpp.
  void read_file(std::string_view text, const std::string& file);

 private:
  using Tree = toml::Tree;

  void read_group(const Tree::Entry& entry);
  void read_row(const Tree::Entry& entry, Table& table);
  void read_word(const Tree::Entry& entry, const std::string& key, Row& row);
  void read_value(const Tree::Entry& entry, const Table& table, const std::string& key, std::vector<Value>& values);
  void read_sizes(const Tree& tree, const Table& table, const std::string& key, Row& row);
  void read_size(const Tree& tree, const Table& table, const std::string& key, Row& row);
  /// An issue if a value is zero or less, and those of the built-in rows never are.
  void check_sign(const Value& value, const Column& column, std::string_view group, const Place& place);
  double read_quantity(const Tree& tree, const Column& column, const std::string& key);
  void check_kind(const Tree::Entry& entry, const std::string& key, std::string_view group);
  void read_series(const Tree::Entry& entry);
  void read_unit_of(const Tree::Entry& entry, const std::string& key, Series& series);
  std::vector<double> read_members(const Tree& tree, const std::string& key);
  std::string read_source(const Tree& row, const Place& place, const std::string& key);
  Table& table_of(const std::string& group);

  /// A row as it was read, and where.
  struct RowRead {
    const Row& row;
    const Table& table;
    const Place& place;
    const std::string& key;
  };
  /// Reports values that are impossible for any part, and values better than the built-in rows without a reason.
  void check_bounds(const Row& row, const Table& table, const Place& place, const std::string& key);
  void check_strengths(const RowRead& read, std::vector<std::string>& used);
  void check_strength(const RowRead& read, const char* key, std::vector<std::string>& used);
  void check_shape(const RowRead& read);
  void check_replaced(const RowRead& read, std::vector<std::string>& used);
  void compare_with(const RowRead& read, const Entry& replaced, double most, std::vector<std::string>& used);
  void check_namesake(const RowRead& read, std::vector<std::string>& used);
  void check_moduli(const RowRead& read, std::vector<std::string>& used);
  void check_contraction(const RowRead& read, double of_moduli, std::vector<std::string>& used);
  void check_density(const RowRead& read, double E, std::vector<std::string>& used);
  void check_modulus(const RowRead& read, const char* key, double low, double high, std::vector<std::string>& used);
  void check_group(const RowRead& read, std::vector<std::string>& used);
  void read_because(const Tree::Entry& entry, const Table& table, const std::string& key, Row& row);

  bool check_file(const Tree& file);
  void check_unit(const Tree::Entry& unit, const Table& known);
  void check_signs(const Row& row, const Table& table, const Place& place);
  void take_file(Library&& read, const std::string& file);
  /// False, and an issue, where another row of the project answers to one of its names.
  bool is_new(const Row& row, const std::string& group, const Place& place, const std::string& key);
  void add_series(Series&& series, const Place& place, const std::string& key);

  std::string text_of(const Tree::Entry& entry, const std::string& key);
  void complain(const Place& place, std::string key, Message message, Message hint = {});

  Library& own_;
  std::vector<std::string> groups_;
  std::vector<Issue>& issues_;
  std::map<std::pair<std::string, std::u32string>, std::string> names_;  // group and folded name: as written
};

}  // namespace loadpath::table
