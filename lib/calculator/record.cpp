#include "lib/calculator/record.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace loadpath {

namespace {

std::string_view name_of_element(const FieldInfo& list, void* element) {
  const FieldInfo* name = find_field(list.fields, "name");
  return name != nullptr && name->type == FieldInfo::Type::name ? name->text(element) : std::string_view{};
}

/// The element that "[2]" or ".journal" at the start of `path` names; the rest of the path is left behind.
void* take_element(const FieldInfo& list, void* owner, std::string_view& path) {
  if (path.starts_with('[')) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(path.data() + 1, path.data() + path.size(), number);
    if (error != std::errc{} || end == path.data() + path.size() || *end != ']') return nullptr;
    path.remove_prefix(static_cast<std::size_t>(end - path.data()) + 1);
    return number >= 1 && number <= list.size(owner) ? list.element(owner, number - 1) : nullptr;
  }
  if (!path.starts_with('.')) return nullptr;
  const std::string_view rest = path.substr(1);
  void* found = nullptr;
  std::size_t longest = 0;  // a name may contain dots: "RHS 60x40x3" and "RHS 60x40x3.2"
  for (std::size_t i = 0; i < list.size(owner); ++i) {
    const std::string_view name = name_of_element(list, list.element(owner, i));
    if (name.size() <= longest || !rest.starts_with(name)) continue;
    if (rest.size() > name.size() && rest[name.size()] != '.') continue;
    found = list.element(owner, i);
    longest = name.size();
  }
  if (found != nullptr) path.remove_prefix(1 + longest);
  return found;
}

}  // namespace

std::vector<std::string> listed_keys(std::string_view list) {
  std::vector<std::string> keys;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(", "), list.size());
    keys.emplace_back(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 2, list.size()));
  }
  return keys;
}

const FieldInfo* find_field(std::span<const FieldInfo> fields, std::string_view key) {
  if (key.empty()) return nullptr;
  for (const FieldInfo& field : fields) {
    if (*field.key == key.front() && field.key == key) return &field;  // the length of most keys is never counted
  }
  return nullptr;
}

const FieldInfo* find_input(std::span<const FieldInfo> fields, std::string_view word) {
  if (const FieldInfo* const own = find_field(fields, word)) return own;
  for (const FieldInfo& field : fields) {
    if (*field.also_called == '\0') continue;
    for (const std::string& other : listed_keys(field.also_called)) {
      if (other == word) return &field;
    }
  }
  return nullptr;
}

Leaf find_member(std::span<const FieldInfo> fields, void* data, std::string_view path) {
  const std::size_t end = std::min(path.find_first_of(".["), path.size());
  const FieldInfo* field = find_field(fields, path.substr(0, end));
  path.remove_prefix(end);
  if (field == nullptr || path.empty()) return {field, data};
  if (!field->has_fields()) return {};
  void* inner = field->type == FieldInfo::Type::list ? take_element(*field, data, path) : field->element(data, 0);
  if (inner == nullptr || !path.starts_with('.')) return {};
  return find_member(field->fields, inner, path.substr(1));
}

Leaf find_leaf(std::span<const FieldInfo> fields, void* data, std::string_view path) {
  const Leaf member = find_member(fields, data, path);
  return member && member.field->is_leaf() ? member : Leaf{};
}

namespace {

/// Takes "[2]" or ".journal" off the path behind a list; false if no element can be meant.
bool skip_element(const FieldInfo& list, std::string_view& path) {
  const bool numbered = path.starts_with('[');
  if (!numbered && find_field(list.fields, "name") == nullptr) return false;
  std::size_t number = 1;
  if (numbered) std::from_chars(path.data() + 1, path.data() + path.size(), number);
  if (number < 1 || number > list.capacity) return false;
  const std::size_t end = numbered ? path.find(']') : path.find_first_of(".[", 1);
  path.remove_prefix(end == std::string_view::npos ? path.size() : numbered ? end + 1 : end);
  return true;
}

}  // namespace

const FieldInfo* find_field_at(std::span<const FieldInfo> fields, std::string_view path) {
  const std::size_t end = std::min(path.find_first_of(".["), path.size());
  const FieldInfo* field = find_field(fields, path.substr(0, end));
  path.remove_prefix(end);
  if (field == nullptr || path.empty()) return field;
  if (field->type == FieldInfo::Type::list && !skip_element(*field, path)) return nullptr;
  if (!field->has_fields()) return nullptr;
  if (path.empty()) return field;  // the entire element
  return path.starts_with('.') ? find_field_at(field->fields, path.substr(1)) : nullptr;
}

bool is_missing(const FieldInfo& field, void* owner) {
  switch (field.type) {
    case FieldInfo::Type::quantity:
      return std::isnan(field.get(owner));
    case FieldInfo::Type::name:
    case FieldInfo::Type::formula:
      return field.text(owner).empty();
    case FieldInfo::Type::list:
      return field.size(owner) == 0;
    case FieldInfo::Type::count:
      return !field.bounds.holds(field.get(owner));
    case FieldInfo::Type::choice:
    case FieldInfo::Type::group:
    case FieldInfo::Type::record:
      return false;
  }
  return false;
}

std::string word_of(const Leaf& leaf) {
  if (leaf.field->type != FieldInfo::Type::choice) return std::string(leaf.field->text(leaf.owner));
  const double index = leaf.get();
  return std::isnan(index) ? "" : leaf.field->choices[static_cast<std::size_t>(index)].key;
}

bool set_word(const Leaf& leaf, std::string_view word) {
  const FieldInfo& field = *leaf.field;
  if (field.type != FieldInfo::Type::choice) {
    if (word.size() > field.capacity) return false;
    field.set_text(leaf.owner, word);
    return true;
  }
  const auto found = std::find_if(field.choices.begin(), field.choices.end(),
                                  [&](const ChoiceInfo& c) { return word == c.key || word == c.also; });
  if (word.empty() || found == field.choices.end()) return false;
  leaf.set(static_cast<double>(found - field.choices.begin()));
  return true;
}

std::string element_path(const FieldInfo& list, void* owner, std::size_t i) {
  const std::string_view name = name_of_element(list, list.element(owner, i));
  return name.empty() ? "[" + std::to_string(i + 1) + "]" : "." + std::string(name);
}

void for_each_leaf(std::span<const FieldInfo> fields, void* data, const VisitLeaf& visit) {
  for (const FieldInfo& field : fields) {
    if (field.is_leaf()) visit(field.key, {&field, data});
    if (!field.has_fields()) continue;
    const bool list = field.type == FieldInfo::Type::list;
    const std::size_t count = list ? field.size(data) : 1;
    for (std::size_t i = 0; i < count; ++i) {
      std::string prefix = field.key;
      if (list) prefix += element_path(field, data, i);
      prefix += '.';
      for_each_leaf(field.fields, field.element(data, i),
                    [&](const std::string& path, const Leaf& leaf) { visit(prefix + path, leaf); });
    }
  }
}

}  // namespace loadpath
