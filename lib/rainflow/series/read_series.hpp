// Opens a series of numbers in a file of any of the forms.
#pragma once

#include "lib/rainflow/series/reader.hpp"

#include <memory>
#include <optional>
#include <string_view>

namespace loadpath::rainflow {

/// The format that the end of a file's name says; none if it says nothing.
std::optional<Format> format_of(std::string_view path);

/// A Fault if the start of the file is not of that form, or the column is not there.
Outcome<std::unique_ptr<Reader>> read_series(std::unique_ptr<Source> source, const Form& form);

}  // namespace loadpath::rainflow
