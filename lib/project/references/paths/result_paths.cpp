#include "lib/project/references/paths/result_paths.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

using Type = FieldInfo::Type;

const FieldInfo* name_in(const FieldInfo& list) {
  const FieldInfo* const name = list.type == Type::list ? find_field(list.fields, "name") : nullptr;
  return name != nullptr && name->type == Type::name ? name : nullptr;
}

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('.') + 1); }

/// Adds the names of the elements of a list.
void add_names(const FieldInfo& list, const StepInput& input, std::vector<std::string>& names) {
  const FieldInfo* const name = name_in(list);
  void* const data = input.reading.record.data.get();
  for (std::size_t i = 0; name != nullptr && data != nullptr && i < list.size(data); ++i) {
    const std::string_view one = name->text(list.element(data, i));
    if (!one.empty()) names.emplace_back(one);
  }
}

/// The names in a list of the input; of a result list that has no input list of its key those of all others.
std::vector<std::string> names_for(const FieldInfo& results, const StepInput& input) {
  std::vector<std::string> names;
  const auto& fields = input.calculator->input->fields;
  const bool has_own = find_field(fields, results.key) != nullptr;
  for (const FieldInfo& list : fields) {
    const bool is_its = has_own ? std::string_view(list.key) == results.key
                                : find_field(input.calculator->result->fields, list.key) == nullptr;
    if (is_its) add_names(list, input, names);
  }
  return names;
}

}  // namespace

std::vector<std::string> named_elements(const StepInput& input) {
  std::vector<std::string> paths;
  if (input.calculator->result == nullptr) return paths;
  for (const FieldInfo& list : input.calculator->result->fields) {
    if (name_in(list) == nullptr) continue;
    for (const std::string& name : names_for(list, input)) paths.push_back(std::string(list.key) + "." + name);
  }
  return paths;
}

namespace {

/// "did you mean 'shaft.pieces.seat.d' or 'shaft.seats.gear.d'?": the first members of this key, of inputs and results.
Message member_called(const StepInput& input, std::string_view key) {
  std::vector<std::string> paths;
  for (const FieldInfo& list : input.calculator->input->fields) {
    if (name_in(list) == nullptr || find_field(list.fields, key) == nullptr) continue;
    for (const std::string& name : names_for(list, input)) paths.push_back(std::string(list.key) + "." + name);
  }
  for (const std::string& element : named_elements(input)) {
    const FieldInfo* const list = find_field(input.calculator->result->fields, element.substr(0, element.find('.')));
    if (find_field(list->fields, key) != nullptr) paths.push_back(element);
  }
  if (paths.empty()) return {};
  const auto shown = [&](const std::string& element) { return input.name + "." + element + "." + std::string(key); };
  return paths.size() == 1 ? say("did you mean '{1}'?", shown(paths[0]))
                           : say("did you mean '{1}' or '{2}'?", shown(paths[0]), shown(paths[1]));
}

/// "write filled.states.NAME.KEY": of a path that ends at a list.
Message member_of(const StepInput& input, const std::string& path) {
  const FieldInfo* const list = find_field(input.calculator->result->fields, path);
  if (list == nullptr || !list->has_fields()) return {};
  if (list->type != Type::list) return say("write {1}.{2}.KEY", input.name, path);
  return name_in(*list) != nullptr ? say("write {1}.{2}.NAME.KEY", input.name, path)
                                   : say("write {1}.{2}[1].KEY", input.name, path);
}

}  // namespace

Fault unknown_path(const StepInput& input, const std::string& path) {
  std::vector<std::string> known;
  Record blank(*input.calculator->result);
  for_each_leaf(blank, [&](const std::string& leaf, const Leaf&) { known.push_back(leaf); });
  for (const FieldInfo& f : input.calculator->result->fields) {
    if (f.is_handed_over) known.emplace_back(f.key);
    for (const FieldInfo& inner : f.fields) known.push_back(std::string(f.key) + "[1]." + inner.key);
  }
  Message otherwise = member_called(input, path);
  if (otherwise.empty()) otherwise = member_of(input, path);
  if (otherwise.empty()) otherwise = say("`loadpath describe {1}` lists them", input.calculator->id);
  for (const std::string& element : named_elements(input)) {
    known.push_back(element);
    const FieldInfo* const list = find_field(input.calculator->result->fields, element.substr(0, element.find('.')));
    for (const FieldInfo& inner : list->fields) known.push_back(std::string(element).append(".").append(inner.key));
    const bool is_first = otherwise.text().find("did you mean") == std::string::npos;
    if (last_part(element) == last_part(path) && (is_first || list->is_handed_over))
      otherwise = say("did you mean '{1}.{2}'?", input.name, element);
  }
  return {0, path.size(), say("'{1}' has no result '{2}'", input.name, path),
          did_you_mean(path, known, std::move(otherwise), input.name + ".")};
}

std::vector<std::string> elements_of(const Step& step, const std::string& list) {
  const StepInput& input = step.input();
  std::vector<std::string> names, paths;
  const auto* const result = input.calculator->result;
  const FieldInfo* const results = result == nullptr ? nullptr : find_field(result->fields, list);
  const FieldInfo* const own = find_field(input.calculator->input->fields, list);
  if (results != nullptr && name_in(*results) != nullptr)
    names = names_for(*results, input);
  else if (own != nullptr)
    add_names(*own, input, names);
  for (const std::string& name : names) {
    std::string& path = paths.emplace_back(step.name());
    path.append(".").append(list).append(".").append(name);
  }
  return paths.empty() ? std::vector{step.name() + "." + list + "[1]"} : paths;
}

std::string record_with(const Step& step, const std::string& source, const std::string& key) {
  for (const std::string& element : named_elements(step.input())) {
    const auto members = step.members(element);
    const auto has_key = [&](const Member& member) { return member.key == key; };
    if (last_part(element) == last_part(source) && std::any_of(members.begin(), members.end(), has_key))
      return step.name() + "." + element;
  }
  return {};
}

}  // namespace loadpath::project
