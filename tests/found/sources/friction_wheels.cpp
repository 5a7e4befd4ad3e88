// Regression tests of friction wheels of impossible or unusual shape: contacts as long as the cones, deep grooves, soft
// rims with the limits of metals, rims that burst.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string contact(const std::string& lines) { return mode_with("drive.friction_wheels", lines, "contact"); }

}  // namespace

TEST_SUITE("found friction wheels") {
  TEST_CASE("bevel wheels are no wider than a third of their cone distance") {
    const std::string bevel = "shape = \"bevel\"\n";
    CHECK(contact(bevel + "b = \"400 mm\"") == "not-judged");
    CHECK(contact(bevel + "b = \"120 mm\"") == "pass");  // of 0.4 x 316 mm
    CHECK(contact(bevel + "b = \"400 mm\"\nbecause.b = \"two rims\"") == "pass");
  }

  TEST_CASE("the width of cylinders is at most the diameter of the smaller one") {
    CHECK(contact("b = \"2000 mm\"") == "not-judged");
    CHECK(contact("b = \"200 mm\"") == "pass");
  }

  TEST_CASE("grooves are shallow") {
    const std::string grooved = "shape = \"grooved\"\nalpha = \"15 deg\"\nz = 3\n";
    CHECK(contact(grooved + "b = \"80 mm\"") == "not-judged");
    CHECK(contact(grooved + "b = \"40 mm\"") == "pass");
  }

  TEST_CASE("soft rims do not have the limits of metals, nor more friction than soft rims have") {
    CHECK(contact("q_adm = \"3000 N/mm\"") == "not-judged");
    CHECK(contact("q_adm = \"60 N/mm\"") == "pass");
    const std::string elastic = "q_adm = \nE_1 = \"210 GPa\"\nE_2 = \"210 GPa\"\np_adm = \"600 MPa\"\n";
    CHECK(contact(elastic) == "not-judged");
    CHECK(contact(elastic + "pair = \"cast_iron\"") == "pass");
    CHECK(contact("pair = \nmu = 0.9") == "not-judged");
    CHECK(contact("pair = \nmu = 0.6") == "pass");
  }

  TEST_CASE("a rim of cast iron turns with 35 m/s at most") {
    CHECK(contact("n_1 = \"30000 rpm\"") == "not-judged");
    CHECK(contact("n_1 = \"3000 rpm\"") == "pass");
    CHECK(contact("n_1 = \"30000 rpm\"\nbecause.n_1 = \"steel discs, see disc\"") == "pass");
  }
}
