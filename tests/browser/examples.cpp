#include "tests/browser/examples.hpp"

#include <algorithm>

namespace loadpath::test {

namespace fs = std::filesystem;

std::vector<std::string> examples() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples")) {
    if (fs::exists(entry.path() / "project.toml")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool write_report(const Desk& desk, const std::string& example, const std::string& file) {
  const Ran ran =
      desk.run({"run", LOADPATH_ROOT "/examples/" + example + "/project.toml", "--quiet", "--report", file});
  return ran.code != 2;
}

std::string address_of(const Desk& desk, const std::string& file) {
  return "file://" + (desk.folder() / file).string();
}

std::string text_of(Browser& browser, const std::string& expression) {
  return browser.value(expression).as_string().c_str();
}

}  // namespace loadpath::test
