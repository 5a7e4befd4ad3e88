// Cycles in columns against one position after the other: the same bits, for one variant after another.
#include "lib/mechanism/columns/cycle.hpp"

#include "tests/allocations.hpp"
#include "tests/lib/mechanism/cam_models.hpp"
#include "tests/lib/mechanism/models.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace loadpath::mechanism;

constexpr Kept all{.forces = true, .poses = true, .velocities = true, .accelerations = true, .pins = true};

/// A rod that a crank's pin drives through a sleeve that swings: two pinned links that slide in each other.
Model swinging_sleeve() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int crank = models::add_bar(model, "crank", {0.0, 0.0, 1.0}, 0.1, 1.0);
  const double phi = std::atan2(-0.1 * std::sin(1.0), 0.3 - 0.1 * std::cos(1.0));
  const int rod = models::add_bar(model, "rod", {0.1 * std::cos(1.0), 0.1 * std::sin(1.0), phi}, 0.5, 1.5);
  const int sleeve = models::add_link(model, "sleeve", {0.3, 0.0, phi + 0.4}, 0.7, 0.002, {0.01, 0.02});
  models::pin(model, "O", crank, {}, ground, {});
  models::pin(model, "A", rod, {}, crank, {0.1, 0.0});
  models::pin(model, "B", sleeve, {}, ground, {0.3, 0.0});
  models::slide(model, "bush", sleeve, {0.0, 0.0}, rod, {0.0, 0.0}, 0.0, 0.4);
  models::drive_turning(model, "motor", crank);
  models::load(model, "pull", rod, {0.5, 0.0}, {30.0, -40.0}, 2.0);
  model.loads.back().turns_with_link = true;
  return model;
}

/// A slider that a cylinder moves, with a bar to a rocker: a sliding drive.
Model pushed_rocker() {
  Model model;
  model.gravity = {0.0, -9.81};
  const int piston = models::add_link(model, "piston", {0.1, 0.02, 0.0}, 1.0, 0.001, {0.01, 0.005});
  const int bar = models::add_bar(model, "bar", {0.1, 0.02, 0.6}, 0.3, 1.0);
  const int rocker = models::add_bar(model, "rocker", {0.5, 0.0, 2.2}, 0.25, 1.4);
  models::slide(model, "barrel", piston, {}, ground, {0.0, 0.02});
  models::pin(model, "A", bar, {}, piston, {});
  models::pin(model, "B", bar, {0.3, 0.0}, rocker, {0.25, 0.0});
  models::pin(model, "C", rocker, {}, ground, {0.5, 0.0});
  models::drive_sliding(model, "cylinder", 0);
  models::load(model, "weight", rocker, {0.1, 0.03}, {0.0, -50.0});
  return model;
}

/// One position after the other.
struct Alone {
  std::vector<Position> positions;
  std::vector<Status> status;
  Status assembled = Status::closed;
};

Alone alone(const Model& model, std::span<const Drive> drives, std::span<const LoadNow> course = {}) {
  GroupSystem system(model);
  Alone found{.positions = std::vector<Position>(drives.size(), blank_position(model)),
              .status = std::vector<Status>(drives.size(), Status::does_not_close),
              .assembled = system.assemble()};
  bool passes = false;
  for (std::size_t k = 0; k < drives.size(); ++k) {
    if (!course.empty()) system.set_load(0, course[k].force, course[k].moment);
    found.status[k] = system.solve(drives.subspan(k, 1), found.positions[k]);
    const bool there = found.status[k] == Status::closed || found.status[k] == Status::jams;
    if (!there && (passes || found.status[k] != Status::singular)) break;
    passes = !there;
  }
  return found;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool same_bits(const CycleColumns::Frames& a, std::size_t k, const Pose& b) {
  return same_bits(a.x[k], b.x) && same_bits(a.y[k], b.y) && same_bits(a.phi[k], b.phi);
}

bool same_bits(Vec a, Vec b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }
bool same_bits(const Pose& a, const Pose& b) { return same_bits(Vec{a.x, a.y}, {b.x, b.y}) && same_bits(a.phi, b.phi); }
bool same_bits(const Reaction& a, const Reaction& b) {
  return same_bits(a.at, b.at) && same_bits(a.force, b.force) && same_bits(a.couple, b.couple) &&
         same_bits(a.touch, b.touch);
}
bool same_bits(const LoadNow& a, const LoadNow& b) {
  return same_bits(a.force, b.force) && same_bits(a.moment, b.moment);
}

template <class Things>
bool all_same_bits(const Things& one, const Things& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const auto& a, const auto& b) { return same_bits(a, b); });
}

