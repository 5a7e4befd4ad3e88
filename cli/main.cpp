#include <CLI/CLI.hpp>

#include <csignal>
#include <deque>
#include <exception>
#include <functional>
#include <iostream>
#include <map>

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/issue.hpp"

namespace loadpath::cli {

namespace {

using Action = std::function<int()>;

constexpr auto footer = R"(Examples:
  loadpath run examples/slotted-lever/project.toml --report report.html
  loadpath shaft torsion --T "2700 N*m" --tau_adm "30 MPa"
  loadpath convert "2700 lbf*in" "N*m"

Exit codes: 0 solved and every check passes; 1 solved, but a check fails, is not covered or not available;
2 the input is wrong, nothing is written; 3 a fault of the program; 130 interrupted.)";

void add_output(CLI::App& app, OutputOptions& output) {
  app.add_option("--report", output.reports, "write a report: FILE.html, FILE.md or FILE.pdf")
      ->type_name("FILE")->expected(1)->take_all()->allow_extra_args(false);
  app.add_flag("--json", output.json, "print the results as one JSON object");
  app.add_option("--csv", output.csv, "write the series of each step into this folder")->type_name("DIR");
  app.add_flag("--quiet", output.quiet, "print errors only");
}

void setup_run(CLI::App& app, RunOptions& options, Action& action) {
  CLI::App* run_app = app.add_subcommand("run", "solve a project file");
  run_app->add_option("file", options.file, "project file; - is standard input")->required();
  add_output(*run_app, options.output);
  run_app->callback([&] { action = [&] { return run(options); }; });
}

void setup_describe(CLI::App& app, DescribeOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("describe", "fields, sources, limits and an example of one calculator");
  sub->add_option("id", options.id, "calculator, for example shaft.torsion")->required();
  sub->callback([&] { action = [&] { return describe(options); }; });
}

void setup_convert(CLI::App& app, ConvertOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("convert", "convert a quantity, or an expression that starts with =");
  sub->add_option("quantity", options.quantity, "for example \"2700 lbf*in\", \"2,5 kN·m\", \"=2*pi*30 rpm\"")->required();
  sub->add_option("unit", options.unit, "target unit; a readable one where missing");
  sub->footer(R"(Numbers: 30  1e6  2·10^6  1 200  1'200  2,5 (decimal comma)  1/2 in  1-1/2 in
Units:   SI with prefixes, N·m N*m Nm, mm² mm^2, min⁻¹ 1/min, parentheses after a /; deg rad rev rpm rev/s min h d
         bar atm psi ksi in ft mil lbf lb kip hp PS kgf t % °C K, and Н·м кН МПа мм кВт об/мин
What can be read in two ways is refused: 1,250 mm; N/m*s.)");
  sub->callback([&] { action = [&] { return convert(options); }; });
}

void setup_verify(CLI::App& app, VerifyOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("verify", "published reference cases: published value, ours, deviation, source");
  sub->add_option("files", options.files, "project files with [[expect]] entries; the built-in manual where missing");
  sub->callback([&] { action = [&] { return verify(options); }; });
}

void setup_tables(CLI::App& app, TablesOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("tables", "materials, preferred sizes and their sources");
  sub->add_option("table", options.table, "table, for example materials");
  sub->add_option("key", options.key, "row, for example C45E");
  sub->add_flag("--audit", options.audit, "every value whose source was not seen");
  sub->callback([&] { action = [&] { return tables(options); }; });
}

/// Flags of one calculator: the top-level fields of its input, and the rows that its providers look up.
void setup_calculator(CLI::App& element, const Calculator& calculator, CalculateOptions& options, Action& action) {
  const std::string_view id = calculator.id;
  CLI::App* sub = element.add_subcommand(std::string(id.substr(id.find('.') + 1)), calculator.title);
  options.calculator = &calculator;
  const auto add = [&](const std::string& key, const std::string& doc, const std::string& type) {
    sub->add_option_function<std::string>("--" + key, [&options, key](const std::string& text) { options.values.emplace_back(key, text); }, doc)
        ->type_name(type)->expected(1)->allow_extra_args(false);
  };
  bool material = false;
  for (const FieldInfo& f : calculator.input->fields) {
    const bool quantity = f.type == FieldInfo::Type::quantity;
    add(f.key, f.doc, quantity ? f.unit : f.has_fields() ? "TOML" : "WORD");
    material = material || std::string_view(f.provider.table) == "material";
  }
  if (material) add("material", "row of the materials table that fills what is missing", "NAME");
  add("title", "title of the report", "TEXT");
  add_output(*sub, options.output);
  sub->footer("`loadpath describe " + std::string(id) + "` tells more, with an example. A quantity is written with its unit: \"30 MPa\".");
  sub->callback([&] { action = [&] { return calculate(options); }; });
}

void setup_calculators(CLI::App& app, std::deque<CalculateOptions>& options, Action& action) {
  std::map<std::string, CLI::App*> elements;
  for (const Calculator* calculator : catalogue()) {
    const std::string element(calculator->element());
    CLI::App*& parent = elements[element];
    if (parent == nullptr) {
      parent = app.add_subcommand(element, "calculators for this machine element");
      parent->require_subcommand(0, 1)->allow_extras();
    }
    setup_calculator(*parent, *calculator, options.emplace_back(), action);
  }
}

/// What was typed where a command is expected, with the nearest one.
int unknown_command(const CLI::App& app, const std::string& prefix) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(sub->get_name());
  const auto words = app.remaining();
  if (words.empty()) {
    std::cerr << app.help();
    return wrong_input;
  }
  const std::string near = nearest(words[0], names);
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  std::cerr << "loadpath: there is no " << (prefix.empty() ? "command" : "calculator") << " '" << prefix << words[0] << "'\n  = help: "
            << (near.empty() ? "there is: " + all : "did you mean '" + prefix + near + "'?") << "\n";
  return wrong_input;
}

