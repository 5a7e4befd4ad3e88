#include "tests/cli/process.hpp"

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli help") {
  TEST_CASE("no arguments: the help on standard error, exit 2") {
    const Ran o = loadpath_with({});
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(contains(o.error, "loadpath run examples/slotted-lever/project.toml"));
    CHECK(contains(o.error, "Exit codes: 0 every failure mode that applies passes"));
  }

  TEST_CASE("--help and --version print to standard output, exit 0") {
    CHECK(loadpath_with({"--help"}).code == 0);
    CHECK(contains(loadpath_with({"--help"}).out, "shaft                       calculators: torsion, overhung"));
    CHECK(loadpath_with({"--version"}).code == 0);
    CHECK(loadpath_with({"--version"}).out.starts_with("loadpath "));
  }

  TEST_CASE("an element shows its calculators") {
    const Ran o = loadpath_with({"shaft"});
    CHECK(o.code == 2);
    CHECK(contains(o.error, "Usage: loadpath shaft"));
    CHECK(contains(o.error, "torsion"));
    CHECK(contains(o.error, "overhung"));
  }

  TEST_CASE("the help of a calculator has its fields with units") {
    const Ran o = loadpath_with({"shaft", "torsion", "--help"});
    CHECK(o.code == 0);
    CHECK(contains(o.out, "--tau_adm MPa"));
    CHECK(contains(o.out, "--K_A NUMBER"));
    CHECK(contains(o.out, "--segments TOML"));
    CHECK(contains(o.out, "--material NAME"));
    CHECK(contains(loadpath_with({"mechanism", "planar", "--help"}).out, "--positions COUNT"));
  }

  TEST_CASE("an unknown command is reported with the nearest one, or with all") {
    CHECK(loadpath_with({"runn", "a.toml"}).error ==
          "loadpath: unknown command 'runn'\n  = help: did you mean 'run'?\n");
    CHECK(loadpath_with({"teapot"})
              .error.starts_with(
                  "loadpath: unknown command 'teapot'\n  = help: available: run, sweep, why, watch, list, describe, "
                  "convert, verify, tables, completion, man, schema, init, diff, fmt, lsp, mechanism, shaft"));
    CHECK(loadpath_with({"teapot"}).code == 2);
  }

  TEST_CASE("an unknown command is reported with the meaning of the word") {
    CHECK(contains(loadpath_with({"torsion"}).error, "did you mean 'shaft torsion'?"));
    CHECK(contains(loadpath_with({"bolt"}).error, "not included: bolted joints"));
    CHECK(contains(loadpath_with({"materials"}).error, "did you mean 'tables materials'?"));
    CHECK(contains(loadpath_with({"report"}).error, "did you mean 'run'"));
  }

  TEST_CASE("a value split at its blank is reported with the quotes it needs") {
    CHECK(loadpath_with({"shaft", "torsion", "--T", "2700", "N*m", "--tau_adm", "30 MPa"}).error ==
          "loadpath: 'N*m' is not expected here\n  = help: a value with a blank needs quotes: --T \"2700 N*m\"\n");
  }

  TEST_CASE("an input of a table is reported with its flag") {
    const auto said = [](const std::string& flag) {
      return loadpath_with({"mechanism", "planar", "--template", "slider_crank", flag, "180 rpm"}).error;
    };
    CHECK(contains(said("--crank.speed"), "write --crank '{ speed = \"... rad/s\" }'"));
    CHECK(contains(said("--n"), "write --crank '{ speed = \"... rad/s\" }'"));
  }

  TEST_CASE("an unknown calculator is reported with the nearest one") {
    const Ran o = loadpath_with({"shaft", "torsoin", "--T", "3 N*m"});
    CHECK(o.code == 2);
    CHECK(o.error == "loadpath: unknown calculator 'shaft torsoin'\n  = help: did you mean 'shaft torsion'?\n");
  }

  TEST_CASE("an unknown option is reported with the nearest one") {
    CHECK(contains(loadpath_with({"run", "--rport", "a.html", "a.toml"}).error,
                   "loadpath: unknown option '--rport'\n  = help: did you mean '--report' ("));
    CHECK(contains(loadpath_with({"--versoin"}).error,
                   "loadpath: unknown option '--versoin'\n  = help: did you mean '--version' ("));
    CHECK(
        loadpath_with({"shaft", "--T", "3 N*m"})
            .error.starts_with("loadpath: unknown option '--T'\n  = help: name the calculator; available: torsion, "));
    CHECK(loadpath_with({"bearing", "--bearing", "6208"}).error ==
          "loadpath: unknown option '--bearing'\n  = help: name the calculator: loadpath bearing rolling\n");
    CHECK(loadpath_with({"shaft", "--T", "3 N*m"}).code == 2);
  }

  TEST_CASE("a missing word and a superfluous word are reported") {
    CHECK(loadpath_with({"run"}).error ==
          "loadpath: FILE is missing\n  = help: `loadpath run FILE`; `loadpath run --help` lists all options\n");
    CHECK(loadpath_with({"sweep", "a.toml", "b.toml"}).error ==
          "loadpath: 'b.toml' is not expected here\n  = help: `loadpath sweep --help` lists all options\n");
    CHECK(loadpath_with({"run"}).code == 2);
  }
}
