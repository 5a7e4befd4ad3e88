#include "calculators/column/lightest/families.hpp"

#include <algorithm>

namespace loadpath::column {

namespace {

std::vector<TableSection> read_sections() {
  auto sections = table::rows_of<SectionRow>();
  std::erase_if(sections, [](const TableSection& s) { return !is_set(s.m); });
  std::stable_sort(sections.begin(), sections.end(),
                   [](const TableSection& a, const TableSection& b) { return a.m < b.m; });
  return sections;
}

bool is_letter(char c) { return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z'); }

}  // namespace

const std::vector<TableSection>& sections_by_mass() {
  static const auto sections = read_sections();
  return sections;
}

std::string_view family_of(std::string_view name) {
  const auto end = std::find_if_not(name.begin(), name.end(), is_letter);
  return name.substr(0, static_cast<std::size_t>(end - name.begin()));
}

std::vector<std::string> families() {
  std::vector<std::string> all;
  for (const TableSection& section : sections_by_mass()) {
    std::string family(family_of(section.name()));
    if (std::find(all.begin(), all.end(), family) == all.end()) all.push_back(std::move(family));
  }
  return all;
}

}  // namespace loadpath::column