int no_action(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) return unknown_command(*sub, sub->get_name() + " ");
  return unknown_command(app, "");
}

/// Wrong words on the command line: CLI11's sentence, with the nearest flag.
int wrong_words(const CLI::App& app, const CLI::ParseError& error) {
  std::cerr << "loadpath: " << error.what() << "\n";
  const CLI::App* deepest = &app;
  while (!deepest->get_subcommands().empty()) deepest = deepest->get_subcommands().front();
  std::vector<std::string> flags;
  for (const CLI::Option* option : deepest->get_options()) flags.push_back("--" + (option->get_lnames().empty() ? "" : option->get_lnames()[0]));
  const auto words = app.remaining(true);
  const std::string near = words.empty() ? "" : nearest(words[0].substr(0, words[0].find('=')), flags);
  std::cerr << "  = help: " << (near.empty() ? "--help shows what there is" : "did you mean '" + near + "'?") << "\n";
  return wrong_input;
}

int dispatch(int argc, char** argv) {
  CLI::App app("loadpath: design calculator for machine elements, from the loads of a mechanism to the sizes of its parts", "loadpath");
  app.set_version_flag("--version", program());
  app.footer(footer);
  app.allow_extras();
  Action action;
  RunOptions run_options;
  DescribeOptions describe_options;
  ConvertOptions convert_options;
  VerifyOptions verify_options;
  TablesOptions tables_options;
  std::deque<CalculateOptions> calculate_options;
  setup_run(app, run_options, action);
  app.add_subcommand("list", "all calculators")->callback([&] { action = list; });
  setup_describe(app, describe_options, action);
  setup_convert(app, convert_options, action);
  setup_verify(app, verify_options, action);
  setup_tables(app, tables_options, action);
  app.add_subcommand("schema", "JSON Schema of a project file, for editors")->callback([&] { action = schema; });
  setup_calculators(app, calculate_options, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return wrong_words(app, error);
  }
  return action && app.remaining().empty() ? action() : no_action(app);
}

}  // namespace

std::string program() { return "loadpath " LOADPATH_VERSION; }

}  // namespace loadpath::cli

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { std::_Exit(loadpath::cli::interrupted); });
  try {
    return loadpath::cli::dispatch(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "loadpath: a fault of the program: " << error.what() << "\n";
    return loadpath::cli::fault;
  }
}
