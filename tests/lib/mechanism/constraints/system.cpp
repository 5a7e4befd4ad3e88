#include "lib/mechanism/constraints/system.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

constexpr double turn_of_crank = 2.0 * std::numbers::pi;

double largest_force(const Position& at) {
  double most = 0.0;
  for (const auto& reaction : at.reactions) most = std::max(most, length(reaction.force));
  return most;
}

// Invariants of a mechanism under a change of its axes and of its units.
void check_same_forces(const Position& a, const Position& b, double angle, double force_factor, double moment_factor) {
  const Turn back = turn(-angle);
  const double size = largest_force(a);
  for (std::size_t k = 0; k < a.reactions.size(); ++k) {
    const Vec force = force_factor * back(b.reactions[k].force);
    CHECK(length(force - a.reactions[k].force) <= 1e-12 * size);
    CHECK(std::abs(moment_factor * b.reactions[k].couple - a.reactions[k].couple) <= 1e-12 * size);
  }
  for (std::size_t k = 0; k < a.effort.size(); ++k) {
    CHECK(moment_factor * b.effort[k] == doctest::Approx(a.effort[k]).epsilon(1e-12));
  }
}

// The same mechanism turned by `angle` and then shifted; its joints to the ground have the ground as j.
Model moved(Model model, double angle, Vec shift) {
  const Turn turned = turn(angle);
  for (auto& link : model.links) {
    const Vec origin = turned({link.pose.x, link.pose.y}) + shift;
    link.pose = {origin.x, origin.y, link.pose.phi + angle};
  }
  for (auto& joint : model.joints) {
    if (joint.j != ground) continue;
    joint.point_j = turned(joint.point_j) + shift;
    joint.direction += angle;
    joint.angle += angle;
  }
  for (auto& load : model.loads) load.force = turned(load.force);
  model.gravity = turned(model.gravity);
  return model;
}

// Lengths in mm with kg and s: forces then are in mN, moments in 1e-6 N m.
Model in_millimetres(Model model) {
  for (auto& link : model.links) {
    link.inertia *= 1e6;
    link.centre = 1e3 * link.centre;
    link.pose.x *= 1e3;
    link.pose.y *= 1e3;
  }
  for (auto& joint : model.joints) {
    joint.point_i = 1e3 * joint.point_i;
    joint.point_j = 1e3 * joint.point_j;
  }
  for (auto& load : model.loads) {
    load.point = 1e3 * load.point;
    load.force = 1e3 * load.force;
    load.moment *= 1e6;
  }
  model.gravity = 1e3 * model.gravity;
  return model;
}

struct Cycle {
  const char* name;
  Model model;
};

std::vector<Cycle> cycles() {
  return {{"slider-crank", slider_crank()},
          {"four-bar", four_bar()},
          {"six-bar", six_bar()},
          {"slotted lever", slotted_lever()},
          {"slotted lever with slider", slotted_lever(true)}};
}

// Calls `check(position, drive)` at each of 72 positions of a turn from the stated crank angle.
template <class Check>
void around(const Model& model, double speed, double acceleration, Check check, bool statics = false) {
  WholeSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  Position at = system.blank();
  const double start = system.coordinate(0);
  for (int k = 0; k <= 72; ++k) {
    const Drive drive{start + turn_of_crank * k / 72.0, speed, acceleration};
    REQUIRE(system.solve({&drive, 1}, at, statics) == Status::closed);
    check(at, drive);
  }
}

