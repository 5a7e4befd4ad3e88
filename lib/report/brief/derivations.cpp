#include "lib/report/brief/derivations.hpp"

#include "lib/report/appendix.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/why.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loadpath::report {

namespace {

using account::Derived;

constexpr std::size_t most_lines = 30;
constexpr double heading_height = 8.5, least_height = 38.0;  // mm

bool has_fraction(const std::string& formula) { return formula.find_first_of("/^") != std::string::npos; }

/// Whether a line says something: a formula, or a value with its source. A value that only gets another name is in
/// the numbers of the next formula.
bool is_worth_a_line(const Derived& line) {
  return !line.step.formula.empty() || line.step.why.text().find('[') != std::string::npos;
}

/// The height of a line as it is set, mm.
double height_of(const account::Step& line) {
  constexpr double plain = 4.9, fraction = 8.4, of_note_line = 3.3;
  constexpr double note_letters = 31.0;  // in a line of the note column
  const double row = has_fraction(line.formula) ? fraction : plain;
  const Setting setting = setting_of(line);
  const double rows = setting == Setting::row ? 1.0 : setting == Setting::two_rows ? 2.0 : 3.0;
  const double notes = std::ceil(letters_of(line.why.text()) / note_letters);
  return std::max(row * rows, of_note_line * notes + 1.0);
}

Panel panel_of(const Governing& row, const project::Step& step, const std::vector<Derived>& lines, std::size_t left) {
  Panel panel{say("{1}: {2}", capitalised(row.component), mode_name(row.mode)), {}, {}};
  if (!step.account().governing.empty()) panel.remark = say("calculated {1}", step.account().governing);
  if (left > 0) {
    const Message before =
        left == 1 ? say("1 line before: appendix") : say("{1} lines before: appendix", std::to_string(left));
    panel.remark = panel.remark.empty() ? before : say("{1}; {2}", panel.remark, before);
  }
  Derivation derivation;
  for (const Derived& line : lines) {
    derivation.steps.push_back(line.step);
    Message& why = derivation.steps.back().why;
    if (!why.empty()) why = say("{1}", with_greek(why.text()));
  }
  panel.blocks.emplace_back(std::move(derivation));
  return panel;
}

}  // namespace

double height_of(const Derivation& derivation) {
  double height = 0.0;
  for (const account::Step& line : derivation.steps) height += height_of(line);
  return height;
}

namespace {

/// A mode with the lines that its utilisation follows from, and their heights.
struct Derivable {
  Derivable(const Governing& mode, const project::Step& of, std::vector<Derived> from)
      : row(&mode), step(&of), lines(std::move(from)), heights(lines.size()) {
    std::ranges::transform(lines, heights.begin(), [](const Derived& line) { return height_of(line.step); });
  }

  /// The last lines that fit into a height.
  [[nodiscard]] std::size_t count_within(double height) const {
    std::size_t count = 0;
    while (count < std::min(most_lines, lines.size())) {
      height -= heights[lines.size() - 1 - count];
      if (height < 0.0) break;
      ++count;
    }
    return count;
  }
  /// Of the last lines and the heading.
  [[nodiscard]] double height_of_last(std::size_t count) const {
    return std::accumulate(heights.end() - static_cast<std::ptrdiff_t>(count), heights.end(), heading_height);
  }
  [[nodiscard]] double height() const { return height_of_last(count_within(most_height)); }
  [[nodiscard]] std::vector<Derived> last(std::size_t count) const {
    return {lines.end() - static_cast<std::ptrdiff_t>(count), lines.end()};
  }
  static constexpr double most_height = 1e6;

  const Governing* row;
  const project::Step* step;
  std::vector<Derived> lines;
  std::vector<double> heights;  // mm
};

/// One mode of each component; a formula set only once.
std::vector<Derivable> derivable(const project::Project& project, const std::vector<Governing>& rows) {
  std::vector<Derivable> all;
  std::set<std::string> components, formulas;
  for (const Governing& row : rows) {
    const project::Step* const step = project.find(row.mode.step);
    if (step == nullptr || !components.insert(row.component).second) continue;
    if (!formulas.insert(std::string(step->input().calculator->id) + "." + row.mode.id).second) continue;
    std::vector<Derived> lines = reasons_of(step->account(), row.mode.governs).lines;
    std::erase_if(lines, [](const Derived& line) { return !is_worth_a_line(line); });
    if (!lines.empty()) all.emplace_back(row, *step, std::move(lines));
  }
  return all;
}

/// The height that each may take where none takes more than it needs: what the short ones leave goes to the long ones.
double fair_height(const std::vector<Derivable>& all, double height) {
  std::vector<double> needs(all.size());
  std::ranges::transform(all, needs.begin(), [](const Derivable& one) { return one.height(); });
  std::ranges::sort(needs);
  double left = height;
  for (std::size_t i = 0; i < needs.size(); ++i) {
    const double share = left / static_cast<double>(needs.size() - i);
    if (needs[i] > share) return share;
    left -= needs[i];
  }
  return Derivable::most_height;
}

}  // namespace

Derivations governing_derivations(const project::Project& project, const std::vector<Governing>& rows, double height) {
  Derivations all;
  std::vector<Derivable> modes = derivable(project, rows);
  while (modes.size() > 1 && fair_height(modes, height) < least_height) modes.pop_back();
  const double share = fair_height(modes, height);
  for (const Derivable& mode : modes) {
    const bool fits = mode.height() <= share;
    const std::size_t count = mode.count_within(fits ? Derivable::most_height : share - heading_height);
    const std::vector<Derived> lines = mode.last(count);
    for (const Derived& line : lines) all.sources.merge(keys_in(line.step.why.text()));
    all.height += mode.height_of_last(count);
    all.panels.push_back(panel_of(*mode.row, *mode.step, lines, mode.lines.size() - lines.size()));
  }
  return all;
}

}  // namespace loadpath::report
