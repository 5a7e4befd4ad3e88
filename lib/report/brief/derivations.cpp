#include "lib/report/brief/derivations.hpp"

#include "lib/formula/formula.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/brief/heights.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/why.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loadpath::report {

namespace {

using account::Derived;

constexpr std::size_t most_lines = 30;
constexpr double heading_height = 8.5;  // mm

bool has_fraction(const std::string& formula) { return formula.find_first_of("/^") != std::string::npos; }

/// Whether a line says something: a formula, or a value with its source. A value that only gets another name is in
/// the numbers of the next formula.
bool is_worth_a_line(const Derived& line) {
  return !line.step.formula.empty() || line.step.why.text().find('[') != std::string::npos;
}

/// The height of a line as it is set, mm.
double height_of(const account::Step& line) {
  constexpr double plain = 4.9, fraction = 8.75, root = 11.5,
                   of_note_line = 3.3;   // root: over or under a fraction line
  constexpr double note_letters = 31.0;  // in a line of the note column
  const bool has_root = line.formula.find("sqrt(") != std::string::npos;
  const double row = !has_fraction(line.formula) ? plain : has_root ? root : fraction;
  const Setting setting = setting_of(line);
  const double rows = setting == Setting::row ? 1.0 : setting == Setting::two_rows ? 2.0 : 3.0;
  const double notes = std::ceil(letters_of(line.why.text()) / note_letters);
  return std::max(row * rows, of_note_line * notes + 1.0);
}

/// " for F_a ≤ e F_r" of a reason that begins with the condition of its formula; empty of others.
std::string condition_of(const std::string& why) {
  const std::size_t colon = why.find(": ");
  if (colon == std::string::npos) return {};
  const std::string condition = why.substr(0, colon);
  const bool compares = condition.find("≤") != std::string::npos || condition.find(" > ") != std::string::npos;
  return compares ? say(" for {1}", with_greek(condition)).text() : std::string();
}

/// A line within a text: "K_v = 1 + 0.25·v = 1.132", with the source of a value that has no formula.
std::string in_a_row(const Derived& line) {
  constexpr int most_digits = 4;
  constexpr double longest_unbroken = 80.0;  // letters
  const account::Step& step = line.step;
  std::string text = formula::symbol_plain(step.symbol);
  Quantity value = step.value;
  value.digits = most_digits;
  const std::string result = formula::quantity_plain(written(value));
  const Worked w = step.formula.empty() ? Worked{} : worked(step);
  if (w.tree) {
    const std::string side = formula::plain(*w.tree, {}, w.known);
    if (side != result) text += " = " + side;
  }
  text += " = " + result;
  text += condition_of(step.why.text());
  std::string keys;
  for (const std::string& key : keys_in(step.why.text())) keys += " [" + key + "]";
  if (letters_of(text) <= longest_unbroken) text = unbroken(std::move(text));
  return text + keys;
}

/// The lines before those that are set, one after the other as a text.
Paragraph in_a_text(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : ";\u00A0 ") + line;  // a wider gap
  return {say("Preliminary values: {1}.", all), Paragraph::Tone::note};
}

