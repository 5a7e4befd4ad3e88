// A PDF is printed by a browser, which may fail: browsers of shell script replace it here.
#include "tests/cli/process.hpp"
#include "tests/program.hpp"
#include "tests/waiting.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace loadpath::test;
namespace fs = std::filesystem;

namespace {

const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";
const std::string old_pdf = "an old PDF\n";
/// Print target of the browser.
const std::string target = "for word in \"$@\"; do case $word in --print-to-pdf=*) out=${word#*=};; esac; done\n";

/// A desk with a project, an old PDF, a folder for temporary files and a browser.
class Office {
 public:
  explicit Office(const std::string& browser) {
    fs::create_directory(desk_.folder() / "bin");
    fs::create_directory(desk_.folder() / "tmp");
    desk_.put("a.toml", axle);
    desk_.put("a.pdf", old_pdf);
    desk_.put("bin/chromium", "#!/bin/sh\n" + target + browser);
    fs::permissions(desk_.folder() / "bin/chromium", fs::perms::owner_all);
  }
  [[nodiscard]] const Desk& desk() const { return desk_; }
  [[nodiscard]] std::string in(const char* name) const { return (desk_.folder() / name).string(); }
  [[nodiscard]] Ran print() const {
    return desk_.run({"run", "a.toml", "--quiet", "--report", "a.pdf"}, "",
                     {{"PATH", in("bin") + ":/usr/bin:/bin"}, {"TMPDIR", in("tmp")}});
  }
  /// Whether nothing is left but what was there, and the browser.
  [[nodiscard]] bool is_tidy() const {
    return fs::is_empty(in("tmp")) && desk_.files() == std::vector<std::string>{"a.pdf", "a.toml", "bin/chromium"};
  }

 private:
  Desk desk_;
};

/// Starts the program and, once its browser has written "runs", sends the signal; the exit code.
int interrupted_with(const Office& office, int signal) {
  const std::string line = "cd '" + office.in("") + "' && PATH='" + office.in("bin") + "':/usr/bin:/bin TMPDIR='" +
                           office.in("tmp") + "' exec '" + program + "' run a.toml --quiet --report a.pdf";
  const char* words[] = {"/bin/sh", "-c", line.c_str(), nullptr};
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, words[0], nullptr, nullptr, const_cast<char**>(words), environ) == 0);
  CHECK(becomes([&] { return office.desk().has("runs"); }));
  kill(child, signal);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Whether a process has ended; as a zombie too, where nothing waits for its end.
bool has_ended(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t state = text.rfind(") ");
  return state == std::string::npos || text.substr(state + 2, 1) == "Z";
}

void check_kept(const Office& office) {
  const Ran ran = office.print();
  CHECK(ran.code == 2);
  CHECK(ran.error == "loadpath: the browser did not write 'a.pdf'\n");
  CHECK(office.desk().get("a.pdf") == old_pdf);
  CHECK(office.is_tidy());
}

}  // namespace

TEST_SUITE("cli pdf") {
  TEST_CASE("the output of the browser replaces the old PDF") {
    const Office office("echo 'a new PDF' > \"$out\"\n");
    CHECK(office.print().code == 0);
    CHECK(office.desk().get("a.pdf") == "a new PDF\n");
    CHECK(office.is_tidy());
  }

  TEST_CASE("a browser that writes nothing leaves the old PDF") { check_kept(Office("exit 0\n")); }

  TEST_CASE("a browser that writes an empty file leaves the old PDF") { check_kept(Office(": > \"$out\"\n")); }

  TEST_CASE("a browser that fails half-way leaves the old PDF") {
    check_kept(Office("echo half > \"$out\"\nexit 1\n"));
  }

  TEST_CASE("a browser that is killed leaves the old PDF") { check_kept(Office("echo half > \"$out\"\nkill -9 $$\n")); }

  TEST_CASE("an interrupt ends the browser, too, and its folder is removed") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      const Office office(
          "echo half > \"$out\"\nmkdir \"$TMPDIR\"/loadpath-*/profile\necho $$ > \"${out%/*}\"/process\n"
          "mv \"${out%/*}\"/process \"${out%/*}\"/runs\nexec sleep 10000\n");
      CHECK(interrupted_with(office, signal) == 130);
      CHECK(becomes([browser = std::stoi(office.desk().get("runs"))] { return has_ended(browser); }));
      CHECK(office.desk().get("a.pdf") == old_pdf);
      fs::remove(office.in("runs"));
      CHECK(office.is_tidy());
    }
  }

  TEST_CASE("a project cannot be overwritten by its PDF") {
    const Office office("echo 'a new PDF' > \"$out\"\n");
    office.desk().put("a.pdf", axle);
    const Ran ran = office.desk().run({"run", "a.pdf", "--report", "a.pdf"}, "",
                                      {{"PATH", office.in("bin")}, {"TMPDIR", office.in("tmp")}});
    CHECK(ran.code == 2);
    CHECK(ran.error.find("'a.pdf' is the project itself: nothing is written") != std::string::npos);
    CHECK(office.desk().get("a.pdf") == axle);
  }
}
