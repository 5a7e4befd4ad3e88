// What README.md says that can be typed works as it says.
#include "lib/project/parts.hpp"
#include "lib/toml/tree.hpp"
#include "tests/cli/process.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

using namespace loadpath;
using namespace loadpath::test;

namespace {

struct Command {
  std::string line;
  int code = 0;
};

/// The lines of code blocks that start with the program's name; "# exit 1" behind one tells its exit code.
std::vector<Command> commands_of(const std::string& text) {
  std::vector<Command> commands;
  bool code = false;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    if (line.starts_with("```")) code = !code;
    if (!code || !line.starts_with("loadpath ")) continue;
    const std::size_t exit = line.find("# exit ");
    commands.push_back({line, exit == std::string::npos ? 0 : std::atoi(line.c_str() + exit + 7)});
  }
  return commands;
}

}  // namespace

TEST_SUITE("readme") {
  TEST_CASE("every command line exits with the code that it is said to") {
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/README.md", text));
    const auto commands = commands_of(text);
    CHECK(commands.size() > 5);
    const Desk desk;
    std::filesystem::create_directory_symlink(LOADPATH_ROOT "/examples", desk.folder() / "examples");
    for (const Command& command : commands) {
      CAPTURE(command.line);
      const Ran ran = desk.shell(command.line);
      CAPTURE(ran.error);
      CHECK(ran.code == command.code);
    }
  }

  TEST_CASE("every command line about sweeps works, one after the other") {
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/docs/sweeps.md", text));
    const auto commands = commands_of(text);
    CHECK(commands.size() >= 5);
    const Desk desk;
    std::filesystem::copy_file(LOADPATH_ROOT "/examples/strut-sweep/project.toml", desk.folder() / "project.toml");
    for (const Command& command : commands) {
      CAPTURE(command.line);
      const Ran ran = desk.shell(command.line);
      CAPTURE(ran.error);
      CHECK(ran.code == command.code);
    }
  }

  TEST_CASE("the words that cannot name a step are those of the program, in its order") {
    std::string words;
    for (const char* word : project::reserved_names()) words += (words.empty() ? "" : " ") + std::string(word);
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/README.md", text));
    std::replace(text.begin(), text.end(), '\n', ' ');
    CHECK(text.find("cannot name one: `" + words + "`.") != std::string::npos);
  }

  TEST_CASE("every command of the help stands in a line that can be typed") {
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/README.md", text));
    std::istringstream help(loadpath_with({"--help"}).out);
    std::string line;
    while (std::getline(help, line) && line != "Subcommands:") continue;
    int commands = 0;
    while (std::getline(help, line) && line.starts_with("  ")) {
      const std::string command = line.substr(2, line.find(' ', 2) - 2);
      CAPTURE(command);
      CHECK(text.find("\nloadpath " + command) != std::string::npos);
      ++commands;
    }
    CHECK(commands >= 8);
  }
}
