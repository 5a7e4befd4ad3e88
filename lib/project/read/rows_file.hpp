// A list of a project whose rows are in a file next to it: over_time = { file = "pressure.csv" }.
//
// The first line names the fields, with their units in brackets: t [s], share; or columns = { t = "time", share = 3 }
// assigns columns to fields, by its name or its number. Cells are parted by tabs, semicolons, commas or blanks;
// where a comma does not part them it may stand for a decimal point. What follows a # is left out. An error is
// reported once, with the line of the file.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

/// Whether this replaces the rows themselves.
bool names_rows_file(const toml::Tree& tree);

/// The paths of all files that a table of a project names, of rows and of histories, from where the project was read.
std::vector<std::string> files_in(const toml::Tree& table);

/// The rows, which have these fields, as they would be in the project file, each value with its place in its own.
/// The path is taken from the folder of the project.
/// None, and an issue, where something is wrong.
std::optional<toml::Tree> read_rows_file(const toml::Tree& tree, std::span<const FieldInfo> fields, Issue& wrong);

}  // namespace loadpath::project
