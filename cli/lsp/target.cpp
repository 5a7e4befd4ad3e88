#include "cli/lsp/target.hpp"

#include "calculators/catalogue.hpp"

#include <algorithm>
#include <charconv>

namespace loadpath::cli::lsp {

namespace {

using Type = FieldInfo::Type;

bool is_number_of_element(std::string_view part) { return part.starts_with('['); }

std::size_t number_in(std::string_view part) {
  std::size_t number = 0;
  std::from_chars(part.data() + 1, part.data() + part.size(), number);
  return number;
}

/// Goes down from the step by the parts of a path.
class Walk {
 public:
  explicit Walk(Target& target) : target_(target) {}

  void run(const Path& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!step(path[i])) return forget();
    }
    target_.is_list = awaits_element_;
    if (awaits_element_ || target_.field == nullptr || !target_.field->has_fields()) target_.inner = nullptr;
  }

 private:
  bool step(const std::string& part) {
    const FieldInfo* const field = target_.field;
    if (field == nullptr) return is_number_of_element(part) ? false : top(part);
    if (awaits_element_) return element(part);
    if (!field->has_fields()) return true;  // a range, a list of values: still of this field
    if (is_number_of_element(part)) return positional(number_in(part));
    return enter(find_field(field->fields, part), target_.inner);
  }

  bool top(const std::string& part) {
    if (enter(find_input(target_.calculator->input->fields, part), target_.input.data.get())) return true;
    return target_.from != nullptr &&
           enter(find_field(target_.from->parameters->fields, part), target_.parameters.data.get());
  }

  bool enter(const FieldInfo* field, void* owner) {
    if (field == nullptr) return false;
    target_.field = field;
    target_.owner = owner;
    awaits_element_ = field->type == Type::list;
    target_.inner = field->type == Type::group ? field->element(owner, 0) : nullptr;
    if (awaits_element_) target_.inner = field->push(owner);
    return true;
  }

  /// An element by its number or its name.
  bool element(const std::string& part) {
    const FieldInfo& list = *target_.field;
    awaits_element_ = false;
    if (is_number_of_element(part) || find_field(list.fields, "name") != nullptr) return true;
    return list.positional || part == "file";
  }

  /// The n-th value of an element that is written as an array.
  bool positional(std::size_t number) {
    if (!target_.field->positional) return true;
    std::size_t at = 0;
    for (const FieldInfo& inner : target_.field->fields) {
      if (std::string_view(inner.key) == "name") continue;
      if (at++ == number) return enter(&inner, target_.inner);
    }
    return false;
  }

  void forget() {
    target_.field = nullptr;
    target_.owner = target_.inner = nullptr;
    target_.is_list = false;
  }

  Target& target_;
  bool awaits_element_ = false;
};

std::string text_of(const Outline& outline, std::string_view text, const Path& path) {
  const Item* const item = outline.find(path);
  return item == nullptr ? "" : std::string(item->in(text));
}

}  // namespace

const Calculator* calculator_of(const Outline& outline, std::string_view text, const std::string& step) {
  return find_calculator(calculators(), text_of(outline, text, {step, "calculator"}));
}

Target target_of(const Outline& outline, std::string_view text, const Path& path) {
  Target target;
  if (path.empty()) return target;
  target.calculator = calculator_of(outline, text, path[0]);
  if (target.calculator == nullptr) return target;
  target.from = find_template(*target.calculator, text_of(outline, text, {path[0], "template"}));
  target.input = Record(*target.calculator->input);
  if (target.from != nullptr) target.parameters = Record(*target.from->parameters);
  if (path.size() == 1) return target;
  const auto groups = table_groups(*target.calculator);
  if (std::find(groups.begin(), groups.end(), path[1]) != groups.end()) target.group = path[1];
  target.in_accept = path[1] == "accept";
  target.in_because = path[1] == "because";
  Walk(target).run(path);
  return target;
}

std::vector<StepKey> general_keys(const Calculator& calculator) {
  std::vector<StepKey> keys{{"calculator", "calculator"}};
  if (!calculator.templates.empty()) keys.push_back({"template", "a standard mechanism, by its parameters"});
  for (const std::string& group : table_groups(calculator))
    keys.push_back({group, "a row of `loadpath tables`, or of [tables." + group + "s] in the file"});
  keys.push_back({"title", "for the report"});
  keys.push_back({"note", "for the report"});
  if (calculator.result != nullptr) keys.push_back({"display", "units of results"});
  if (!calculator.modes.empty()) keys.push_back({"accept", "failure modes accepted by the user, with the reason"});
  if (calculator.result != nullptr)
    keys.push_back({"because", "reason why a typed value is more favourable than its row or record"});
  return keys;
}

}  // namespace loadpath::cli::lsp
