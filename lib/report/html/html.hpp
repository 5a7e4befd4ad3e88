// The parts of the HTML writer.
#pragma once

#include "lib/report/document.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::report::page {

std::string symbol(std::string_view path);
/// Running text, escaped; symbols of quantities in it have subscripts: "K_A", not "left_seat" or "values.K_A".
std::string prose(std::string_view text);
std::string cell(const Cell& cell);
/// A number with its unit, escaped: negative exponents are raised by markup, for the font has no raised minus.
std::string quantity(std::string_view text);

/// A table of many columns has closer spacing and units in the head; if still too wide, it is divided.
std::string table(const Table& table, const std::string& caption);

std::string state(State state);
/// A cell of a table that has only the state, in these words.
std::string state_cell(State state, const std::string& words);
/// "INCOMPLETE", marked as the worst of the modes is.
std::string headline(const Modes& modes);

std::string derivation(const Derivation& derivation);
/// A few values between formulas as lines without a formula: a table of their own would take as much room in print, and
/// more in the file. Nothing of other tables.
std::optional<Derivation> as_lines(const Table& table);
/// Links a row to the heading of its step where the page has one.
std::string verdicts(const Verdicts& verdicts, const std::set<std::string>& anchors);
/// A bar for a utilisation.
std::string bar(double utilisation);

/// The outcome of all modes in a sentence.
std::string conclusion(const Modes& modes);
/// Each that does not pass in a row, those excluded by proof and those that are open and remote in a line each.
std::string doubts(const Modes& modes, const std::set<std::string>& anchors);
/// Each that passes in a row.
std::string passes(const Modes& modes, const std::set<std::string>& anchors);

/// A figure that holds a Motion; without scripts it is a picture.
std::string motion(const figure::Figure& figure);
/// A figure that holds a chart: scripts show its points.
std::string chart(const figure::Figure& figure);

/// The title block of page 1.
std::string title_block(const Document& document);
/// The headline and what it is about.
std::string finding(const Finding& finding);

/// The texts in the footer of every printed page.
struct Running {
  std::string title, program;
};
/// The style sheet with the fonts in it: of letters that few reports have only where the page has one.
std::string style(const Running& running, std::string_view paper, std::string_view page);

}  // namespace loadpath::report::page
