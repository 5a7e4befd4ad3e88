#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/parts/parts.hpp"
#include "cli/setup.hpp"
#include "lib/text/issue.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>
#include <map>

namespace loadpath::cli {

namespace {

constexpr auto footer = R"(Examples:
  loadpath run examples/slotted-lever/project.toml --report report.html
  loadpath sweep examples/strut-sweep/project.toml --report sweep.html
  loadpath why examples/press-link/project.toml lever
  loadpath shaft torsion --T "2700 N*m" --tau_adm "30 MPa"
  loadpath mechanism planar --file examples/toggle-press/project.toml --svg press.svg
  loadpath convert "2700 lbf*in" "N*m"

Exit codes: 0 solved, and every mode of failure that applies is judged and passes, or accepted; 1 solved, but one fails,
is not judged, not covered or not available;
2 the input is wrong, nothing is written; 3 a fault of the program, or of standard output; 130 interrupted.)";

void add_output(CLI::App& app, OutputOptions& output) {
  app.add_option("--report", output.reports, "write a report: FILE.html, FILE.md or FILE.pdf")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_flag("--json", output.json, "print the results as one JSON object");
  app.add_option("--csv", output.csv, "write the series: each step's into a folder, or the one's into FILE.csv")
      ->type_name("PATH");
  app.add_option("--series", output.series,
                 "the series that CSV and JSON hold, by name: drive.M,links.*.N; * is any characters")
      ->type_name("NAMES")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_flag("--quiet", output.quiet, "print errors only");
  app.add_flag("--strict", output.strict, "count modes of failure that are open as not judged: exit code 1");
}

void setup_run(CLI::App& app, RunOptions& options, Action& action) {
  CLI::App* run_app = app.add_subcommand("run", "solve a project file");
  run_app->add_option("file", options.file, "project file; - is standard input")->required();
  run_app->add_option("--point", options.point, "the point of this number of the project's sweep, counted from 0")
      ->type_name("N");
  add_points(*run_app, options.points);
  add_output(*run_app, options.output);
  run_app->callback([&] { action = [&] { return run(options); }; });
}

void setup_why(CLI::App& app, WhyOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("why", "what decides over a step: what was chosen, what judges it, its formulas");
  sub->add_option("file", options.file, "project file; - is standard input")->required();
  sub->add_option("of", options.of,
                  "step, or a result or mode of failure of one: rod, rod.u; every step where missing");
  sub->callback([&] { action = [&] { return why(options); }; });
}

void setup_describe(CLI::App& app, DescribeOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("describe", "fields, sources, limits and an example of one calculator");
  sub->add_option("id", options.id, "calculator, for example shaft.torsion")->required();
  sub->add_option("name", options.name, "its name where the id is an element alone, as in shaft torsion");
  sub->callback([&] { action = [&] { return describe(options); }; });
}

void setup_list(CLI::App& app, ListOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("list", "all calculators, or those of an element");
  sub->add_option("element", options.element, "for example shaft");
  sub->callback([&] { action = [&] { return list(options); }; });
}

void setup_convert(CLI::App& app, ConvertOptions& options, Action& action) {
  CLI::App* sub = app.add_subcommand("convert", "convert a quantity, or an expression that starts with =");
  sub->add_option("quantity", options.quantity, "for example \"2700 lbf*in\", \"2,5 kN·m\", \"=30 kW / (1500 rpm)\"")
      ->required();
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
  sub->add_option("--where", options.where,
                  "rows that hold this, as in \"I_min >= 300 cm^4 and h <= 200 mm\"; a value that depends on the size "
                  "counts at the smallest")
      ->type_name("CONDITION");
  sub->add_option("--sort", options.sort, "column to sort by, as in mass or h; with - before it from the largest")
      ->type_name("COLUMN");
  sub->add_flag("--audit", options.audit, "every value whose source was not seen");
  sub->callback([&] { action = [&] { return tables(options); }; });
}

/// What the help shows behind a flag.
std::string type_word(const FieldInfo& field) {
  switch (field.type) {
    case FieldInfo::Type::quantity:
      return std::string_view(field.unit) == "-" ? "NUMBER" : field.unit;
    case FieldInfo::Type::count:
      return "COUNT";
    case FieldInfo::Type::choice:
    case FieldInfo::Type::name:
      return "WORD";
    case FieldInfo::Type::formula:
      return "FORMULA";
    case FieldInfo::Type::group:
    case FieldInfo::Type::list:
      return "TOML";
    case FieldInfo::Type::record:
      return "RECORD";
  }
  return "";
}

void add_drawing(CLI::App& app, CalculateOptions& options) {
  app.add_option("--at", options.at,
                 "crank angles in place of a turn: --at \"30 deg\", or --at '[\"0 deg\", \"90 deg\"]'")
      ->type_name("deg");
  app.add_option("--svg", options.output.svg,
                 "write the mechanism at the first position as FILE.svg, or every figure "
                 "into a folder (at up to 12 given angles)")
      ->type_name("PATH");
  app.add_option("--dxf", options.output.dxf,
                 "write the mechanism at the first position for CAD (DXF R12, mm); of several, into a folder")
      ->type_name("FILE");
}

using AddFlag = std::function<void(const std::string& key, const std::string& doc, const std::string& type)>;

/// The name of a template, and the parameters of all of them, each once.
void add_templates(const Calculator& calculator, const AddFlag& add) {
  if (calculator.templates.empty()) return;
  add("template", "input known in shape, by its parameters: `loadpath describe " + std::string(calculator.id) + "`",
      "NAME");
  std::map<std::string, std::string> users;
  for (const Template* t : calculator.templates) {
    for (const FieldInfo& f : t->parameters->fields)
      users[f.key] += (users[f.key].empty() ? "" : ", ") + std::string(t->id);
  }
  for (const Template* t : calculator.templates) {
    for (const FieldInfo& f : t->parameters->fields) {
      if (const auto used = users.extract(f.key)) add(f.key, "of " + used.mapped(), type_word(f));
    }
  }
}

/// Flags of one calculator: the top-level fields of its input, and the rows that its providers look up.
void add_flags(CLI::App& app, const Calculator& calculator, CalculateOptions& options) {
  const auto add = [&](const std::string& key, const std::string& doc, const std::string& type) {
    app.add_option_function<std::string>(
           "--" + key, [&options, key](const std::string& text) { options.values.emplace_back(key, text); }, doc)
        ->type_name(type)
        ->expected(1)
        ->allow_extra_args(false);
  };
  for (const FieldInfo& f : calculator.input->fields) add(f.key, f.doc, type_word(f));
  add_templates(calculator, add);
  for (const std::string& group : table_groups(calculator)) {
    add(group, "row of the " + group + " tables that fills what is missing", "NAME");
  }
  add("title", "title of the report", "TEXT");
  if (!calculator.modes.empty()) {
    app.add_option("--accept", options.accepted,
                   "answer for a mode of failure that is not judged: --accept fatigue=\"stands still\"")
        ->type_name("MODE=REASON")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
  }
  app.add_option("--file", options.file,
                 "project file: its steps of this calculator, and what they refer to; other flags replace their fields")
      ->type_name("FILE");
  add_output(app, options.output);
  if (calculator.element() == "mechanism") add_drawing(app, options);
}

std::string name_in_element(const Calculator& calculator) {
  const std::string_view id = calculator.id;
  return std::string(id.substr(id.find('.') + 1));
}

void setup_calculator(CLI::App& element, const Calculator& calculator, CalculateOptions& options, Action& action) {
  CLI::App* sub = element.add_subcommand(name_in_element(calculator), calculator.title);
  sub->allow_extras(false);  // an element's are told by us, a calculator's by CLI11
  sub->footer("`loadpath describe " + std::string(calculator.id) +
              "` tells more, with an example. A quantity is written with its unit: \"30 MPa\".");
  sub->preparse_callback([sub, &calculator, &options](std::size_t) { add_flags(*sub, calculator, options); });
  sub->callback([&] {
    options.calculator = &calculator;
    action = [&] { return calculate(options); };
  });
}

/// Every element of the catalogue. Its calculators and their flags are set up once it is named: those of all would take
/// longer than what most commands do.
void setup_elements(CLI::App& app, CalculateOptions& options, Action& action) {
  std::vector<std::vector<const Calculator*>> elements;  // in the order of the catalogue
  for (const Calculator* c : calculators()) {
    const auto own = std::find_if(elements.begin(), elements.end(),
                                  [&](const auto& element) { return element[0]->element() == c->element(); });
    own == elements.end() ? elements.push_back({c}) : own->push_back(c);
  }
  for (const auto& calculators : elements) {
    const std::string element(calculators[0]->element());
    std::string names;
    for (const Calculator* c : calculators) names += (names.empty() ? "" : ", ") + name_in_element(*c);
    CLI::App* parent = app.add_subcommand(element, "calculators: " + names);
    parent->require_subcommand(0, 1);
    parent->allow_extras();
    parent->footer("`loadpath describe " + element +
                   ".NAME` tells the fields, sources and limits of one, with an example.");
    parent->preparse_callback([parent, list = calculators, &options, &action](std::size_t) {
      for (const Calculator* c : list) setup_calculator(*parent, *c, options, action);
    });
  }
}

int refuse(const std::string& what, const std::string& help) {
  std::cerr << "loadpath: " << what << "\n  = help: " << help << "\n";
  return wrong_input;
}

const CLI::App& deepest(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : deepest(*chosen.front());
}

/// "loadpath shaft torsion"
std::string path_of(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name()
                                         : path_of(*command.get_parent()) + " " + command.get_name();
}

int unknown_option(const CLI::App& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& long_name : option->get_lnames()) options.push_back("--" + long_name);
  }
  return refuse("there is no option '" + name + "'",
                did_you_mean(name, options, say("`{1} --help` shows what there is", path_of(command))).text());
}

