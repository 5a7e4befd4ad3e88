// Outputs come into being whole or not at all.
#include "tests/cli/process.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace loadpath::test;
namespace fs = std::filesystem;

namespace {

const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";
const std::string old_report = "an old report\n";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Starts the program over an old report, and ends it with the signal after so many microseconds.
void end_early(const Desk& desk, int signal, int after) {
  const std::string report = (desk.folder() / "a.html").string(), project = (desk.folder() / "a.toml").string();
  const char* words[] = {LOADPATH_PROGRAM, "run", project.c_str(), "--quiet", "--report", report.c_str(), nullptr};
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, words[0], nullptr, nullptr, const_cast<char**>(words), environ) == 0);
  std::this_thread::sleep_for(std::chrono::microseconds(after));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
}

}  // namespace

TEST_SUITE("cli outputs") {
  TEST_CASE("whatever ends the program, a report is the old one or a whole new one") {
    const Desk desk;
    desk.put("a.toml", axle);
    for (int k = 0; k < 40; ++k) {
      desk.put("a.html", old_report);
      end_early(desk, k % 2 == 0 ? SIGKILL : SIGINT, 250 * k);
      const std::string text = desk.get("a.html");
      CHECK((text == old_report || text.ends_with("</html>\n")));
    }
  }

  TEST_CASE("an interrupt leaves nothing beside the outputs") {
    const Desk desk;
    desk.put("a.toml", axle);
    for (int k = 0; k < 40; ++k) end_early(desk, SIGINT, 250 * k);
    for (const std::string& file : desk.files()) {
      CAPTURE(file);
      CHECK((file == "a.toml" || file == "a.html"));
    }
  }

  TEST_CASE("the project itself is no place for an output, also through a link") {
    const Desk desk;
    desk.put("a.md", axle);
    fs::create_symlink("a.md", desk.folder() / "b.md");
    for (const char* name : {"a.md", "./a.md", "b.md"}) {
      const Ran ran = desk.run({"run", "a.md", "--report", name});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, "is the project itself: nothing is written"));
      CHECK(desk.get("a.md") == axle);
    }
  }

  TEST_CASE("where there is no room for it the old report stays, and nothing beside it") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("a.html", old_report);
    const Ran ran = desk.shell("trap '' XFSZ; ulimit -f 4; loadpath run a.toml --report a.html");
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "cannot write 'a.html': File too large"));
    CHECK(desk.get("a.html") == old_report);
    CHECK(desk.files().size() == 2);
  }

  TEST_CASE("a link stays a link, and what it names is written") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("real.md", old_report);
    fs::create_symlink("real.md", desk.folder() / "link.md");
    CHECK(desk.run({"run", "a.toml", "--quiet", "--report", "link.md"}).code == 0);
    CHECK(fs::is_symlink(desk.folder() / "link.md"));
    CHECK(contains(desk.get("real.md"), "# a.toml"));
  }

  TEST_CASE("standard output that cannot be written is a fault") {
    const Desk desk;
    desk.put("a.toml", axle);
    const Ran full = desk.shell("loadpath run a.toml > /dev/full"), closed = desk.shell("loadpath run a.toml >&-");
    CHECK(full.code == 3);
    CHECK(closed.code == 3);
    CHECK(contains(full.error, "standard output cannot be written"));
  }

  TEST_CASE("a project that never ends is refused by its size") {
    const Ran ran = loadpath_with({"run", "/dev/zero"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "larger than 4 MiB"));
  }

  TEST_CASE("control characters reach neither terminal nor report") {
    const Desk desk;
    desk.put("a.toml", "[project]\ntitle = \"\\u001b[31mred\"\n" + axle);
    const Ran ran = desk.run({"run", "a.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "a control character in a text"));
  }

  TEST_CASE("tables that lie too deep are refused") {
    std::string key = "a";
    for (int i = 0; i < 10'000; ++i) key += ".a";
    const Desk desk;
    desk.put("a.toml", axle + key + " = 1\n");
    const Ran ran = desk.run({"run", "a.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "too deep"));
  }
}
