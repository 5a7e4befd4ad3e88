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

/// 1-1/2, 8.625
bool is_of_number(char c) { return ('0' <= c && c <= '9') || c == '.' || c == '/' || c == '-'; }

/// The name up to the end of its first number.
std::string_view up_to_number(std::string_view name) {
  const auto start = std::find_if(name.begin(), name.end(), &is_of_number);
  const auto end = std::find_if_not(start, name.end(), &is_of_number);
  return name.substr(0, static_cast<std::size_t>(end - name.begin()));
}

std::string without_spaces(std::string_view name) {
  std::string joined(name);
  joined.erase(std::remove(joined.begin(), joined.end(), ' '), joined.end());
  return joined;
}

void add_once(std::vector<std::string>& all, std::string_view name) {
  if (std::find(all.begin(), all.end(), name) == all.end()) all.emplace_back(name);
}

}  // namespace

const std::vector<TableSection>& sections_by_mass() {
  static const auto sections = read_sections();
  return sections;
}

std::string_view family_of(std::string_view name) {
  const auto end = std::find_if_not(name.begin(), name.end(), is_letter);
  return name.substr(0, static_cast<std::size_t>(end - name.begin()));
}

bool begins_with(std::string_view name, std::string_view beginning) {
  std::size_t at = 0;
  for (const char c : beginning) {
    while (at < name.size() && name[at] == ' ') ++at;
    if (at == name.size() || name[at++] != c) return false;
  }
  if (beginning.empty() || at == name.size()) return !beginning.empty();
  const char last = beginning.back(), next = name[at];
  return !(is_letter(last) && is_letter(next)) && !(is_of_number(last) && is_of_number(next));
}

std::vector<std::string> first_sizes(std::string_view family) {
  std::vector<std::string> all;
  for (const TableSection& section : sections_by_mass()) {
    if (family_of(section.name()) == family) add_once(all, without_spaces(up_to_number(section.name())));
  }
  return all;
}

std::vector<std::string> families() {
  std::vector<std::string> all;
  for (const TableSection& section : sections_by_mass()) add_once(all, family_of(section.name()));
  return all;
}

}  // namespace loadpath::column
