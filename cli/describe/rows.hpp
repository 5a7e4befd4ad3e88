// Fields in rows of columns: path, type, its value if it is not given, meaning.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <span>
#include <string>
#include <vector>

namespace loadpath::cli {

using Rows = std::vector<std::vector<std::string>>;

std::string joined(const std::vector<std::string>& words);

/// Rows for fields and all that they hold: path behind `prefix`, type, its value if it is not given, meaning.
void add_fields(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows);
/// The rows of all fields of a type, under a title.
void show_type(const char* title, const RecordType& type);

}  // namespace loadpath::cli
