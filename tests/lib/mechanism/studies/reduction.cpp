// The mechanism reduced to its drive, and masses reduced to points.
#include "lib/mechanism/studies/reduction.hpp"

#include "lib/mechanism/groups/system.hpp"
#include "tests/allocations.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

Position solved_by_groups(const Model& model, std::span<const Drive> drives) {
  GroupSystem system(model);
  Position at = blank_position(model);
  REQUIRE(system.assemble() == Status::closed);
  REQUIRE(system.solve(drives, at) == Status::closed);
  return at;
}

std::vector<double> start_of(const Model& model) {
  GroupSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  std::vector<double> start;
  for (std::size_t k = 0; k < model.drivers.size(); ++k) start.push_back(system.coordinate(k));
  return start;
}

/// This driver moves, the others hold still.
std::vector<Drive> drives_of(const std::vector<double>& start, std::size_t driver, double part) {
  std::vector<Drive> drives;
  for (const double s : start) drives.push_back({s, 0.0, 0.0});
  drives[driver] = {start[driver] + part, 3.0, -11.0};
  return drives;
}

double of_all(std::span<const PointMass> masses, auto of) {
  double sum = 0.0;
  for (const PointMass& mass : masses) sum += of(mass);
  return sum;
}

void check_equivalent(const Link& link, std::span<const PointMass> masses) {
  CHECK(of_all(masses, [](const PointMass& m) { return m.mass; }) == doctest::Approx(link.mass).epsilon(1e-13));
  CHECK(std::abs(of_all(masses, [&](const PointMass& m) { return m.mass * (m.at.x - link.centre.x); })) <= 1e-13);
  CHECK(std::abs(of_all(masses, [&](const PointMass& m) { return m.mass * (m.at.y - link.centre.y); })) <= 1e-13);
}

const Link connecting_rod{.name = "rod", .mass = 1.5, .inertia = 0.012, .centre = {0.09, 0.03}, .pose = {}};

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("reduced inertia and moments give the effort of the drive: J epsilon + J' omega^2 / 2 - M") {
    std::vector<Case> all = cases();
    for (const Model& model :
         {slider_crank(), four_bar(), six_bar(), slotted_lever(), slotted_lever(true), slot_on_a_moving_link(false),
          class_three(), five_bar(), boom(), telescope(), trammel(), driven_piston(), chain(3)}) {
      all.push_back({"", model});
    }
    for (const Case& c : all) {
      CAPTURE(c.name);
      CAPTURE(c.model.links.back().name);
      Reduction reduction(c.model);
      const std::vector<double> start = start_of(c.model);
      for (std::size_t d = 0; d < start.size(); ++d) {
        for (const double part : {-0.01, 0.01, 0.03}) {
          const std::vector<Drive> drives = drives_of(start, d, part);
          const Position at = solved_by_groups(c.model, drives);
          const auto reduced = reduction.find(at, d);
          REQUIRE(reduced.has_value());
          CHECK(reduced->effort(drives[d]) == doctest::Approx(at.effort[d]).epsilon(1e-9));
        }
      }
    }
  }

  TEST_CASE("the derivative of the reduced inertia is its slope over the drive") {
    constexpr double h = 1e-3;
    const Model model = six_bar();
    Reduction reduction(model);
    const auto inertia = [&](double phi) {
      const Drive drive{phi, 0.0, 0.0};
      return reduction.find(solved_by_groups(model, {&drive, 1}))->inertia;
    };
    const Drive drive{1.3, 0.0, 0.0};
    const double slope =
        (8.0 * (inertia(1.3 + h) - inertia(1.3 - h)) - inertia(1.3 + 2 * h) + inertia(1.3 - 2 * h)) / (12 * h);
    CHECK(reduction.find(solved_by_groups(model, {&drive, 1}))->derivative == doctest::Approx(slope).epsilon(1e-8));
  }

  TEST_CASE("a friction moment counts together with the reduced quantities") {
    Model model = slider_crank();
    for (Joint& joint : model.joints) joint.friction = {.coefficient = 0.1, .pin_radius = 0.01};
    const std::vector<Drive> drives = drives_of(start_of(model), 0, 0.1);
    const Position at = solved_by_groups(model, drives);
    const auto reduced = Reduction(model).find(at);
    REQUIRE(reduced.has_value());
    CHECK(reduced->induced < 0.0);
    CHECK(reduced->effort(drives[0]) == doctest::Approx(at.effort[0]).epsilon(1e-9));
  }

  TEST_CASE("reducing allocates nothing, and a dead point gives no result") {
    const Model model = driven_piston();
    Reduction reduction(model);
    Position at = solved_by_groups(model, drives_of(start_of(model), 0, 0.01));
    bool found = reduction.find(at).has_value();
    const std::size_t before = loadpath::tests::allocations();
    found = reduction.find(at).has_value() && found;
    CHECK(loadpath::tests::allocations() == before);
    CHECK(found);
    at.pose = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.4, 0.0, 0.0}};
    CHECK_FALSE(reduction.find(at).has_value());
  }

  TEST_CASE("two masses have a link's mass and mass centre, and too little or too much inertia") {
    const auto masses = statically_equivalent(connecting_rod, {}, {0.27, 0.09});
    REQUIRE(masses.has_value());
    check_equivalent(connecting_rod, *masses);
    CHECK((*masses)[1].mass == doctest::Approx(0.5).epsilon(1e-13));
    CHECK(missing_inertia(connecting_rod, *masses) == doctest::Approx(0.012 - 1.5 * 2.0 * 0.009).epsilon(1e-12));
    CHECK_FALSE(statically_equivalent(connecting_rod, {}, {0.3, 0.0}).has_value());
    CHECK_FALSE(statically_equivalent(connecting_rod, {0.1, 0.1}, {0.1, 0.1}).has_value());
  }

  TEST_CASE("three masses in two chosen points and the mass centre have a link's inertia too") {
    const auto masses = dynamically_equivalent(connecting_rod, {}, {0.27, 0.09});
    REQUIRE(masses.has_value());
    check_equivalent(connecting_rod, *masses);
    CHECK(std::abs(missing_inertia(connecting_rod, *masses)) <= 1e-15);
    CHECK_FALSE(dynamically_equivalent(connecting_rod, {0.12, 0.04}, {0.27, 0.09}).has_value());
  }
}
