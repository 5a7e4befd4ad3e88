// Pages of the documentation as a reader follows them: files to write, commands to type, expected output.
#pragma once

#include "tests/cli/process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace loadpath::test {

/// "```toml" and its content, or the text between two such blocks, without a language.
struct Block {
  std::string language;  ///< empty of plain text
  std::string text;
};

struct Command {
  std::string line;
  int code = 0;  ///< exit code of "# exit 1" after it
};

/// A link as it is written: [words](target).
struct Link {
  std::string words;
  std::string target;
};

std::vector<Block> blocks_of(const std::string& page);

/// The lines of code that start with the program's name; a backslash at the end continues on the next line.
std::vector<Command> commands_of(const std::string& code);

/// The links outside of code.
std::vector<Link> links_of(const std::string& page);

/// The names that a "#..." can have: of the headings, as GitHub makes them.
std::vector<std::string> anchors_of(const std::string& page);

/// README.md, CONTRIBUTING.md, CHANGELOG.md, and the files under docs, by their paths within the repository.
std::vector<std::string> documents();

std::string text_of(const std::filesystem::path& path);

/// Runs a command; `watch` until its page is there, and ends it by Ctrl-C. CHECKs its exit code, returns its output.
std::string typed(const Desk& desk, const Command& command);

/// The error in the lines shown, in which "..." replaces omitted ones; empty if there is none.
std::string difference(const std::string& shown, const std::string& printed);

/// Goes through a page: writes the files whose first line is "# NAME.toml", or "# NAME.toml, continued"; runs the
/// commands; compares each block of text with the output of the commands before it.
void follow(const Desk& desk, const std::string& page);

}  // namespace loadpath::test
