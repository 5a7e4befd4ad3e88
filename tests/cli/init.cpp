// New projects: every template solves, and contains the values set by the shell or its answers.
#include "tests/cli/process.hpp"
#include "tests/program.hpp"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The lines of [values] that do not say what they are.
std::string values_without_comment(const std::string& text) {
  const std::string head = "\n[values]\n";
  std::string found;
  for (std::size_t at = text.find(head) + head.size(); at < text.size() && text[at] != '\n';) {
    const std::string line = text.substr(at, text.find('\n', at) - at);
    if (!contains(line, "  # ")) found += line + "\n";
    at += line.size() + 1;
  }
  return found;
}

/// The program on a terminal where these lines are typed.
Ran on_terminal(const Desk& desk, const std::vector<std::string>& words, const std::string& typed) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    std::vector<char*> arguments{const_cast<char*>(program)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (chdir(desk.folder().c_str()) == 0) execv(arguments[0], arguments.data());
    _exit(127);
  }
  REQUIRE(write(terminal, typed.data(), typed.size()) == static_cast<ssize_t>(typed.size()));
  Ran ran;
  char part[1024];
  for (ssize_t n = 0; (n = read(terminal, part, sizeof part)) > 0;) ran.out.append(part, static_cast<std::size_t>(n));
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  close(terminal);
  return ran;
}

}  // namespace

TEST_SUITE("cli init") {
  TEST_CASE("every template runs: assessed modes pass, others are listed as open, nothing is without effect") {
    for (const char* name : {"belt", "chain", "column", "gear", "mechanism", "shaft", "vessel", "worm"}) {
      CAPTURE(name);
      const Desk desk;
      const Ran begun = desk.run({"init", name});
      CHECK(begun.code == 0);
      const std::string file = std::string(name) + ".toml";
      CHECK(contains(begun.out, "loadpath run " + file + " --report " + name + ".html"));
      const Ran ran = desk.run({"run", file});
      CHECK(ran.code == 0);
      CHECK(ran.error.empty());
      CHECK(contains(desk.get(file), "\n[values]\n"));
      CHECK(desk.get(file).starts_with("# "));
      CHECK(values_without_comment(desk.get(file)) == "");
    }
  }

  TEST_CASE("without a template and without a terminal, the templates are listed") {
    const Ran ran = loadpath_with({"init"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "belt, chain, column, gear, mechanism, shaft, vessel, worm"));
    CHECK(contains(loadpath_with({"init", "shat"}).error, "did you mean 'shaft'?"));
  }

  TEST_CASE("the main numbers and other fields are set, in the layout of fmt") {
    const Ran ran = loadpath_with({"init", "shaft", "-", "--set", "T=80 N*m", "--set", "shaft.S_D=1.6", "--set",
                                   "project.title=Countershaft", "--set", "shaft.supports.left.x=86 mm"});
    CHECK(ran.code == 0);
    CHECK(ran.error.empty());
    CHECK(contains(ran.out, "\nT = \"80 N*m\"     # torque; from power and speed: "));
    CHECK(contains(ran.out, "\nS_D = 1.6            # required safety factor, fatigue\n"));
    CHECK(contains(ran.out, "\ntitle = \"Countershaft\"\n"));
    CHECK(contains(ran.out, "{ name = \"left\", x = \"86 mm\", "));
    CHECK(Desk().run({"fmt", "--check", "-"}, ran.out).code == 0);
    CHECK(Desk().run({"run", "-", "--quiet"}, ran.out).code == 0);
  }

  TEST_CASE("an existing file is kept, and the error is reported; nothing is written") {
    const Desk desk;
    desk.put("shaft.toml", "mine");
    const Ran there = desk.run({"init", "shaft"});
    CHECK(there.code == 2);
    CHECK(contains(there.error, "'shaft.toml' already exists"));
    CHECK(desk.get("shaft.toml") == "mine");
    CHECK(contains(desk.run({"init", "gear.bevel"}).error,
                   "loadpath describe gear.bevel --toml > project.toml; available: "));
    CHECK(contains(desk.run({"init", "shat"}).error, "did you mean 'shaft'?"));
    const Ran unit = desk.run({"init", "column", "--set", "P=300 kn"});
    CHECK(unit.code == 2);
    CHECK(contains(unit.error, "unknown unit 'kn'"));
    const Ran dimension = desk.run({"init", "column", "--set", "P=300 m"});
    CHECK(dimension.code == 2);
    CHECK(contains(dimension.error, "--set:1:"));
    CHECK(contains(desk.run({"init", "column", "--set", "lenght=3 m"}).error, "'lenght' is not a valid key here"));
    CHECK(contains(desk.run({"init", "shaft", "-", "--set", "shaft.pieces=[]"}).error, "is an array"));
    CHECK(contains(desk.run({"init", "column", "--set", "colum.n_st=3"}).error, "did you mean 'column'?"));
    CHECK(desk.files() == std::vector<std::string>{"shaft.toml"});
  }

  TEST_CASE("on a terminal it asks, and again where an answer is not valid") {
    const Desk desk;
    desk.put("column.toml", "mine");
    const Ran ran = on_terminal(desk, {"init"}, "colum\ncolumn\n\ntower.toml\n450 kn\n450 kN\n\n\n\n");
    CAPTURE(ran.out);
    CHECK(ran.code == 0);
    CHECK(contains(ran.out, "did you mean 'column'?"));
    CHECK(contains(ran.out, "'column.toml' already exists"));
    CHECK(contains(ran.out, "compressive force [300 kN]"));
    CHECK(contains(ran.out, "unknown unit 'kn'"));
    CHECK(contains(desk.get("tower.toml"), "P = \"450 kN\""));
    CHECK(contains(desk.get("tower.toml"), "l = \"4 m\""));
    CHECK(desk.get("column.toml") == "mine");
  }

  TEST_CASE("answers that end early write nothing") {
    const Desk desk;
    CHECK(on_terminal(desk, {"init"}, "1\nmine.toml\n\x04").code == 2);
    CHECK(desk.files().empty());
  }
}
