#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
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
      [&](std::vector<Issue>& issues) {
        using project::Ranges;
        project::Project project =
            project::read_project(text, name, catalogue(), issues, options.point ? Ranges::taken : Ranges::refused);
        take_points(options.points, project.sweep);
        if (options.point && !has_errors(issues)) take_point(project, *options.point, issues);
        return project;
      },
      {{name, text}}, options.output, false);
}

}  // namespace loadpath::cli
