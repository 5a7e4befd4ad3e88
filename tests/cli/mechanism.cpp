#include "tests/cli/process.hpp"
#include "tests/slotted_lever.hpp"

#include <algorithm>

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string project = R"([project]
title = "Press"
[press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 12 }
links.slider.mass = "2 kg"
[broken]
calculator = "shaft.torsion"
T = "=peak(press.drive.M) * 3 mm"
)";

Ran mechanism(const Desk& desk, std::vector<std::string> words) {
  words.insert(words.begin(), {"mechanism", "planar", "--file", "-", "--full"});
  return desk.run(words, project);
}

}  // namespace

TEST_SUITE("cli mechanism") {
  TEST_CASE("a mechanism of a project file is solved by itself: extremes, structure, mobility, proof") {
    const Ran o = mechanism(Desk(), {});
    CHECK(o.code == 0);
    CHECK(o.error.empty());
    CHECK(o.out.starts_with("PASS ("));
    CHECK(contains(o.out,
                   ")\nPress\n\npress: Planar mechanism (kinematics, kinetostatics) (mechanism.planar)\n  Extreme "
                   "values over the cycle\n"));
    CHECK(contains(o.out, "    rod, slider  A, B, guide  two-link group, class II, order 2, RRP  6 = 2 · 3 + 0\n"));
    CHECK(contains(o.out, "    mobility by rank of the constraints "));
    CHECK(contains(o.out, "  12 of 12  "));
    CHECK_FALSE(contains(o.out, "broken"));
  }

  TEST_CASE("at given angles there is no mean over time, and no column for it") {
    const Ran given = mechanism(Desk(), {"--at", "[\"0 deg\", \"90 deg\"]"}), turn = mechanism(Desk(), {});
    const auto head = [](const std::string& text) {
      const std::size_t from = text.find("largest");
      return text.substr(from, text.find('\n', from) - from);
    };
    CHECK(contains(head(turn.out), "rms"));
    CHECK_FALSE(contains(head(given.out), "mean"));
    CHECK_FALSE(contains(head(given.out), "rms"));
  }

  TEST_CASE("flags replace the values in the file") {
    CHECK(contains(mechanism(Desk(), {"--positions", "36"}).out, "  36 of 36  "));
    CHECK(contains(mechanism(Desk(), {"--at", "[\"0 deg\", \"90 deg\"]"}).out, "  2 of 2  "));
    CHECK(contains(mechanism(Desk(), {"--at", "30 deg"}).out, "Drive and reactions\n"));
    CHECK(contains(mechanism(Desk(), {"--at", "\"30 deg\""}).out, "Drive and reactions\n"));
    CHECK(contains(mechanism(Desk(), {"--at", "[]"}).error, "--at:1:1: error: 'crank.at' is empty\n"));
    CHECK(contains(mechanism(Desk(), {"--r", "250 mm"}).error,
                   ": error: the crank cannot make a full revolution: the rod, l = 200 mm"));
    CHECK(mechanism(Desk(), {"--r", "250 mm"}).code == 2);
    CHECK(mechanism(Desk(), {"--at", "x deg"}).error.starts_with("--at:1:1: error: a number must come first"));
  }

  TEST_CASE("the mechanism is drawn to the given file, for a page and for CAD, and its series are written") {
    const Desk desk;
    CHECK(mechanism(desk, {"--at", "[\"0 deg\", \"90 deg\"]", "--svg", "a.svg", "--dxf", "a.dxf", "--csv", "a.csv"})
              .code == 0);
    CHECK(desk.files() == std::vector<std::string>{"a.csv", "a.dxf", "a.svg"});
    CHECK(desk.get("a.svg").starts_with("<svg"));
    CHECK(contains(desk.get("a.dxf"), "\nLINE\n8\nrod\n10\n50\n20\n0\n30\n0\n11\n250\n21\n0\n31\n0\n"));
    const std::string csv = desk.get("a.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
  }

  TEST_CASE("series are chosen by name for CSV and JSON") {
    const Desk desk;
    CHECK(mechanism(desk, {"--csv", "a.csv", "--series", "drive.M,links.*.N", "--series", "press.points.A.v_?"}).code ==
          0);
    CHECK(desk.get("a.csv").starts_with(
        "crank angle [deg],drive.M [N*m],points.A.v_x [m/s],points.A.v_y [m/s],links.crank.N "
        "[N],links.rod.N [N]\n0,"));
    const std::string all = mechanism(desk, {"--json"}).out, some = mechanism(desk, {"--json", "--series=drive.M"}).out;
    CHECK(contains(some,
                   "\"drive.M\": {\n          \"unit\": \"N*m\",\n          \"axis\": \"press: crank angle\",\n"
                   "          \"values\": ["));
    CHECK_FALSE(contains(some, "\"drive.P\""));
    CHECK(some.size() < all.size());
  }

  TEST_CASE("a choice of unknown series, or without an output, is refused, and nothing is written") {
    const Desk desk;
    const Ran wrong = mechanism(desk, {"--csv", "a.csv", "--series", "drive.M,link.*.N"});
    CHECK(wrong.code == 2);
    CHECK(wrong.error == "--series: error: unknown series 'link.*.N'\n  = help: did you mean 'links.*.N'?\n");
    CHECK(wrong.out.empty());
    CHECK(desk.files().empty());
    CHECK(contains(mechanism(desk, {"--json", "--series", "x"}).out, "\"message\": \"unknown series 'x'\""));
    const Ran idle = mechanism(desk, {"--series", "drive.M"});
    CHECK(idle.code == 2);
    CHECK(idle.error ==
          "loadpath: '--series' selects the series for --csv and --json; neither is given\n  = help: add --csv "
          "PATH or "
          "--json\n");
  }

  TEST_CASE("one file is not enough for the drawings of two mechanisms") {
    std::string two = project.substr(0, project.find("[broken]"));
    const std::string step = two.substr(two.find("[press]"));
    two += "[second" + step.substr(6);
    for (const char* const kind : {"svg", "dxf"}) {
      const Desk desk;
      const std::string file = std::string("two.") + kind, option = std::string("--") + kind;
      const Ran one = desk.run({"mechanism", "planar", "--file", "-", option, file}, two);
      CHECK(contains(one.error,
                     "loadpath: '" + file + "' is one file, and 2 steps are drawn\n  = help: name a folder\n"));
      CHECK(one.code == 2);
      CHECK(desk.files().empty());
      CHECK(desk.run({"mechanism", "planar", "--file", "-", option, "out"}, two).code == 0);
      CHECK(desk.has(kind == std::string("svg") ? "out/second-first-position.svg" : "out/second.dxf"));
    }
  }

  TEST_CASE("a folder takes every figure, one for each given angle among them") {
    const Desk desk;
    CHECK(mechanism(desk, {"--at", "[\"0 deg\", \"90 deg\"]", "--svg", "out"}).code == 0);
    CHECK(desk.has("out/press-first-position.svg"));
    CHECK(desk.has("out/press-position-2.svg"));
    CHECK(desk.has("out/press-reactions.svg"));
  }

  TEST_CASE("one file holds one step's series") {
    const Desk desk;
    const Ran o = desk.run({"run", "-", "--csv", "a.csv"},
                           project.substr(0, project.find("[broken]")) +
                               "[lifted]\ncalculator = \"shaft.overhung\"\nF = \"=press.joints.O.F\"\nT = "
                               "\"=press.drive.M\"\na = \"5 mm\"\nsigma_adm = \"60 MPa\"\n");
    CHECK(o.code == 2);
    CHECK(o.error == "loadpath: 'a.csv' is one file, and 2 steps have series\n  = help: name a folder\n");
    CHECK(desk.files().empty());
  }

  TEST_CASE("a file without such a step, or without a crank, is reported") {
    const Desk desk;
    desk.put("a.toml", "[axle]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\n");
    CHECK(desk.run({"mechanism", "planar", "--file", "a.toml"}).error ==
          "a.toml: error: the project has no step of 'mechanism.planar'\n");
    CHECK(desk.run({"mechanism", "planar", "--file", "b.toml"}).error ==
          "loadpath: cannot read 'b.toml'\n  = help: did you mean 'a.toml'?\n");
    CHECK(desk.run({"mechanism", "planar", "--template", "scotch_yoke", "--r", "9 mm", "--at", "3 deg"}).error ==
          "--at: error: crank angles need a crank, and this mechanism has none\n  = help: write its speed: --crank '{ "
          "speed = "
          "\"60 rpm\" }'\n");
  }

  TEST_CASE("any calculator takes its steps from a file, with the steps they refer to") {
    const Desk desk;
    desk.put("a.toml", slotted_lever_with_two_shafts());
    const Ran o = desk.run({"shaft", "torsion", "--file", "a.toml", "--tau_adm", "40 MPa", "--full"});
    CHECK(o.code == 4);
    CHECK(contains(o.out, "d_strength = ∛(16 · W_t / π)"));
    CHECK(contains(o.out, "24.8497 mm"));
    CHECK(contains(o.out, "crank_end"));  // the same body
    CHECK_FALSE(contains(o.out, "the report of the lever"));
  }
}
