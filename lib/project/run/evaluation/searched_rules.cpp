#include "lib/project/run/evaluation/searched_rules.hpp"

#include <algorithm>
#include <string>

namespace loadpath::project {

namespace {

bool concerns(const PreparedStep& step, const Search& wanted, std::size_t rule) {
  if (wanted.leaf && wanted.leaf.field->is_load) return true;
  if (wanted.leaf || step.seeks_name(wanted)) return step.is_about(rule, wanted.path);
  const Calculator& calculator = *step.input().calculator;
  const auto fields = listed_keys(calculator.rules[rule].fields);
  return std::any_of(fields.begin(), fields.end(), [&](const std::string& key) {
    const FieldInfo* const field = find_field(calculator.input->fields, key);
    return field != nullptr && field->provider.table == wanted.path;
  });
}

}  // namespace

namespace {

/// Whether all that a rule compares with the searched input are values of a row.
bool is_of_standard(const PreparedStep& step, const Search& wanted, std::size_t rule) {
  const Calculator& calculator = *step.input().calculator;
  const auto fields = listed_keys(calculator.rules[rule].fields);
  const auto is_given = [&](const std::string& key) {
    const FieldInfo* const field = find_field(calculator.input->fields, key);
    return key == wanted.path || (field != nullptr && field->provider.kind == Provider::Kind::table);
  };
  return wanted.leaf && fields.size() > 1 && std::find(fields.begin(), fields.end(), wanted.path) != fields.end() &&
         std::all_of(fields.begin(), fields.end(), is_given);
}

}  // namespace

bool must_hold_in_search(const PreparedStep& step, std::size_t rule) {
  if (!step.input().calculator->rules[rule].only_warns) return concerns_search(step, rule);
  const auto& all = step.searches();
  return std::any_of(all.begin(), all.end(), [&](const Search& search) { return is_of_standard(step, search, rule); });
}

bool concerns_search(const PreparedStep& step, std::size_t rule) {
  const auto& all = step.searches();
  return std::any_of(all.begin(), all.end(), [&](const Search& search) { return concerns(step, search, rule); });
}

bool waits_for_search(const PreparedStep& step, std::size_t rule) {
  const auto& all = step.searches();
  return std::any_of(all.begin(), all.end(), [&](const Search& search) {
    return !(search.leaf && search.leaf.field->sought_unasked) && concerns(step, search, rule);
  });
}

}  // namespace loadpath::project
