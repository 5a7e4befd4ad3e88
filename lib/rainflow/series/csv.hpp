// One column of a text of lines and columns.
#pragma once

#include "lib/rainflow/series/reader.hpp"

#include <memory>

namespace loadpath::rainflow {

/// Decimal points, or commas where a comma does not part columns; CR LF or LF, a byte order mark, lines of comment and
/// empty lines wherever they are; the first other line is a header where the column is asked for by name, or where
/// there is no number in it. Names and numbers may be in `"`. A line is at most a mebibyte.
Outcome<std::unique_ptr<Reader>> read_csv(std::unique_ptr<Source> source, const Form& form);

}  // namespace loadpath::rainflow
