#include "calculators/catalogue.hpp"
#include "cli/program/words.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>

namespace loadpath::cli {

std::string name_in_element(const Calculator& calculator) {
  const std::string_view id = calculator.id;
  return std::string(id.substr(id.find('.') + 1));
}

namespace {

/// The type that the help shows after a flag.
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

void add_angles(CLI::App& app, CalculateOptions& options) {
  app.add_option("--at", options.at,
                 "crank angles in place of a turn: --at \"30 deg\", or --at '[\"0 deg\", \"90 deg\"]'; its figures are "
                 "drawn at up to 12 of them")
      ->type_name("deg");
}

using AddFlag = std::function<void(const std::string& key, const std::string& doc, const std::string& type)>;

/// The name of a template, and the parameters of all of them, each once.
void add_templates(const Calculator& calculator, const AddFlag& add) {
  if (calculator.templates.empty()) return;
  add("template", "standard mechanism, by its parameters: `loadpath describe " + std::string(calculator.id) + "`",
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

/// "--n_2_set,--n_2": its key, and what it is called, too.
std::string flags_of(const FieldInfo& field) {
  std::string flags = std::string("--") + field.key;
  for (const std::string& other : listed_keys(field.also_called)) flags += ",--" + other;
  return flags;
}

/// Flags of one calculator: the top-level fields of its input, and the rows that its providers look up.
void add_flags(CLI::App& app, const Calculator& calculator, CalculateOptions& options) {
  const auto add_named = [&](const std::string& key, const std::string& flags, const std::string& doc,
                             const std::string& type) {
    app.add_option_function<std::string>(
           flags, [&options, key](const std::string& text) { options.values.emplace_back(key, text); }, doc)
        ->type_name(type)
        ->expected(1)
        ->allow_extra_args(false);
  };
  const auto add = [&](const std::string& key, const std::string& doc, const std::string& type) {
    add_named(key, "--" + key, doc, type);
  };
  for (const FieldInfo& f : calculator.input->fields) add_named(f.key, flags_of(f), f.doc, type_word(f));
  add_templates(calculator, add);
  for (const std::string& group : table_groups(calculator)) {
    add(group, "row of the " + group + " tables that fills what is missing", "NAME");
  }
  add("title", "title of the report", "TEXT");
  if (!calculator.modes.empty()) {
    app.add_option("--accept", options.accepted,
                   "accept a failure mode that is not assessed: --accept fatigue=\"static use\"")
        ->type_name("MODE=REASON")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
  }
  if (calculator.result != nullptr) {
    app.add_option("--because", options.because,
                   "reason why a typed value is more favourable than its row or record: --because "
                   "R_e=\"certificate 4711\"")
        ->type_name("KEY=REASON")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
  }
  app.add_option("--file", options.file,
                 "project file: its steps of this calculator and their references; other flags replace their fields")
      ->type_name("FILE");
  add_settings(app, options.settings);
  add_output(app, options.output);
  if (calculator.element() == "mechanism") add_angles(app, options);
}

void setup_calculator(CLI::App& element, const Calculator& calculator, CalculateOptions& options, Action& action,
                      Late& late) {
  CLI::App* sub = element.add_subcommand(name_in_element(calculator), calculator.title);
  sub->allow_extras(false);  // elements report them here, calculators through CLI11
  sub->footer("`loadpath describe " + std::string(calculator.id) +
              "` shows more, with an example. A quantity is written with its unit: \"30 MPa\".");
  late[sub] = [sub, &calculator, &options] { add_flags(*sub, calculator, options); };
  sub->preparse_callback([sub, &late](std::size_t) { late.at(sub)(); });
  sub->callback([&] {
    options.calculator = &calculator;
    action = [&] { return calculate(options); };
  });
}

}  // namespace

void setup_elements(CLI::App& app, CalculateOptions& options, Action& action, Late& late) {
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
                   ".NAME` shows inputs, results, sources and limits of one, with an example.");
    late[parent] = [parent, list = calculators, &options, &action, &late] {
      for (const Calculator* c : list) setup_calculator(*parent, *c, options, action, late);
    };
    parent->preparse_callback([parent, &late](std::size_t) { late.at(parent)(); });
  }
}

}  // namespace loadpath::cli
