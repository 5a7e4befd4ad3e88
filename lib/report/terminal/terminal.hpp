// What the terminal shows: issues, a solved project in brief, tables; colour only where someone looks.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/terminal/layout.hpp"

#include <string>
#include <vector>

namespace loadpath::terminal {

/// Issues on standard error. `sources` gives the text of what they point into.
struct SourceText {
  std::string file;
  std::string text;
};
void show_issues(const std::vector<Issue>& issues, const std::vector<SourceText>& sources);

/// Whether text on this stream may be coloured: a terminal, and NO_COLOR is not set.
enum class Stream { out, error };
bool colours(Stream stream);

/// The results and verdicts of a solved project; `in_full`: its formulas too, and of a mechanism its tables.
void show_project(const project::Project& project, bool in_full);

/// Paragraphs and tables of a document; its figures are not shown.
void show_tables(const std::vector<account::Block>& blocks);

/// One coloured word for a state: "pass", "FAIL".
std::string state_word(account::State state);

}  // namespace loadpath::terminal