/// What was typed where a command, or the calculator of an element, is expected.
int unknown_command(const CLI::App& app, const CLI::App& command) {
  const auto words = command.remaining();
  if (words.empty()) {
    std::cerr << app.help();
    return wrong_input;
  }
  if (words[0].starts_with('-')) return unknown_option(command, words[0]);
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(sub->get_name());
  }
  const bool top = &app == &command;
  const std::string prefix = top ? "" : command.get_name() + " ";
  return refuse((top ? "there is no command '" : "there is no calculator '") + prefix + words[0] + "'",
                did_you_mean(words[0], names, there_is(names), prefix).text());
}

/// An option of the command that takes one value and was given several; null where there is none.
const CLI::Option* repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 1 && option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw) return option;
  }
  return nullptr;
}

/// Wrong words on the command line: an unknown option with the nearest one, or CLI11's sentence.
int wrong_words(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = deepest(app);
  const auto words = app.remaining(true);
  if (!words.empty() && words[0].starts_with("--")) return unknown_option(command, words[0]);
  const std::string help = "`" + path_of(command) + " --help` shows what there is";
  if (!words.empty()) return refuse("'" + words[0] + "' is not expected here", help);
  if (const CLI::Option* option = repeated_option(command)) {
    return refuse("'" + option->get_name() + "' is given more than once", "it takes one value: leave out all but one");
  }
  const std::string said = error.what();
  if (error.get_name() == "ArgumentMismatch")
    return refuse("'" + said.substr(0, said.find(':')) + "' needs a value", help);
  return refuse(said, help);
}

