// Look-ups in the tables that are built into the program.
#pragma once

#include "lib/table/table.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

/// The tables built into the program, read at first use.
const Library& built_in();

/// A row of them; only the necessary part of the tables is read, also by the functions below.
Outcome<Entry> find_row(std::string_view group, std::string_view name);

/// The tables of a group, in order; reads only these.
std::vector<const Table*> tables_of(std::string_view group);
/// Likewise the table of a name ("sections/ipe"), or all of a folder ("sections").
std::vector<const Table*> tables_in(std::string_view name);
/// The first of them, null if there is none; the others are not read.
const Table* first_table_in(std::string_view name);

Outcome<const Series*> find_series(std::string_view name);
/// Null if there is none; then nothing else is read to say so.
const Series* series_named(std::string_view name);

/// The bibliographic entry of a key; empty if there is none.
std::string citation(std::string_view key);

}  // namespace loadpath::table
