// Completion as the shells do it, and the manual page.
#include "tests/cli/process.hpp"
#include "tests/program.hpp"

#include <algorithm>

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The words that are offered, a line each, behind these.
std::string offered(const Desk& desk, std::vector<std::string> words) {
  words.insert(words.begin(), {"completion", "candidates", "--"});
  const Ran ran = desk.run(words);
  CHECK(ran.code == 0);
  return "\n" + ran.out;
}

bool has(const std::string& offered, const std::string& word) {
  return contains(offered, "\n" + word + "\n") || contains(offered, "\n" + word + "\t");
}

/// Completion by bash of a line that ends where the tabulator is struck.
std::string in_bash(const Desk& desk, const std::string& words) {
  desk.put("try.bash", std::string("loadpath() { '") + program +
                           "' \"$@\"; }\nsource <(loadpath completion bash)\nCOMP_WORDS=(" + words +
                           ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_loadpath\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  return "\n" + desk.shell("bash try.bash").out;
}

}  // namespace

TEST_SUITE("completion") {
  TEST_CASE("commands, calculators, flags and their values come from the program") {
    const Desk desk;
    const std::string commands = offered(desk, {""});
    for (const char* word : {"run", "sweep", "watch", "completion", "shaft"}) CHECK(has(commands, word));
    CHECK(has(offered(desk, {"sha"}), "shaft"));
    CHECK_FALSE(has(offered(desk, {"sha"}), "run"));
    CHECK(has(offered(desk, {"shaft", ""}), "torsion"));
    CHECK(has(offered(desk, {"shaft", "torsion", "--tau"}), "--tau_adm"));
    CHECK(has(offered(desk, {"shaft", "torsion", "--T", "3 N*m", "--material", "C4"}), "C45E"));
    CHECK(has(offered(desk, {"chain", "roller", "--chain", "16"}), "16B"));
    CHECK(has(offered(desk, {"describe", "shaft.t"}), "shaft.torsion"));
    CHECK(has(offered(desk, {"describe", "mechanism.planar.s"}), "mechanism.planar.slider_crank"));
    CHECK(has(offered(desk, {"describe", "shaft.torsion", "th"}), "theta_adm"));
    CHECK(has(offered(desk, {"describe", "--to"}), "--toml"));
    CHECK(has(offered(desk, {"list", ""}), "belt"));
    CHECK(has(offered(desk, {"tables", "sections/ip"}), "sections/ipe"));
    CHECK(has(offered(desk, {"tables", "sections", "IPE 2"}), "IPE 200"));
    CHECK(has(offered(desk, {"run", "--detail", ""}), "brief"));
    CHECK(has(offered(desk, {"init", "v"}), "vessel"));
    CHECK(has(offered(desk, {"completion", ""}), "fish"));
    CHECK(offered(desk, {"run", "--report", ""}) == "\n:files\n");
    CHECK(offered(desk, {"convert", "3 N*m", ""}) == "\n");
  }

  TEST_CASE("steps, results and modes come out of the file") {
    const Desk desk;
    const std::string file = LOADPATH_ROOT "/examples/slotted-lever/project.toml";
    CHECK(offered(desk, {"why", ""}) == "\n:files\n");
    CHECK(has(offered(desk, {"why", file, ""}), "crankshaft"));
    const std::string of_step = offered(desk, {"why", file, "crankshaft."});
    CHECK(has(of_step, "crankshaft.twist"));
    CHECK(has(of_step, "crankshaft.T_max"));
    CHECK(offered(desk, {"why", "no.toml", ""}) == "\n");
    desk.put("broken.toml", "[a\n");
    CHECK(offered(desk, {"why", "broken.toml", ""}) == "\n");
  }

  TEST_CASE("unknown words offer nothing, and no words everything") {
    const Desk desk;
    CHECK(offered(desk, {"teapot", "--x", ""}).size() < 40);
    CHECK(has(offered(desk, {}), "run"));
    CHECK(offered(desk, {"shaft", "teapot", "--", "-"}) != "");
    CHECK(desk.run({"completion", "csh"}).code == 2);
  }

  TEST_CASE("in bash, zsh and fish") {
    const Desk desk;
    CHECK(has(in_bash(desk, "loadpath sha"), "shaft"));
    CHECK(has(in_bash(desk, "loadpath shaft torsion --material C4"), "C45E"));
    desk.put("project.toml", "");
    CHECK(has(in_bash(desk, "loadpath run pro"), "project.toml"));
    CHECK(desk.shell("loadpath completion bash > c && bash -n c").code == 0);
    for (const std::string& shell : {std::string("zsh"), std::string("fish")}) {
      CHECK(contains(desk.run({"completion", shell}).out, "loadpath completion candidates --"));
      if (desk.shell("command -v " + shell).code != 0) continue;
      CHECK(desk.shell("loadpath completion " + shell + " > c && " + shell + " -n c").code == 0);
    }
  }
}

TEST_SUITE("manual page") {
  TEST_CASE("every command and calculator is in it, and roff reads it") {
    const Desk desk;
    const std::string page = desk.run({"man"}).out;
    for (const char* part : {".TH LOADPATH 1", ".SS \"loadpath run file\"", "\\fB\\-\\-report\\fR \\fIFILE\\fR",
                             "\\fBshaft.torsion\\fR", ".SH EXAMPLES", ".SH \"EXIT STATUS\""})
      CHECK(contains(page, part));
    if (desk.shell("command -v groff").code == 0) {
      const Ran set = desk.shell("loadpath man | groff -man -Tutf8 -ww > set");
      CHECK(set.code == 0);
      CHECK(set.error == "");
      CHECK(desk.get("set").size() > 10'000);
    }
  }
}
