#include "lib/project/references/agreement/stated_names.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c == '_')
      words.emplace_back();
    else
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return words;
}

bool is_among(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, std::string_view(word)) != words.end();
}

}  // namespace

bool has_word(std::string_view name, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words_of(name), [&](const std::string& word) { return is_among(word, words); });
}

bool has_only_words(std::string_view name, std::initializer_list<std::string_view> words) {
  return std::ranges::all_of(words_of(name), [&](const std::string& word) { return is_among(word, words); });
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
