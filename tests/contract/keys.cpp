// A key is the name of the member that it stands for, or says that it is not: nothing else joins the symbol of a report
// to the one in the formulas.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Keys {
  std::vector<std::string> differing;  // "{&Input::mass, "m""
  std::size_t count = 0;
};

/// The keys next to a pointer to a member. One that is called otherwise on purpose is `called("m")`.
Keys keys_in(const std::string& text) {
  static const std::regex field(R"(\{\s*&[\w:]+::(\w+),\s*"([^"]*)\")");
  Keys keys;
  for (std::sregex_iterator i(text.begin(), text.end(), field), end; i != end; ++i, ++keys.count) {
    if ((*i)[1] != (*i)[2]) keys.differing.push_back(i->str());
  }
  return keys;
}

}  // namespace

TEST_SUITE("keys and members") {
  TEST_CASE("a key is the name of its member, unless another name is declared") {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LOADPATH_ROOT) / "calculators")) {
      if (!entry.is_regular_file()) continue;
      const Keys keys = keys_in(text_of(entry.path()));
      count += keys.count;
      for (const std::string& key : keys.differing) FAIL_CHECK(entry.path().filename().string() << ": " << key);
    }
    CHECK(count > 1000);
  }

  TEST_CASE("a key that differs from its member is found, also on the next line") {
    CHECK(keys_in("Field{&Input::d_1, \"d_1\", mm}, Field{&Input::d_2,\n  \"d_1\", mm}").differing ==
          std::vector<std::string>{"{&Input::d_2,\n  \"d_1\""});
    CHECK(keys_in("Field{&Input::mass, called(\"m\"), kg}").differing.empty());
  }
}