/// How many positions differ in a bit of anything from those that are read off a cycle.
std::size_t differing_as_read(const Model& model, const CycleColumns& columns, const Alone& alone) {
  std::size_t differ = 0;
  Position read = blank_position(model);
  for (std::size_t k = 0; k < alone.positions.size(); ++k) {
    columns.read(k, all, {&read, 1});
    const Position& p = alone.positions[k];
    const bool same = all_same_bits(read.pose, p.pose) && all_same_bits(read.velocity, p.velocity) &&
                      all_same_bits(read.acceleration, p.acceleration) && all_same_bits(read.tendency, p.tendency) &&
                      all_same_bits(read.reactions, p.reactions) && all_same_bits(read.effort, p.effort) &&
                      all_same_bits(read.loads, p.loads);
    differ += same ? 0 : 1;
  }
  return differ;
}

/// How many positions differ in a bit of anything.
std::size_t differing(const Model& model, const CycleColumns& columns, const Alone& alone) {
  std::size_t differ = 0;
  for (std::size_t k = 0; k < alone.positions.size(); ++k) {
    const Position& p = alone.positions[k];
    bool same = columns.status()[k] == alone.status[k];
    const bool moves = alone.status[k] == Status::closed || alone.status[k] == Status::jams;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      if (alone.status[k] != Status::closed) {
        same = same && std::isnan(columns.force(j).x[k]) && std::isnan(columns.couple(j)[k]);
        continue;
      }
      const Reaction& r = p.reactions[j];
      same = same && same_bits(columns.force(j).x[k], r.force.x) && same_bits(columns.force(j).y[k], r.force.y) &&
             same_bits(columns.couple(j)[k], r.couple);
    }
    for (std::size_t d = 0; d < model.drivers.size() && alone.status[k] == Status::closed; ++d)
      same = same && same_bits(columns.effort(d)[k], p.effort[d]);
    for (std::size_t n = 0; n < model.links.size(); ++n) {
      if (!moves) {
        same = same && std::isnan(columns.pose(n).phi[k]) && std::isnan(columns.velocity(n).x[k]);
        continue;
      }
      same = same && same_bits(columns.pose(n), k, p.pose[n]) && same_bits(columns.velocity(n), k, p.velocity[n]) &&
             same_bits(columns.acceleration(n), k, p.acceleration[n]);
    }
    differ += same ? 0 : 1;
  }
  return differ;
}

std::vector<Drive> turn_from(double start, double way, std::size_t positions, double speed) {
  std::vector<Drive> drives;
  for (std::size_t k = 0; k < positions; ++k)
    drives.push_back({start + way * static_cast<double>(k) / static_cast<double>(positions), speed, 0.3 * speed, 1.0});
  return drives;
}

/// Other lengths, masses and loads, by a few percent.
Model varied(Model model, std::mt19937& random) {
  std::uniform_real_distribution<double> about(0.97, 1.03);
  for (Link& link : model.links) {
    link.mass *= about(random);
    link.inertia *= about(random);
    link.centre = about(random) * link.centre;
  }
  for (Joint& joint : model.joints) {
    joint.point_i = about(random) * joint.point_i;
    joint.point_j = about(random) * joint.point_j;
  }
  for (Load& load : model.loads) {
    load.force = about(random) * load.force;
    load.moment *= about(random);
  }
  return model;
}

struct Case {
  const char* name;
  Model model;
  double way;  // of the drive from its position
  double speed;
  bool in_lanes;
};

