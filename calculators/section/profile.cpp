#include "calculators/section/profile.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace loadpath::section {

namespace {

char folded(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// By their letters, whatever the case and the spaces: below zero where a comes first, zero where they are the same.
int compare(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (true) {
    while (i < a.size() && a[i] == ' ') ++i;
    while (j < b.size() && b[j] == ' ') ++j;
    if (i == a.size() || j == b.size()) return static_cast<int>(i < a.size()) - static_cast<int>(j < b.size());
    const int difference = folded(a[i++]) - folded(b[j++]);
    if (difference != 0) return difference;
  }
}

struct Named {
  std::string_view name;
  const table::Typed<Profile>* row;
};

/// Names and aliases of all rows in order; of equal ones the earlier row's first.
std::vector<Named> sorted_names() {
  std::vector<Named> names;
  for (const auto& row : table::rows_of<Profile>()) {
    names.push_back({row.name(), &row});
    for (const std::string& alias : row.entry.row->aliases) names.push_back({alias, &row});
  }
  std::stable_sort(names.begin(), names.end(),
                   [](const Named& a, const Named& b) { return compare(a.name, b.name) < 0; });
  return names;
}

}  // namespace

const table::Typed<Profile>* find_profile(std::string_view name) {
  static const auto names = sorted_names();
  const auto found = std::lower_bound(names.begin(), names.end(), name,
                                      [](const Named& a, std::string_view b) { return compare(a.name, b) < 0; });
  return found == names.end() || compare(found->name, name) != 0 ? nullptr : found->row;
}

}  // namespace loadpath::section
