// Rigid joints, gears, racks, belts and rolling wheels: both solvers, against closed forms and against invariants of
// every mechanism.
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "tests/lib/mechanism/models.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using std::numbers::pi;

/// The drives `t` seconds after the stated assembly, each with its own speed and acceleration.
std::vector<Drive> drives_at(const std::vector<double>& start, double t) {
  std::vector<Drive> drives;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double speed = 2.0 + static_cast<double>(k), acceleration = 1.5 - static_cast<double>(k);
    drives.push_back({start[k] + (speed + 0.5 * acceleration * t) * t, speed + acceleration * t, acceleration});
  }
  return drives;
}

template <class System>
struct Run {
  explicit Run(const Model& of) : model(of), system(of), at(blank_position(of)) {
    REQUIRE(system.assemble() == Status::closed);
    for (std::size_t k = 0; k < model.drivers.size(); ++k) start.push_back(system.coordinate(k));
  }
  const Position& operator()(double t) {
    drives = drives_at(start, t);
    REQUIRE(system.solve(drives, at) == Status::closed);
    return at;
  }
  const Model& model;
  System system;
  Position at;
  std::vector<double> start;
  std::vector<Drive> drives;
};

double largest_force(const Position& at) {
  double most = 0.0;
  for (const Reaction& r : at.reactions) most = std::max(most, length(r.force));
  return most;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("every joint type: the groups and the full system agree") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      CHECK(diagnose(c.model).empty());
      Run<GroupSystem> groups(c.model);
      Run<WholeSystem> whole(c.model);
      for (int k = 0; k < 40; ++k) {
        CAPTURE(k);
        const Position &a = groups(0.05 * k), &b = whole(0.05 * k);
        const double size = largest_force(b);
        for (std::size_t j = 0; j < a.reactions.size(); ++j) {
          CAPTURE(c.model.joints[j].name);
          CHECK(length(a.reactions[j].force - b.reactions[j].force) <= 1e-10 * size);
          CHECK(std::abs(a.reactions[j].couple - b.reactions[j].couple) <= 1e-10 * size);
        }
        for (std::size_t d = 0; d < a.effort.size(); ++d) CHECK(std::abs(a.effort[d] - b.effort[d]) <= 1e-10 * size);
        for (std::size_t l = 0; l < a.pose.size(); ++l) CHECK(std::abs(a.pose[l].phi - b.pose[l].phi) <= 1e-10);
      }
    }
  }

  TEST_CASE("every joint type: links in equilibrium, power in balance") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      Run<GroupSystem> run(c.model);
      for (int k = 0; k < 40; ++k) {
        const Position& at = run(0.05 * k);
        const Residuals left = residuals(c.model, run.drives, false, at);
        CHECK(left.force <= 1e-12 * largest_force(at));
        CHECK(left.moment <= 1e-12 * largest_force(at));
        CHECK(std::abs(left.power) <= 1e-11 * left.power_scale);
      }
    }
  }

  TEST_CASE("every joint type: all proofs agree, over many revolutions") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      Run<GroupSystem> run(c.model);
      Prover prover(c.model);
      for (int k = 0; k < 20; ++k) {
        const Position& at = run(0.37 * k);
        check_trustworthy(prover.prove(run.drives, false, at));
      }
    }
  }

  TEST_CASE("every joint type: velocities and accelerations are derivatives of the positions") {
    constexpr double h = 1e-3;
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      Run<GroupSystem> run(c.model);
      for (int k = 1; k < 20; ++k) {
        const double t = 0.1 * k;
        const Position p[] = {run(t - 2 * h), run(t - h), run(t), run(t + h), run(t + 2 * h)};
        for (std::size_t l = 0; l < c.model.links.size(); ++l) {
          CAPTURE(c.model.links[l].name);
          const auto phi = [&](int s) { return p[s].pose[l].phi; };
          const auto omega = [&](int s) { return p[s].velocity[l].phi; };
          const double speed = (phi(0) - 8 * phi(1) + 8 * phi(3) - phi(4)) / (12 * h);
          const double acceleration = (omega(0) - 8 * omega(1) + 8 * omega(3) - omega(4)) / (12 * h);
          CHECK(std::abs(speed - omega(2)) <= 1e-7 * (1.0 + std::abs(speed)));
          CHECK(std::abs(acceleration - p[2].acceleration[l].phi) <= 1e-6 * (1.0 + std::abs(acceleration)));
        }
      }
    }
  }

  TEST_CASE("a gear turns by the ratio of the radii, and its teeth push apart") {
    Run<GroupSystem> run(gear_train(0.349));
    const Position& at = run(0.7);
    CHECK(at.velocity[0].phi == doctest::Approx(-2.5 * at.velocity[1].phi).epsilon(1e-13));
    const Reaction& tooth = at.reactions.back();
    CHECK(tooth.at.x == doctest::Approx(0.02).epsilon(1e-12));
    CHECK(tooth.force.x == doctest::Approx(-std::tan(0.349) * std::abs(tooth.force.y)).epsilon(1e-12));
    CHECK(at.effort[0] == doctest::Approx(0.01 * at.acceleration[0].phi - 0.02 * tooth.force.y).epsilon(1e-12));
  }

  TEST_CASE("a planetary gear obeys Willis and balances its moments") {
    Run<GroupSystem> run(planetary());
    for (const double t : {0.0, 2.0, 5.0}) {
      const Position& at = run(t);
      const double sun = at.velocity[0].phi, arm = at.velocity[1].phi, planet = at.velocity[2].phi;
      CHECK(sun - arm == doctest::Approx(-2.5 * (0.0 - arm)).epsilon(1e-12));
      CHECK(planet - arm == doctest::Approx(-0.02 / 0.015 * (sun - arm)).epsilon(1e-12));
    }
    Model light = planetary();
    for (Link& link : light.links) link.mass = link.inertia = 0.0;
    Run<GroupSystem> statics(light);
    CHECK(statics(1.0).effort[0] == doctest::Approx(10.0 / 3.5).epsilon(1e-12));
  }

  TEST_CASE("gears keep their assembly over many revolutions and long moves") {
    for (const Model& model : {planetary(), gear_train()}) {
      GroupSystem small(model), large(model);
      REQUIRE(small.assemble() == Status::closed);
      REQUIRE(large.assemble() == Status::closed);
      Position a = blank_position(model), b = a;
      const double start = small.coordinate(0);
      for (int k = 1; k <= 400; ++k) {
        const Drive drive{start + 0.1 * k, 1.0, 0.0};
        REQUIRE(small.solve({&drive, 1}, a) == Status::closed);
      }
      const Drive far{start + 40.0, 1.0, 0.0};
      REQUIRE(large.solve({&far, 1}, b) == Status::closed);
      for (std::size_t l = 0; l < a.pose.size(); ++l)
        CHECK(a.pose[l].phi == doctest::Approx(b.pose[l].phi).epsilon(1e-10));
    }
  }

  TEST_CASE("a rolling wheel keeps its distance and turns as far as it rolls") {
    Run<GroupSystem> run(rolling_wheel());
    const Pose from = run(0.0).pose[2];
    for (const double t : {0.4, 0.9, 1.7}) {
      const Pose to = run(t).pose[2];
      CHECK(to.y == doctest::Approx(0.05).epsilon(1e-13));
      CHECK(to.x - from.x == doctest::Approx(-0.05 * (to.phi - from.phi)).epsilon(1e-12));
    }
  }

  TEST_CASE("an open belt turns in the same direction, a crossed one in the other, and it only pulls") {
    for (const bool crossed : {false, true}) {
      CAPTURE(crossed);
      for (const double moment : {-3.0, 3.0}) {
        Model model = belt_on_rocker(crossed, 25.0);
        for (Link& link : model.links) link.mass = link.inertia = 0.0;
        model.gravity = {};
        model.loads.back().moment = moment;
        Run<GroupSystem> run(model);
        const Position& at = run(0.3);
        const double ratio = (at.velocity[4].phi - at.velocity[2].phi) / (at.velocity[3].phi - at.velocity[2].phi);
        CHECK(ratio == doctest::Approx(crossed ? -0.04 / 0.06 : 0.04 / 0.06).epsilon(1e-12));
        CHECK(std::abs(at.effort[1]) == doctest::Approx(3.0 * 0.04 / 0.06).epsilon(1e-12));
        // Both spans: 25 N in the slack one, 3 N m / 60 mm more in the other, along the line of centres.
        const double along = dot(at.reactions.back().force, turn(at.pose[2].phi)({1.0, 0.0}));
        const double cosine = std::sqrt(1.0 - std::pow((crossed ? 0.1 : 0.02) / 0.3, 2));
        CHECK(along == doctest::Approx((25.0 + 25.0 + 50.0) * cosine).epsilon(1e-11));
      }
    }
  }

  TEST_CASE("a rigid joint transmits the internal couple of the same link in one piece") {
    Model whole = four_bar();
    const Model pieces = welded_four_bar();
    const Link& end = pieces.links[3];
    Link& coupler = whole.links[1];
    const Vec from_weld = turn(0.4)(end.centre) + Vec{0.25, 0.0};
    const double mass = coupler.mass + end.mass;
    const Vec centre = (1.0 / mass) * (coupler.mass * coupler.centre + end.mass * from_weld);
    const auto steiner = [&](const Link& link, Vec at) {
      return link.inertia + link.mass * dot(at - centre, at - centre);
    };
    coupler = {"coupler", mass, steiner(coupler, coupler.centre) + steiner(end, from_weld), centre, coupler.pose};
    load(whole, "tip", 1, turn(0.4)({0.1, 0.0}) + Vec{0.25, 0.0}, {30.0, -70.0});
    Run<GroupSystem> one(whole), two(pieces);
    for (const double t : {0.1, 0.8, 1.6}) {
      CHECK(one(t).effort[0] == doctest::Approx(two(t).effort[0]).epsilon(1e-11));
      CHECK(std::abs(two.at.reactions.back().couple) > 0.1);
    }
  }

  TEST_CASE("a joint is open by as much as its points are apart") {
    const Model model = four_bar();
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    Constraints constraints(model);
    Position at = blank_position(model);
    const Drive drive{system.coordinate(0), 0.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == Status::closed);
    std::vector<double> q;
    for (const Pose& pose : at.pose) q.insert(q.end(), {pose.x, pose.y, pose.phi});
    q.resize(constraints.columns() + 3, 0.0);
    q[3] += 0.003, q[4] += 0.004;  // the coupler off its place
    constraints.place(q, {&drive.coordinate, 1});
    const double wanted[] = {0.0, 0.005, 0.005, 0.0};
    for (std::size_t joint = 0; joint < 4; ++joint) CHECK(std::abs(constraints.opening(joint) - wanted[joint]) < 1e-12);
  }
}
