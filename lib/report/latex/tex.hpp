// The parts of the LaTeX writer.
#pragma once

#include "lib/report/document.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace loadpath::report::tex {

/// Words with a link to the heading of a step, where the document has one.
using Linked = std::function<std::string(const std::string& step)>;

std::string symbol(std::string_view path);
std::string cell(const Cell& cell);
std::string state(State state);
/// The same of a mode: "outside the scope" where no calculator assesses it.
std::string state_of(const Mode& mode);
/// "INCOMPLETE", marked as the worst of the modes is.
std::string headline(const Modes& modes);

/// A table too wide in any type size is divided into several, one below the other.
std::string table(const Table& table);
std::string derivation(const Derivation& derivation);
std::string verdicts(const Verdicts& verdicts, const Linked& linked);

/// The headline of page 1 and what it is about.
std::string finding(const Finding& finding);
/// The outcome of all modes in a sentence.
std::string conclusion(const Modes& modes);
/// Each that does not pass in a row, those excluded by proof and those that are open and remote in a line each.
std::string doubts(const Modes& modes, const Linked& linked);
/// Each that passes in a row.
std::string passes(const Modes& modes, const Linked& linked);

/// The text of a file as it was typed.
std::string listing(std::string_view text);

}  // namespace loadpath::report::tex