/// What was typed; the id of a calculator, shaft.torsion, as the two words that it is here.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const Calculator* const named = words.empty() ? nullptr : find_calculator(calculators(), words[0]);
  if (named == nullptr) return words;
  words[0] = name_in_element(*named);
  words.insert(words.begin(), std::string(named->element()));
  return words;
}

int dispatch(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--version") {  // asked by scripts, again and again: nothing is set up
    std::cout << program() << "\n";
    return passed;
  }
  CLI::App app(
      "loadpath: design calculator for machine elements, from the loads of a mechanism to the sizes of its parts",
      "loadpath");
  app.set_version_flag("--version", program());
  app.require_subcommand(0, 1);
  Action action;
  RunOptions run_options;
  SweepOptions sweep_options;
  WhyOptions why_options;
  ListOptions list_options;
  DescribeOptions describe_options;
  ConvertOptions convert_options;
  VerifyOptions verify_options;
  TablesOptions tables_options;
  CalculateOptions calculate_options;
  setup_run(app, run_options, action);
  setup_sweep(app, sweep_options, action);
  setup_why(app, why_options, action);
  setup_list(app, list_options, action);
  setup_describe(app, describe_options, action);
  setup_convert(app, convert_options, action);
  setup_verify(app, verify_options, action);
  setup_tables(app, tables_options, action);
  app.add_subcommand("schema", "JSON Schema of a project file, for editors")->callback([&] { action = schema; });
  setup_elements(app, calculate_options, action);
  app.footer(footer);  // both only here: commands inherit what is set before they are made
  app.allow_extras();
  std::vector<std::string> words = words_of(argc, argv);
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return wrong_words(app, error);
  }
  return action && app.remaining().empty() ? action() : unknown_command(app, deepest(app));
}

int guarded(int argc, char** argv) {
  try {
    const int code = dispatch(argc, argv);
    if (std::cout.flush()) return code;
    std::cerr << "loadpath: standard output cannot be written\n";
    return fault;
  } catch (const std::exception& error) {
    std::cerr << "loadpath: a fault of the program: " << error.what() << "\n";
    return fault;
  }
}

}  // namespace

std::string program() { return "loadpath " LOADPATH_VERSION; }

}  // namespace loadpath::cli

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { std::_Exit(loadpath::cli::interrupted); });
  return loadpath::cli::run_program([&] { return loadpath::cli::guarded(argc, argv); });
}
