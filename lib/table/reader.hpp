// Reads files of tables into a library. Errors become issues; the rest is read all the same.
//
// A file names its `table` and the `group` of its rows ("material"), the `units` of its columns, `[defaults]` common
// to its rows, and each `[[row]]`: name, aliases, near, standard, kind, note, its values, and `by_size` for those
// that hold up to a `size_max`. `sources` are those of all values of a row or a step, `cite.KEY` those of the values
// it lists, and `recalled` (a list, or true) marks the values that no source was seen for. A file of sizes has
// `[[series]]` instead; `[sources]` are the citations. Rows that all give the same keys may be written as lines:
// `columns` are the keys, and each of `rows` is an array of their values, "" if there is none; `recalled_columns` are
// those of them that no source was seen for.
#pragma once

#include "lib/quantity/unit.hpp"
#include "lib/table/lines.hpp"
#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"

#include <functional>
#include <set>

namespace loadpath::table {

class Reader {
 public:
  Reader(Library& library, std::vector<Issue>& issues) : library_(library), issues_(issues) {}

  void read(std::string_view text, const std::string& file);

  /// Every cited key must have its citation, in any of the files, or be known elsewhere.
  void check_citations(const std::function<bool(const std::string& key)>& known_elsewhere = {});

 private:
  using Tree = toml::Tree;
  using Texts = std::vector<std::string>;

  struct ReadColumn {
    Column column;
    ParsedUnit unit;
  };

  /// The sources of the values of a row, a step or a series.
  struct Credit {
    Texts sources;
    std::map<std::string, Texts> cited;  // key of a value -> sources
    std::set<std::string> recalled;      // keys of values
    bool all_recalled = false;
  };

  /// Data common to all rows of a file.
  struct Frame {
    std::vector<ReadColumn> units;
    Row defaults;
    Credit credit;  // for values in the row itself: the default sources, not those of default values
  };

  /// A column of rows written as lines.
  struct LineColumn {
    std::string key;
    const ReadColumn* unit;  // null: not a column of values
  };

  struct Cited {
    std::string key;
    Place place;
  };

  /// False if there are lines and one of them is of another form.
  bool read_tree(const Tree& tree, const Lines* lines);
  void read_citations(const Tree& table, bool of_method);
  bool read_rows(const Tree& file, const Lines* lines);
  void read_series_list(const Tree& file);

  /// Reads rows of lines without a tree; false if the tree is needed: to report an error, or for features that only
  /// it has.
  static bool rows_of_lines(const Lines& lines, const Texts& columns, const Frame& frame, std::vector<Row>& rows);
  static bool row_of_cells(const std::vector<Cell>& cells, const std::vector<LineColumn>& columns, const Frame& frame,
                           Row& row);
  static bool add_cell(const Cell& cell, const LineColumn& column, const Frame& frame, Row& row);
  static void let_defaults(const Frame& frame, Row& row);
  std::vector<Tree> row_trees(const Tree& file);
  Tree row_of_line(const Tree& line, const Texts& columns);
  Table& table_of(const Tree& file);
  std::vector<ReadColumn> read_units(const Tree& file, const Table& table);
  Frame read_frame(const Tree& file, const Table& table);
  void read_recalled_columns(const Tree& tree, const Table& table, Frame& frame);
  void add_columns(Table& table, const std::vector<ReadColumn>& units);
  bool read_row(const Tree& tree, const Frame& frame, Row& row);
  void read_values(const Tree& tree, const Frame& frame, Row& row);
  void read_steps(const Tree& tree, const Frame& frame, Row& row, const Credit& credit);
  Step read_step(const Tree& tree, const Frame& frame, const std::string& row, const Credit& credit);
  void add_value(const Tree::Entry& entry, const Frame& frame, const std::string& row,
                 const std::vector<const Credit*>& credits, std::vector<Value>& values);
  const ReadColumn* column_of(const Tree::Entry& entry, const Frame& frame, const std::string& row);
  void check_recalled(const Tree& tree, const Row& row, const Credit& credit);

  bool read_series(const Tree& tree, Series& series);
  std::vector<double> ascending(const Tree& tree, const std::string& key);
  std::vector<double> repeated(const Tree& tree, const std::vector<double>& decade, const std::string& name);
  void read_origin(const Tree& tree, const std::vector<double>& listed, Series& series);

  Credit read_credit(const Tree& tree, const std::string& row);
  std::string text_of(const Tree& table, std::string_view key, const std::string& row, bool needed = false);
  Texts texts(const Tree& tree, const std::string& key);
  Texts sources(const Tree& tree, const std::string& key);
  std::vector<double> numbers(const Tree& tree, const std::string& key);
  void check_keys(const Tree& table, const Texts& known, const std::string& row);
  void complain(const Place& place, std::string key, Message message, Message hint = {});

  Library& library_;
  std::vector<Issue>& issues_;
  std::vector<Cited> cited_;
};

}  // namespace loadpath::table
