#include "lib/project/read/reader.hpp"
#include "lib/project/read/rows_file.hpp"

#include <algorithm>
#include <set>

namespace loadpath::project {

using Type = FieldInfo::Type;

/// What a list without a bound takes: no rule of any calculator, but what has more is a slip, and fills the memory.
constexpr std::size_t most_elements = 100'000;

static Fault too_many(const FieldInfo& field, std::size_t count) {
  const bool bounded = field.capacity != no_bound;
  const std::size_t most = bounded ? field.capacity : most_elements;
  return {0, 0, say("at most {1} {2}; there are {3}", std::to_string(most), field.key, std::to_string(count)),
          bounded ? Message{} : say("no list of a project has more")};
}

/// What is wrong with one row is wrong with all, mostly: it is said once, at its line of the file.
static void keep_first_of_file(std::vector<Issue>& issues, std::size_t before) {
  const auto is_error = [](const Issue& issue) { return issue.severity == Severity::error; };
  const auto first = std::find_if(issues.begin() + static_cast<std::ptrdiff_t>(before), issues.end(), is_error);
  if (first == issues.end()) return;
  issues.erase(std::remove_if(first + 1, issues.end(), is_error), issues.end());
}

/// Whether a table that should hold elements by their names has the keys of one element: { link = "slider", at = "B" }.
static bool is_one_element(const Tree& tree, const FieldInfo& list) {
  const auto is_input = [&](const Tree::Entry& entry) {
    const bool is_value = entry.value.type != Tree::Type::table && entry.value.type != Tree::Type::array;
    return is_value && find_input(list.fields, entry.key) != nullptr;
  };
  return !list.positional && !tree.entries.empty() && std::all_of(tree.entries.begin(), tree.entries.end(), is_input);
}

void Reader::read_list(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  const bool has_own = find_field(field.fields, "name") != nullptr || find_field(field.fields, "file") != nullptr;
  if (names_rows_file(tree) && !has_own) {
    Issue wrong;
    const auto rows = read_rows_file(tree, field.fields, wrong);
    if (!rows) return say_at(wrong.place, path, std::move(wrong.message), std::move(wrong.hint));
    const std::size_t before = issues_.size();
    read_list(*rows, field, owner, path);
    return keep_first_of_file(issues_, before);
  }
  const bool named = tree.type == Tree::Type::table && find_field(field.fields, "name") != nullptr &&
                     find_field(field.fields, "name")->type == Type::name;
  if (!field.positional && takes(tree, field, path)) return;
  if (tree.type == Tree::Type::array && tree.items.empty()) {
    return say_at(tree.place, path, say("'{1}' is empty", path),
                  field.optional ? say("give what it lists, or leave it out") : say("give what it lists"));
  }
  if (named && is_one_element(tree, field)) {
    return say_at(tree.place, path, say("'{1}' is a list, and this is a single element of it", path),
                  say("put it in square brackets: {1} = [{ {2} = ... }]", path, tree.entries.front().key));
  }
  const Target target{field, owner, field.size(owner)};
  std::size_t count = target.given + (tree.type == Tree::Type::array ? tree.items.size() : 1);
  if (named) {
    const auto is_new = [&](const Tree::Entry& entry) { return target.find_given(entry.key) == nullptr; };
    count = target.given + static_cast<std::size_t>(std::count_if(tree.entries.begin(), tree.entries.end(), is_new));
  }
  if (count > std::min(field.capacity, most_elements)) {
    Fault fault = too_many(field, count);
    return say_at(tree.place, path, std::move(fault.message), std::move(fault.hint));
  }
  field.reserve(owner, count);  // operands point into elements
  if (named) {
    for (const Tree::Entry& entry : tree.entries) read_element(entry.value, target, path, &entry);
  } else if (tree.type == Tree::Type::array) {
    for (const Tree& item : tree.items) read_element(item, target, path, nullptr);
  } else {
    read_element(tree, target, path, nullptr);
  }
  check_names(field, owner, path, tree.place);
}

std::vector<std::string> Reader::Target::given_names() const {
  std::vector<std::string> names;
  const FieldInfo* name = find_field(list.fields, "name");
  for (std::size_t i = 0; name != nullptr && i < given; ++i) names.emplace_back(name->text(list.element(owner, i)));
  return names;
}

void* Reader::Target::find_given(const std::string& name) const {
  const auto names = given_names();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : list.element(owner, static_cast<std::size_t>(found - names.begin()));
}

void Reader::read_element(const Tree& tree, const Target& target, const std::string& path, const Tree::Entry* named) {
  const auto& [list, owner, given] = target;
  const auto* own_name = find_field(list.fields, "name") == nullptr ? nullptr : tree.find("name");
  const std::string written = named != nullptr ? named->key : own_name != nullptr ? own_name->value.text : "";
  void* const known = target.find_given(written);
  void* const element = known != nullptr ? known : list.push(owner);
  std::string inner = path + "[" + std::to_string(list.size(owner)) + "]";
  if (is_name(written) || named != nullptr) inner = path + "." + written;
  if (named != nullptr) {
    if (const auto* again = tree.find("name")) {
      say_at(again->place, inner, say("the name is already used before the table: '{1}'", named->key),
             say("leave out 'name'"));
    }
    Tree name;
    name.type = Tree::Type::text;
    name.text = named->key;
    name.place = named->place;
    reading_.typed[inner + ".name"] = {name.text, name.place};
    read_name(name, *find_field(list.fields, "name"), element, inner);
  }
  if (known != nullptr && reading_.typed.count(inner) != 0)
    say_at(tree.place, path, say("the name '{1}' is used twice in '{2}'", written, path));
  reading_.typed[inner] = {tree.text, tree.place};
  const std::size_t before = issues_.size();
  read_aggregate(tree, list, element, inner);
  const std::vector<std::string> names = known == nullptr ? target.given_names() : std::vector<std::string>{};
  for (std::size_t i = before; i < issues_.size() && known == nullptr; ++i) {  // no known element: suggest a given name
    const bool is_missing = !names.empty() && issues_[i].key_fault == KeyFault::missing;
    if (issues_[i].hint.empty())
      issues_[i].hint = did_you_mean(written, names, is_missing ? there_is(names) : Message{}, path + ".");
  }
}

void Reader::check_names(const FieldInfo& list, void* owner, const std::string& path, const Place& place) {
  const FieldInfo* name = find_field(list.fields, "name");
  if (name == nullptr || name->type != Type::name) return;
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < list.size(owner); ++i) {
    const std::string_view n = name->text(list.element(owner, i));
    if (!n.empty() && !seen.insert(n).second) {
      const auto typed = reading_.typed.find(path + "." + std::string(n) + ".name");
      say_at(typed == reading_.typed.end() ? place : typed->second.place, path,
             say("the name '{1}' is used twice in '{2}'", n, path));
    }
  }
}

}  // namespace loadpath::project
