// Forms of an input that sweeps are compiled for. With the given inputs known to the compiler, the tests for presence
// and all code for other inputs or results vanish from `evaluate`, and the rest is vectorised.
#pragma once

#include <cstddef>
#include <string_view>

namespace loadpath {

/// Keys, separated by ", ". A choice is given with its word, "method = euler", or without, for any word. All other
/// inputs are as in a blank input. If several forms serve a sweep, the first is used.
struct Form {
  const char* given;       // inputs: quantities, counts, choices of the input itself, of no list
  const char* asked = "";  // results: "u_tau, cycle.sigma_max"; empty: every quantity outside of lists
};

namespace detail {

/// Whether an entry of the list satisfies the condition.
template <class IsSuch>
constexpr bool any_of(std::string_view list, IsSuch is_such) {
  while (!list.empty()) {
    const std::string_view entry = list.substr(0, list.find(", "));
    if (is_such(entry)) return true;
    list.remove_prefix(entry.size() == list.size() ? entry.size() : entry.size() + 2);
  }
  return false;
}

constexpr std::string_view equals = " = ";

/// Whether the list names this key, with a word or without.
constexpr bool names(std::string_view list, std::string_view key) {
  return any_of(list, [&](std::string_view entry) { return entry.substr(0, entry.find(equals)) == key; });
}

/// The word that the list gives a choice; empty if it gives none.
constexpr std::string_view word_in(std::string_view list, std::string_view key) {
  std::string_view word;
  any_of(list, [&](std::string_view entry) {
    const std::size_t end = entry.find(equals);
    if (end != std::string_view::npos && entry.substr(0, end) == key) word = entry.substr(end + equals.size());
    return false;
  });
  return word;
}

constexpr std::size_t count_of(std::string_view list) {
  std::size_t n = 0;
  any_of(list, [&](std::string_view) { return ++n == 0; });
  return n;
}

}  // namespace detail

}  // namespace loadpath
