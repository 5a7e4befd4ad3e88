// Seeds of the fuzzer: every example of the catalogue, every reference case and shipped example, and the projects of
// tests/fuzz/seeds, one step of each at a time with the steps that it refers to.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::fuzz {

struct Seeds {
  std::vector<std::string> projects;
  std::vector<std::string> lines;                          // "d = \"40 mm\"", each once
  std::map<std::string, std::vector<std::string>> values;  // values of a key, over all seeds
};

const Seeds& seeds();

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);
std::string joined(const std::vector<std::string>& lines);
/// Key and value of "key = value"; an empty key where a line is none.
std::pair<std::string, std::string> halves(const std::string& line);

}  // namespace loadpath::fuzz
