#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/inputs/projects.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <iostream>
#include <set>
#include <sstream>

namespace loadpath::cli {

namespace {

int refuse(const std::string& message, const std::string& hint = {}) {
  std::cerr << "loadpath: " << message << "\n";
  if (!hint.empty()) std::cerr << "  = help: " << hint << "\n";
  return wrong_input;
}

int run_one(const std::string& file, const RunOptions& options, OutputOptions output) {
  output.report_of_project = true;
  std::string text;
  if (!toml::read_file(file, text)) return refuse("cannot read '" + file + "'", help_for_file(file));
  const std::string name = file == "-" ? "standard input" : file;
  return solve_and_show(
      [&](std::vector<Issue>& issues) {
        using project::Ranges;
        project::Project project =
            read_set(text, name, options.settings, issues, options.point ? Ranges::taken : Ranges::refused);
        take_points(options.points, project.sweep);
        if (options.point && !has_errors(issues)) take_point(project, *options.point, issues);
        return project;
      },
      {{name, text}, source_of(options.settings)}, output, report::Detail::normal);
}

/// The outputs of one of several projects: its name replaces each *.
OutputOptions output_for(const ProjectFile& project, OutputOptions output) {
  for (std::string& report : output.reports) report = path_for(report, project);
  for (std::string* const path : {&output.csv, &output.svg, &output.dxf}) *path = path_for(*path, project);
  return output;
}

std::vector<std::string> paths_of(const OutputOptions& output) {
  std::vector<std::string> paths = output.reports;
  for (const std::string& path : {output.csv, output.svg, output.dxf}) {
    if (!path.empty()) paths.push_back(path);
  }
  return paths;
}

/// The first output that all projects would write to, though each has its own.
std::string shared_output(const std::vector<std::string>& paths) {
  const auto shared = std::find_if(paths.begin(), paths.end(),
                                   [](const std::string& path) { return path.find('*') == std::string::npos; });
  return shared == paths.end() ? "" : *shared;
}

/// Refuses options that need a single project; 0 if there are none.
int refuse_for_several(const RunOptions& options, const std::vector<ProjectFile>& projects) {
  if (options.point) return refuse("'--point' needs a single project", "name one file");
  const std::vector<std::string> paths = paths_of(options.output);
  const std::string shared = shared_output(paths);
  if (!shared.empty())
    return refuse("'" + shared + "' is one output, but every project needs its own",
                  "a * is replaced by the name of each: 'reports/*.html'");
  std::set<std::string> names;
  for (const ProjectFile& project : projects) {
    if (!names.insert(project.name).second && !paths.empty())
      return refuse("two projects would write to '" + path_for(paths[0], project) + "'",
                    "name the folder that both lie in, or run them apart");
  }
  return passed;
}

/// Combines the output of commands that each print one object, or none, as one list.
class Objects {
 public:
  template <class Solve>
  int add(const Solve& solve) {
    std::ostringstream printed;
    auto* const before = std::cout.rdbuf(printed.rdbuf());
    int code = fault;
    try {
      code = solve();
    } catch (...) {
      std::cout.rdbuf(before);
      throw;
    }
    std::cout.rdbuf(before);
    std::string object = std::move(printed).str();
    while (object.ends_with('\n')) object.pop_back();
    if (!object.empty()) all_ += (all_.empty() ? "" : ",\n") + object;
    return code;
  }
  [[nodiscard]] std::string list() const { return "[\n" + all_ + "\n]\n"; }

 private:
  std::string all_;
};

const char* word_of(int code) {
  switch (code) {
    case passed:
      return "pass";
    case not_passed:
      return "does not pass";
    case incomplete:
      return "incomplete";
    default:
      return "not solved";
  }
}

/// The exit code of several projects: wrong input before a failure, and this before an incomplete result.
int worst_of(const std::vector<int>& codes) {
  const auto rank = [](int code) { return code == passed ? 0 : code == incomplete ? 1 : code + 1; };
  return *std::ranges::max_element(codes, {}, rank);
}

/// The outcome of every project, in a line each.
void print_all(const std::vector<ProjectFile>& projects, const std::vector<int>& codes) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < projects.size(); ++i) {
    rows.push_back({"  " + std::string(word_of(codes[i])), projects[i].path});
  }
  std::cout << projects.size() << " projects\n" << terminal::columns(rows);
}

/// One block each, and at the end a line each; with --json a list of objects. An error in one does not stop the
/// others.
int run_several(const RunOptions& options) {
  std::string wrong;
  const auto projects = projects_of(options.files, wrong);
  if (!wrong.empty()) return refuse(wrong, "a project file ends with .toml, and has a step: a table with a calculator");
  if (const int refused = refuse_for_several(options, projects); refused != passed) return refused;
  const bool shown = !options.output.json && !options.output.quiet;
  std::vector<int> codes;
  Objects objects;
  for (const ProjectFile& project : projects) {
    if (shown) std::cout << "== " << project.path << "\n" << std::flush;
    const auto solve = [&] { return run_one(project.path, options, output_for(project, options.output)); };
    codes.push_back(options.output.json ? objects.add(solve) : solve());
    if (shown) std::cout << "\n" << std::flush;
  }
  if (options.output.json) std::cout << objects.list();
  if (shown) print_all(projects, codes);
  return worst_of(codes);
}

}  // namespace

int run(const RunOptions& options) {
  if (const std::string wrong = needs_point(options.points); !wrong.empty() && !options.point)
    return refuse(wrong, "add --point N, or use `loadpath sweep`");
  if (!can_write(options.output)) return wrong_input;
  return are_several(options.files) ? run_several(options) : run_one(options.files[0], options, options.output);
}

}  // namespace loadpath::cli
