// Any bytes are a tree, or issues whose places lie in the text; the parser behind the gate stays on its feet.
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

using namespace loadpath;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<Issue> issues;
  const toml::Tree tree = toml::read_toml(text, "a.toml", issues);
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  for (const Issue& issue : issues) {
    if (issue.message.text().empty() || issue.place.line > lines + 1) std::abort();
  }
  if (!issues.empty() && !tree.entries.empty()) std::abort();
  return 0;
}
