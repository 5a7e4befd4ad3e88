// The messages for unknown words.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace loadpath::cli {

/// The command that was named last: torsion of `loadpath shaft torsion`.
const CLI::App& deepest(const CLI::App& app);

/// The text typed in place of a command, or of the calculator of an element.
int unknown_command(const CLI::App& app, const CLI::App& command);

/// Wrong words on the command line, of all that were typed: an unknown option with the nearest one, a value that its
/// blank has divided, or CLI11's sentence.
int wrong_words(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& typed);

}  // namespace loadpath::cli
