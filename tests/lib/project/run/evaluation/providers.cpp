#include "lib/project/run/evaluation/providers.hpp"

#include "tests/lib/project/texts.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

account::Origin origin(const project::Project& project, const std::string& path) {
  const auto& inputs = project.find("axle")->account().inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const auto& e) { return e.path == path; });
  REQUIRE(found != inputs.end());
  return found->origin;
}

}  // namespace

TEST_SUITE("project providers") {
  TEST_CASE("a material fills in missing values, and the account cites its row") {
    const auto project = solved(axle + "T = \"300 N*m\"\nS = 2\nmaterial = \"C45E\"\n");
    CHECK(value(project, "axle.R_e") == doctest::Approx(430e6));
    CHECK(origin(project, "R_e").text.text() == "C45E");
    CHECK_FALSE(origin(project, "R_e").sources.empty());
  }

  TEST_CASE("a typed value overrides the row") {
    const auto project = solved(axle + "T = \"90 N*m\"\nS = 2\nmaterial = \"C45E\"\nR_e = \"300 MPa\"\n");
    CHECK(value(project, "axle.R_e") == doctest::Approx(300e6));
    CHECK(origin(project, "R_e").text.text() == "given");
  }

  TEST_CASE("the strength of a row is that of the size that follows from it") {
    CHECK(value(solved(axle + "T = \"10 N*m\"\nS = 2\nmaterial = \"C45E\"\n"), "axle.R_e") == doctest::Approx(490e6));
    CHECK(value(solved(axle + "T = \"3 kN*m\"\nS = 2\nmaterial = \"C45E\"\n"), "axle.R_e") == doctest::Approx(370e6));
  }

  TEST_CASE("beyond the largest size of a row the check is not covered") {
    const std::string shaft = axle + "T = \"100 kN*m\"\nS = 2\nmaterial = \"C45E\"\n";
    const auto given = told(shaft + "d = \"120 mm\"\n").project;
    const auto verdicts = project::verdicts(given);
    REQUIRE_FALSE(verdicts.empty());
    CHECK(verdicts[0].state == account::State::not_covered);
    CHECK_FALSE(verdicts[0].note.empty());
    const auto searched = told(shaft).project;  // 100 mm is too thin, and nothing is known beyond
    CHECK(project::verdicts(searched)[0].state == account::State::not_available);
    CHECK(project::verdicts(searched)[0].note.text().find("nearest is 100 mm") != std::string::npos);
  }

  TEST_CASE("a material that does not exist is reported with the nearest one, once") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\nS = 2\nmaterial = \"C54E\"\n") ==
          R"(a.toml:5:13: error: no material 'C54E' in the tables
5 | material = "C54E"
  |             ^^^^
  = help: did you mean 'C45E'?
)");
  }

  TEST_CASE("a material without such a strength is reported") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\nS = 2\nmaterial = \"EN-GJL-150\"\n") ==
          R"(a.toml:5:13: error: the material 'EN-GJL-150' has no yield strength R_e
5 | material = "EN-GJL-150"
  |             ^^^^^^^^^^
  = help: name another, or give tau_adm in its place
)");
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nmaterial = \"EN-GJL-150\"\n").empty());
  }

  TEST_CASE("a material that is not a text is described in words") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\nS = 2\nmaterial = 3\n") ==
          R"(a.toml:5:12: error: 'axle.material' takes a text, not a number
5 | material = 3
  |            ^
)");
  }

  TEST_CASE("a calculator that takes nothing from a material reports so") {
    CHECK(issues_of("[bar]\ncalculator = \"mechanism.planar\"\nmaterial = \"C45E\"\nlinks = { a = { points = { O = "
                    "[\"0 mm\", \"0 mm\"] } } }\n"
                    "ground = { O = [\"0 mm\", \"0 mm\"] }\njoints = { O = { type = \"revolute\", links = [\"ground\", "
                    "\"a\"] } }\ncrank = { joint = \"O\" }\n") ==
          R"(a.toml:3:1: error: 'mechanism.planar' takes nothing from a material
3 | material = "C45E"
  | ^^^^^^^^
)");
  }

  TEST_CASE("a value that the row does not have at this size does not affect the rest of the step") {
    const auto project = solved(
        "[cycle]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"180 MPa\"\nsigma_min = \"-60 MPa\"\n"
        "material = \"S235JR\"\n");
    CHECK(value(project, "cycle.sigma_m") == doctest::Approx(60e6));
    const auto verdicts = project::verdicts(project);
    REQUIRE(verdicts.size() == 1);
    CHECK(verdicts[0].state == account::State::not_covered);
    CHECK(verdicts[0].note.text().find("depends on the size") != std::string::npos);
  }

  TEST_CASE("a strength by size needs the size, and ends with it") {
    const std::string part =
        "[part]\ncalculator = \"fatigue.endurance\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\n"
        "loading = \"bending\"\nrule = \"din743\"\n";
    CHECK(issues_of(part) == R"(a.toml:3:13: error: R_m of 'C45E' depends on the size, which is not given
3 | material = "C45E"
  |             ^^^^
  = help: give d, or R_m
)");
    CHECK(issues_of(part + "d = \"300 mm\"\n").find("R_m of 'C45E' is given up to 100 mm, not for 300 mm") !=
          std::string::npos);
    CHECK(value(solved(part + "d = \"32 mm\"\n"), "part.R_m") == doctest::Approx(650e6));
  }

  TEST_CASE("an integer is a result like any other") {
    const auto project = solved(
        "[fan]\ncalculator = \"belt.v_sizing\"\nbasis = \"optibelt\"\nP = \"11 kW\"\nK_A = 1.2\n"
        "n_1 = \"1460 rpm\"\nn_2_set = \"730 rpm\"\na_set = \"600 mm\"\n"
        "[belts]\ncalculator = \"drive.train\"\nP = \"1 kW\"\nn_1 = \"100 rpm\"\n"
        "stages = [{ kind = \"belt\", i = \"=fan.z\" }]\n");
    CHECK(value(project, "fan.candidates[1].z") == value(project, "fan.z"));
    CHECK(value(project, "belts.i") == doctest::Approx(value(project, "fan.z")));
  }
}
