#include "lib/report/terminal/answer.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/answer.hpp"
#include "lib/report/terminal/layout.hpp"
#include "lib/report/terminal/rows.hpp"
#include "lib/report/terminal/words.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace loadpath::terminal {

namespace {

using account::Modes;
using account::State;

/// "████████·· 0.847": full at 1.
std::string bar(double utilisation) {
  constexpr int length = 10;
  const int filled = std::clamp(static_cast<int>(std::lround(utilisation * length)), utilisation > 0.0 ? 1 : 0, length);
  std::string all;
  for (int i = 0; i < length; ++i) all += i < filled ? "█" : "·";
  return all + "\u00A0" + format_number(utilisation, 3);
}

/// Spaces that kept a value on one line, as a user would search for them.
std::string with_plain_spaces(std::string text) {
  const std::string unbroken = "\u00A0";
  for (std::size_t at = text.find(unbroken); at != std::string::npos; at = text.find(unbroken, at))
    text.replace(at, unbroken.size(), " ");
  return text;
}

void show_chosen(const project::Project& project) {
  std::vector<Row> rows;
  for (const report::ChosenPart& part : report::chosen_parts(project)) {
    const auto& governing = part.governing;
    rows.push_back({"  " + state_word(part.state), part.step, part.sizes.empty() ? "–" : part.sizes,
                    governing ? bar(governing->utilisation.value_or(0.0)) : "",
                    governing ? governing->title.text() + "; " + account::reason(*governing).text() : ""});
  }
  if (!rows.empty()) std::cout << with_plain_spaces(columns(rows)) << "\n";
}

/// Shows the modes that do not pass.
void show_doubts(const Modes& modes) {
  Modes rows = modes;
  std::erase_if(rows, [](const account::Mode& mode) { return mode.state == State::pass; });
  if (!rows.empty()) std::cout << mode_columns(rows, true) << "\n";
}

}  // namespace

void show_answer(const project::Project& project, bool in_full) {
  const Modes modes = project::modes(project);
  if (in_full && !modes.empty())
    std::cout << mode_columns(modes, true) << "\n";
  else
    show_doubts(modes);
  show_chosen(project);
  if (modes.empty()) return;
  std::cout << paragraph(account::brief_scope(modes).text(), 2);
}

}  // namespace loadpath::terminal
