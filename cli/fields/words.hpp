// A field of a calculator in words: its type or unit, its range, its default.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <string>

namespace loadpath::cli {

/// "must be > 0 mm"; empty if every value is taken.
std::string bounds_of(const FieldInfo& field);
/// The words of a choice: "mild | hard".
std::string words_of(const FieldInfo& field);
/// "default 1", "required", "optional", "from material", of a field of a blank record.
std::string default_of(const FieldInfo& field, void* owner);
/// The object found by "?", unless it is a size of a stock.
std::string searched_of(const FieldInfo& field);
/// "list, at most 12"
std::string list_of(const FieldInfo& field);
/// The unit, or its replacement: "mm", "whole number", "mild | hard".
std::string type_of(const FieldInfo& field);

}  // namespace loadpath::cli
