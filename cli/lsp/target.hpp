// What a key of a project file is about: the calculator of its step, and the field.
#pragma once

#include "cli/lsp/text/outline.hpp"
#include "lib/calculator/calculator.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// A key of a step that is no field of its calculator.
struct StepKey {
  std::string key;
  std::string meaning;
};

/// The blank records are kept: what fields there are, and which need a value, is asked of them.
struct Target {
  const Calculator* calculator = nullptr;
  const Template* from = nullptr;
  Record input, parameters;
  const FieldInfo* field = nullptr;  // null: the step itself, or what is no field
  void* owner = nullptr;             // that holds the field
  void* inner = nullptr;             // that holds the fields of a table or of an element; null elsewhere
  std::string group;                 // of the row that the key names: "material"
  bool in_accept = false;            // accept.MODE
  bool in_because = false;           // because.KEY
  bool is_list = false;              // the list itself, not an element of it
};

/// Of the path of a key or a value, or of a table within a step; without calculator where the step has none.
Target target_of(const Outline& outline, std::string_view text, const Path& path);

const Calculator* calculator_of(const Outline& outline, std::string_view text, const std::string& step);

/// The keys of a step beside the fields.
std::vector<StepKey> keys_beside(const Calculator& calculator);

}  // namespace loadpath::cli::lsp