Panel panel_of(const project::Project& project, const Governing& row, const project::Step& step,
               const std::vector<Derived>& lines) {
  constexpr double most_letters = 45.0;
  const std::string name = capitalised(titled(project, row.component, most_letters));
  Panel panel{say("{1}: {2}", name, mode_name(row.mode)), {}, {}};
  if (!step.account().governing.empty()) panel.remark = say("calculated {1}", step.account().governing);
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

/// A mode with the lines that its utilisation follows from: the last are set, those before are a text.
class Derivable {
 public:
  Derivable(const project::Project& project, const Governing& mode, const project::Step& of, std::vector<Derived> from)
      : project_(&project), row_(&mode), step_(&of), lines_(std::move(from)) {
    for (const Derived& line : lines_) {
      heights_.push_back(height_of(line.step));
      texts_.push_back(in_a_row(line));
    }
    set_ = std::min(least_lines, lines_.size());
  }

  [[nodiscard]] double height() const {
    const double set = std::accumulate(heights_.end() - static_cast<std::ptrdiff_t>(set_), heights_.end(), 0.0);
    return heading_height + set + (early().empty() ? 0.0 : height_of(Panel{{}, {}, {in_a_text(early())}}, page_width));
  }
  [[nodiscard]] std::size_t early_lines() const { return lines_.size() - set_ - left_out_; }
  [[nodiscard]] bool has_more() const { return set_ < std::min(most_lines, lines_.size()) && early_lines() > 0; }
  void set_one_more() { ++set_; }
  void set_one_less() { --set_; }
  void leave_one_out() { ++left_out_; }
  [[nodiscard]] std::size_t left_out() const { return left_out_; }

  [[nodiscard]] Panel panel() const {
    Panel panel = panel_of(*project_, *row_, *step_, {lines_.end() - static_cast<std::ptrdiff_t>(set_), lines_.end()});
    if (!early().empty()) panel.blocks.insert(panel.blocks.begin(), in_a_text(early()));
    if (left_out_ == 0) return panel;
    const Message before =
        left_out_ == 1 ? say("1 line before: appendix") : say("{1} lines before: appendix", std::to_string(left_out_));
    panel.remark = panel.remark.empty() ? before : say("{1}; {2}", panel.remark, before);
    return panel;
  }
  [[nodiscard]] std::set<std::string> sources() const {
    std::set<std::string> keys;
    for (std::size_t i = left_out_; i < lines_.size(); ++i) keys.merge(keys_in(lines_[i].step.why.text()));
    return keys;
  }

 private:
  static constexpr std::size_t least_lines = 3;

  [[nodiscard]] std::vector<std::string> early() const {
    const auto begin = texts_.begin() + static_cast<std::ptrdiff_t>(left_out_);
    return {begin, begin + static_cast<std::ptrdiff_t>(early_lines())};
  }

  const project::Project* project_;
  const Governing* row_;
  const project::Step* step_;
  std::vector<Derived> lines_;
  std::vector<double> heights_;  // mm
  std::vector<std::string> texts_;
  std::size_t set_ = 0, left_out_ = 0;  // the last, the first of the lines
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
    if (!lines.empty()) all.emplace_back(project, row, *step, std::move(lines));
  }
  return all;
}

double height_of_all(const std::vector<Derivable>& modes) {
  double height = 0.0;
  for (const Derivable& mode : modes) height += mode.height();
  return height;
}

/// Leaves out modes, then the first lines of the longest, until all fit.
void shorten(double height, std::vector<Derivable>& modes) {
  constexpr std::size_t least_modes = 3;
  while (modes.size() > least_modes && height_of_all(modes) > height) modes.pop_back();
  while (height_of_all(modes) > height) {
    const auto longest = std::ranges::max_element(modes, {}, &Derivable::early_lines);
    if (longest == modes.end() || longest->early_lines() == 0) return;
    longest->leave_one_out();
  }
}

/// Sets more of the lines, one of each mode in turn.
void set_more(double height, std::vector<Derivable>& modes) {
  for (bool has_set = true; has_set;) {
    has_set = false;
    for (Derivable& mode : modes) {
      if (!mode.has_more()) continue;
      mode.set_one_more();
      if (height_of_all(modes) <= height)
        has_set = true;
      else
        mode.set_one_less();
    }
  }
}

}  // namespace

bool keeps_lines(const project::Project& project, const std::vector<Governing>& rows, double height, double used) {
  std::vector<Derivable> alone = derivable(project, rows), below = alone;
  shorten(height, alone);
  shorten(height - used, below);
  return std::ranges::equal(alone, below, {}, &Derivable::left_out, &Derivable::left_out);
}

Derivations governing_derivations(const project::Project& project, const std::vector<Governing>& rows, double height) {
  Derivations all;
  std::vector<Derivable> modes = derivable(project, rows);
  shorten(height, modes);
  set_more(height, modes);
  all.height = height_of_all(modes);
  for (const Derivable& mode : modes) {
    all.sources.merge(mode.sources());
    all.panels.push_back(mode.panel());
  }
  return all;
}

}  // namespace loadpath::report
