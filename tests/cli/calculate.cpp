#include "tests/cli/process.hpp"

#include <boost/json.hpp>

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli calculate") {
  TEST_CASE("one line sizes a shaft and shows the formulas") {
    const Ran o = loadpath_with({"shaft", "torsion", "--T", "2700 N*m", "--tau_adm", "30 MPa", "--full"});
    CHECK(o.code == 0);
    CHECK(o.error.empty());
    CHECK(contains(o.out, "d_strength = ∛(16 · W_t / π)"));
    CHECK(contains(o.out, "77.1029 mm"));
    CHECK(contains(o.out, "pass  torsion.u_tau"));
  }

  TEST_CASE("the short answer: verdict, governing check, size, the formulas of that check") {
    const Ran o = loadpath_with({"shaft", "torsion", "--T", "2700 N*m", "--tau_adm", "30 MPa"});
    CHECK(o.code == 0);
    CHECK(o.out.starts_with("PASS (torsion only; fatigue"));
    CHECK(contains(o.out, ", utilisation 0.895 (26.9 / 30 MPa)\n"));
    CHECK(contains(o.out, "\n* d = 80 mm; 75 mm fails: "));
    CHECK(contains(o.out, "  u_τ = τ_max / τ_all "));
    CHECK(contains(o.out, "\nNot considered: fatigue"));
    CHECK(contains(o.out, "\nMore: --full, --report FILE.pdf, loadpath describe shaft.torsion\n"));
    CHECK_FALSE(contains(o.out, "d_strength"));
    const Ran section = loadpath_with({"section", "circle", "--d", "50 mm"});  // without a check: its results
    CHECK(contains(section.out, "  A           1963.5 mm²   area\n"));
    CHECK(contains(section.out, " more results: --full\n"));
  }

  TEST_CASE("flags take what a file takes: decimal comma, material, search") {
    CHECK(
        loadpath_with({"shaft", "torsion", "--T", "2,7 kN·m", "--material", "C45E", "--S", "2", "--chi", "0.6"}).code ==
        0);
    const Ran o =
        loadpath_with({"shaft", "torsion", "--T=2700 N*m", "--tau_adm=30 MPa", "--d", "{ stock = \"R20\" }", "--json"});
    CHECK(o.code == 0);
    const auto v = boost::json::parse(o.out);
    CHECK(v.at("steps").at(0).at("inputs").at("d").at("from") ==
          "smallest of R20 with which no assessed mode fails; 71 mm fails: u_tau = 1.281");
  }

  TEST_CASE("a negative quantity is a value, not an option") {
    CHECK(contains(loadpath_with({"shaft", "torsion", "--T", "-5 N*m", "--tau_adm", "30 MPa"}).out, "-5 N·m"));
  }

  TEST_CASE("a list is inline TOML") {
    CHECK(loadpath_with({"shaft", "torsion", "--tau_adm", "30 MPa", "--torques",
                         R"([{ x = "0 mm", T = "90 N*m" }, { x = "1 m", T = "-90 N*m" }])"})
              .code == 0);
  }

  TEST_CASE("an error is shown at its place in the text of the flag") {
    CHECK(loadpath_with({"shaft", "torsion", "--T", "2700 N*m", "--tau_adm", "30 mpa"}).error ==
          R"(--tau_adm:1:4: error: unknown unit 'mpa'
1 | 30 mpa
  |    ^^^
  = help: did you mean 'MPa'?
)");
    CHECK(loadpath_with({"shaft", "torsion", "--tau_adm", "30 MPa", "--torques", R"([{ x = "0 mm", T = "90 N" }])"})
              .error ==
          R"(--torques:1:21: error: '90 N' is a force; a moment is expected
1 | [{ x = "0 mm", T = "90 N" }]
  |                     ^^^^
  = help: write a unit such as N*m
)");
    CHECK(loadpath_with({"shaft", "torsion", "--tau_adm", "30 MPa", "--torques", "[{ x = 3 mm }]"})
              .error.starts_with("--torques:1:10: error: not valid TOML"));
  }

  TEST_CASE("a word or a quantity in the place of an integer is reported as that") {
    const auto error_of = [](const std::string& z_2) {
      return loadpath_with({"gear", "pair", "--z_1", "20", "--z_2", z_2}).error;
    };
    CHECK(error_of("x") == R"(--z_2:1:1: error: an integer is expected, not 'x'
1 | x
  | ^
  = help: for example --z_2 3
)");
    CHECK(contains(error_of("3 mm"), "--z_2:1:1: error: an integer is expected, not '3 mm'\n"));
  }

  TEST_CASE("an unknown flag is reported with the nearest one, and nothing is computed") {
    const Ran o = loadpath_with({"shaft", "torsion", "--T", "2700 N*m", "--tua_adm", "30 MPa"});
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(contains(o.error, "unknown option '--tua_adm'\n  = help: did you mean '--tau_adm' ("));
  }

  TEST_CASE("a flag without its value and a superfluous word are reported") {
    const std::string help = "  = help: `loadpath shaft torsion --help` lists all options\n";
    CHECK(loadpath_with({"shaft", "torsion", "--T"}).error == "loadpath: '--T' needs a value\n" + help);
    CHECK(loadpath_with({"shaft", "torsion", "heavy"}).error == "loadpath: 'heavy' is not expected here\n" + help);
  }

  TEST_CASE("a flag that is given twice is reported, and nothing is computed") {
    const Ran o = loadpath_with({"shaft", "torsion", "--T", "1 N*m", "--T", "2 N*m", "--tau_adm", "30 MPa"});
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(o.error == "loadpath: '--T' is given more than once\n  = help: it takes one value: leave out all but one\n");
    CHECK(loadpath_with({"run", "a.toml", "--csv", "a", "--csv=b"}).error ==
          "loadpath: '--csv' is given more than once\n  = help: it takes one value: leave out all but one\n");
  }

  TEST_CASE("a rule that is broken is reported without a place") {
    CHECK(loadpath_with({"shaft", "torsion", "--tau_adm", "30 MPa"}).error ==
          "command line: error: torsion: give the torque T, or the power P with the speed n, or torques\n");
  }

  TEST_CASE("missing input of a mechanism in the shell is reported") {
    const Ran o =
        loadpath_with({"mechanism", "planar", "--links", R"({ crank = { points = { O = ["0 mm", "0 mm"] } } })"});
    CHECK(o.code == 2);
    CHECK(o.error == "command line: error: planar.joints: 'joints' is missing: joints, by name\n");
    CHECK(loadpath_with({"mechanism", "planar", "--links", "{ crank = 3 }", "--joints", "{}"})
              .error.starts_with("--links:1:11: error: 'links.crank' is a table of fields, not a number\n"));
  }

  TEST_CASE("a mechanism from the shell is solved") {
    const Ran o = loadpath_with(
        {"mechanism", "planar", "--ground", R"({ O = ["0 mm", "0 mm"] })", "--links",
         R"({ crank = { angle = "0 deg", points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] } } })", "--joints",
         R"({ O = { type = "revolute", links = ["ground", "crank"] } })", "--crank", R"({ joint = "O", at = "0 deg" })",
         "--loads", R"([{ link = "crank", at = "A", F_x = "0 N", F_y = "-100 N" }])"});
    CHECK(o.error.empty());
    CHECK(o.code == 0);
    CHECK(contains(o.out, "5 N·m"));
  }

  TEST_CASE("a mechanism from the shell is a template with its parameters as flags") {
    const Ran o = loadpath_with({"mechanism", "planar", "--template", "scotch_yoke", "--r", "25 mm", "--crank",
                                 R"({ speed = "60 rpm", positions = 12 })", "--links", R"({ yoke.mass = "2 kg" })"});
    CHECK(o.error.empty());
    CHECK(o.code == 0);
    CHECK(loadpath_with({"mechanism", "planar", "--template", "scotchyoke"}).error ==
          "--template:1:1: error: unknown template 'scotchyoke'\n1 | scotchyoke\n  | ^^^^^^^^^^\n  = help: did you "
          "mean 'scotch_yoke'?\n");
  }

  TEST_CASE("a report is written from the shell, too") {
    const Desk desk;
    CHECK(desk.run({"shaft", "torsion", "--T", "2700 N*m", "--tau_adm", "30 MPa", "--title", "Drive", "--report",
                    "a.html"})
              .code == 0);
    CHECK(contains(desk.get("a.html"), "Drive"));
  }

  TEST_CASE("an id is equivalent to its two words") {
    const std::vector<std::string> flags{"--T", "2700 N*m", "--tau_adm", "30 MPa"};
    std::vector<std::string> one{"shaft.torsion"}, two{"shaft", "torsion"};
    one.insert(one.end(), flags.begin(), flags.end());
    two.insert(two.end(), flags.begin(), flags.end());
    CHECK(loadpath_with(one).code == 0);
    CHECK(loadpath_with(one).out == loadpath_with(two).out);
    CHECK(loadpath_with({"shaft.torsoin"}).code == 2);
  }

  TEST_CASE("--accept accepts a mode that is not assessed, --strict counts the open ones") {
    const std::vector<std::string> gears{"gear",          "pair",    "--z_1",         "20",     "--z_2", "57",
                                         "--m_n",         "2.5 mm",  "--T_1",         "60 N*m", "--b",   "25 mm",
                                         "--sigma_adm_1", "200 MPa", "--sigma_adm_2", "200 MPa"};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), gears.begin(), gears.end());
      return loadpath_with(more);
    };
    const std::vector<std::string> accepted{"--accept", "pitting_1=rated by the maker", "--accept",
                                            "pitting_2=rated by the maker"};
    CHECK(with({}).code == 4);
    CHECK(with(accepted).code == 0);
    std::vector<std::string> in_full = accepted;
    in_full.emplace_back("--full");
    CHECK(with(in_full).out.find("accepted") != std::string::npos);
    std::vector<std::string> strict = accepted;
    strict.emplace_back("--strict");
    CHECK(with(strict).code == 4);
    CHECK(with({"--accept", "pitting_1"}).code == 2);
    CHECK(with({"--accept", "piting_1=x"}).error.find("did you mean 'pitting_1'?") != std::string::npos);
  }
}
