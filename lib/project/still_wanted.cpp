#include "lib/project/still_wanted.hpp"

#include <algorithm>

namespace loadpath::project {

std::string still_wanted(const Step& step, const char* wants) {
  const StepInput& input = step.input();
  const auto is_given = [&](const std::string& key) {
    const auto& operands = input.reading.operands;
    const bool referred =
        std::any_of(operands.begin(), operands.end(), [&](const Operand& operand) { return operand.path == key; });
    const FieldInfo* const field = find_field(input.calculator->input->fields, key);
    const bool of_row = field != nullptr && input.rows.contains(field->provider.table);
    return referred || of_row || input.reading.typed.contains(key);
  };
  std::string left;
  for (const std::string& key : listed_keys(wants)) {
    if (!is_given(key)) left += (left.empty() ? "" : ", ") + key;
  }
  return left;
}

std::string wanted_by_limits(const Step& step, const ModeInfo& mode) {
  std::string wants;
  if (step.input().calculator->result == nullptr) return wants;  // a mechanism declares its results itself
  if (*mode.advice != '\0' || *mode.request != '\0' || *mode.judge != '\0') return wants;
  for (const std::string& key : listed_keys(mode.checks)) {
    const FieldInfo* const limit = find_field(step.input().calculator->result->fields, key);
    if (limit == nullptr || limit->role != Role::limit || *limit->asked_by == '\0') continue;
    const bool is_known = wants.find(limit->asked_by) != std::string::npos;
    if (is_known || still_wanted(step, limit->asked_by) != limit->asked_by) continue;
    wants += (wants.empty() ? "" : ", ") + std::string(limit->asked_by);
  }
  return wants;
}

}  // namespace loadpath::project