std::vector<Case> cases() {
  const double turn = 2.0 * std::numbers::pi;
  Model rocker_driven = models::four_bar();
  rocker_driven.drivers[0].i = 2;
  Model crank;
  crank.gravity = {0.0, -9.81};
  models::add_bar(crank, "crank", {0.02, 0.0, 1.0}, 0.1, 1.0);
  models::pin(crank, "O", 0, {0.03, 0.01}, ground,
              {0.02 + 0.03 * std::cos(1.0) - 0.01 * std::sin(1.0), 0.03 * std::sin(1.0) + 0.01 * std::cos(1.0)});
  models::drive_turning(crank, "motor", 0);
  models::load(crank, "tip", 0, {0.1, 0.0}, {3.0, -5.0}, 1.0);
  return {{"crank alone", crank, turn, 5.0, true},
          {"crank alone in long steps", crank, 20.0 * turn, 5.0, false},
          {"slider-crank", models::slider_crank(), turn, 100.0, true},
          {"four-bar", models::four_bar(), -turn, 100.0, true},
          {"six-bar", models::six_bar(), turn, 30.0, true},
          {"chain", models::chain(6), turn, 10.0, true},
          {"slotted lever", models::slotted_lever(), turn, 10.0, true},
          {"slotted lever with slider", models::slotted_lever(true), turn, 10.0, true},
          {"swinging sleeve", swinging_sleeve(), turn, 20.0, true},
          {"pushed rocker", pushed_rocker(), 0.05, 0.4, true},
          {"class III", models::class_three(), turn, 10.0, false},
          {"with friction", models::rubbing_slider_crank(0.1), turn, 10.0, false},
          {"driven by the rocker", rocker_driven, turn, 10.0, false},
          {"cam", models::cam_with_roller(), turn, 10.0, false}};
}

}  // namespace

