// Complete objects taken from other steps: words, lists, rows of tables.
#include "lib/project/run/evaluation/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::project {

namespace {

/// Splits "[2].R" or ".pump.R" into the element and the rest.
std::pair<std::string, std::string> split_element(const std::string& path) {
  const std::size_t end = path.starts_with('[') ? path.find(']') + 1 : path.find('.', 1);
  return {path.substr(0, end), path.substr(std::min(end + 1, path.size()))};
}

/// ".pump": the name of a new element, where it has one.
void name_element(const FieldInfo& list, void* element, const std::string& here) {
  const FieldInfo* const name = find_field(list.fields, "name");
  if (name != nullptr && name->type == FieldInfo::Type::name && here.starts_with('.'))
    name->set_text(element, std::string_view(here).substr(1));
}

/// The message for a missing value of the other step.
Message unavailable(const Taken& taken) { return say("'{1}' is not available: {2}", taken.path, taken.source); }

/// "[1], [2]" or "left, right": the elements of a list of another step.
std::string elements_in(const Known& known, const std::string& list) {
  std::string names, last;
  for (const auto& [behind, entry] : known.within(list)) {
    const std::string here = split_element(behind).first;
    if (here == last) continue;
    last = here;
    names += (names.empty() ? "" : ", ") + (here.starts_with('.') ? here.substr(1) : here);
  }
  return names;
}

/// Where a path names an element that the list of a solved step does not have, "shaft.bearings.left": the element.
struct MissingElement {
  std::string list, name;
  std::string available;  // "left, right"
  [[nodiscard]] Message text() const { return say("'{1}' has no '{2}'; available: {3}", list, name, available); }
};

std::optional<MissingElement> missing_element(const Known& known, const std::string& element) {
  const std::size_t dot = element.rfind('.');
  const std::string list = element.substr(0, dot), name = element.substr(dot + 1);
  if (list.find('.') == std::string::npos || !known.within(element).empty()) return std::nullopt;
  std::string elements = elements_in(known, list);
  if (elements.empty()) return std::nullopt;
  return MissingElement{list, name, std::move(elements)};
}

/// A record of an element that does not exist; nothing if it does.
std::optional<Issue> missing_record(const Known& known, const std::string& step, const Taken& record) {
  const auto missing = missing_element(known, record.source);
  if (!missing) return std::nullopt;
  const bool has_names = !missing->available.starts_with('[');
  return Issue{place_in(record.place, record.source, missing->list.size() + 1, missing->name.size()),
               step + "." + record.path, missing->text(),
               has_names ? Message{}
                         : say("write \"={1}[1]\", or name the elements: name = \"{2}\"", missing->list, missing->name),
               Severity::error};
}

Issue refused_length(const std::string& step, const Taken& taken) {
  return {place_in(taken.place, taken.source, 0, taken.source.size()),
          step + "." + taken.path,
          say("at most {1} {2}; '{3}' has more", std::to_string(taken.field->capacity), taken.field->key, taken.source),
          {},
          Severity::error};
}

}  // namespace

bool Inputs::take_from_others(std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  for (const Taken& taken : step_.input().reading.taken) {
    if (taken.field != nullptr && taken.field->type == FieldInfo::Type::list)
      take_list(taken, issues);
    else
      take_word(taken, issues);
  }
  for (const Varied& varied : step_.input().reading.varied) {
    if (!varied.leaf) take_row(varied.path, varied.words[varied.at], issues);
  }
  return issues.size() == before;
}

/// A record without any value comes from a step without results; the step then has no results either, instead of
/// violated rules.
bool Inputs::find_records(const std::set<std::string>& left_open, std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  const auto& reading = step_.input().reading;
  const auto has_number = [&](const std::string& path) {
    const ComputedInput* const input = find_computed(path);
    return input != nullptr &&
           std::any_of(input->value.si.begin(), input->value.si.end(), [](double x) { return !std::isnan(x); });
  };
  for (const Taken& record : reading.records) {
    const std::string within = record.source + ".";
    bool has_any = false, has_value = false;
    for (const Operand& operand : reading.operands) {
      if (!operand.of_record || !operand.text.starts_with(within)) continue;
      has_any = true;
      has_value = has_value || left_open.contains(operand.path) || has_number(operand.path);
    }
    if (!has_any || has_value) continue;
    if (auto missing = missing_record(known_, step_.name(), record))
      issues.push_back(std::move(*missing));
    else
      set_unavailable(say("'{1}' is not available: {2}", record.path, record.source));
  }
  return issues.size() == before;
}

/// A value of an element that a solved step turns out not to have, "filled.states.service.sigma_2i".
bool Inputs::has_elements(const Operand& operand, std::vector<Issue>& issues) const {
  for (const auto& reference : operand.expression.references()) {
    const std::size_t list = reference.path.find('.'), element = reference.path.find('.', list + 1);
    const std::size_t key = element == std::string::npos ? element : reference.path.find('.', element + 1);
    if (key == std::string::npos) continue;
    const auto missing = missing_element(known_, reference.path.substr(0, key));
    if (!missing) continue;
    issues.push_back({place_in(operand.place, operand.text, reference.at + element + 1, missing->name.size()),
                      step_.name() + "." + operand.path,
                      missing->text(),
                      {},
                      Severity::error});
    return false;
  }
  return true;
}

void Inputs::take_word(const Taken& taken, std::vector<Issue>& issues) {
  const std::string word = known_.word(taken.source);
  if (word.empty()) {
    if (!taken.may_be_incomplete) set_unavailable(unavailable(taken));
    return;
  }
  const auto refuse = [&](Message message) {
    issues.push_back({place_in(taken.place, taken.source, 0, taken.source.size()),
                      step_.name() + "." + taken.path,
                      std::move(message),
                      {},
                      Severity::error});
  };
  if (taken.field == nullptr) {
    std::vector<Issue> found;
    take_row(taken.path, word, found);
    if (!found.empty()) refuse(say("{1} = {2}: {3}", taken.source, word, found.front().message));
  } else if (!set_word(leaf(taken.path), word)) {
    refuse(say("{1} = {2} is not a choice of '{3}'", taken.source, word, taken.path));
  }
  origins_[taken.path] = {say("= {1}", taken.source), {}, false};
}

/// Elements by number or name, leaves by their keys; a series stays one. All elements exist before a leaf of one is
/// kept.
void Inputs::take_list(const Taken& taken, std::vector<Issue>& issues) {
  void* const owner = find_member(record_.type->fields, record_.data.get(), taken.path).owner;
  const auto given = known_.within(taken.source);
  std::vector<std::string> elements;
  for (const auto& [behind, entry] : given) {
    const std::string here = split_element(behind).first;
    if (!elements.empty() && elements.back() == here) continue;
    if (elements.size() == taken.field->capacity) return issues.push_back(refused_length(step_.name(), taken));
    elements.push_back(here);
    name_element(*taken.field, taken.field->push(owner), here);
  }
  if (elements.empty()) return set_unavailable(unavailable(taken));
  std::size_t element = 0;
  for (const auto& [behind, entry] : given) {
    const auto [here, key] = split_element(behind);
    if (here != elements[element]) ++element;
    const std::string path = taken.path + element_path(*taken.field, owner, element) + "." + key;
    const Leaf member = leaf(path);
    if (!member || member.field->role != Role::input) continue;
    if (member.field->is_word()) set_word(member, entry->word);
    if (member.field->is_number() && !entry->values().si.empty())
      add_computed({path, member, entry->values(), {say("= {1}", taken.source + behind), {}, false}});
  }
}

}  // namespace loadpath::project
