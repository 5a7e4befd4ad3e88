#include "tests/parts.hpp"

#include "calculators/catalogue.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

namespace loadpath::test {

namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string, std::less<>>;

Names words_of(const char* text) {
  std::istringstream words(text);
  Names all;
  for (std::string word; words >> word;) all.insert(word);
  return all;
}

/// The parts of which tests/CMakeLists.txt makes ctests, "belt gear shaft".
const Names& elements() {
  static const Names all = words_of(LOADPATH_ELEMENTS);
  return all;
}
const Names& examples() {
  static const Names all = words_of(LOADPATH_EXAMPLES);
  return all;
}

/// The part that this run covers; empty where it covers all.
std::string_view chosen() {
  const char* const part = std::getenv("LOADPATH_PART");
  if (part == nullptr || *part == '\0') return {};
  if (elements().count(part) == 0 && examples().count(part) == 0)
    throw std::runtime_error("LOADPATH_PART is no element and no example: " + std::string(part));
  return part;
}

}  // namespace

bool is_part() { return !chosen().empty(); }

bool takes(std::string_view part) { return !is_part() || part == chosen(); }

std::string_view element_of(std::string_view id) { return id.substr(0, id.find('.')); }

std::vector<std::string> elements_of_project(const std::string& text) {
  static constexpr std::string_view key = "calculator";
  std::vector<std::string> named;
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t from = text.find_first_not_of(" =\"'", at + key.size());
    if (from == std::string::npos) break;
    const std::string element(element_of(std::string_view(text).substr(from)));
    const bool is_new = std::find(named.begin(), named.end(), element) == named.end();
    if (is_new && elements().count(element) == 1) named.push_back(element);
  }
  if (named.empty()) named.push_back(*elements().begin());
  return named;
}

std::vector<const Calculator*> calculators_taken() {
  std::vector<const Calculator*> taken;
  for (const Calculator* c : calculators()) {
    if (takes(c->element())) taken.push_back(c);
  }
  return taken;
}

TEST_SUITE("parts") {
  TEST_CASE("every element of the catalogue and every example is a part") {
    for (const Calculator* c : calculators())
      CHECK_MESSAGE(elements().count(c->element()) == 1, c->id, ": its element has no folder in calculators");
    for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples")) {
      const std::string name = entry.path().filename().string();
      if (fs::exists(entry.path() / "project.toml"))
        CHECK_MESSAGE(examples().count(name) == 1, name, ": configure again, so that ctest runs it");
    }
    for (const std::string& example : examples()) CHECK(elements().count(example) == 0);
  }

  TEST_CASE("a project has the elements of the calculators that it names") {
    using All = std::vector<std::string>;
    const std::string key = "calculator = \"shaft.key\"\n", pair = "calculator='gear.pair'\n";
    CHECK(elements_of_project("# a calculator\n[a]\n" + key + "[b]\n" + key + "[c]\n" + pair) == All{"shaft", "gear"});
    CHECK(elements_of_project("[a]\n").size() == 1);
  }
}

}  // namespace loadpath::test
