#include "lib/project/solving/causes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

using toml::Tree;
using ValueNames = std::set<std::string>;

constexpr std::string_view values_prefix = "values.";

/// The values that an expression refers to, by their names; none of a text that cannot be read.
ValueNames values_in(const std::string& text) {
  ValueNames names;
  const auto expression = Expression::parse(text);
  if (!expression) return names;
  for (const auto& reference : expression->references()) {
    if (reference.path.starts_with(values_prefix)) names.insert(reference.path.substr(values_prefix.size()));
  }
  return names;
}

bool is_computed(const Tree& tree) { return tree.type == Tree::Type::text && tree.text.starts_with('='); }

bool is_same(const Place& a, const Place& b) { return a.file == b.file && a.line == b.line && a.column == b.column; }

/// Whether an issue points into the text of a value, or to a number, a list or a table in it.
bool is_at(const Issue& issue, const Tree& value) {
  const Place& at = issue.place;
  if (value.type == Tree::Type::text)
    return at.file == value.place.file && at.line == value.place.line && at.column >= value.place.column &&
           at.column <= value.place.column + value.place.length;
  return is_same(at, value.place) ||
         std::ranges::any_of(value.items, [&](const Tree& item) { return is_at(issue, item); }) ||
         std::ranges::any_of(value.entries, [&](const Tree::Entry& entry) { return is_at(issue, entry.value); });
}

/// Whether only `run` has no number of it: a list of quantities, a range.
bool may_be_swept(const Tree& tree) {
  if (tree.type == Tree::Type::table) return tree.find("from") != nullptr;
  return tree.type == Tree::Type::array &&
         std::ranges::all_of(tree.items, [](const Tree& item) { return item.type == Tree::Type::text; });
}

bool is_error(const Issue& issue) { return issue.severity == Severity::error; }

class Causes {
 public:
  Causes(const Project& project, const std::vector<Tree::Entry>& values, std::vector<Issue>& issues)
      : project_(project), values_(values), issues_(issues) {}

  void run() {
    add_unknown_steps();
    for (const Tree::Entry& value : values_) keep_first_at(value);
    if (wrong_.empty()) return;
    spread();
    std::erase_if(issues_, [&](const Issue& issue) { return is_error(issue) && follows(issue); });
  }

 private:
  /// An expression of a value that names no step is reported at the value, not where it is used.
  void add_unknown_steps() {
    const auto is_unknown = [](const Issue& issue) { return issue.message.id == "unknown step '{1}'"; };
    if (std::none_of(issues_.begin(), issues_.end(), is_unknown)) return;
    for (const Tree::Entry& value : values_) {
      if (!is_computed(value.value)) continue;
      const std::string text = value.value.text.substr(1);
      const auto expression = Expression::parse(text);
      if (!expression) continue;
      for (const auto& reference : expression->references()) {
        const std::string name = split_step(reference.path).first;
        if (name == "values" || name == "tables" || project_.find(name) != nullptr) continue;
        const Fault fault = project_.unknown_step(reference.path);
        Place start = value.value.place;
        ++start.column;
        const std::size_t at = std::min(text.find(reference.path), text.size());
        if (!fault.message.empty())
          issues_.insert(issues_.begin(),
                         {place_in(start, text, at, reference.path.size()), std::string(values_prefix) + value.key,
                          fault.message, fault.hint, Severity::error});
        break;
      }
    }
  }

  void keep_first_at(const Tree::Entry& value) {
    const bool is_range = may_be_swept(value.value);
    const auto is_here = [&](const Issue& issue) {
      return is_error(issue) && (is_at(issue, value.value) || (!is_range && is_same(issue.place, value.place)));
    };
    const auto first = std::find_if(issues_.begin(), issues_.end(), is_here);
    if (first == issues_.end()) return;
    wrong_.insert(value.key);
    issues_.erase(std::remove_if(first + 1, issues_.end(), is_here), issues_.end());
  }

  /// Values that calculate with a wrong one are wrong too.
  void spread() {
    std::map<std::string, std::vector<std::string>> users;
    for (const Tree::Entry& value : values_) {
      if (!is_computed(value.value)) continue;
      for (const std::string& name : values_in(value.value.text.substr(1))) users[name].push_back(value.key);
    }
    std::vector<std::string> open(wrong_.begin(), wrong_.end());
    while (!open.empty()) {
      const auto those = users.extract(open.back());
      open.pop_back();
      if (those.empty()) continue;
      for (const std::string& user : those.mapped()) {
        if (wrong_.insert(user).second) open.push_back(user);
      }
    }
  }

  [[nodiscard]] bool is_wrong(const ValueNames& names) const {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return wrong_.contains(name); });
  }

  /// Whether the issue is about an expression of a step that calculates with a wrong value.
  [[nodiscard]] bool follows(const Issue& issue) const {
    const auto [name, path] = split_step(issue.key);
    const Step* const step = project_.find(name);
    if (step == nullptr) return false;
    const auto& operands = step->input().reading.operands;
    return std::any_of(operands.begin(), operands.end(), [&, path = path](const Operand& operand) {
      return operand.path == path && issue.place.line == operand.place.line && is_wrong(values_in(operand.text));
    });
  }

  const Project& project_;
  const std::vector<Tree::Entry>& values_;
  std::vector<Issue>& issues_;
  ValueNames wrong_;
};

}  // namespace

void keep_first_of_values(const Project& project, const Tree& file, std::vector<Issue>& issues) {
  const auto* const values = file.find("values");
  if (values != nullptr && is_shared(*values) && has_errors(issues))
    Causes(project, values->value.entries, issues).run();
}

}  // namespace loadpath::project
