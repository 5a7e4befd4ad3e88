#include "lib/project/references/row_pairs.hpp"

#include "lib/project/references/references.hpp"

#include <algorithm>
#include <set>

namespace loadpath::project {

namespace {

/// The group of the rows that a step searches for; empty if it searches for something else, too, or for nothing.
std::string searched_group(const Step& step) {
  const auto& searches = step.input().reading.searches;
  const bool is_row =
      searches.size() == 1 && !searches.front().leaf && step.input().rows.contains(searches.front().path);
  return is_row ? searches.front().path : std::string();
}

/// The inputs of a step, filled by the row that it searches for, that another one takes.
std::vector<std::string> taken_of_row(const Step& taker, const Step& of) {
  const std::string group = searched_group(of);
  std::set<std::string> all;
  for_each_reference(taker.input().reading, [&](const std::string& path) {
    const auto [name, rest] = split_step(path);
    if (name != of.name()) return;
    const FieldInfo* const field = find_field(of.input().calculator->input->fields, rest);
    const bool is_of_row =
        field != nullptr && field->provider.table == group && field->type == FieldInfo::Type::quantity;
    if (is_of_row && !of.input().reading.typed.contains(rest)) all.insert(rest);
  });
  return {all.begin(), all.end()};
}

}  // namespace

std::vector<RowPair> row_pairs(const Project& project) {
  std::vector<std::size_t> searching;
  for (std::size_t i = 0; i < project.steps.size(); ++i) {
    if (!searched_group(*project.steps[i]).empty()) searching.push_back(i);
  }
  std::vector<RowPair> pairs;
  std::set<std::size_t> paired;
  for (const std::size_t a : searching) {
    for (const std::size_t b : searching) {
      if (b <= a || paired.contains(a) || paired.contains(b)) continue;
      RowPair pair{a, b, taken_of_row(*project.steps[b], *project.steps[a]),
                   taken_of_row(*project.steps[a], *project.steps[b])};
      if (pair.of_a.empty() || pair.of_b.empty()) continue;
      paired.insert({a, b});
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

}  // namespace loadpath::project
