// The cells of a line of a text with columns, as series and lists of rows are read from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::rainflow {

inline constexpr char blanks = ' ';  // as a separator: any number of blanks and tabs

bool is_blank(char c);
/// Without blanks around it, and without the quotes of a field.
std::string_view trimmed(std::string_view text);
/// Takes the first field off a line; a separator within "" is none.
std::string_view take_field(std::string_view& line, char separator);
std::vector<std::string> fields_of(std::string_view line, char separator);
/// What parts the fields of a line: a tab before a semicolon before a comma before blanks.
char separator_of(std::string_view line);
/// All of the text as a finite number; with a decimal comma where a comma does not part fields.
std::optional<double> number_of(std::string_view text, char separator);

/// "t [s]" or "t (s)"; the unit is empty where none is named, and of "[-]" and "[1]".
struct Heading {
  std::string name, unit;
};
Heading heading_of(std::string_view text);

}  // namespace loadpath::rainflow
