// Where the mass of a link lies that names no mass centre: the same in a template and written out.
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string by_template =
    "[a]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
    "crank = { speed = \"60 rpm\", positions = 12 }\n";

/// The same mechanism; `rod`, `slider`: further fields of the link.
std::string written(const std::string& rod, const std::string& slider = "") {
  return R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 12 }
gravity = "0 m/s^2"
ground = { O = ["0 mm", "0 mm"], G = ["0 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["crank", "ground"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "slider"] }
joints.guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "G"] }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"], C = ["80 mm", "30 mm"] }, angle = "0 deg")" +
         rod +
         " }\nlinks.slider = { points = { B = [\"0 mm\", \"0 mm\"], T = [\"40 mm\", \"0 mm\"] }, angle = \"0 deg\"" +
         slider + " }\n";
}

std::string with_shaft(const std::string& text) {
  return replaced(text, "[a]\n",
                  "[b]\ncalculator = \"shaft.torsion\"\nT = \"=peak(a.drive.M)\"\ntau_adm = \"30 MPa\"\n[a]\n");
}
/// The largest driving moment, as a shaft takes it.
double peak(const std::string& text) { return value(solved(with_shaft(text)), "b.M_max"); }

}  // namespace

TEST_SUITE("masses of links") {
  TEST_CASE("a bar and a slide are the same, written out and by a template") {
    const std::string masses = "links.rod.mass = \"3 kg\"\nlinks.slider.mass = \"5 kg\"\n";
    CHECK(peak(written(", mass = \"3 kg\"", ", mass = \"5 kg\"")) ==
          doctest::Approx(peak(by_template + masses)).epsilon(1e-12));
    CHECK(value(solved(written(", mass = \"3 kg\"")), "a.links.rod.J") == doctest::Approx(3.0 * 0.04 / 12.0));
  }

  TEST_CASE("weights that are left out because no gravity is given are named") {
    const auto warned = [](const std::string& text) { return solved(text).find("a")->account().warnings; };
    const std::string none_given = replaced(written(", mass = \"3 kg\""), "gravity = \"0 m/s^2\"\n", "");
    REQUIRE(warned(none_given).size() == 1);
    CHECK(warned(none_given)[0].text() == "gravity not given: own weights of the links are not included");
    CHECK(warned(written(", mass = \"3 kg\"")).empty());
    CHECK(warned(replaced(none_given, "[a]\n", "[a]\ngravity = \"9.81 m/s^2\"\n")).empty());
    CHECK(warned(replaced(written(""), "gravity = \"0 m/s^2\"\n", "")).empty());
  }

  TEST_CASE("a typed mass centre needs the inertia, except where inertia is not included") {
    const std::string own = ", mass = \"3 kg\", S = \"C\"";
    CHECK(first_error(written(own)).starts_with("'links.rod.J' is missing"));
    CHECK(told(written(own + ", J = \"0.01 kg*m^2\"")).issues.empty());
    CHECK(told(written(own) + "analysis = \"static\"\n").issues.empty());
  }

  TEST_CASE("a link that is neither a bar nor a block states where its mass is") {
    CHECK(first_error(replaced(written(", mass = \"3 kg\""), "C = [\"80 mm\"", "C = [\"280 mm\""))
              .starts_with("the point 'C' of 'rod' lies beyond its joints"));
    const std::string pendulum = R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 12 }
ground = { O = ["0 mm", "0 mm"] }
links.arm = { points = { O = ["0 mm", "0 mm"], T = ["100 mm", "0 mm"] }, angle = "0 deg", mass = "1 kg" }
joints.O = { type = "revolute", links = ["ground", "arm"] }
)";
    CHECK(first_error(pendulum) == "link 'arm' has a mass, but its mass centre is missing");
  }
}
