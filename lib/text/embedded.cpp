#include "lib/text/embedded.hpp"

#include <algorithm>

namespace loadpath::embedded {

std::string_view asset(std::string_view name) {
  const auto files = assets();
  const auto found = std::find_if(files.begin(), files.end(), [&](const File& file) { return file.name == name; });
  return found == files.end() ? std::string_view{} : found->text;
}

}  // namespace loadpath::embedded
