#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/solving.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>

namespace loadpath::cli {

int run(const RunOptions& options) {
  if (!can_write(options.output)) return wrong_input;
  std::string text;
  if (!toml::read_file(options.file, text)) {
    std::cerr << "loadpath: cannot read '" << options.file << "'\n";
    return wrong_input;
  }
  const std::string name = options.file == "-" ? "standard input" : options.file;
  return solve_and_show(
      [&](std::vector<Issue>& issues) { return project::read_project(text, name, catalogue(), issues); },
      {{name, text}}, options.output, false);
}

}  // namespace loadpath::cli
