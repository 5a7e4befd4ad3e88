// The possible continuations of a command line: from the commands, the catalogue, the tables and the named project.
#pragma once

#include "cli/program/command_line.hpp"

#include <string>
#include <vector>

namespace loadpath::cli {

struct Candidate {
  std::string word;
  std::string meaning;  // in a line; may be empty
};

struct Candidates {
  std::vector<Candidate> words;
  bool files = false;  // a file may follow as well
};

/// The candidates for the last word, which may be empty, after those before it.
Candidates candidates(CommandLine& line, std::vector<std::string> words);

}  // namespace loadpath::cli
