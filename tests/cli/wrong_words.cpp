// Wrong keys and options: the similar ones are reported with their meanings, on the shell and in a file.
#include "tests/cli/process.hpp"

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Ran with_key(const std::string& key) {
  const std::string file = "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"900 N*m\"\ntau_adm = \"30 MPa\"\n";
  return Desk().run({"run", "-"}, file + key + " = \"20 mm\"\n");
}

}  // namespace

TEST_SUITE("cli wrong words") {
  TEST_CASE("a wrong option is reported with the similar ones and their meanings") {
    const Ran near = loadpath_with({"shaft", "torsion", "--T", "3 N*m", "--tauadm", "30 MPa"});
    CHECK(near.code == 2);
    CHECK(contains(near.error, "unknown option '--tauadm'"));
    CHECK(contains(near.error, "did you mean '--tau_adm' (allowable "));
    const Ran begun = loadpath_with({"shaft", "torsion", "--theta", "1 deg/m"});
    CHECK(contains(loadpath_with({"gear", "worm", "--a", "100 mm"}).error, "'--a' is a result, not an input: "));
    CHECK(contains(begun.error, "'--theta_adm' (allowable "));
    const Ran meaning = loadpath_with({"shaft", "torsion", "--length", "1 m"});
    CHECK(contains(meaning.error, "'--l' ("));
  }

  TEST_CASE("the remedy for missing input in the shell is a flag") {
    const Ran lacking = loadpath_with({"shaft", "overhung", "--F", "1 kN"});
    CHECK(lacking.code == 2);
    CHECK(contains(lacking.error, "= help: write --a \"... mm\""));
    const Ran ends =
        loadpath_with({"column", "buckling", "--P", "1 kN", "--l", "1 m", "--d", "40 mm", "--material", "S235"});
    CHECK(contains(ends.error, "give the end conditions"));
    CHECK(contains(ends.error, "--ends \"pinned_pinned\", \"fixed_free\""));
    CHECK(contains(loadpath_with({"run", "--accept", "a=b", "a.toml"}).error, "accept.MODE = \"reason\""));
    CHECK(contains(loadpath_with({"mechanism", "slider_crank"}).error,
                   "`loadpath mechanism planar --template slider_crank`"));
  }

  TEST_CASE("a wrong word of a choice is reported with the similar one, else with all and their short forms") {
    const auto with_ends = [](const char* ends) {
      return loadpath_with({"column", "buckling", "--P", "1 kN", "--l", "1 m", "--d", "40 mm", "--ends", ends}).error;
    };
    CHECK(contains(with_ends("hinged"), "'hinged' is not a valid value of 'ends'"));
    CHECK(contains(with_ends("hinged"), "did you mean 'pinned'?"));
    CHECK(contains(with_ends("welded"), "available: pinned_pinned (or pinned), fixed_free (or cantilever), "));
  }

  TEST_CASE("an empty text is not a value of an option") {
    for (const char* option : {"--minimise", "--maximise", "--seek", "--pareto", "--results", "--csv", "--out"}) {
      const Ran ran = loadpath_with({"sweep", "none.toml", option, ""});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, std::string(option) + ": a value is missing"));
    }
    CHECK(contains(loadpath_with({"run", "none.toml", "--csv", ""}).error, "--csv: a value is missing"));
  }

  TEST_CASE("a value outside its range or choices is named with what may be given") {
    CHECK(loadpath_with({"sweep", "a.toml", "--jobs", "0"})
              .error.starts_with("loadpath: --jobs: '0' is not an integer from 1 to 1024\n"));
    CHECK(loadpath_with({"sweep", "a.toml", "--quantile", "3"})
              .error.starts_with("loadpath: --quantile: '3' is not a number from 0.5 to 0.999999\n"));
    CHECK(loadpath_with({"sweep", "a.toml", "--save-every", "-1"})
              .error.starts_with("loadpath: --save-every: '-1' is not a number of 0 or more\n"));
    CHECK(loadpath_with({"run", "a.toml", "--detail", "long"}).error ==
          "loadpath: 'long' is not a value of --detail\n  = help: one of brief, normal, full\n");
    CHECK(contains(loadpath_with({"completion", "tcsh"}).error, "one of bash, zsh, fish\n"));
    CHECK(contains(loadpath_with({"run", "a.toml", "--full", "--modes"}).error,
                   "'--full' and '--modes' cannot be given together"));
  }

  TEST_CASE("a file in place of a command, and options of a sweep without a point, are reported with the remedy") {
    CHECK(contains(loadpath_with({"shaft.toml"}).error, "`loadpath run shaft.toml` solves a project file"));
    CHECK(contains(loadpath_with({"help"}).error, "`loadpath --help`"));
    CHECK(contains(loadpath_with({"sweep"}).error, "FILE is missing"));
    for (const char* command : {"run", "why"}) {
      const Ran ran = loadpath_with({command, "a.toml", "--zip", "a.T,a.n"});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, "'--zip' applies to a sweep"));
      CHECK(contains(ran.error, "add --point N"));
    }
  }

  TEST_CASE("a mechanism without its model is answered with a template") {
    CHECK(
        contains(loadpath_with({"mechanism", "planar"}).error,
                 "help: write --template \"slider_crank\"; `loadpath describe mechanism.planar templates` lists all"));
  }

  TEST_CASE("misspelt keys of steps and ranges, a list of one value and a far too high utilisation") {
    const auto ran = [](const std::string& text) { return Desk().run({"run", "-"}, text); };
    const std::string shaft = "[a]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
    CHECK(contains(ran("[a]\ncalculater = \"shaft.torsion\"\n").error, "2:1: error: 'calculater' is not a valid key"));
    CHECK(contains(ran(shaft + "T = [\"5 N*m\"]\n").error, "this is a list; a single value is required"));
    CHECK(contains(ran(shaft + "T = { form = \"5 N*m\", to = \"6 N*m\", count = 3 }\n").error, "did you mean 'from'?"));
    CHECK(contains(ran(shaft + "T = \"5 N*m\"\nd = \"30 nm\"\n").out, "  3.144e16 "));
    CHECK(contains(ran(shaft + "T = \"5 N*m\"\nd = \"30 mn\"\n").error, "did you mean 'mm'?"));
  }

  TEST_CASE("a wrong key of a file is reported with the similar ones and their meanings") {
    CHECK(with_key("d_bor").code == 2);
    CHECK(contains(with_key("d_bor").error, "did you mean 'd_bore' ("));
    CHECK(contains(with_key("diameter").error, "diameter"));
    CHECK(contains(with_key("diameter").error, "'d' ("));
    CHECK(contains(with_key("length").error, "'l' ("));
  }
}
