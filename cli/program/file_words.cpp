#include "cli/files/commands.hpp"
#include "cli/program/words.hpp"

#include <CLI/CLI.hpp>

namespace loadpath::cli {

void setup_init(CLI::App& app, InitOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("init", "start a project: a commented file that runs");
  sub->add_option("template", options.starter,
                  "belt, chain, column, gear, mechanism, shaft, vessel or worm; prompted for on a terminal if omitted");
  sub->add_option("file", options.file, "file to write; omitted: TEMPLATE.toml; - is standard output");
  sub->add_option("--set", options.settings,
                  "another value: --set T=\"80 N*m\" of [values], --set shaft.S_F=2 of a step")
      ->type_name("FIELD=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  sub->callback([&] { action = [&] { return init(options); }; });
}

void setup_diff(CLI::App& app, DiffOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("diff", "differences between two projects: inputs, sizes, verdicts, results");
  sub->add_option("before", options.before, "project file; - is standard input")->required();
  sub->add_option("after", options.after, "project file; - is standard input")->required();
  sub->add_flag("--json", options.json, "print the differences as one JSON object");
  sub->footer("Exit codes: 0 no difference; 1 they differ; 2 the input is wrong.");
  sub->callback([&] { action = [&] { return diff(options); }; });
}

void setup_fmt(CLI::App& app, FmtOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("fmt", "format project files: order of tables and keys, spaces, units");
  sub->add_option("file", options.files, "project files, and folders of them; - from standard input to standard output")
      ->required();
  sub->add_flag("--check", options.check, "write nothing, name the files that would change: exit code 1");
  sub->callback([&] { action = [&] { return fmt(options); }; });
}

}  // namespace loadpath::cli
