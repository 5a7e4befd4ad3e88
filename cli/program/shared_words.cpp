#include "cli/program/words.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <string>

namespace loadpath::cli {

namespace {

/// An integer in the range of a project file.
CLI::Validator whole_from(std::int64_t least) {
  return {[least](const std::string& text) {
            std::int64_t number = 0;
            const char* const end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, number);
            const bool fits = read.ec == std::errc() && read.ptr == end && number >= least;
            return fits ? std::string() : "'" + text + "' is not an integer of " + std::to_string(least) + " or more";
          },
          ""};
}

}  // namespace

void add_output(CLI::App& app, OutputOptions& output) {
  app.add_option("--report", output.reports,
                 "write a report: FILE.html, FILE.md, FILE.tex or FILE.pdf; html:- is standard output")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  auto* const detail =
      app.add_option("--detail", output.detail,
                     "detail of reports: brief (no appendix), normal, full (every list, formula and input)")
          ->type_name("WORD")
          ->check(CLI::IsMember({"brief", "normal", "full"}));
  app.add_flag("--brief", output.brief, "with --report: only the pages to decide, to check and to recompute")
      ->excludes(detail);
  app.add_flag("--json", output.json, "print the results as one JSON object, of several projects as a list");
  app.add_option("--csv", output.csv,
                 "write the series: a file per step into a folder, or those of a single step into FILE.csv or -")
      ->type_name("PATH");
  app.add_option("--series", output.series,
                 "series for CSV and JSON, by name: drive.M,links.*.N; * matches any characters")
      ->type_name("NAMES")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--svg", output.svg,
                 "write every figure into a folder; or, as FILE.svg, the drawing to scale, of a mechanism at its first "
                 "position, or the first figure")
      ->type_name("PATH");
  app.add_option("--dxf", output.dxf,
                 "write the drawing to scale for CAD (DXF R12, mm) as FILE.dxf; several into a folder")
      ->type_name("PATH");
  auto* const full = app.add_flag("--full", output.full, "print every part with its results and all failure modes");
  app.add_flag("--modes", output.modes, "print every failure mode: state, utilisation, basis")->excludes(full);
  app.add_flag("--quiet", output.quiet, "print errors, and the verdict line where it is not PASS");
  app.add_flag("--strict", output.strict, "count failure modes not considered as not assessed (exit code 4)");
}

void add_settings(CLI::App& app, std::vector<std::string>& settings) {
  app.add_option("--set", settings, "replace a field of the file: --set shaft.d=\"45 mm\"")
      ->type_name("STEP.FIELD=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void add_points(CLI::App& app, PointOptions& options) {
  app.add_option("--samples", options.samples, "samples of uncertain inputs, at each point of the ranges")
      ->type_name("N")
      ->check(whole_from(1));
  app.add_option("--seed", options.seed, "seed of the random samples")->type_name("N")->check(whole_from(0));
  app.add_flag("--latin", options.latin, "Latin hypercube sampling");
  app.add_option("--zip", options.zip, "inputs varied in parallel, not crossed: shaft.T,shaft.n")
      ->type_name("INPUTS")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace loadpath::cli
