// What the terminal shows: issues, a solved project in brief, tables; colour only where someone looks.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/terminal/layout.hpp"

#include <string>
#include <vector>

namespace loadpath::terminal {

/// What issues point into.
struct SourceText {
  std::string file;
  std::string text;
};
/// Issues with their lines of these texts, as they are shown where nobody looks at a terminal.
std::string issues_text(const std::vector<Issue>& issues, const std::vector<SourceText>& sources);
/// The same on standard error.
void show_issues(const std::vector<Issue>& issues, const std::vector<SourceText>& sources);

/// Whether text on this stream may be coloured: a terminal, and NO_COLOR is not set.
enum class Stream { out, error };
bool colours(Stream stream);

/// A solved project: its parts, and last the answer. Brief: that alone; full: with lists, formulas, every verdict.
void show_project(const project::Project& project, report::Detail detail);

/// Paragraphs and tables of a document; its figures are not shown.
void show_tables(const std::vector<account::Block>& blocks);

/// One coloured word for a state: "pass", "FAIL".
std::string state_word(account::State state);
/// The verdict in one line.
void show_headline(const account::Modes& modes);
/// The same of a mode: "outside the scope" where no calculator assesses it.
std::string mode_word(const account::Mode& mode);

}  // namespace loadpath::terminal