TEST_SUITE("mechanism in columns") {
  TEST_CASE("a cycle in columns has the bits of single positions, for every variant") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      constexpr std::size_t positions = 77;  // not in full blocks
      std::mt19937 random(7);
      CycleColumns columns(c.model, positions, all);
      std::size_t lanes = 0, closed = 0;
      for (int n = 0; n < 12; ++n) {
        const Model model = n == 0 ? c.model : varied(c.model, random);
        const Status status = columns.take(model);
        if (status == Status::closed) ++closed;
        const std::vector<Drive> drives = turn_from(columns.coordinate(0), c.way, positions, c.speed);
        columns.solve(drives);
        const Alone expected = alone(model, drives);
        CHECK(status == expected.assembled);
        CHECK(differing(model, columns, expected) == 0);
        if (columns.in_lanes()) CHECK(differing_as_read(model, columns, expected) == 0);
        lanes += columns.in_lanes() ? 1 : 0;
      }
      CHECK(closed > 0);
      CHECK((lanes > 0) == c.in_lanes);
    }
  }

  TEST_CASE("solving once more gives the same result, from the assembly on") {
    const Model model = models::four_bar();
    CycleColumns columns(model, 50, all);
    const std::vector<Drive> drives = turn_from(1.0, 3.0, 50, 10.0), others = turn_from(1.2, 4.0, 50, 20.0);
    columns.solve(drives);
    columns.solve(others);
    CHECK(differing(model, columns, alone(model, others)) == 0);
    columns.solve(drives);
    CHECK(differing(model, columns, alone(model, drives)) == 0);
  }

  TEST_CASE("loads that vary over the cycle") {
    for (const Model& model : {models::slider_crank(), models::rubbing_slider_crank(0.05), swinging_sleeve()}) {
      std::vector<LoadNow> course;
      for (int k = 0; k < 40; ++k) course.push_back({{-1000.0 * std::sin(0.2 * k), 20.0 * k}, 0.1 * k});
      CycleColumns columns(model, course.size(), all);
      const std::vector<Drive> drives = turn_from(1.0, 6.2, course.size(), 50.0);
      columns.vary_load(0, course);
      columns.solve(drives);
      CHECK(differing(model, columns, alone(model, drives, course)) == 0);
      if (columns.in_lanes()) CHECK(differing_as_read(model, columns, alone(model, drives, course)) == 0);
    }
  }

  TEST_CASE("an assembly at a change point is reported, whatever state a cycle has left it in") {
    Model model = models::four_bar();
    CycleColumns columns(model, 30, all);
    CHECK(columns.is_regular_at_start());
    columns.solve(turn_from(columns.coordinate(0), 6.2, 30, 10.0));
    CHECK_FALSE(columns.is_regular_at_start());  // it has moved on: there is no assembly to ask about
    CHECK(columns.take(model) == Status::closed);
    CHECK(columns.is_regular_at_start());
    CHECK_FALSE(CycleColumns(models::class_three(), 4).is_regular_at_start());
  }

  TEST_CASE("without inertia, and without the results that are not kept") {
    const Model model = models::six_bar();
    const std::vector<Drive> drives = turn_from(1.0, 6.0, 33, 50.0);
    CycleColumns columns(model, drives.size());
    CHECK(columns.solve(drives, true) == Status::closed);
    CHECK(columns.in_lanes());
    GroupSystem system(model);
    Position at = blank_position(model);
    REQUIRE(system.assemble() == Status::closed);
    for (std::size_t k = 0; k < drives.size(); ++k) {
      REQUIRE(system.solve({&drives[k], 1}, at, true) == Status::closed);
      CHECK(same_bits(columns.effort(0)[k], at.effort[0]));
      CHECK(same_bits(columns.force(6).y[k], at.reactions[6].force.y));
    }
  }

  TEST_CASE("the sides of a cycle agree with the equations of the full system") {
    for (const Case& c : cases()) {
      if (!c.in_lanes) continue;
      CAPTURE(c.name);
      CycleColumns columns(c.model, 60, all);
      const std::vector<Drive> drives = turn_from(columns.coordinate(0), c.way, 60, c.speed);
      REQUIRE(columns.solve(drives) == Status::closed);
      WholeSystem whole(c.model);
      Position at = whole.blank();
      REQUIRE(whole.assemble() == Status::closed);
      double largest = 0.0, apart = 0.0;
      for (std::size_t k = 0; k < drives.size(); ++k) {
        REQUIRE(whole.solve({&drives[k], 1}, at) == Status::closed);
        for (std::size_t j = 0; j < at.reactions.size(); ++j) {
          const Vec force{columns.force(j).x[k], columns.force(j).y[k]};
          largest = std::max(largest, length(at.reactions[j].force));
          apart = std::max(apart, length(force - at.reactions[j].force));
          apart = std::max(apart, std::abs(columns.couple(j)[k] - at.reactions[j].couple));
        }
        apart = std::max(apart, std::abs(columns.effort(0)[k] - at.effort[0]));
        for (std::size_t n = 0; n < at.pose.size(); ++n)
          CHECK(std::abs(columns.pose(n).phi[k] - at.pose[n].phi) < 1e-11);
      }
      CHECK(apart < 1e-11 * largest);
    }
  }

  TEST_CASE("a variant and its cycle allocate nothing") {
    for (const Model& model : {models::slider_crank(), models::six_bar(), models::slotted_lever()}) {
      CycleColumns columns(model, 72, all);
      const std::vector<Drive> drives = turn_from(columns.coordinate(0), 6.2, 72, 10.0);
      std::mt19937 random(3);
      const std::vector<Model> variants{varied(model, random), varied(model, random), model};
      const std::size_t before = loadpath::tests::allocations();
      for (const Model& variant : variants) {
        columns.take(variant);
        columns.solve(drives);
      }
      CHECK(loadpath::tests::allocations() == before);
    }
  }

  TEST_CASE("NaN does not close a loop") {
    const Model model = models::slider_crank();
    CycleColumns columns(model, 20, all);
    std::vector<Drive> drives = turn_from(1.0, 1.0, 20, 10.0);
    drives[12].coordinate = std::numeric_limits<double>::quiet_NaN();
    columns.solve(drives);
    CHECK_FALSE(columns.in_lanes());
    CHECK(columns.status()[11] == Status::closed);
    CHECK(columns.status()[12] != Status::closed);
    CHECK(std::isnan(columns.effort(0)[12]));
  }
}
