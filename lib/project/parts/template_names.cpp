#include "lib/project/parts/template_names.hpp"

#include <algorithm>
#include <sstream>

namespace loadpath::project {

namespace {

/// The words of an id in alphabetical order: "crank slider".
std::vector<std::string> sorted_words(const std::string& id) {
  std::vector<std::string> words;
  std::istringstream stream(id);
  for (std::string word; std::getline(stream, word, '_');) words.push_back(word);
  std::sort(words.begin(), words.end());
  return words;
}

/// The nearest id, or that of the same words in another order; empty if there is none.
std::string nearest_id(const std::string& id, const std::vector<std::string>& ids) {
  const auto same = std::find_if(ids.begin(), ids.end(),
                                 [words = sorted_words(id)](const auto& one) { return sorted_words(one) == words; });
  return same != ids.end() ? *same : nearest(id, ids);
}

std::vector<std::string> ids_of(const Calculator& calculator) {
  std::vector<std::string> ids;
  for (const Template* t : calculator.templates) ids.emplace_back(t->id);
  return ids;
}

/// "slider_crank, four_bar": those with a parameter of this key; empty if none has.
std::string templates_with(const Calculator& calculator, std::string_view key) {
  std::string ids;
  for (const Template* t : calculator.templates) {
    if (find_input(t->parameters->fields, key) != nullptr) ids += (ids.empty() ? "" : ", ") + std::string(t->id);
  }
  return ids;
}

bool is_fault_of(const Issue& issue, const std::string& step, KeyFault fault) {
  return issue.key_fault == fault && issue.key.starts_with(step);
}

}  // namespace

Message template_near(const std::string& id, const std::vector<std::string>& ids) {
  const std::string near = nearest_id(id, ids);
  return near.empty() ? there_is(ids) : say("did you mean '{1}'?", near);
}

Message template_meant(const std::string& id, Catalogue catalogue) {
  const std::size_t point = id.find('.');
  if (point == std::string::npos) return {};
  for (const CatalogueEntry& entry : catalogue) {
    const Calculator& calculator = *entry.calculator;
    if (calculator.element() != std::string_view(id).substr(0, point)) continue;
    const std::string near = nearest_id(id.substr(point + 1), ids_of(calculator));
    if (!near.empty()) return say("a template: write calculator = \"{1}\" and template = \"{2}\"", calculator.id, near);
  }
  return {};
}

void name_templates(const StepInput& input, std::size_t before, std::vector<Issue>& issues) {
  if (input.from != nullptr) return;
  const auto begin = issues.begin() + static_cast<std::ptrdiff_t>(before);
  const std::string step = input.name + ".";
  const auto is_parameter = [&](const Issue& issue) {
    return is_fault_of(issue, step, KeyFault::unknown) &&
           !templates_with(*input.calculator, issue.key.substr(step.size())).empty();
  };
  const auto first = std::find_if(begin, issues.end(), is_parameter);
  if (first == issues.end()) return;
  Issue named = *first;
  const std::string key = named.key.substr(step.size());
  named.message = say("'{1}' is a parameter of templates, and no template is named", key);
  named.hint = say("write template = \"...\" with one of {1}", templates_with(*input.calculator, key));
  const auto follows = [&](const Issue& one) { return is_parameter(one) || is_fault_of(one, step, KeyFault::missing); };
  issues.erase(std::remove_if(begin, issues.end(), follows), issues.end());
  issues.push_back(std::move(named));
}

}  // namespace loadpath::project
