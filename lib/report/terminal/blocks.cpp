#include "lib/report/terminal/blocks.hpp"

#include "lib/report/numbers/numbers.hpp"
#include "lib/report/terminal/words.hpp"

#include <algorithm>
#include <span>

namespace loadpath::terminal {

namespace {

using report::Gap;
using report::Summary;

/// How much of a block is shown, step by step; by Limits::Block.
constexpr int least_shown = -1;  // behind the last step
constexpr std::array<std::array<int, 9>, Limits::blocks> steps{{{8, 7, 6, 5, 4, 3, 2, least_shown},
                                                                {4, 3, 2, 1, least_shown},
                                                                {4, 3, 2, 1, least_shown},
                                                                {3, 2, 1, least_shown},
                                                                {7, 5, 4, 3, 2, least_shown},
                                                                {2, 1, 0, least_shown},
                                                                {10, 8, 7, 6, 5, 4, 3, 2, least_shown}}};

void add(Lines& lines, const std::string& text, const Look& look, std::size_t hang) {
  for (std::string& line : lines_of(text, look.width, hang)) lines.push_back(std::move(line));
}

void dim(Lines& lines) {
  for (std::string& line : lines) line = in_colour(line, "2");
}

void add_rest(std::size_t left, Lines& lines) {
  if (left > 0) lines.push_back("  " + std::to_string(left) + " more: --full");
}

void add_gaps(const std::vector<Gap>& gaps, std::size_t most, const char* heading, const Look& look, Lines& lines) {
  if (gaps.empty()) return;
  add(lines, heading, look, 2);
  for (const Gap& gap : std::span(gaps).first(std::min(most, gaps.size())))
    add(lines, "  " + report::modes_text(gap) + (gap.action.typed.empty() ? "" : " -> " + gap.action.typed), look, 4);
  add_rest(gaps.size() - std::min(most, gaps.size()), lines);
}

}  // namespace

std::size_t Limits::of(Block block) const {
  const auto i = static_cast<std::size_t>(block);
  return static_cast<std::size_t>(steps[i][steps_[i]]);
}

bool Limits::lower() {
  for (std::size_t tried = 0; tried < steps.size(); ++tried) {
    const std::size_t i = turn_++ % steps.size();
    if (steps[i][steps_[i] + 1] == least_shown) continue;
    ++steps_[i];
    return true;
  }
  return false;
}

bool Limits::raise(std::size_t block) {
  if (steps_[block] == 0) return false;
  --steps_[block];
  return true;
}

Lines joined(const std::vector<Lines>& blocks) {
  Lines all;
  for (const Lines& block : blocks) {
    if (block.empty()) continue;
    if (!all.empty()) all.emplace_back();
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string fitted(const std::function<std::vector<Lines>(const Limits&)>& blocks, const Look& look) {
  constexpr std::size_t most = 25;
  Limits limits;
  Lines all = joined(blocks(limits));
  while (all.size() > most && limits.lower()) all = joined(blocks(limits));
  // A round lowers every block: what still has room comes back.
  for (std::size_t block = 0; block < Limits::blocks; ++block) {
    for (Limits tried = limits; tried.raise(block); limits = tried) {
      Lines more = joined(blocks(tried));
      if (more.size() > most) break;
      all = std::move(more);
    }
  }
  return in_signs_of(text_of(all), look);
}

Lines verdict_lines(const Summary& summary, const Look& look) {
  std::string line = headline(summary.modes, summary.subject, look.width);
  line.pop_back();
  return {line};
}

Lines next_lines(const Summary& summary, const Limits& limits, const Look& look) {
  const bool sized = std::ranges::any_of(summary.components, &report::Component::is_sized);
  if (!sized) return {};
  if (summary.next.empty()) return {"* sized"};
  Lines lines{"* sized; next smaller size:"};
  const std::size_t shown = std::min(limits.of(Limits::next), summary.next.size());
  for (const report::NextOf& next : std::span(summary.next).first(shown))
    add(lines, "    " + next.name + ": " + report::failure_text(next.size), look, 2);
  if (summary.next.size() > shown)
    lines.push_back("    " + std::to_string(summary.next.size() - shown) + " more: --full");
  return lines;
}

Lines failure_lines(const Summary& summary, const Limits& limits, const Look& look) {
  if (summary.failures.empty()) return {};
  Lines lines{"Fails:"};
  const std::size_t shown = std::min(limits.of(Limits::fixes), summary.failures.size());
  for (const std::string& failure : std::span(summary.failures).first(shown)) add(lines, "  " + failure, look, 4);
  add_rest(summary.failures.size() - shown, lines);
  return lines;
}

Lines gap_lines(const Summary& summary, const Limits& limits, const Look& look) {
  Lines lines;
  add_gaps(summary.gaps, limits.of(Limits::fixes), "Not assessed: give the input, or the step", look, lines);
  add_gaps(summary.outside, limits.of(Limits::scope),
           "Outside the scope of loadpath: assess by hand, then accept.MODE = \"reason\"", look, lines);
  return lines;
}

namespace {

/// "hub tilting and axial shift (key)", of the modes that the user accepted with a reason.
std::string accepted_modes(const Summary& summary, std::size_t most) {
  std::string text;
  std::size_t all = 0;
  for (const account::Mode& mode : summary.modes) {
    if (mode.state != account::State::accepted || ++all > most) continue;
    text += (text.empty() ? "" : ", ") + mode.title.text() + " (" + report::spoken(mode.step) + ")";
  }
  return all > most ? text + "; " + std::to_string(all - most) + " more" : text;
}

Lines not_considered(const Summary& summary, const Limits& limits, const Look& look) {
  const report::NotConsidered& open = summary.open;
  if (open.names.empty() && open.others == 0) return {};
  const std::size_t shown = std::min(limits.of(Limits::names), open.names.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + open.names[i];
  if (const std::size_t rest = open.names.size() - shown; rest > 0)
    text += "; " + std::to_string(rest) + (rest == 1 ? " more strength mode" : " more strength modes");
  if (open.others > 0 && text.empty())
    text = report::other_modes(open);
  else if (open.others > 0)
    text += "; " + std::to_string(open.others) + (open.others == 1 ? " other" : " others");
  Lines lines;
  add(lines, "Not considered: " + text, look, 2);
  std::string hints;
  for (const report::Remedy& hint : std::span(open.hints).first(std::min(limits.of(Limits::hints), open.hints.size())))
    hints += (hints.empty() ? "  " : "; ") + hint.typed;
  if (!hints.empty()) add(lines, hints, look, 0);
  dim(lines);
  return lines;
}

}  // namespace

Lines open_lines(const Summary& summary, const Limits& limits, const Look& look) {
  Lines lines;
  const std::string accepted = accepted_modes(summary, limits.of(Limits::scope));
  if (!accepted.empty()) add(lines, "Accepted by user: " + accepted, look, 2);
  const Lines open = not_considered(summary, limits, look);
  lines.insert(lines.end(), open.begin(), open.end());
  return lines;
}

Lines more_line(const std::string& command, const Look& look) {
  Lines lines;
  add(lines, "More: --full, --report FILE.pdf, " + command, look, 2);
  dim(lines);
  return lines;
}

}  // namespace loadpath::terminal
