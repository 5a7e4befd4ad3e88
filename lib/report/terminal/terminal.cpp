#include "lib/report/terminal/terminal.hpp"

#include "lib/account/conclusion.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/summary/summary.hpp"
#include "lib/report/terminal/answer.hpp"
#include "lib/report/terminal/look.hpp"
#include "lib/report/terminal/rows.hpp"
#include "lib/report/terminal/short.hpp"
#include "lib/report/terminal/words.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace loadpath::terminal {

namespace {

/// Results worth a line on the terminal: only requested ones.
bool is_shown(const account::Entry& e) {
  return e.brief && e.role == Role::result && (!account::is_open(e) || !e.missing.empty());
}

/// The result of a search, and its reason.
void show_found(const project::Step& step) {
  std::vector<Row> rows;
  for (const account::Entry* e : report::chosen(step.account()))
    rows.push_back({"  found", e->path + " = " + value_text(*e), e->origin.text.text()});
  std::cout << columns(rows);
}

/// Values with a reason of the user.
void show_justified(const project::Step& step) {
  std::vector<Row> rows;
  for (const report::Justified& value : report::justified_values(step))
    rows.push_back({"  justified", value.name(), value.reason});
  std::cout << columns(rows);
}

void show_results(const project::Step& step) {
  std::vector<Row> rows;
  for (const account::Entry& e : step.account().results) {
    if (is_shown(e)) rows.push_back({"  " + e.path, value_text(e), e.doc});
  }
  std::cout << columns(rows);
}

std::string text_of(const account::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* message = std::get_if<Message>(&cell)) return message->text();
  if (const auto* quantity = std::get_if<account::Quantity>(&cell))
    return format_quantity(quantity->si, quantity->unit, quantity->digits);
  if (const auto* symbol = std::get_if<account::Symbol>(&cell)) return symbol->name;
  if (const auto* used = std::get_if<account::Utilisation>(&cell)) return report::utilisation_text(used->value);
  if (const auto* sized = std::get_if<account::Sized>(&cell)) return sized->text;
  return state_word(std::get<account::State>(cell));
}

void show_table(const account::Table& table) {
  std::cout << paragraph("  " + table.caption.text());
  std::vector<Row> rows;
  if (!table.head.empty()) rows.emplace_back();
  for (const Message& word : table.head) rows.back().push_back(word.text());
  for (const auto& row : table.rows) {
    rows.emplace_back();
    for (const account::Cell& cell : row) rows.back().push_back(text_of(cell));
  }
  for (auto& row : rows) row.front().insert(0, "    ");
  std::cout << columns(rows);
}

/// Lists of which the calculation does not work out every element: results of a search, sections that do not govern.
void show_lists(const project::Step& step) {
  const auto& account = step.account();
  if (!account.blocks.empty()) return;
  for (const account::Table& table : report::list_tables(report::pointers_to(account.results))) {
    const std::string list = table.caption.text();
    const auto worked_out = std::count_if(account.scopes.begin(), account.scopes.end(),
                                          [&](const std::string& scope) { return scope.starts_with(list + "["); });
    if (static_cast<std::size_t>(worked_out) < table.rows.size()) show_table(table);
  }
}

/// Tables specific to this kind of step: for a mechanism its extremes and its structure.
void show_tables(const project::Step& step) {
  for (const account::Block& block : step.account().blocks) {
    if (const auto* table = std::get_if<account::Table>(&block)) show_table(*table);
  }
}

void show_derivation(const project::Step& step) {
  const auto& lines = step.account().derivation;
  if (!step.account().governing.empty()) std::cout << "  calculated " << step.account().governing.text() << ":\n";
  const bool several = std::any_of(lines.begin(), lines.end(), [](const auto& d) { return d.scope.ends_with("[2]"); });
  std::vector<Row> rows;
  rows.reserve(lines.size());
  for (const account::Derived& line : lines) rows.push_back(line_row(line, several));
  std::cout << columns(rows);
}

void show_verdicts(const std::vector<account::Verdict>& verdicts) {
  std::vector<Row> rows;
  for (const account::Verdict& v : verdicts) {
    const auto* number = std::get_if<account::Quantity>(&v.value);
    const auto* words = std::get_if<Message>(&v.value);
    const std::string value = number != nullptr  ? format_quantity(number->si, number->unit, 4)
                              : words != nullptr ? words->text()
                                                 : "";
    rows.push_back({"  " + state_word(v.state), v.step + "." + v.symbol, value,
                    v.meaning.text() + (v.note.empty() ? "" : "; " + v.note.text())});
  }
  std::cout << columns(rows);
}

