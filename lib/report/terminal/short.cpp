#include "lib/report/terminal/short.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/terminal/blocks.hpp"
#include "lib/report/terminal/layout.hpp"
#include "lib/report/terminal/rows.hpp"
#include "lib/report/terminal/short_table.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::terminal {

namespace {

using report::Component;
using report::Summary;

Lines title_lines(const Summary& summary, const Look& look) {
  Lines lines = verdict_lines(summary, look);
  if (!summary.title.empty()) {
    for (std::string& line : lines_of(summary.title, look.width, 2)) lines.push_back(std::move(line));
  }
  return lines;
}

Lines rows_as_lines(std::vector<std::vector<std::string>> rows, const Look& look) {
  Lines lines;
  const std::string all = columns(rows, look.width);
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find('\n', at), all.size());
    for (std::string& line : lines_of(all.substr(at, end - at), look.width, 4)) lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

Lines search_lines(const Summary& summary, const Look& look) {
  Lines lines;
  for (const report::FailedSearch& search : summary.searches) {
    for (std::string& line : lines_of("No solution: " + search.text, look.width, 2)) lines.push_back(std::move(line));
    std::vector<std::vector<std::string>> rows;
    for (const account::TriedSize& tried : search.tried)
      rows.push_back({"  " + tried.name, report::failed_mode_text(tried)});
    if (rows.size() < 2) continue;
    rows.insert(rows.begin(), {"  tried", "fails"});
    for (std::string& line : rows_as_lines(std::move(rows), look)) lines.push_back(std::move(line));
  }
  return lines;
}

void add_details(const Component& component, const Look& look, Lines& lines) {
  if (component.details.empty()) return;
  for (std::string& line : lines_of("  " + component.details, look.width, 2)) lines.push_back(std::move(line));
}

/// The components, the details of a single one, and the next sizes right below them.
Lines part_lines(const Summary& summary, const Limits& limits, const Look& look) {
  const auto shown = most_telling(summary.components, limits.of(Limits::components));
  Lines lines = component_lines(shown, look);
  if (const std::size_t left = summary.components.size() - shown.size(); left > 0) {
    double most = -1.0;
    for (const Component& c : summary.components) {
      const bool dropped = std::ranges::find(shown, c.name, &Component::name) == shown.end();
      if (dropped && !std::isnan(c.utilisation())) most = std::max(most, c.utilisation());
    }
    lines.push_back("  " + std::to_string(left) + (left == 1 ? " more component" : " more components") +
                    (most < 0.0 ? "" : ", highest utilisation " + report::utilisation_text(most)));
  }
  if (summary.components.size() == 1) add_details(summary.components.front(), look, lines);
  for (std::string& line : next_lines(summary, limits, look)) lines.push_back(std::move(line));
  return lines;
}

std::string capitalised(std::string text) {
  if (!text.empty() && 'a' <= text[0] && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// "Yielding in torsion at key end, utilisation 0.895 (26.9 / 30 MPa)"
std::string governing_text(const account::Mode& mode) {
  const std::string location = report::location_of(mode);
  std::string text = capitalised(mode.title.text()) + (location.empty() ? "" : " at " + location);
  if (mode.utilisation) text += ", utilisation " + report::utilisation_text(*mode.utilisation);
  if (mode.compared) text += " (" + report::short_pair(mode.compared->demand, mode.compared->capacity) + ")";
  return text;
}

/// The result of a search with its reason, else the size of the part.
Lines size_lines(const Summary& summary, const Limits& limits, const Look& look) {
  Lines lines;
  for (const Component& component : summary.components) {
    for (std::size_t i = 0; i < component.sizes.size(); ++i) {
      std::string line = (component.is_sized ? "* " : "  ") + component.sizes[i];
      if (component.sizes.size() == 1 && summary.next.size() == 1)
        line += "; " + report::failure_text(summary.next.front().size);
      for (std::string& part : lines_of(line, look.width, 2)) lines.push_back(std::move(part));
    }
    add_details(component, look, lines);
  }
  if (summary.next.size() < 2) return lines;
  for (std::string& line : next_lines(summary, limits, look)) lines.push_back(std::move(line));
  return lines;
}

/// The formulas that the governing check follows from, the last of them where they are many.
Lines formula_lines(const project::Step& step, const account::Mode& mode, std::size_t most, const Look& look) {
  const auto all = report::reasons_of(step.account(), mode.governs).lines;
  const std::size_t shown = std::min(most, all.size());
  std::vector<std::vector<std::string>> rows;
  for (const account::Derived& line : std::span(all).last(shown)) {
    auto row = line_row(line, false);
    row[1] = "= " + report::short_quantity(line.step.value.si, line.step.value.unit);
    rows.push_back(std::move(row));
  }
  Lines lines;
  if (!step.account().governing.empty() && shown > 0)
    lines = lines_of("  evaluated " + step.account().governing.text(), look.width, 2);
  if (all.size() > shown) lines.push_back("  " + std::to_string(all.size() - shown) + " preceding formulas: --full");
  for (std::string& line : rows_as_lines(std::move(rows), look)) lines.push_back(std::move(line));
  return lines;
}

/// The results of a step without a utilisation.
Lines result_lines(const project::Step& step, const Limits& limits, const Look& look) {
  std::vector<std::vector<std::string>> rows;
  std::size_t left = 0;
  for (const account::Entry& e : step.account().results) {
    if (!e.brief || e.role != Role::result || account::is_open(e)) continue;
    if (rows.size() < limits.of(Limits::formulas))
      rows.push_back({"  " + e.path, value_text(e), e.doc});
    else
      ++left;
  }
  Lines lines = rows_as_lines(std::move(rows), look);
  if (left > 0) lines.push_back("  " + std::to_string(left) + " more results: --full");
  return lines;
}

}  // namespace

std::string short_answer(const Summary& summary, const Look& look) {
  return fitted(
      [&](const Limits& limits) {
        return std::vector<Lines>{title_lines(summary, look),
                                  search_lines(summary, look),
                                  part_lines(summary, limits, look),
                                  failure_lines(summary, limits, look),
                                  gap_lines(summary, limits, look),
                                  open_lines(summary, limits, look),
                                  more_line("loadpath why FILE " + summary.governing_step, look)};
      },
      look);
}

std::string short_answer(const Summary& summary, const project::Step& step, const Look& look) {
  const auto& component = summary.components;
  const auto governing = component.empty() ? std::nullopt : component.front().governing;
  const bool has_check = governing && governing->utilisation;
  return fitted(
      [&](const Limits& limits) {
        Lines head = verdict_lines(summary, look);
        if (has_check) {
          for (std::string& line : lines_of(governing_text(*governing), look.width, 2)) head.push_back(std::move(line));
        }
        return std::vector<Lines>{head,
                                  search_lines(summary, look),
                                  size_lines(summary, limits, look),
                                  has_check ? formula_lines(step, *governing, limits.of(Limits::formulas), look)
                                            : result_lines(step, limits, look),
                                  failure_lines(summary, limits, look),
                                  gap_lines(summary, limits, look),
                                  open_lines(summary, limits, look),
                                  more_line("loadpath describe " + std::string(step.input().calculator->id), look)};
      },
      look);
}

namespace {

/// The inputs that the formulas start from, and where they come from.
Lines input_lines(const project::Step& step, const account::Mode& mode, const Look& look) {
  std::vector<std::vector<std::string>> rows;
  for (const account::Entry* e : report::reasons_of(step.account(), mode.governs).inputs)
    rows.push_back({"  " + e->path, value_text(*e), e->origin.text.text()});
  Lines lines = rows_as_lines(std::move(rows), look);
  if (!lines.empty()) lines.insert(lines.begin(), "From");
  return lines;
}

/// "Passes: shear yielding 0.506, yielding in pure torsion 0.388", what other steps assess, and the limits that no load
/// changes, each by itself: a larger number among these does not govern.
Lines passing_lines(const Summary& summary, const account::Mode& governing, const Look& look) {
  std::string own, elsewhere, limits;
  for (const account::Mode& mode : account::in_order(summary.modes)) {
    if (mode.state != account::State::pass || mode.id == governing.id) continue;
    const bool is_elsewhere = account::is_assessed_elsewhere(mode);
    std::string& text = is_elsewhere ? elsewhere : account::is_ranked(mode) ? own : limits;
    text += (text.empty() ? "" : ", ") + report::plain_title(mode);
    if (mode.utilisation) text += " " + report::utilisation_text(*mode.utilisation);
    if (is_elsewhere) text += " (" + mode.judge + ")";
  }
  Lines lines;
  const auto add = [&](const char* head, const std::string& text) {
    if (text.empty()) return;
    for (std::string& line : lines_of(head + text, look.width, 2)) lines.push_back(std::move(line));
  };
  add("Passes: ", own);
  add("Passes in other steps: ", elsewhere);
  add("Geometry and limits: ", limits);
  return lines;
}

}  // namespace

std::string why_answer(const Summary& summary, const project::Step& step, const Look& look) {
  constexpr std::size_t every = 1000;
  const auto& governing = summary.components.front().governing;
  std::vector<Lines> blocks{title_lines(summary, look), search_lines(summary, look),
                            size_lines(summary, Limits{}, look)};
  if (governing && governing->utilisation) {
    Lines lines =
        lines_of("Governing: " + governing_text(*governing) + "  " + bar(*governing->utilisation, look), look.width, 2);
    for (std::string& line : formula_lines(step, *governing, every, look)) lines.push_back(std::move(line));
    blocks.push_back(std::move(lines));
    blocks.push_back(input_lines(step, *governing, look));
    blocks.push_back(passing_lines(summary, *governing, look));
  } else {
    blocks.push_back(result_lines(step, Limits{}, look));
  }
  blocks.push_back(failure_lines(summary, Limits{}, look));
  blocks.push_back(gap_lines(summary, Limits{}, look));
  blocks.push_back(open_lines(summary, Limits{}, look));
  return in_signs_of(text_of(joined(blocks)), look);
}

}  // namespace loadpath::terminal
