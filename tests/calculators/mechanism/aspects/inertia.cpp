// Inertia forces and moments of links as results.
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::vector<double>& series(const project::Project& project, const std::string& path) {
  const Value* found = project.value(path);
  CAPTURE(path);
  REQUIRE(found != nullptr);
  return found->si;
}

bool has(const project::Project& project, const std::string& path) {
  const auto& results = project.steps[0]->account().results;
  return std::any_of(results.begin(), results.end(), [&](const auto& entry) { return entry.path == path; });
}

}  // namespace

TEST_SUITE("mechanism inertia of links") {
  TEST_CASE("an unbalanced rotor: m r omega^2 outwards, -J epsilon") {
    const auto rotor = solved(R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "20 rad/s", acceleration = "5 rad/s^2", at = ["0 deg", "90 deg"] }
ground.O = ["0 mm", "0 mm"]
links.rotor = { points = { O = ["0 mm", "0 mm"], S = ["30 mm", "0 mm"] }, angle = "0 deg", mass = "2 kg", J = "0.1 kg*m^2", S = "S" }
joints.O = { links = ["ground", "rotor"] }
)");
    const double r = 0.03, m = 2.0, omega = 20.0, epsilon = 5.0;
    const auto &x = series(rotor, "a.links.rotor.F_ix"), &y = series(rotor, "a.links.rotor.F_iy");
    CHECK(x[0] == doctest::Approx(m * r * omega * omega));
    CHECK(y[0] == doctest::Approx(-m * r * epsilon));
    for (std::size_t k = 0; k < x.size(); ++k) {
      CHECK(series(rotor, "a.links.rotor.F_i")[k] == doctest::Approx(std::hypot(x[k], y[k])));
      CHECK(series(rotor, "a.links.rotor.M_i")[k] == doctest::Approx(-0.1 * epsilon));
      // With no other load the pin carries the inertia force: force of the rotor on the frame, and the other way.
      CHECK(series(rotor, "a.joints.O.x")[k] == doctest::Approx(-x[k]));
      CHECK(series(rotor, "a.joints.O.y")[k] == doctest::Approx(-y[k]));
    }
  }

  TEST_CASE("only links with a mass or an inertia have inertia forces, and only where inertia is included") {
    const std::string text = press_of_heavy_rod;
    const auto press = solved(text);
    CHECK(has(press, "links.rod.F_i"));
    CHECK(has(press, "links.rod.M_i"));
    CHECK_FALSE(has(press, "links.crank.F_i"));
    CHECK_FALSE(has(press, "links.slider.M_i"));
    const auto still = solved(replaced(text, "template =", "analysis = \"static\"\ntemplate ="));
    CHECK_FALSE(has(still, "links.rod.F_i"));
  }

  TEST_CASE("the inertia work of a heavy rod is that of the drive") {
    const auto press = solved(press_of_heavy_rod);
    const auto &M = series(press, "press.drive.M"), &x = series(press, "press.links.rod.F_ix"),
               &y = series(press, "press.links.rod.F_iy"), &moment = series(press, "press.links.rod.M_i"),
               &dphi = series(press, "press.links.rod.dphi"), &dx = series(press, "press.points.S_rod.dx"),
               &dy = series(press, "press.points.S_rod.dy");
    for (std::size_t k = 0; k < M.size(); ++k)
      CHECK(M[k] + x[k] * dx[k] + y[k] * dy[k] + moment[k] * dphi[k] == doctest::Approx(0.0).epsilon(1e-9));
  }
}
