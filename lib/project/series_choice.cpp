#include "lib/project/series_choice.hpp"

#include <algorithm>

namespace loadpath::project {

// On a mismatch it resumes from the last *, which then matches one character more.
bool fits_pattern(std::string_view name, std::string_view pattern) {
  std::size_t t = 0, p = 0, star = std::string_view::npos, taken = 0;
  while (t < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool fits_pattern(std::string_view step, std::string_view path, std::string_view pattern) {
  return fits_pattern(path, pattern) || fits_pattern(std::string(step) + "." + std::string(path), pattern);
}

bool SeriesChoice::holds(std::string_view step, std::string_view path) const {
  return patterns_.empty() || std::any_of(patterns_.begin(), patterns_.end(),
                                          [&](const auto& pattern) { return fits_pattern(step, path, pattern); });
}

}  // namespace loadpath::project
