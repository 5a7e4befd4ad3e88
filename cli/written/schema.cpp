// Writes the schema of project files during the build, for the program to embed: generating it takes ten times as long
// as the rest of `loadpath schema`. An unchanged file is left as it is, so that nothing is built again.
#include "calculators/catalogue.hpp"
#include "lib/export/json.hpp"

#include <fstream>
#include <iostream>
#include <iterator>

namespace {

std::string text_of(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: loadpath_schema FILE\n";
    return 2;
  }
  const std::string schema = loadpath::exports::project_schema(loadpath::calculators());
  if (text_of(words[1]) == schema) return 0;
  std::ofstream out(words[1], std::ios::binary);
  out << schema << std::flush;
  return out ? 0 : 1;
}
