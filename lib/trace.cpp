#include "lib/trace.hpp"

#include <algorithm>

namespace loadpath {

namespace {

bool in_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

std::string RenamedTrace::renamed(const char* text) const {
  const std::string_view all = text;
  std::string out;
  for (auto at = all.begin(); at != all.end();) {
    const auto end = in_name(*at) ? std::find_if_not(at, all.end(), in_name) : at + 1;
    const std::string_view word(at, end);
    const auto found = std::find_if(names_.begin(), names_.end(), [&](const auto& name) { return name.first == word; });
    out += found == names_.end() ? word : std::string_view(found->second);
    at = end;
  }
  return out;
}

}  // namespace loadpath
