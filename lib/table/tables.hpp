// The tables that a project uses: its own rows and series first, then the built-in ones.
#pragma once

#include "lib/table/table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

class Tables {
 public:
  Tables() = default;  // only the built-in ones `groups`: those whose rows can be named.
  Tables(Library own, std::vector<std::string> groups) : own_(std::move(own)), groups_(std::move(groups)) {}

  [[nodiscard]] Outcome<Entry> find_row(std::string_view group, std::string_view name) const;
  [[nodiscard]] Outcome<const Series*> find_series(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> series_names() const;
  [[nodiscard]] bool has_own_rows() const { return !own_.tables.empty(); }
  /// Whether a row of the project answers to the name.
  [[nodiscard]] bool is_own(std::string_view group, std::string_view name) const;

  /// The rows of a group, of one of its tables ("sections/ipe") or of one kind, ascending by their ordering column
  /// (`order_of`); rows without it are left out.
  [[nodiscard]] std::vector<Entry> ordered_rows(std::string_view group, std::string_view within) const;
  /// Those of them that hold a condition of lib/table/search.hpp, "d = 40 mm"; a Fault of its text.
  [[nodiscard]] Outcome<std::vector<Entry>> ordered_rows(std::string_view group, std::string_view within,
                                                         std::string_view where) const;
  /// The tables of a group: "sections/ipe".
  [[nodiscard]] std::vector<std::string> names_of(std::string_view group) const;

  struct Referred {
    Property value;
    Dimension dimension;
  };
  /// The value that an expression names, "tables.sections.\"IPE 330\".I_y"; a Fault if there is none, or where it
  /// depends on the size.
  [[nodiscard]] Outcome<Referred> value_at(std::string_view path) const;

 private:
  [[nodiscard]] std::vector<const Table*> all_of(std::string_view group) const;

  Library own_;
  std::vector<std::string> groups_;
};

/// The property by which the rows of a group are small or large, so that one can be searched for: the area of a
/// section, the pitch of a chain. Empty if they have no such order.
std::string_view order_of(std::string_view group);

/// The group of a word of `[tables]`, which is its plural too: "materials", "material". Empty if it is none of them.
std::string group_of(std::string_view word, const std::vector<std::string>& groups);

/// The tables of a group as one: the columns of its rows, and the column with their sizes.
Table columns_of(std::string_view group);

/// The origin of a value, in words for the report: "P265GH", with the table if it is one of the project's own.
Message named_source(const std::string& row, const Property& property);
Message named_source(Message chosen, const Series& series);

}  // namespace loadpath::table
