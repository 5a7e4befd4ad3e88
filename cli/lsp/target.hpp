// The subject of a key of a project file: the calculator of its step, and the field.
#pragma once

#include "cli/lsp/text/outline.hpp"
#include "lib/calculator/calculator.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// A key of a step other than a field of its calculator.
struct StepKey {
  std::string key;
  std::string meaning;
};

/// The blank records are kept: they show the fields that exist, and those that need a value.
struct Target {
  const Calculator* calculator = nullptr;
  const Template* from = nullptr;
  Record input, parameters;
  const FieldInfo* field = nullptr;  // null: the step itself, or a key without a field
  void* owner = nullptr;             // aggregate with the field
  void* inner = nullptr;             // aggregate with the fields of a table or of an element; null elsewhere
  std::string group;                 // table group of a key that names a row: "material"
  bool in_accept = false;            // accept.MODE
  bool in_because = false;           // because.KEY
  bool is_list = false;              // the list itself, not an element of it
};

/// The target at the path of a key or a value, or of a table within a step; without calculator if the step has none.
Target target_of(const Outline& outline, std::string_view text, const Path& path);

const Calculator* calculator_of(const Outline& outline, std::string_view text, const std::string& step);

/// The keys of a step other than fields.
std::vector<StepKey> general_keys(const Calculator& calculator);

}  // namespace loadpath::cli::lsp
