#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/files/commands.hpp"
#include "cli/files/starters.hpp"
#include "cli/settings/settings.hpp"
#include "cli/staged.hpp"

#include <filesystem>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace loadpath::cli {

namespace {

namespace fs = std::filesystem;

int refuse(const std::string& message, const std::string& hint) {
  std::cerr << "loadpath: " << message << "\n  = help: " << hint << "\n";
  return wrong_input;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Starter& starter : starters()) all.push_back(starter.name);
  return all;
}

/// The remedy for an unknown template: of a calculator, its example.
std::string template_hint(const std::string& name) {
  for (const Calculator* const calculator : calculators()) {
    const std::string id = calculator->id;
    if (id == name || id.starts_with(name + "."))
      return say("write the example of {1}: loadpath describe {1} --toml > project.toml; {2}", id, there_is(names()))
          .text();
  }
  return did_you_mean(name, names(), there_is(names())).text();
}

/// Whether a file of this name would take the place of something; a link into nowhere is something too.
bool is_there(const std::string& file) {
  std::error_code error;
  return file != "-" && fs::exists(fs::symlink_status(file, error));
}

/// One line of an answer; the proposal where it is empty, nothing if there is no more to read.
std::optional<std::string> ask(const std::string& question, const std::string& proposal) {
  std::cerr << question << (proposal.empty() ? "" : " [" + proposal + "]") << ": " << std::flush;
  std::string answer;
  if (!std::getline(std::cin, answer)) return std::nullopt;
  while (!answer.empty() && (answer.back() == ' ' || answer.back() == '\r')) answer.pop_back();
  answer.erase(0, std::min(answer.find_first_not_of(' '), answer.size()));
  return answer.empty() ? proposal : answer;
}

/// The template selected by the user, by its name or its number.
const Starter* ask_for_starter() {
  std::cerr << "Type of project?\n";
  for (std::size_t i = 0; i < starters().size(); ++i)
    std::cerr << "  " << i + 1 << "  " << starters()[i].name << ": " << starters()[i].title << "\n";
  while (const auto answer = ask("name or number", "")) {
    if (const Starter* const named = find_starter(*answer)) return named;
    const bool digit = answer->size() == 1 && *answer >= "1" && *answer <= std::to_string(starters().size());
    if (digit) return &starters()[static_cast<std::size_t>((*answer)[0] - '1')];
    std::cerr << "  " << did_you_mean(*answer, names(), there_is(names())).text() << "\n";
  }
  return nullptr;
}

bool ask_for_file(const Starter& starter, std::string& file) {
  while (auto answer = ask("file", starter.name + ".toml")) {
    file = std::move(*answer);
    if (!is_there(file)) return true;
    std::cerr << "  '" << file << "' already exists and is not overwritten: name another\n";
  }
  return false;
}

/// Prompts for the main numbers, each again until the project solves with it.
bool ask_for_values(const Starter& starter, const std::string& file, std::vector<std::string>& settings) {
  for (const MainValue& value : starter.values) {
    for (;;) {
      const auto answer = ask(value.question, value.text);
      if (!answer) return false;
      if (*answer == value.text) break;
      settings.push_back(value.key + "=" + *answer);
      std::vector<Issue> issues;
      filled(starter, file, settings, issues);
      if (!has_errors(issues)) break;
      terminal::show_issues(issues, {source_of(with_table(settings)), {file, starter.text}});
      settings.pop_back();
    }
  }
  return true;
}

/// A name as the shell takes it.
std::string shell_word(const std::string& name) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-+";
  if (name.find_first_not_of(plain) == std::string::npos) return name;
  std::string word = "'";
  for (const char c : name) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

void print_next_steps(const Starter& starter, const std::string& file) {
  const std::string name = shell_word(file), report = shell_word(fs::path(file).replace_extension(".html").string());
  const MainValue& first = starter.values.front();
  std::cout << "written: " << file << "\n\nEdit its numbers and steps as required; next:\n"
            << "  loadpath run " << name << " --report " << report << "\n"
            << "  loadpath why " << name << "\n"
            << "  loadpath run " << name << " --set values." << first.key << "=\"" << first.text << "\"\n"
            << "  loadpath --help\n";
}

int write(const Starter& starter, const std::string& file, const std::vector<std::string>& settings) {
  std::vector<Issue> issues;
  const std::string text = filled(starter, file == "-" ? starter.name + ".toml" : file, settings, issues);
  if (has_errors(issues)) {
    terminal::show_issues(issues, {source_of(with_table(settings)), {file, starter.text}});
    return wrong_input;
  }
  if (file == "-") {
    std::cout << text;
    return passed;
  }
  Scratch scratch;
  Staged staged(scratch);
  if (!staged.add(file, text) || !staged.finish()) return wrong_input;
  print_next_steps(starter, file);
  return passed;
}

int ended() { return refuse("the questions were not answered to the end", "nothing is written"); }

}  // namespace

int init(const InitOptions& options) {
  std::vector<std::string> settings = options.settings;
  if (options.starter.empty()) {
    if (isatty(STDIN_FILENO) == 0)
      return refuse("give a template", there_is(names()).text() + "; as in `loadpath init shaft`");
    const Starter* const starter = ask_for_starter();
    std::string file;
    if (starter == nullptr || !ask_for_file(*starter, file) || !ask_for_values(*starter, file, settings))
      return ended();
    return write(*starter, file, settings);
  }
  const Starter* const starter = find_starter(options.starter);
  if (starter == nullptr) return refuse("unknown template '" + options.starter + "'", template_hint(options.starter));
  const std::string file = options.file.empty() ? starter->name + ".toml" : options.file;
  if (is_there(file)) return refuse("'" + file + "' already exists and is not overwritten", "name another file");
  return write(*starter, file, settings);
}

}  // namespace loadpath::cli
