// Pictures of all examples, compared by their checksums. A change of them is a decision: look at them in the reports,
// then write the new list with
//   LOADPATH_APPROVE=1 loadpath_tests --test-case="pictures are as they were approved"
#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/report/build.hpp"
#include "lib/toml/tree.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace {

using namespace loadpath;
namespace fs = std::filesystem;

constexpr const char* list = LOADPATH_ROOT "/tests/golden/pictures.txt";

std::string text_of(const std::string& path) {
  std::string text;
  REQUIRE(toml::read_file(path, text));
  return text;
}

/// Fowler, Noll and Vo, 1a, in 64 bits.
std::string checksum(const std::string& text) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
  return digits;
}

using Pictures = std::map<std::string, std::string>;  // their names, and their checksums

void add_pictures(const std::string& text, const std::string& name, Pictures& pictures) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, name + ".toml", catalogue(), issues);
  project::solve(project, issues);
  REQUIRE_MESSAGE(!has_errors(issues), name);
  const auto document = report::build(project, "loadpath");
  for (const auto& [picture, svg] : report::markdown(document, name).figures) pictures[picture] = checksum(svg);
}

/// Of the examples, and of the example of every calculator.
Pictures all_pictures() {
  Pictures pictures;
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples"))
    add_pictures(text_of((entry.path() / "project.toml").string()), entry.path().filename().string(), pictures);
  for (const Calculator* c : calculators()) add_pictures(c->example, c->id, pictures);
  return pictures;
}

Pictures approved_pictures() {
  Pictures pictures;
  std::istringstream in(text_of(list));
  for (std::string sum, name; in >> sum >> name;) pictures[name] = sum;
  return pictures;
}

void approve(const Pictures& pictures) {
  std::ofstream out(list);
  for (const auto& [name, sum] : pictures) out << sum << ' ' << name << '\n';
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("pictures are as they were approved") {
    const Pictures pictures = all_pictures();
    CHECK(pictures.size() > 50);
    if (std::getenv("LOADPATH_APPROVE") != nullptr) approve(pictures);
    const Pictures approved = approved_pictures();
    for (const auto& picture : pictures) {
      const auto found = approved.find(picture.first);
      CHECK_MESSAGE((found != approved.end() && found->second == picture.second), picture.first,
                    " looks otherwise than approved: look at it, then write tests/golden/pictures.txt anew");
    }
    for (const auto& picture : approved) CHECK_MESSAGE(pictures.count(picture.first) == 1, picture.first, " is gone");
  }
}
