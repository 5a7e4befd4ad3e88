#include "cli/program/command_line.hpp"

namespace loadpath::cli {

namespace {

constexpr auto footer = R"(Examples:
  loadpath run examples/slotted-lever/project.toml --report report.html
  loadpath sweep examples/strut-sweep/project.toml --report sweep.html
  loadpath why examples/press-link/project.toml pin
  loadpath shaft torsion --T "2700 N*m" --tau_adm "30 MPa"
  loadpath mechanism planar --file examples/toggle-press/project.toml --svg press.svg
  loadpath convert "2700 lbf*in" "N*m"

Exit codes: 0 every failure mode that applies passes, or the user accepts it; 1 one fails, or a search has no result;
4 incomplete: none fails, but some have not been assessed, or are outside the scope;
2 the input is wrong, nothing is written; 3 an internal error, or standard output cannot be written; 130 interrupted.)";

void setup_run(CLI::App& app, RunOptions& options, Action& action) {
  CLI::App* run_app = app.add_subcommand("run", "solve project files");
  run_app->add_option("file", options.files, "project files, and folders of them; - is standard input")->required();
  run_app->add_option("--point", options.point, "solve point N (from 0) of the project's sweep")->type_name("N");
  add_points(*run_app, options.points);
  add_settings(*run_app, options.settings);
  add_output(*run_app, options.output);
  run_app->footer(
      "With several projects a * in the name of a report or table is replaced by the name of each: 'reports/*.html'.");
  run_app->callback([&] { action = [&] { return run(options); }; });
}

void setup_why(CLI::App& app, WhyOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("why", "governing checks, choices and formulas of a step");
  sub->add_option("file", options.file, "project file; - is standard input")->required();
  sub->add_option("step", options.of,
                  "step, or a result or failure mode of one: rod, rod.u; omitted: the step that governs the verdict");
  sub->add_option("--point", options.point, "show point N (from 0) of the project's sweep")->type_name("N");
  add_points(*sub, options.points);
  add_settings(*sub, options.settings);
  sub->callback([&] { action = [&] { return why(options); }; });
}

void setup_watch(CLI::App& app, WatchOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("watch", "solve a project file on every save, its report in the browser");
  sub->add_option("file", options.file, "project file")->required();
  sub->add_flag("--open", options.open, "open the report in the browser");
  sub->add_option("--port", options.port, "port on the loopback address; omitted: a free one")
      ->type_name("N")
      ->check(CLI::Range(1, 65535));
  sub->add_flag("--strict", options.strict, "count failure modes not considered as not assessed (exit code 4)");
  sub->footer(
      "The page follows the file, at the current scroll position; errors of the file are overlaid. Stop with Ctrl-C.");
  sub->callback([&] { action = [&] { return watch(options); }; });
}

void setup_describe(CLI::App& app, DescribeOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("describe", "inputs, results, failure modes, sources and example of a calculator");
  sub->add_option("id", options.id, "calculator, for example shaft.torsion")->required();
  sub->add_option(
      "name", options.name,
      "its name if the id is only an element, e.g. shaft torsion; else an input, a result or a failure mode, e.g. "
      "shaft.torsion theta_adm; or a part: inputs, keys, templates, rules, results, modes, sources, example");
  sub->add_option("part", options.part, "input, result or failure mode, if the id is two words");
  sub->add_flag("--full", options.full, "every field, rule, result, failure mode and source");
  sub->add_flag("--toml", options.toml, "only the example, a project file that runs");
  sub->add_flag("--json", options.json, "print as one JSON object, numbers in SI");
  sub->callback([&] { action = [&] { return describe(options); }; });
}

void setup_list(CLI::App& app, ListOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("list", "calculators: all, those of an element, or those that match words");
  sub->add_option("word", options.words, "an element, e.g. shaft, or a search word: buckling, S-N, Passfeder");
  sub->add_flag("--all", options.all, "include matches in failure modes and scope");
  sub->add_flag("--json", options.json, "print as one JSON object, numbers in SI");
  sub->callback([&] { action = [&] { return list(options); }; });
}

void setup_convert(CLI::App& app, ConvertOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("convert", "convert a quantity or evaluate an expression starting with =");
  sub->add_option("quantity", options.quantity, "for example \"2700 lbf*in\", \"2,5 kN·m\", \"=30 kW / (1500 rpm)\"")
      ->required();
  sub->add_option("unit", options.unit, "target unit; omitted: a readable one");
  sub->footer(R"(Numbers: 30  1e6  2·10^6  1 200  1'200  2,5 (decimal comma)  1/2 in  1-1/2 in
Units:   SI with prefixes, N·m N*m Nm, mm² mm^2, min⁻¹ 1/min, parentheses after a /; deg rad rev rpm rev/s min h d
         bar atm psi ksi in ft mil lbf lb kip hp PS kgf t % °C K, and Н·м кН МПа мм кВт об/мин
What can be read in two ways is refused: 1,250 mm; N/m*s.)");
  sub->callback([&] { action = [&] { return convert(options); }; });
}

void setup_verify(CLI::App& app, VerifyOptions& options, Action& action) {
  CLI::App* sub =
      app.add_subcommand("verify", "published reference cases: published and computed value, deviation, source");
  sub->add_option("file", options.files, "project files with [[expect]] entries; omitted: the built-in cases");
  sub->add_flag("--full", options.full, "print every value of the built-in cases, not only the misses and the counts");
  sub->add_flag("--json", options.json, "print as one JSON object, numbers in SI");
  sub->add_option("--report", options.reports,
                  "write a report of every value: FILE.html, FILE.md, FILE.tex or FILE.pdf")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  sub->callback([&] { action = [&] { return verify(options); }; });
}

void setup_tables(CLI::App& app, TablesOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("tables", "materials, preferred sizes and sources");
  sub->add_option("table", options.table, "table, for example materials");
  sub->add_option("key", options.key, "row, for example C45E");
  sub->add_option("--where", options.where,
                  "rows that satisfy the condition, e.g. \"I_min >= 300 cm^4 and h <= 200 mm\"; a value that depends "
                  "on the size counts at the smallest")
      ->type_name("CONDITION");
  sub->add_option("--sort", options.sort, "column to sort by, as in mass or h; with - before it from the largest")
      ->type_name("COLUMN");
  sub->add_flag("--audit", options.audit, "all values not checked against a source");
  sub->add_flag("--json", options.json, "print as one JSON object, numbers in SI");
  sub->callback([&] { action = [&] { return tables(options); }; });
}

void setup_completion(CLI::App& app, CompletionOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("completion", "shell completion for bash, zsh or fish");
  sub->add_option("shell", options.shell, "bash, zsh or fish (candidates: used by their scripts)")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish", "candidates"}));
  sub->add_option("words", options.words, "for candidates: the words after loadpath, the last one incomplete")
      ->type_name("");
  sub->footer(
      "For this shell: source <(loadpath completion bash). Permanently: save its output in the shell's completions "
      "folder.");
  sub->callback([&] { action = [&] { return completion(options); }; });
}

/// An option with an empty text is an error: --minimise "" would start no search, as if it had not been typed.
void refuse_empty_texts(CLI::App& app) {
  const auto is_given = [](const std::string& text) { return text.empty() ? "a value is missing" : std::string(); };
  for (CLI::Option* option : app.get_options()) {
    if (!option->get_positional() && option->get_items_expected_max() > 0) option->check(is_given);
  }
  for (CLI::App* sub : app.get_subcommands({})) refuse_empty_texts(*sub);
}

}  // namespace

