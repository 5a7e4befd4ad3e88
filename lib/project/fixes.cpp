#include "lib/project/fixes.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// The input of a calculator that takes a record: the one of its name, or the one that its name ends with, "mesh" of
/// "sun_mesh", or the first.
const FieldInfo* input_for(const Calculator& judge, std::string_view record) {
  const FieldInfo* found = nullptr;
  for (const FieldInfo& field : judge.input->fields) {
    if (field.type != FieldInfo::Type::record) continue;
    if (field.key == record) return &field;
    if (found == nullptr || record.ends_with(field.key)) found = &field;
  }
  return found;
}

/// The record that the mode leaves to the calculator; else one of the step that the calculator has an input for.
std::string record_for(const Step& step, const ModeInfo& info, const Calculator& judge) {
  if (step.input().calculator->result == nullptr) return {};
  const std::string taken = std::string(info.taken).substr(0, std::string_view(info.taken).find('.'));
  for (const FieldInfo& field : step.input().calculator->result->fields) {
    const bool is_record = field.type == FieldInfo::Type::group && field.is_handed_over;
    if (is_record && (taken.empty() ? find_field(judge.input->fields, field.key) != nullptr : field.key == taken))
      return std::string(field.key);
  }
  return {};
}

std::string taken_by(const Step& step, const ModeInfo& info, const Calculator& judge) {
  const std::string record = record_for(step, info, judge);
  const FieldInfo* const input = record.empty() ? nullptr : input_for(judge, record);
  return input == nullptr ? "" : std::string(input->key) + " = \"=" + step.name() + "." + record + "\"";
}

/// "=key1.notch", for an element of a list there; empty if the mode leaves no record of its own.
std::string record_path(const Step& step, const ModeInfo& info) {
  const std::string key = std::string(info.taken).substr(0, std::string_view(info.taken).find_first_of(".,"));
  const RecordType* const result = step.input().calculator->result;
  const FieldInfo* const field = key.empty() || result == nullptr ? nullptr : find_field(result->fields, key);
  const bool is_record = field != nullptr && field->type == FieldInfo::Type::group && field->is_handed_over;
  return is_record ? "=" + step.name() + "." + key : "";
}

}  // namespace

void name_fixes(Project& project) {
  for (const auto& step : project.steps) {
    for (account::Mode& mode : step->modes()) {
      const std::string id = mode.judge.empty() ? mode.add : mode.judge;
      const CatalogueEntry* const entry = id.empty() ? nullptr : find_entry(project.catalogue, id);
      const auto& infos = step->input().calculator->modes;
      const auto info = std::ranges::find_if(infos, [&](const ModeInfo& i) { return mode.id == i.id; });
      if (entry != nullptr && info != infos.end()) mode.takes = taken_by(*step, *info, *entry->calculator);
      if (entry != nullptr && info != infos.end() && mode.takes.empty()) mode.takes = record_path(*step, *info);
    }
  }
}

}  // namespace loadpath::project
