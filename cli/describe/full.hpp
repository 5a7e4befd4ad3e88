// All that the program knows of a calculator: every field, rule, result, failure mode and source, and its example.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli {

using Rows = std::vector<std::vector<std::string>>;

std::string joined(const std::vector<std::string>& words);

/// Rows for fields and all that they hold: path behind `prefix`, type, what it is where nobody gives it, meaning.
void add_fields(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows);
/// The rows of all fields of a type, under a title.
void show_type(const char* title, const RecordType& type);

/// What assesses a failure mode, or what to do so that something does.
std::string assessor_of(const ModeInfo& mode);

void show_in_full(const Calculator& calculator);

/// What can be asked for alone: "inputs", "modes".
std::vector<std::string> part_names();
/// False where there is no part of that name.
bool show_part(const Calculator& calculator, std::string_view name);

}  // namespace loadpath::cli
