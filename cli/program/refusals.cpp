#include "cli/program/refusals.hpp"

#include "calculators/catalogue.hpp"
#include "cli/catalogue/not_included.hpp"
#include "cli/catalogue/search.hpp"
#include "cli/commands.hpp"
#include "cli/typed_remedies.hpp"
#include "lib/project/read/meant/elsewhere.hpp"
#include "lib/table/library.hpp"
#include "lib/text/meant.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <iostream>

namespace loadpath::cli {

namespace {

int refuse(const std::string& what, const std::string& help) {
  std::cerr << "loadpath: " << what << "\n  = help: " << help << "\n";
  return wrong_input;
}

/// "loadpath shaft torsion"
std::string path_of(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name()
                                         : path_of(*command.get_parent()) + " " + command.get_name();
}

std::vector<std::string> subcommands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

/// The calculator of a command, shaft.torsion of `loadpath shaft torsion`; null for any other command.
const Calculator* calculator_named_by(const CLI::App& command) {
  const CLI::App* const element = command.get_parent();
  return element == nullptr ? nullptr : find_calculator(calculators(), element->get_name() + "." + command.get_name());
}

/// An input of a group or of a list's elements that was typed as a flag: --n of the crank, --crank.speed; empty if it
/// is none.
std::string input_of_table(const CLI::App& command, const std::string& flag) {
  const Calculator* const calculator = calculator_named_by(command);
  if (calculator == nullptr) return "";
  const auto fields = calculator->input->fields;
  const std::size_t point = flag.find('.');
  if (point == std::string::npos) return as_flags(project::input_within(flag, fields).text());
  const FieldInfo* const outer = find_input(fields, flag.substr(0, point));
  if (outer == nullptr || !outer->has_fields()) return "";
  return as_flags(project::input_within(flag.substr(point + 1), std::span(outer, 1)).text());
}

/// The result that an unknown option names: it is computed, and cannot be given. Null if there is none.
const FieldInfo* result_named(const CLI::App& command, const std::string& flag) {
  const Calculator* const calculator = calculator_named_by(command);
  return calculator == nullptr || calculator->result == nullptr ? nullptr
                                                                : find_field(calculator->result->fields, flag);
}

int unknown_option(const CLI::App& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<Known> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& long_name : option->get_lnames()) options.push_back({long_name, option->get_description()});
  }
  const auto has = [&](const std::string& option) {
    return std::any_of(options.begin(), options.end(), [&](const Known& one) { return one.word == option; });
  };
  if ((name == "--accept" || name == "--because") && !has(name.substr(2)))
    return refuse("unknown option '" + name + "'", name.substr(2) +
                                                       " goes into the file, in its step: " + name.substr(2) +
                                                       (name == "--accept" ? ".MODE" : ".INPUT") + " = \"reason\"");
  if ((name == "--P" || name == "--n") && has("T"))
    return refuse("unknown option '" + name + "'", "a power and a speed are a torque: --T \"=15 kW/(1450 rpm)\"");
  if (const auto subs = subcommands_of(command); command.get_parent() != nullptr && !subs.empty())
    return refuse("unknown option '" + name + "'", subs.size() == 1
                                                       ? "name the calculator: " + path_of(command) + " " + subs[0]
                                                       : "name the calculator; " + there_is(subs).text());
  std::string otherwise = name.size() > 2 ? input_of_table(command, name.substr(2)) : "";
  if (otherwise.empty()) otherwise = "`" + path_of(command) + " --help` lists all options";
  const FieldInfo* const result = name.size() > 2 ? result_named(command, name.substr(2)) : nullptr;
  return refuse(
      result == nullptr ? "unknown option '" + name + "'" : "'" + name + "' is a result, not an input: " + result->doc,
      meant(name.substr(2), options, say("{1}", otherwise), "--").text());
}

/// "FILE", as the help calls an argument.
std::string shown_name(const CLI::Option& argument) {
  std::string name = argument.get_name(true);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

/// The first required argument that was not given; null if there is none.
const CLI::Option* missing_argument(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && option->get_required() && option->count() == 0) return option;
  }
  return nullptr;
}

/// "`loadpath diff BEFORE AFTER`", with the arguments that the command requires; empty if it requires none.
std::string call_of(const CLI::App& command) {
  std::string call;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || !option->get_required()) continue;
    call += " " + shown_name(*option);
  }
  return call.empty() ? "" : "`" + path_of(command) + call + "`";
}

/// "loadpath mechanism planar --template slider_crank"; empty where no calculator of the element has such a template.
std::string call_of_template(const std::string& element, const std::string& name) {
  for (const Calculator* calculator : calculators()) {
    if (calculator->element() != element || find_template(*calculator, name) == nullptr) continue;
    std::string call = "loadpath ";
    call.append(element).append(" ").append(std::string(calculator->id).substr(element.size() + 1));
    return call.append(" --template ").append(name);
  }
  return "";
}

/// An option of the command that takes one value and was given several; null if there is none.
const CLI::Option* repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 1 && option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw) return option;
  }
  return nullptr;
}

/// The help for an unknown command: a subject that is not included, a calculator of this name, a table.
std::string command_meant(const std::string& word, const std::vector<std::string>& commands) {
  if (const auto subjects = not_included(word, true); !subjects.empty())
    return "not included: " + std::string(subjects.front()->what) + "; `loadpath list " + word + "` shows the nearest";
  for (const Calculator* calculator : calculators()) {
    if (std::string_view(calculator->id).substr(calculator->element().size() + 1) == word)
      return "did you mean '" + std::string(calculator->element()) + " " + word + "'?";
  }
  if (table::first_table_in(word) != nullptr) return "did you mean 'tables " + word + "'?";
  if (word == "solve" || word == "report" || word == "calculate") return "did you mean 'run' (solves a project file)?";
  if (word == "help") return "`loadpath --help`, or `loadpath COMMAND --help`";
  if (word.ends_with(".toml")) return "`loadpath run " + word + "` solves a project file";
  const std::string near = nearest(word, commands);
  if (near.empty() && !search(word).named.empty()) return "`loadpath list " + word + "` finds calculators";
  return did_you_mean(word, commands, there_is(commands)).text();
}

