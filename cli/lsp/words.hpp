// Values, units and the meanings of names, as an editor shows them.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli::lsp {

/// "12.5 mm"; of a series its ends, "-3.2 to 8 kN". In a readable unit where none is given.
std::string text_of(const Value& value, std::string_view unit = {});

/// The units that a quantity may be written in, the field's own first.
std::vector<std::string> units_for(const Expected& expected);

/// "30 mm = 0.03 m = 1.1811 in"
std::string in_units(double si, const Expected& expected);

/// The value of an expression, without its `=`, in a project that is solved; a word, where it names one; else empty.
std::string value_of(project::Project& project, std::string_view expression, std::string_view unit = {});

/// The text for a path of another step: its meaning and value. Empty if it is unknown.
std::string meaning_of(project::Project& project, const std::string& path);

/// The tables for rows and stocks: the project's own with the built-in ones.
const table::Tables& tables_of(const OpenFile& file);

/// The rows of the file's own, of a group: [tables.materials.NAME].
std::vector<std::string> own_rows(const OpenFile& file, const std::string& group);

/// The words of [tables] that a group has: "material", "materials".
bool is_of_group(std::string_view word, const std::string& group);

}  // namespace loadpath::cli::lsp
