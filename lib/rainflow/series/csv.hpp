// One column of a text of lines and columns.
#pragma once

#include "lib/rainflow/series/reader.hpp"

#include <memory>

namespace loadpath::rainflow {

/// Decimal points, CR LF or LF, a byte order mark, lines of comment and empty lines anywhere; the first other line is
/// a header if the column is selected by name, or if it contains no number. `"` may enclose names and numbers. A line
/// is at most a mebibyte.
Outcome<std::unique_ptr<Reader>> read_csv(std::unique_ptr<Source> source, const Form& form);

}  // namespace loadpath::rainflow