/// "--T "2700 N*m"" where a blank has divided the value of an option before this word; empty if none has.
std::string divided_value(const CLI::App& command, const std::string& word, const std::vector<std::string>& typed) {
  const auto takes_value = [&](const std::string& flag) {
    const CLI::Option* const option = flag.starts_with("--") ? command.get_option_no_throw(flag) : nullptr;
    return option != nullptr && option->get_items_expected_max() > 0;
  };
  for (std::size_t i = 2; i < typed.size(); ++i) {
    if (typed[i] != word || typed[i - 1].starts_with('-')) continue;
    if (!takes_value(typed[i - 2])) continue;
    std::string value = typed[i - 1];
    for (std::size_t k = i; k < typed.size() && !typed[k].starts_with('-'); ++k) value += " " + typed[k];
    return typed[i - 2] + " \"" + value + "\"";
  }
  return "";
}

/// "0.500000" as "0.5"
std::string short_number(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// "run,bash" as "run, bash"; a word that only the scripts of the shells use is left out.
std::string listed_choices(std::string_view words) {
  std::string all;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(','));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (word != "candidates") all.append(all.empty() ? "" : ", ").append(word);
  }
  return all;
}

/// Refuses a value that is not a choice or not in its range; 0 for any other text of the library:
/// "--detail: long not in {brief,normal,full}", "--jobs: Value 0 not in range 1 to 1024".
int wrong_value(const std::string& said, const std::string& help) {
  const std::size_t value = said.find(": "), choices = said.find(" not in {"), range = said.find(" not in range ");
  if (value == std::string::npos) return 0;
  const std::string option = said.substr(0, value);
  if (choices != std::string::npos && said.ends_with('}'))
    return refuse("'" + said.substr(value + 2, choices - value - 2) + "' is not a value of " + option,
                  "one of " + listed_choices(std::string_view(said).substr(choices + 9, said.size() - choices - 10)));
  const std::string word = ": Value ";
  if (range == std::string::npos || !said.substr(value).starts_with(word)) return 0;
  const std::string given = said.substr(value + word.size(), range - value - word.size());
  const std::size_t from = range + std::string_view(" not in range ").size(), to = said.find(" to ", from);
  const std::string least = said.substr(from, to - from), most = said.substr(to + 4);
  constexpr std::size_t longest = 20;  // digits of the largest number that there is
  const std::string kind = least.find('.') == std::string::npos ? "an integer" : "a number";
  return refuse(option + ": '" + given + "' is not " + kind +
                    (most.size() > longest ? " of " + short_number(least) + " or more"
                                           : " from " + short_number(least) + " to " + short_number(most)),
                help);
}

}  // namespace

const CLI::App& deepest(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : deepest(*chosen.front());
}

int unknown_command(const CLI::App& app, const CLI::App& command) {
  const auto words = command.remaining();
  if (words.empty()) {
    std::cerr << app.help();
    return wrong_input;
  }
  if (words[0].starts_with('-')) return unknown_option(command, words[0]);
  const std::vector<std::string> names = subcommands_of(command);
  const bool top = &app == &command;
  if (const std::string call = call_of_template(command.get_name(), words[0]); !top && !call.empty())
    return refuse("'" + words[0] + "' is a template, not a calculator", "`" + call + "`");
  const std::string prefix = top ? "" : command.get_name() + " ";
  if (top) return refuse("unknown command '" + words[0] + "'", command_meant(words[0], names));
  return refuse("unknown calculator '" + prefix + words[0] + "'",
                did_you_mean(words[0], names, there_is(names), prefix).text());
}

int wrong_words(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& typed) {
  const CLI::App& command = deepest(app);
  const auto words = app.remaining(true);
  if (!words.empty() && words[0].starts_with("--")) return unknown_option(command, words[0]);
  const std::string help = "`" + path_of(command) + " --help` lists all options";
  if (!words.empty()) {
    const std::string whole = divided_value(command, words[0], typed);
    return refuse("'" + words[0] + "' is not expected here",
                  whole.empty() ? help : "a value with a blank needs quotes: " + whole);
  }
  if (const CLI::Option* option = repeated_option(command)) {
    return refuse("'" + option->get_name() + "' is given more than once", "it takes one value: leave out all but one");
  }
  if (error.get_name() == "RequiredError") {
    const CLI::Option* const missing = missing_argument(command);
    if (missing != nullptr) return refuse(shown_name(*missing) + " is missing", call_of(command) + "; " + help);
  }
  const std::string said = error.what();
  if (said == "file is required") return refuse("FILE is missing", "`" + path_of(command) + " FILE`; " + help);
  if (const int refused = wrong_value(said, help); refused != 0) return refused;
  if (const std::size_t both = said.find(" excludes "); both != std::string::npos)
    return refuse("'" + said.substr(0, both) + "' and '" + said.substr(both + 10) + "' cannot be given together",
                  "leave one of them out");
  if (error.get_name() == "ArgumentMismatch")
    return refuse("'" + said.substr(0, said.find(':')) + "' needs a value", help);
  return refuse(said, help);
}

}  // namespace loadpath::cli
