// Laws of motion as a project gives them: by formulas, by points that are not overshot; and what is wrong with them.
#include "lib/quantity/series.hpp"
#include "tests/lib/project/texts.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string arm = R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", positions = 41, LAW }
ground = { O = ["0 mm", "0 mm"] }
links.arm = { points = { O = ["0 mm", "0 mm"], T = ["100 mm", "0 mm"] }, angle = "30 deg", mass = "1 kg", J = "0.02 kg*m^2", S = "O" }
joints.O = { type = "revolute", links = ["ground", "arm"] }
)";
const std::string ram = R"([a]
calculator = "mechanism.planar"
ground = { O = ["0 mm", "0 mm"] }
links.ram = { points = { P = ["0 mm", "0 mm"] }, mass = "4 kg", angle = "0 deg", origin = ["10 mm", "0 mm"] }
joints.G = { type = "prismatic", links = ["ram", "ground"], points = ["P", "O"] }
cylinders.c = { joint = "G", LAW }
positions = 21
)";

std::string by(std::string text, const std::string& law) { return text.replace(text.find("LAW"), 3, law); }

bool says(const std::string& text, const std::string& message) {
  const std::string said = issues_of(text);
  INFO(said);
  return said.find(message + "\n") != std::string::npos;
}

}  // namespace

TEST_SUITE("mechanism law") {
  TEST_CASE("an arm that swings by a formula: angle, speed, acceleration and moment at every time") {
    const auto project = solved(by(arm, "angle_of_t = \"30 deg + 90 deg*sin(2*pi*t/(2 s))\", duration = \"2 s\""));
    const Value& phi = *project.value("a.links.arm.phi");
    const Value& omega = *project.value("a.links.arm.omega");
    const Value& M = *project.value("a.drive.M");
    REQUIRE(phi.si.size() == 41);
    for (std::size_t k = 0; k < phi.si.size(); ++k) {
      const double t = 2.0 * static_cast<double>(k) / 40.0, a = pi / 2.0;
      CHECK(phi.signature.axis->at[k] == doctest::Approx(t));
      CHECK(phi.si[k] == doctest::Approx(pi / 6.0 + a * std::sin(pi * t)));
      CHECK(omega.si[k] == doctest::Approx(a * pi * std::cos(pi * t)).scale(1.0));
      CHECK(M.si[k] == doctest::Approx(-0.02 * a * pi * pi * std::sin(pi * t)).scale(1.0));
    }
  }

  TEST_CASE("where a law reverses, friction acts either way, and the moment is a range around that without it") {
    std::string text = by(arm, "angle_of_t = \"90 deg*sin(2*pi*t/(2 s))\", duration = \"2 s\"");
    const std::string pin = "links = [\"ground\", \"arm\"]";
    text.replace(text.find(pin), pin.size(), pin + ", mu = 0.1, pin_radius = \"10 mm\"");
    const auto project =
        solved("project.title = \"a\"\n" + text + "[[a.loads]]\nlink = \"arm\"\nat = \"O\"\nF_x = \"50 N\"\n");
    const Value& M = *project.value("a.drive.M");
    const Value& least = *project.value("a.drive.M_min");
    const Value& most = *project.value("a.drive.M_max");
    for (std::size_t k = 0; k < M.si.size(); ++k) {
      CAPTURE(k);
      const double t = 2.0 * static_cast<double>(k) / 40.0;
      const double without = -0.02 * pi / 2.0 * pi * pi * std::sin(pi * t), friction = 0.1 * 0.01 * 50.0;
      const bool turns = k == 10 || k == 30;
      const double sense = turns ? 0.0 : std::cos(pi * t) > 0.0 ? 1.0 : -1.0;
      CHECK(M.si[k] == doctest::Approx(without + sense * friction).scale(1.0));
      CHECK(most.si[k] - least.si[k] == doctest::Approx(turns ? 2.0 * friction : 0.0).scale(1.0));
    }
  }

  TEST_CASE("a cylinder by a formula") {
    const auto project = solved(by(ram, "place_of_t = \"10 mm + 40 mm*(1 - cos(pi*t/(1 s)))/2\", duration = \"1 s\""));
    const Value& F = *project.value("a.cylinders.c.F");
    for (std::size_t k = 0; k < F.si.size(); ++k)
      CHECK(F.si[k] == doctest::Approx(4.0 * 0.02 * pi * pi * std::cos(pi * static_cast<double>(k) / 20.0)).scale(1.0));
  }

  TEST_CASE("a law that overshoots its points gives a warning, and a monotone one does not") {
    const std::string points = "law = [[\"0 s\", \"0 deg\"], [\"1 s\", \"90 deg\"], [\"2 s\", \"90 deg\"]]";
    CHECK(says(by(arm, points), "warning: the law swings beyond its points: to 100° at 1.333 s, which is 10° too far"));
    const auto calm = solved(by(arm, points + ", law_shape = \"monotone\""));
    CHECK(maximum(*calm.value("a.links.arm.phi")).value == doctest::Approx(pi / 2.0).epsilon(1e-9));
  }

  TEST_CASE("errors in a formula") {
    const auto crank = [](const std::string& law) { return by(arm, law); };
    CHECK(says(crank("angle_of_t = \"30 deg*t\", duration = \"1 s\""),
               "error: the law gives the kind 'quantity in s*rad', and 'angle' is expected"));
    CHECK(says(crank("angle_of_t = \"30 deg + x\", duration = \"1 s\""), "error: 'x' is not a variable"));
    CHECK(says(crank("angle_of_t = \"30 deg*abs(t/(1 s))\", duration = \"1 s\""),
               "error: 'abs' has kinks, or uses a series"));
    CHECK(says(crank("angle_of_t = \"30 deg*sqrt(t/(1 s))\", duration = \"1 s\""),
               "error: the law has no position, speed or acceleration at t = 0 s"));
    CHECK(says(crank("angle_of_t = \"30 deg/s*t\""), "error: a law by a formula needs the time for which it holds"));
    CHECK(says(crank("duration = \"1 s\", speed = \"1 rad/s\""),
               "error: 'duration' belongs to a formula, and 'angle_of_t' is missing"));
    CHECK(says(crank("angle_of_t = \"30 deg/s*t\", duration = \"1 s\", speed = \"1 rad/s\""),
               "error: 'crank.speed' and 'crank.angle_of_t' both define the motion of the crank"));
    CHECK(says(crank("angle_of_t = \"30 deg/s*t\", duration = \"1 s\", impending = \"forward\""),
               "error: 'impending' belongs to a drive at rest, and this one follows a law"));
    CHECK(says(crank("law_shape = \"monotone\", speed = \"1 rad/s\""),
               "error: 'law_shape' belongs to a law by points, and there is none"));
    CHECK(says(by(ram, "place_of_t = \"30 deg\", duration = \"1 s\""),
               "error: the law gives the kind 'angle', and 'length' is expected"));
    CHECK(says(crank("angle_of_t = 3, duration = \"1 s\""), "error: a formula is expected, not a number"));
  }
}
