// The commands of README.md and docs work as stated.
#include "lib/project/parts/parts.hpp"
#include "lib/toml/tree.hpp"
#include "tests/pages.hpp"
#include "tests/parts.hpp"

#include <algorithm>
#include <sstream>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::vector<Command> commands_of_page(const std::string& page) {
  std::vector<Command> commands;
  for (const Block& block : blocks_of(page)) {
    if (block.language.empty()) continue;
    for (const Command& command : commands_of(block.text)) commands.push_back(command);
  }
  return commands;
}

}  // namespace

TEST_SUITE("readme" * by_case) {
  TEST_CASE("every command line exits with the stated code") {
    for (const char* page : {"/README.md", "/docs/commands.md"}) {
      CAPTURE(page);
      std::string text;
      REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + page, text));
      const auto commands = commands_of_page(text);
      CHECK(commands.size() > 5);
      const Desk desk;
      std::filesystem::create_directory_symlink(LOADPATH_ROOT "/examples", desk.folder() / "examples");
      for (const Command& command : commands) typed(desk, command);
    }
  }

  TEST_CASE("the commands shown in docs/sweeps.md work, one after the other") {
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/docs/sweeps.md", text));
    CHECK(commands_of_page(text).size() >= 5);
    const Desk desk;
    std::filesystem::copy_file(LOADPATH_ROOT "/examples/strut-sweep/project.toml", desk.folder() / "project.toml");
    follow(desk, text);
  }

  TEST_CASE("the words that cannot name a step are those of the program, in its order") {
    std::string words;
    for (const char* word : project::reserved_names()) words += (words.empty() ? "" : " ") + std::string(word);
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/docs/project-file.md", text));
    std::replace(text.begin(), text.end(), '\n', ' ');
    CHECK(text.find("cannot name one: `" + words + "`.") != std::string::npos);
  }

  TEST_CASE("README.md is at most 10 kB") { CHECK(std::filesystem::file_size(LOADPATH_ROOT "/README.md") <= 10240); }

  TEST_CASE("every command of the help is in a line that can be typed") {
    std::string text;
    REQUIRE(toml::read_file(LOADPATH_ROOT "/docs/commands.md", text));
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
