// The manual page, from the same words as the help.
#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/program/command_line.hpp"

#include <iostream>
#include <set>
#include <sstream>

namespace loadpath::cli {

namespace {

/// Escapes text for roff: hyphens stay hyphens, nothing is a request.
std::string roff(std::string_view text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    begins = c == '\n';
  }
  return out;
}

/// "[\fISTEP\fR]", "\fB--report\fR \fIFILE\fR"
std::string option_words(const CLI::Option& option) {
  const std::string all = option.get_type_name(), type = all.substr(0, all.find(':'));  // without its validator
  const auto& names = option.get_lnames();
  if (names.empty()) return "\\fI" + roff(option.get_name(true)) + "\\fR";
  std::string words = "\\fB" + roff("--" + names[0]) + "\\fR";
  if (option.get_expected_max() > 0 && !type.empty()) words += " \\fI" + roff(type) + "\\fR";
  return words;
}

void show_options(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_name() == "--help" || option == app.get_help_ptr()) continue;
    std::cout << ".TP\n" << option_words(*option) << "\n" << roff(option->get_description()) << "\n";
  }
}

void show_command(const CLI::App& app) {
  std::cout << ".SS \"loadpath " << roff(app.get_name());
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
    const std::string name = roff(option->get_name(true));
    std::cout << (option->get_required() ? " " + name : " [" + name + "]");
  }
  std::cout << "\"\n" << roff(app.get_description()) << ".\n";
  show_options(app);
}

std::set<std::string> elements() {
  std::set<std::string> names;
  for (const Calculator* c : calculators()) names.emplace(c->element());
  return names;
}

void show_calculators() {
  std::cout << ".SH CALCULATORS\n"
            << roff(
                   "Each is a command of two words, `loadpath shaft torsion`, with the fields of its input as flags; "
                   "`loadpath describe shaft.torsion` shows them, with their units, limits and sources.")
            << "\n";
  for (const Calculator* c : calculators())
    std::cout << ".TP\n\\fB" << roff(c->id) << "\\fR\n" << roff(c->title) << "\n";
}

/// The lines after a title of the footer, unchanged.
void show_examples(const std::string& footer) {
  std::istringstream lines(footer);
  std::string line;
  std::cout << ".SH EXAMPLES\n.nf\n";
  while (std::getline(lines, line) && !line.empty()) {
    if (line.starts_with("  ")) std::cout << roff(line.substr(2)) << "\n";
  }
  std::cout << ".fi\n.SH \"EXIT STATUS\"\n";
  while (std::getline(lines, line)) std::cout << roff(line) << "\n";
}

}  // namespace

int man() {
  const CommandLine line;
  const std::set<std::string> calculators = elements();
  std::cout
      << ".TH LOADPATH 1 \"\" \"" << roff(program()) << "\" \"User commands\"\n"
      << ".SH NAME\nloadpath \\- design calculator for machine elements\n"
      << ".SH SYNOPSIS\n\\fBloadpath\\fR \\fICOMMAND\\fR [\\fIWORDS\\fR]\n"
      << ".SH DESCRIPTION\n"
      << roff(
             "A text file describes a design: a mechanism, its loads, the parts that carry them. `loadpath run` solves "
             "the reactions over a cycle, passes them to the calculators as design loads, and writes a design report.")
      << "\n.SH COMMANDS\n";
  for (const CLI::App* sub : line.app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!calculators.contains(sub->get_name())) show_command(*sub);
  }
  show_calculators();
  show_examples(line.app.get_footer());
  return passed;
}

}  // namespace loadpath::cli
