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

}  // namespace loadpath::project
