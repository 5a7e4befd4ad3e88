#include "lib/project/run/evaluation/searched_rules.hpp"

#include <algorithm>
#include <string>

namespace loadpath::project {

bool concerns_search(const PreparedStep& step, std::size_t rule) {
  const Search& wanted = step.searches().front();
  if (wanted.leaf && wanted.leaf.field->is_load) return true;
  if (wanted.leaf) return step.is_about(rule, wanted.path);
  const Calculator& calculator = *step.input().calculator;
  const auto fields = listed_keys(calculator.rules[rule].fields);
  return std::any_of(fields.begin(), fields.end(), [&](const std::string& key) {
    const FieldInfo* const field = find_field(calculator.input->fields, key);
    return field != nullptr && field->provider.table == wanted.path;
  });
}

bool waits_for_search(const PreparedStep& step, std::size_t rule) {
  if (step.searches().empty()) return false;
  const Search& wanted = step.searches().front();
  return !(wanted.leaf && wanted.leaf.field->sought_unasked) && concerns_search(step, rule);
}

}  // namespace loadpath::project
