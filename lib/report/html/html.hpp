// The parts of the HTML writer.
#pragma once

#include "lib/report/document.hpp"

#include <set>
#include <string>
#include <string_view>

namespace loadpath::report::page {

/// One inline formula from MathML fragments.
std::string math(std::string_view fragment);

/// How many letters stand in a text: of UTF-8 its continuations do not count.
double letters_of(std::string_view text);

std::string symbol(std::string_view path);
std::string cell(const Cell& cell);

/// One of many columns is set closer, its units in the head; what is still too wide becomes several below each other.
std::string table(const Table& table, const std::string& caption);

/// The shapes that verdicts refer to; once in a page.
std::string_view shapes();
std::string state(State state);

std::string derivation(const Derivation& derivation);
/// Links a row to the heading of its step where the page has one.
std::string verdicts(const Verdicts& verdicts, const std::set<std::string>& anchors);
/// A bar beside a utilisation.
std::string bar(double utilisation);

/// The outcome of all modes in a sentence, and each in a row.
std::string conclusion(const Modes& modes);
std::string modes(const Modes& modes, const std::set<std::string>& anchors);

/// A figure that holds a Motion; without scripts it is a picture.
std::string motion(const draw::Figure& figure);
/// A figure that holds a chart: its points can be told where scripts run.
std::string chart(const draw::Figure& figure);

/// The style sheet with the math font in it; `header` and `footer` stand on every printed page.
std::string style(std::string_view header, std::string_view footer);

}  // namespace loadpath::report::page
