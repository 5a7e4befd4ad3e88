// The output on the terminal: issues, a solved project in brief, tables; colour only if it is a terminal.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/terminal/layout.hpp"

#include <string>
#include <vector>

namespace loadpath::terminal {

/// The source text that issues point into.
struct SourceText {
  std::string file;
  std::string text;
};
/// Issues with their lines of these texts, as shown without a terminal.
std::string issues_text(const std::vector<Issue>& issues, const std::vector<SourceText>& sources);
/// The same on standard error.
void show_issues(const std::vector<Issue>& issues, const std::vector<SourceText>& sources);

/// A solved project in short: the verdict, and what to do about it.
void show_short(const project::Project& project);
/// The same of one calculator: with the formulas of the check that governs.
void show_calculation(const project::Project& project);
/// The verdict, and every failure mode with its state, its utilisation, and what that rests on.
void show_modes(const project::Project& project);
/// The verdict in a line, unless it is a pass.
void show_unless_passed(const project::Project& project);
/// A solved project in full: its parts, and last the answer. Brief: only the answer; full: with lists, formulas,
/// every verdict.
void show_project(const project::Project& project, report::Detail detail);

/// Paragraphs and tables of a document; its figures are not shown.
void show_tables(const std::vector<account::Block>& blocks);

}  // namespace loadpath::terminal
