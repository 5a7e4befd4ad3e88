#include "cli/program/words.hpp"

#include <CLI/CLI.hpp>

namespace loadpath::cli {

namespace {

/// Adds the options for a goal in place of all points.
void add_aims(CLI::App& app, SweepOptions& options) {
  app.add_option("--minimise", options.minimise,
                 "find the design with the minimum of a result: from lists, stocks, words, { from, to }")
      ->type_name("RESULT");
  app.add_option("--maximise", options.maximise, "find the design with the maximum of a result")->type_name("RESULT");
  app.add_option("--such-that", options.such_that,
                 "constraint of --minimise, --maximise (\"every mode passes\" if omitted) and --pareto: \"rod "
                 "passes\", \"rod.mass <= 5 kg\"")
      ->type_name("DEMAND")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--quantile", options.quantile,
                 "designs, objectives and constraints at this probability over the uncertain inputs")
      ->type_name("P")
      ->check(CLI::Range(0.5, 0.999999));
  app.add_option("--seek", options.seek, "goal seek: input at which a result reaches a value: \"shaft.u_tau = 0.9\"")
      ->type_name("GOAL");
  app.add_flag("--influence", options.influence, "sensitivity of results and sources of scatter");
  app.add_option("--sobol", options.sobol, "with --influence: Sobol indices from N rows of samples")
      ->type_name("ROWS")
      ->check(CLI::Range(100, 100'000'000));
}

/// Adds the options for results kept on the disk.
void add_folder(CLI::App& app, SweepOptions& options) {
  app.add_option("--out", options.out, "store columns (numpy) and restart state in a folder")->type_name("DIR");
  app.add_flag("--no-columns", options.no_columns, "store no columns in the folder");
  app.add_flag("--resume", options.resume, "continue the stored sweep");
  app.add_option("--status", options.status, "progress of the sweep in a folder, and the missing points")
      ->type_name("DIR");
  app.add_option("--save-every", options.save_every, "seconds between saved states; omitted: 2")
      ->type_name("S")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--shard", options.shard, "solve share K of N of the points, or points FROM-TO")->type_name("K/N");
  app.add_option("--merge", options.merge, "merge folders of shards")->type_name("DIR")->expected(1, -1);
}

}  // namespace

void setup_sweep(CLI::App& app, SweepOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("sweep", "solve a project at every point of its ranges and distributions");
  sub->add_option("file", options.file, "project file; - is standard input");
  sub->add_option("--results", options.results, "result recorded at every point: rod.u, or \"m = rod.mass + pin.mass\"")
      ->type_name("RESULT")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  add_points(*sub, options.points);
  add_settings(*sub, options.settings);
  sub->add_option("--worst", options.worst, "number of highest-utilisation points listed")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000'000));
  sub->add_option("--pareto", options.pareto, "Pareto-optimal points for these objectives: m:min,u:min")
      ->type_name("AIMS");
  add_aims(*sub, options);
  sub->add_option("--csv", options.csv, "write every point as a line")->type_name("FILE");
  sub->add_option("--hdf5", options.hdf5, "write every point, a dataset for each column")->type_name("FILE");
  sub->add_option("--report", options.reports, "write a report: FILE.html, FILE.md, FILE.tex or FILE.pdf")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  add_folder(*sub, options);
  sub->add_option("--jobs", options.jobs, "threads (all if omitted)")->type_name("N")->check(CLI::Range(1, 1024));
  sub->add_flag("--full", options.full, "print every table instead of the designs");
  sub->add_flag("--json", options.json, "print the results as one JSON object");
  sub->add_flag("--quiet", options.quiet, "print errors only");
  sub->add_flag("--strict", options.strict, "count failure modes not considered as not assessed (exit code 4)");
  sub->footer(
      "Exit codes: that of the best design (0 a design passes, 4 none passes, one is not assessed, 1 all fail); 0 for "
      "the "
      "scatter of one design and for a shard.");
  sub->callback([&] {
    if (options.file.empty() && options.status.empty()) throw CLI::RequiredError("file");
    action = [&] { return sweep(options); };
  });
}

}  // namespace loadpath::cli
