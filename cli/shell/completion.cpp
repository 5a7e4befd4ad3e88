#include "cli/commands.hpp"
#include "cli/shell/candidates.hpp"
#include "lib/text/embedded.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::cli {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void print(const Candidates& all) {
  for (const Candidate& candidate : all.words) {
    std::cout << candidate.word;
    if (!candidate.meaning.empty()) std::cout << "\t" << first_line(candidate.meaning);
    std::cout << "\n";
  }
  if (all.files) std::cout << ":files\n";
}

}  // namespace

int completion(const CompletionOptions& options) {
  if (options.shell == "candidates") {
    CommandLine line;
    print(candidates(line, options.words));
    return passed;
  }
  const auto scripts = embedded::shells();
  const auto script = std::find_if(scripts.begin(), scripts.end(), [&](const embedded::File& file) {
    return file.name == "loadpath." + options.shell;
  });
  std::cout << script->text;
  return passed;
}

}  // namespace loadpath::cli
