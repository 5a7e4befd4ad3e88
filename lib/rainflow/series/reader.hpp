// Reads a series of numbers from a file of any length, part by part: one column of text, of a NumPy array, or plain
// numbers as a machine holds them.
#pragma once

#include "lib/rainflow/series/source.hpp"
#include "lib/text/issue.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace loadpath::rainflow {

/// Parts of a series in their order, each valid until the next call.
class Reader {
 public:
  Reader() = default;
  Reader(Reader&&) = delete;
  virtual ~Reader() = default;
  /// Finite numbers; none at the end. A Fault whose `at` is the line of a text, counted from 1, or the byte of a
  /// binary file, counted from 0: the message includes it too, and reading ends.
  virtual Outcome<std::span<const double>> next() = 0;
  /// The heading of the column, or of the row: "F [N]"; empty where nothing does.
  [[nodiscard]] virtual std::string_view heading() const { return {}; }
};

enum class Format {
  csv,  // lines of columns; .csv, .tsv, .txt, .dat
  npy,  // NumPy's array of float64 or float32, little-endian, in C order, of one dimension or two; .npy
  f64,  // little-endian, one after the other; .f64
  f32,
};

struct Form {
  Format format = Format::csv;
  /// Its name in the header, with its unit or without, or its number, counted from 1; empty: the only one.
  std::string column;
  /// Between columns: ',', ';', a tab, or a blank for any number of blanks and tabs; none: derived from the first
  /// line with numbers or names, a tab before a semicolon before a comma before blanks.
  std::optional<char> separator;
  /// First character of a line of comment.
  char comment = '#';
  /// In place of a column: the line whose first field is this name, or the line of this number. Text only.
  std::string row = {};
};

}  // namespace loadpath::rainflow
