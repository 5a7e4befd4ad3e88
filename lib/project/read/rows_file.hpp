// A list of a project whose rows are in a separate file: over_time = { file = "pressure.csv" }.
//
// The first line names the fields, with their units in brackets: t [s], share. Cells are separated by commas,
// semicolons or tabs; text after a # is ignored.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

/// Whether this refers to a file in place of the rows.
bool names_rows_file(const toml::Tree& tree);

/// The paths of all files that a table of a project names, of rows and of histories, from where the project was read.
std::vector<std::string> files_in(const toml::Tree& table);

/// The rows, which have these fields, as they would be written in the project file. The path is relative to the
/// folder of the project.
Outcome<toml::Tree> read_rows_file(const toml::Tree& tree, std::span<const FieldInfo> fields);

}  // namespace loadpath::project
