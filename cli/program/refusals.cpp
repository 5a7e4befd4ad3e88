#include "cli/program/refusals.hpp"

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/text/meant.hpp"

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
    return refuse("unknown option '" + name + "'", "in the step of the file: " + name.substr(2) +
                                                       (name == "--accept" ? ".MODE" : ".INPUT") + " = \"reason\"");
  if ((name == "--P" || name == "--n") && has("T"))
    return refuse("unknown option '" + name + "'", "a power and a speed are a torque: --T \"=15 kW/(1450 rpm)\"");
  return refuse("unknown option '" + name + "'",
                meant(name.substr(2), options, say("`{1} --help` shows what there is", path_of(command)), "--").text());
}

/// "`loadpath diff BEFORE AFTER`", with the arguments that the command requires; empty if it requires none.
std::string call_of(const CLI::App& command) {
  std::string call;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || !option->get_required()) continue;
    std::string name = option->get_name(true);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    call += " " + name;
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
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(sub->get_name());
  }
  const bool top = &app == &command;
  if (const std::string call = call_of_template(command.get_name(), words[0]); !top && !call.empty())
    return refuse("'" + words[0] + "' is a template, not a calculator", "`" + call + "`");
  const std::string prefix = top ? "" : command.get_name() + " ";
  return refuse((top ? "unknown command '" : "unknown calculator '") + prefix + words[0] + "'",
                did_you_mean(words[0], names, there_is(names), prefix).text());
}

int wrong_words(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = deepest(app);
  const auto words = app.remaining(true);
  if (!words.empty() && words[0].starts_with("--")) return unknown_option(command, words[0]);
  const std::string help = "`" + path_of(command) + " --help` shows what there is";
  if (!words.empty()) return refuse("'" + words[0] + "' is not expected here", help);
  if (const CLI::Option* option = repeated_option(command)) {
    return refuse("'" + option->get_name() + "' is given more than once", "it takes one value: leave out all but one");
  }
  if (error.get_name() == "RequiredError") {
    if (const std::string call = call_of(command); !call.empty())
      return refuse("an argument is missing", call + "; " + help);
  }
  const std::string said = error.what();
  if (error.get_name() == "ArgumentMismatch")
    return refuse("'" + said.substr(0, said.find(':')) + "' needs a value", help);
  return refuse(said, help);
}

}  // namespace loadpath::cli