std::vector<Position> positions(const Model& model, double speed, double acceleration, bool statics = false) {
  std::vector<Position> all;
  around(
      model, speed, acceleration, [&](const Position& at, const Drive&) { all.push_back(at); }, statics);
  return all;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the driving moments of three known linkages are met to the last printed digit") {
    const struct {
      Model model;
      double moment;
    } rows[] = {{slider_crank(), 23.7794793480}, {four_bar(), 71.6014357492}, {six_bar(), 159.0068606345}};
    for (const auto& row : rows) {
      const Solved solved = solve(row.model, {{1.0, 100.0, 0.0}});
      REQUIRE(solved.status == Status::closed);
      CHECK(std::abs(solved.at.effort[0] - row.moment) < 1e-10);
    }
  }

  TEST_CASE("every link is in equilibrium and the power balances over a cycle") {
    for (const auto& cycle : cycles()) {
      const Model& model = cycle.model;
      CAPTURE(cycle.name);
      around(model, 100.0, 500.0, [&](const Position& at, const Drive& drive) {
        const Residuals left = residuals(model, {&drive, 1}, false, at);
        CHECK(left.force <= 1e-12 * largest_force(at));
        CHECK(left.moment <= 1e-12 * largest_force(at));
        CHECK(std::abs(left.power) <= 1e-12 * left.power_scale);
      });
    }
  }

  TEST_CASE("velocities and accelerations are the derivatives of the positions") {
    constexpr double h = 1e-4;
    for (const auto& cycle : cycles()) {
      const Model& model = cycle.model;
      CAPTURE(cycle.name);
      WholeSystem system(model);
      REQUIRE(system.assemble() == Status::closed);
      std::array<Position, 3> at{system.blank(), system.blank(), system.blank()};
      const double start = system.coordinate(0);
      for (int k = -1; k <= 1; ++k) {
        const Drive drive{start + k * h, 1.0, 0.0};
        REQUIRE(system.solve({&drive, 1}, at[static_cast<std::size_t>(k + 1)]) == Status::closed);
      }
      for (std::size_t link = 0; link < model.links.size(); ++link) {
        const auto& [before, now, after] = at;
        const double omega = (after.pose[link].phi - before.pose[link].phi) / (2.0 * h);
        const double epsilon = (after.pose[link].phi - 2.0 * now.pose[link].phi + before.pose[link].phi) / (h * h);
        CHECK(now.velocity[link].phi == doctest::Approx(omega).epsilon(1e-6));
        CHECK(now.acceleration[link].phi == doctest::Approx(epsilon).epsilon(1e-5));
      }
    }
  }

  TEST_CASE("a full revolution leads back to the start, with continuous angles") {
    for (const auto& cycle : cycles()) {
      const Model& model = cycle.model;
      CAPTURE(cycle.name);
      const auto all = positions(model, 10.0, 0.0);
      CHECK(all.back().pose[0].phi - all.front().pose[0].phi == doctest::Approx(turn_of_crank).epsilon(1e-14));
      CHECK(std::abs(all.back().pose[1].phi - all.front().pose[1].phi) <= 1e-12);
      CHECK(all.back().effort[0] == doctest::Approx(all.front().effort[0]).epsilon(1e-11));
    }
  }

  TEST_CASE("one long move ends in the same assembly as many short ones") {
    for (const auto& cycle : cycles()) {
      const Model& model = cycle.model;
      CAPTURE(cycle.name);
      const auto short_moves = positions(model, 10.0, 0.0);
      WholeSystem system(model);
      REQUIRE(system.assemble() == Status::closed);
      Position at = system.blank();
      const Drive drive{system.coordinate(0) + 3.0 * turn_of_crank + turn_of_crank * 50.0 / 72.0, 10.0, 0.0};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      CHECK(at.effort[0] == doctest::Approx(short_moves[50].effort[0]).epsilon(1e-11));
    }
  }

  TEST_CASE("reactions superpose like loads") {
    Model only_first = six_bar();
    load(only_first, "second", 2, {0.1, 0.05}, {30.0, -70.0}, 4.0);
    Model only_second = only_first;
    Model neither = only_first;
    const Model both = only_first;
    only_first.loads.pop_back();
    only_second.loads.erase(only_second.loads.begin());
    neither.loads.clear();
    const Drive drive{1.3, 80.0, 200.0};
    const auto effort = [&](const Model& model) { return solve(model, {drive}).at.effort[0]; };
    CHECK(effort(both) == doctest::Approx(effort(only_first) + effort(only_second) - effort(neither)).epsilon(1e-12));
  }

  TEST_CASE("a load that is changed between positions acts as if it had been given") {
    WholeSystem system(six_bar());
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    const Drive drive{1.3, 80.0, 0.0};
    system.set_load(0, {-400.0, 30.0}, 2.0);
    REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
    Model model = six_bar();
    model.loads[0].force = {-400.0, 30.0};
    model.loads[0].moment = 2.0;
    CHECK(at.effort[0] == doctest::Approx(solve(model, {drive}).at.effort[0]).epsilon(1e-13));
    CHECK(residuals(model, {&drive, 1}, false, at).moment <= 1e-12 * largest_force(at));
  }

  TEST_CASE("forces do not depend on where the axes are") {
    const Drive drive{1.3, 80.0, 200.0};
    const Solved here = solve(six_bar(), {drive});
    const double angle = 0.7;
    const Solved there = solve(moved(six_bar(), angle, {3.0, -2.0}), {{drive.coordinate + angle, 80.0, 200.0}});
    REQUIRE(there.status == Status::closed);
    check_same_forces(here.at, there.at, angle, 1.0, 1.0);
  }

  TEST_CASE("forces do not depend on the unit of length") {
    for (const auto& model : {slider_crank(), four_bar(), six_bar(), slotted_lever()}) {
      WholeSystem metres(model);
      REQUIRE(metres.assemble() == Status::closed);
      const Drive drive{metres.coordinate(0) + 0.3, 80.0, 200.0};
      const Solved here = solve(model, {drive});
      const Solved there = solve(in_millimetres(model), {drive});
      REQUIRE(there.status == Status::closed);
      check_same_forces(here.at, there.at, 0.0, 1e-3, 1e-6);
      CHECK(there.at.pose[1].x == doctest::Approx(1e3 * here.at.pose[1].x).epsilon(1e-12));
    }
  }

  TEST_CASE("statics is the mechanism at rest") {
    for (const auto& cycle : cycles()) {
      const Model& model = cycle.model;
      CAPTURE(cycle.name);
      const auto at_rest = positions(model, 0.0, 0.0);
      const auto statics = positions(model, 30.0, 100.0, true);
      for (std::size_t k = 0; k < statics.size(); ++k) {
        check_same_forces(at_rest[k], statics[k], 0.0, 1.0, 1.0);
      }
    }
  }

  TEST_CASE("running backwards at constant speed leaves the forces unchanged") {
    const auto forwards = positions(six_bar(), 40.0, 0.0);
    const auto backwards = positions(six_bar(), -40.0, 0.0);
    for (std::size_t k = 0; k < forwards.size(); ++k) {
      check_same_forces(forwards[k], backwards[k], 0.0, 1.0, 1.0);
    }
  }

  TEST_CASE("a frame without drivers is solved at its one position") {
    Model frame;
    const int left = add_link(frame, "left", {0.0, 0.0, 0.9});
    const int right = add_link(frame, "right", {2.0, 0.0, 2.2});
    pin(frame, "A", left, {}, ground, {});
    pin(frame, "B", right, {}, ground, {2.0, 0.0});
    pin(frame, "C", left, {std::sqrt(2.0), 0.0}, right, {std::sqrt(2.0), 0.0});
    load(frame, "P", left, {std::sqrt(2.0), 0.0}, {0.0, -100.0});
    const Solved solved = solve(frame, {});
    REQUIRE(solved.status == Status::closed);
    CHECK(solved.at.reactions[0].force.x == doctest::Approx(50.0).epsilon(1e-13));
    CHECK(solved.at.reactions[0].force.y == doctest::Approx(50.0).epsilon(1e-13));
    CHECK(solved.at.reactions[1].force.x == doctest::Approx(-50.0).epsilon(1e-13));
  }

  TEST_CASE("lengths that cannot close are reported with a joint of the loop") {
    Model model = four_bar();
    model.joints[1].point_j.x = 0.8;
    WholeSystem system(model);
    CHECK(system.assemble() == Status::does_not_close);
    CHECK(system.gap().joint >= 0);
    CHECK(system.gap().size > 1e-3);
    CHECK(system.gap().size < 0.5);
  }

  TEST_CASE("a driven rocker stops where the linkage stretches, and the solver stays where it was") {
    Model model = four_bar();
    model.drivers[0].i = 2;
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    const Drive start{system.coordinate(0), 1.0, 0.0};
    REQUIRE(system.solve({&start, 1}, at) == Status::closed);
    const double before = at.effort[0];
    const Drive beyond{0.5, 1.0, 0.0};
    CHECK(system.solve({&beyond, 1}, at) == Status::does_not_close);
    CHECK(at.effort[0] == before);
    CHECK(system.coordinate(0) == start.coordinate);
    // Crank and coupler in one line: a triangle with the sides 0.35 -+ 0.1, 0.3 and 0.4 m.
    const double inner = std::acos((0.3 * 0.3 + 0.4 * 0.4 - 0.45 * 0.45) / (2.0 * 0.3 * 0.4));
    const double outer = std::acos((0.3 * 0.3 + 0.4 * 0.4 - 0.25 * 0.25) / (2.0 * 0.3 * 0.4));
    const double limit = start.coordinate + system.gap().reached * (beyond.coordinate - start.coordinate);
    const double error =
        std::min(std::abs(limit - (std::numbers::pi - inner)), std::abs(limit - (std::numbers::pi - outer)));
    CHECK(error < 1e-7);
    CHECK(system.gap().joint >= 0);
    CHECK(system.gap().size > 0.01);
    REQUIRE(system.solve({&start, 1}, at) == Status::closed);
    CHECK(at.effort[0] == doctest::Approx(before).epsilon(1e-12));
  }

  TEST_CASE("a dead point is singular, whether the assembly starts there or a move ends there") {
    Model model = slider_crank();
    model.drivers.clear();
    drive_sliding(model, "cylinder", 3);
    SUBCASE("assembled there") {
      model.links[0].pose = {0.0, 0.0, 0.0};
      model.links[1].pose = {0.1, 0.0, 0.0};
      model.links[2].pose = {0.4, 0.0, 0.0};
      WholeSystem system(model);
      CHECK(system.assemble() == Status::singular);
    }
    SUBCASE("moved there") {
      WholeSystem system(model);
      REQUIRE(system.assemble() == Status::closed);
      Position at = system.blank();
      const Drive dead{0.4, 1.0, 0.0};
      CHECK(system.solve({&dead, 1}, at) == Status::singular);
      const Drive back{0.34, 1.0, 0.0};
      REQUIRE(system.solve({&back, 1}, at) == Status::closed);
      CHECK(std::isfinite(at.effort[0]));
    }
  }

  TEST_CASE("the condition number falls towards a dead point") {
    Model model = slider_crank();
    model.drivers.clear();
    drive_sliding(model, "cylinder", 3);
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    const double far = system.condition();
    const Drive near{0.4 - 1e-8, 0.0, 0.0};
    REQUIRE(system.move({&near, 1}) == Status::closed);
    CHECK(far > 1e-3);
    CHECK(system.condition() < 1e-3 * far);
  }
}
