// What is said to words that the program does not know.
#pragma once

#include <CLI/CLI.hpp>

namespace loadpath::cli {

/// The command that was named last: torsion of `loadpath shaft torsion`.
const CLI::App& deepest(const CLI::App& app);

/// What was typed where a command, or the calculator of an element, is expected.
int unknown_command(const CLI::App& app, const CLI::App& command);

/// Wrong words on the command line: an unknown option with the nearest one, or CLI11's sentence.
int wrong_words(const CLI::App& app, const CLI::ParseError& error);

}  // namespace loadpath::cli
