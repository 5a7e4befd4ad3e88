// Inputs that were typed and move nothing: said, for who typed them believes that they count.
#include "lib/project/run/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::project {

namespace {

/// Whether a number differs; what is not available is like itself.
bool differs(double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); }

/// Other values for a leaf, near and far.
std::array<double, 6> others(const FieldInfo& field, double value) {
  const double unit = field.factor;
  if (value == 0.0) return {unit, 0.01 * unit, -0.01 * unit, 100.0 * unit, -unit, 1e-4 * unit};
  return {value * (1.0 + 1e-3), value * (1.0 - 1e-3), value * 1.5, value * 0.5, value * 30.0, value * 0.03};
}

}  // namespace

std::vector<double> Run::numbers_at(std::size_t position) {
  std::vector<double> numbers;
  if (!set_position(position)) return numbers;
  calculator_.evaluate(record_.data.get(), result_.data.get());
  for_each_leaf(result_, [&](const std::string&, const Leaf& leaf) {
    if (leaf.field->get != nullptr) numbers.push_back(leaf.get());
  });
  return numbers;
}

bool Run::keeps_rules() const {
  for (std::size_t rule = 0; rule < calculator_.rules.size(); ++rule) {
    if (!calculator_.rules[rule].only_warns && !calculator_.holds(rule, record_.data.get())) return false;
  }
  return true;
}

/// Whether another value of the leaf changes a result at the position; also where it may have no other.
bool Run::moves_something(const Leaf& leaf, std::size_t position, const std::vector<double>& before) {
  const double given = leaf.get();
  bool tried = false, moved = false;
  for (const double value : others(*leaf.field, given)) {
    if (moved || !leaf.field->bounds.holds(value)) continue;
    leaf.set(value);
    if (!keeps_rules()) continue;
    tried = true;
    const std::vector<double> after = numbers_at(position);
    moved = !std::equal(before.begin(), before.end(), after.begin(), after.end(),
                        [](double a, double b) { return !differs(a, b); });
  }
  leaf.set(given);
  return moved || !tried;
}

void Run::warn_of_unused(std::vector<Issue>& issues) {
  if (!traced_ || axis_ != nullptr) return;  // over a series it may count at another position
  const Record blank(*calculator_.input);
  const std::vector<double> before = numbers_at(0);
  for (const auto& entry : step_.input().reading.typed) {
    const std::string& path = entry.first;
    const Leaf leaf = map_leaf(path);
    if (!leaf || leaf.field->type != FieldInfo::Type::quantity || !std::isfinite(leaf.get())) continue;
    const bool in_list = path.find_first_of("[.") != std::string::npos;  // where elements weigh one another out
    const bool required = !leaf.field->optional && !in_list && std::isnan(find_leaf(blank, path).get());
    if (in_list || required) continue;
    const auto is_operand = [&](const Input& input) { return input.path == path; };
    if (std::any_of(inputs_.begin(), inputs_.end(), is_operand)) continue;
    const bool is_size = size_field() != nullptr && path == size_field();  // tables are asked with it
    if (is_size || moves_something(leaf, 0, before)) continue;
    Issue issue = issue_at(step_.input(), path, say("'{1}' has no effect here: no result depends on it", path));
    issue.severity = Severity::warning;
    issues.push_back(std::move(issue));
  }
  set_position(0);
  calculator_.evaluate(record_.data.get(), result_.data.get());  // as it was
}

}  // namespace loadpath::project