/// Hints sometimes name many words. Lines of a file stay unbroken, because the caret is below its character.
std::string with_short_hints(const std::string& text) {
  constexpr std::string_view mark = "= help: ";
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    const bool hint = line.find_first_not_of(' ') == line.find(mark);
    all += hint && !line.empty() ? paragraph(line, mark.size()) : line + "\n";
    at = end + 1;
  }
  return all;
}

void show_step(const project::Step& step, bool in_full) {
  std::cout << step.name() << ": " << step.input().calculator->title << " (" << step.input().calculator->id << ")\n";
  show_found(step);
  show_justified(step);
  if (in_full) show_derivation(step);
  if (in_full && !step.account().blocks.empty())
    show_tables(step);
  else
    show_results(step);
  if (in_full) show_lists(step);
  std::cout << "\n";
}

}  // namespace

void show_tables(const std::vector<account::Block>& blocks) {
  for (const account::Block& block : blocks) {
    if (const auto* text = std::get_if<account::Paragraph>(&block)) std::cout << paragraph(text->text.text()) << "\n";
    if (const auto* table = std::get_if<account::Table>(&block)) show_table(*table);
  }
}

std::string issues_text(const std::vector<Issue>& issues, const std::vector<SourceText>& sources) {
  return render(issues, [&](const std::string& file) {
    const auto found =
        std::find_if(sources.begin(), sources.end(), [&](const SourceText& s) { return s.file == file; });
    return found == sources.end() ? std::string() : found->text;
  });
}

void show_issues(const std::vector<Issue>& issues, const std::vector<SourceText>& sources) {
  constexpr std::size_t most = 30;  // one slip can break a rule at every link of a long chain
  const std::vector<Issue> first(issues.begin(),
                                 issues.begin() + static_cast<std::ptrdiff_t>(std::min(most, issues.size())));
  const std::string text = issues_text(first, sources);
  std::cerr << (isatty(STDERR_FILENO) != 0 ? with_short_hints(text) : text);
  if (issues.size() > most) std::cerr << "loadpath: " << issues.size() - most << " more of these are not shown\n";
}

void show_short(const project::Project& project) {
  std::cout << short_answer(report::summarise(project), look_of_output());
}

void show_calculation(const project::Project& project) {
  if (project.steps.size() != 1) return show_short(project);
  std::cout << short_answer(report::summarise(project), *project.steps.front(), look_of_output());
}

void show_modes(const project::Project& project) {
  const Look look = look_of_output();
  const report::Summary summary = report::summarise(project);
  std::cout << headline(summary.modes, summary.subject, look.width);
  if (!summary.title.empty()) std::cout << paragraph(summary.title, 2, look.width);
  std::vector<Row> rows;
  for (const account::Mode& mode : account::in_order(summary.modes)) {
    const std::string used = mode.utilisation ? report::utilisation_text(*mode.utilisation) : "";
    rows.push_back({"  " + mode_word(mode), mode.step + "." + mode.id, used,
                    mode.title.text() + "; " + account::reason(mode).text()});
  }
  for (const auto& step : project.steps) {
    for (const report::Justified& value : report::justified_values(*step))
      rows.push_back({"  justified", step->name() + "." + value.input, "", value.name() + ": " + value.reason});
  }
  std::cout << "\n" << in_signs_of(columns(rows, look.width), look);
}

void show_unless_passed(const project::Project& project) {
  const account::Modes modes = project::modes(project);
  if (account::conclude(modes).headline != account::Headline::pass)
    std::cout << headline(modes, report::subject_of(project), look_of_output().width);
}

void show_project(const project::Project& project, report::Detail detail) {
  const bool in_full = detail == report::Detail::full;
  std::cout << headline(project::modes(project), report::subject_of(project), line_width());
  if (!project.title.empty()) std::cout << project.title << "\n\n";
  if (detail != report::Detail::brief) {
    for (const auto& step : project.steps) show_step(*step, in_full);
  }
  const auto verdicts = project::verdicts(project);
  if (in_full && !verdicts.empty()) {
    show_verdicts(verdicts);
    std::cout << "\n";
  }
  show_answer(project, in_full);
}

}  // namespace loadpath::terminal