void CommandLine::set_up(const CLI::App& command) {
  const auto found = late.find(&command);
  if (found != late.end()) found->second();
}

CommandLine::CommandLine()
    : app("loadpath: design calculator for machine elements, from the loads of a mechanism to the sizes of its parts",
          "loadpath") {
  app.set_help_flag("-h,--help", "print this help and exit");
  app.set_version_flag("--version", program(), "print the version and exit");
  app.require_subcommand(0, 1);
  setup_run(app, options.run, action);
  setup_sweep(app, options.sweep, action);
  setup_why(app, options.why, action);
  setup_watch(app, options.watch, action);
  setup_list(app, options.list, action);
  setup_describe(app, options.describe, action);
  setup_convert(app, options.convert, action);
  setup_verify(app, options.verify, action);
  setup_tables(app, options.tables, action);
  setup_completion(app, options.completion, action);
  app.add_subcommand("man", "manual page, as roff: loadpath man | man -l -")->callback([this] { action = man; });
  app.add_subcommand("schema", "JSON Schema of a project file, for editors")->callback([this] { action = schema; });
  setup_init(app, options.init, action);
  setup_diff(app, options.diff, action);
  setup_fmt(app, options.fmt, action);
  app.add_subcommand("lsp", "language server for editors, on standard input and output")->callback([this] {
    action = language_server;
  });
  refuse_empty_texts(app);
  setup_elements(app, options.calculate, action, late);
  app.footer(footer);  // both only here: commands inherit settings made before them
  app.allow_extras();
}

}  // namespace loadpath::cli
