#include "lib/calculator/calculator.hpp"

#include <algorithm>

namespace loadpath {

const Calculator* find_calculator(Calculators calculators, std::string_view id) {
  const auto found =
      std::find_if(calculators.begin(), calculators.end(), [&](const Calculator* c) { return c->id == id; });
  return found == calculators.end() ? nullptr : *found;
}

const Template* find_template(const Calculator& calculator, std::string_view id) {
  const auto& all = calculator.templates;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Template* t) { return t->id == id; });
  return found == all.end() ? nullptr : *found;
}

std::vector<std::string> table_groups(const Calculator& calculator) {
  std::vector<std::string> groups;
  for (const FieldInfo& field : calculator.input->fields) {
    if (field.provider.kind != Provider::Kind::table) continue;
    if (std::find(groups.begin(), groups.end(), field.provider.table) != groups.end()) continue;
    groups.emplace_back(field.provider.table);
  }
  return groups;
}

}  // namespace loadpath
