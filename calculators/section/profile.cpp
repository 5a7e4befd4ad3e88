#include "calculators/section/profile.hpp"

#include <algorithm>
#include <string>

namespace loadpath::section {

namespace {

char folded(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_name(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (true) {
    while (i < a.size() && a[i] == ' ') ++i;
    while (j < b.size() && b[j] == ' ') ++j;
    if (i == a.size() || j == b.size()) return i == a.size() && j == b.size();
    if (folded(a[i++]) != folded(b[j++])) return false;
  }
}

}  // namespace

const table::Typed<Profile>* find_profile(std::string_view name) {
  const auto& rows = table::rows_of<Profile>();
  const auto answers = [&](const table::Typed<Profile>& row) {
    const auto& aliases = row.entry.row->aliases;
    return same_name(row.name(), name) || std::any_of(aliases.begin(), aliases.end(),
                                                      [&](const std::string& alias) { return same_name(alias, name); });
  };
  const auto found = std::find_if(rows.begin(), rows.end(), answers);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace loadpath::section
