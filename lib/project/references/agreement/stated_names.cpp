#include "lib/project/references/agreement/stated_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace loadpath::project {

namespace {

bool is_same_word(std::string_view word, std::string_view small) {
  return std::ranges::equal(
      word, small, {}, [](char c) { return std::tolower(static_cast<unsigned char>(c)); },
      [](char c) { return static_cast<int>(static_cast<unsigned char>(c)); });
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view other) { return is_same_word(word, other); });
}

/// How many words a name has between its underscores, and how many of them are among these, in either case.
struct Words {
  std::size_t all = 0, known = 0;
};

Words count_words(std::string_view name, std::initializer_list<std::string_view> words) {
  Words count;
  while (true) {
    const std::size_t end = name.find('_');
    ++count.all;
    if (is_among(name.substr(0, end), words)) ++count.known;
    if (end == std::string_view::npos) return count;
    name.remove_prefix(end + 1);
  }
}

}  // namespace

bool has_word(std::string_view name, std::initializer_list<std::string_view> words) {
  return count_words(name, words).known > 0;
}

bool has_only_words(std::string_view name, std::initializer_list<std::string_view> words) {
  const Words count = count_words(name, words);
  return count.known == count.all;
}

bool is_of_peak(std::string_view name) {
  return has_word(
      name, {"start", "starting", "max", "peak", "jam", "stall", "shock", "impact", "brake", "braking", "overload"});
}

bool is_of_vacuum(std::string_view name) {
  if (has_word(name, {"vacuum", "vac"})) return true;
  return name.starts_with("p_") && has_word(name, {"ext", "external", "outside"});
}

bool is_of_life(std::string_view name) {
  return has_word(name, {"life", "lifetime", "l", "hours"}) &&
         has_only_words(name, {"life",    "lifetime", "l",        "h",     "10h",     "hours", "service", "operating",
                               "running", "design",   "required", "req",   "target",  "total", "gear",    "gears",
                               "gearbox", "bearing",  "bearings", "drive", "machine", "min"});
}

}  // namespace loadpath::project
