// Rows that are written as lines, read without a parser of TOML: the tables of sections have 14,000 values, and a
// look-up needs them at once.
//
//   rows = [
//     ["HEA 100", ["HE 100 A"], 96, 100, 5.5],
//   ]
//
// Only this form is read here. Other TOML (comments, escapes, several lines for a row) and errors are left to the
// parser, which reports the place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

/// A value of a line, in the text that it was read from.
struct Cell {
  enum class Type { text, number, texts };
  Type type = Type::text;
  std::string_view text;  // text: without its quotes; texts: with brackets
  double number = 0.0;
};

struct Lines {
  std::string rest;  // the text with as many empty lines in their place
  std::vector<std::string_view> lines;
};

/// Nothing if the text has no rows of this form.
std::optional<Lines> cut_lines(std::string_view text);

/// The cells of an array on one line; false if it is not of this form. `cells` is used again and again.
bool read_line(std::string_view line, std::vector<Cell>& cells);

/// The texts of such a cell: ["HE 100 A", "HEA100"].
bool read_texts(const Cell& cell, std::vector<std::string>& texts);

/// The value of a line KEY = "text", or of one with the key in quotes, as the file has it; nothing if there is no
/// such line, or its text has escapes.
std::optional<std::string_view> plain_text(std::string_view file, std::string_view key);

}  // namespace loadpath::table
