#include "lib/project/layout/same.hpp"

#include "lib/project/parts/parts.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using toml::Tree;

bool same_text(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto one = parse_literal(a), other = parse_literal(b);
  return one && other && one->si == other->si && one->dimension == other->dimension;
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Down from here every order counts.
bool same_value(const Tree& a, const Tree& b) {
  if (a.type != b.type || a.items.size() != b.items.size() || a.entries.size() != b.entries.size()) return false;
  const bool is_text = a.type == Tree::Type::text;
  if (is_text ? !same_text(a.text, b.text) : a.text != b.text || !same_number(a.number, b.number)) return false;
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(), same_value) &&
         std::equal(
             a.entries.begin(), a.entries.end(), b.entries.begin(),
             [](const Tree::Entry& x, const Tree::Entry& y) { return x.key == y.key && same_value(x.value, y.value); });
}

bool same_keys(const Tree& a, const Tree& b) {
  return a.entries.size() == b.entries.size() &&
         std::all_of(a.entries.begin(), a.entries.end(), [&](const Tree::Entry& entry) {
           const Tree::Entry* const other = b.find(entry.key);
           return other != nullptr && same_value(entry.value, other->value);
         });
}

/// The names of the steps, in order.
std::vector<std::string> steps_of(const Tree& tree) {
  std::vector<std::string> names;
  for (const Tree::Entry& entry : tree.entries) {
    if (!is_reserved(entry.key)) names.push_back(entry.key);
  }
  return names;
}

}  // namespace

bool say_the_same(const Tree& a, const Tree& b) {
  if (a.entries.size() != b.entries.size() || steps_of(a) != steps_of(b)) return false;
  return std::all_of(a.entries.begin(), a.entries.end(), [&](const Tree::Entry& entry) {
    const Tree::Entry* const other = b.find(entry.key);
    if (other == nullptr) return false;
    const bool is_table = entry.value.type == Tree::Type::table && other->value.type == Tree::Type::table;
    return is_table ? same_keys(entry.value, other->value) : same_value(entry.value, other->value);
  });
}

}  // namespace loadpath::project
