// Shaking forces and counterweights.
#include "lib/mechanism/studies/shaking.hpp"

#include "lib/mechanism/groups/system.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

std::vector<Position> turn_of(const Model& model, int positions = 72) {
  GroupSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  std::vector<Position> cycle(static_cast<std::size_t>(positions), blank_position(model));
  for (int k = 0; k < positions; ++k) {
    const Drive drive{system.coordinate(0) + 2.0 * std::numbers::pi / positions, 50.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, cycle[static_cast<std::size_t>(k)]) == Status::closed);
  }
  return cycle;
}

Model with_counterweights(const Model& model, const std::vector<Counterweight>& weights, double radius) {
  Model balanced = model;
  for (const Counterweight& weight : weights) {
    Link& link = balanced.links[weight.site.link];
    link = with_counterweight(link, weight, radius);
  }
  return balanced;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the frame carries the reactions of the bearings, except for weights and loads") {
    Model model = four_bar();
    model.gravity = {};
    model.loads.clear();
    const Vec about{0.1, -0.2};
    for (const Position& at : turn_of(model, 12)) {
      Vec force;
      double moment = -at.effort[0];
      for (const std::size_t k : {0U, 3U}) {
        force = force - at.reactions[k].force;
        moment -= cross(at.reactions[k].at - about, at.reactions[k].force);
      }
      const Shaking found = shaking(model, at, about);
      CHECK(length(found.force - force) <= 1e-10 * length(force));
      CHECK(found.moment == doctest::Approx(moment).epsilon(1e-10));
    }
    CHECK(shaking(four_bar(), turn_of(four_bar(), 1)[0], about).moment ==
          doctest::Approx(shaking(model, turn_of(model, 1)[0], about).moment).epsilon(1e-12));
  }

  TEST_CASE("the rotating part of a slider-crank is balanced exactly") {
    Model model = slider_crank();
    model.links[0].centre = {0.04, 0.02};
    model.links[1].mass = model.links[1].inertia = model.links[2].mass = 0.0;
    const std::vector<Position> cycle = turn_of(model);
    for (const BalanceAim aim : {BalanceAim::rms, BalanceAim::peak}) {
      const auto weights = find_counterweights(model, cycle, std::vector<CounterweightSite>{{0, {}}}, aim);
      REQUIRE(weights.size() == 1);
      CHECK(weights[0].mass_moment.x == doctest::Approx(-0.04).epsilon(1e-12));
      CHECK(weights[0].mass_moment.y == doctest::Approx(-0.02).epsilon(1e-12));
      CHECK(weights[0].mass_at(0.1) == doctest::Approx(std::hypot(0.4, 0.2)).epsilon(1e-12));
      const ShakingCycle before = shaking_over(model, cycle, {});
      const ShakingCycle after = shaking_over(with_counterweights(model, weights, 0.1), cycle, {});
      CHECK(after.peak_force <= 1e-12 * before.peak_force);
      CHECK(before.rms_force == doctest::Approx(before.peak_force).epsilon(1e-12));
    }
  }

  TEST_CASE("in a stated direction a counterweight balances the component in it") {
    Model model = slider_crank();
    model.links[0].centre = {0.04, 0.02};
    model.links[1].mass = model.links[1].inertia = model.links[2].mass = 0.0;
    const std::vector<Position> cycle = turn_of(model);
    const double along = 0.7, m = model.links[0].mass;
    const auto weights =
        find_counterweights(model, cycle, std::vector<CounterweightSite>{{.link = 0, .pivot = {}, .direction = along}});
    const Vec e{std::cos(along), std::sin(along)};
    const double part = -m * dot(Vec{0.04, 0.02}, e);
    CHECK(weights[0].mass_moment.x == doctest::Approx(part * e.x).epsilon(1e-12));
    CHECK(weights[0].mass_moment.y == doctest::Approx(part * e.y).epsilon(1e-12));
    const ShakingCycle after = shaking_over(with_counterweights(model, weights, 0.1), cycle, {});
    CHECK(after.rms_force == doctest::Approx(m * std::abs(cross(Vec{0.04, 0.02}, e)) * 2500.0).epsilon(1e-9));
  }

  // R. S. Berkof, G. G. Lowen: the coupler's mass moment, divided between its pins, is balanced at crank and rocker.
  TEST_CASE("counterweights on crank and rocker balance all of a four-bar's shaking force") {
    Model model = four_bar();
    model.links[1].centre = {0.15, 0.04};
    const std::vector<Position> cycle = turn_of(model);
    const std::vector<CounterweightSite> sites{{0, {}}, {2, {}}};
    const auto weights = find_counterweights(model, cycle, sites);
    const ShakingCycle before = shaking_over(model, cycle, {});
    const ShakingCycle after = shaking_over(with_counterweights(model, weights, 0.08), cycle, {});
    CHECK(after.peak_force <= 1e-12 * before.peak_force);
    CHECK(after.peak_moment > 0.0);
    // By hand: with the coupler's centre at c = (x + i y) l from A, m (1 - c) goes with the crank's pin, m c with the
    // rocker's, turned by the angles between the links' axes and the arms.
    const double l = 0.35, m = 1.5, x = 0.15 / l, y = 0.04 / l;
    CHECK(weights[0].mass_moment.x == doctest::Approx(-1.0 * 0.05 - m * (1.0 - x) * 0.1).epsilon(1e-10));
    CHECK(weights[0].mass_moment.y == doctest::Approx(m * y * 0.1).epsilon(1e-10));
    CHECK(weights[1].mass_moment.x == doctest::Approx(-1.2 * 0.15 - m * x * 0.3).epsilon(1e-10));
    CHECK(weights[1].mass_moment.y == doctest::Approx(-m * y * 0.3).epsilon(1e-10));
  }

  TEST_CASE("a site about a point that is not the link's origin, and one that moves with a stated mass") {
    Model model = four_bar();
    const std::vector<Position> cycle = turn_of(model);
    const std::vector<CounterweightSite> sites{{0, {}}, {1, {0.35, 0.0}, 0.4}, {2, {}}};
    const auto weights = find_counterweights(model, cycle, sites);
    const ShakingCycle after = shaking_over(with_counterweights(model, weights, 0.08), cycle, {});
    CHECK(after.peak_force <= 1e-11 * shaking_over(model, cycle, {}).peak_force);
  }

  TEST_CASE("one counterweight on the crank: the smallest rms, and a smaller peak when that is requested") {
    const Model model = slider_crank();
    const std::vector<Position> cycle = turn_of(model);
    const std::vector<CounterweightSite> site{{0, {}}};
    const auto rms = find_counterweights(model, cycle, site);
    const auto peak = find_counterweights(model, cycle, site, BalanceAim::peak);
    const auto left = [&](const Counterweight& weight) {
      return shaking_over(with_counterweights(model, std::vector{weight}, 0.1), cycle, {});
    };
    const ShakingCycle before = shaking_over(model, cycle, {});
    CHECK(left(rms[0]).rms_force < before.rms_force);
    CHECK(left(rms[0]).rms_force < left(peak[0]).rms_force);
    CHECK(left(peak[0]).peak_force < left(rms[0]).peak_force);
    for (const Vec off : {Vec{1e-3, 0.0}, Vec{-1e-3, 0.0}, Vec{0.0, 1e-3}, Vec{0.0, -1e-3}}) {
      Counterweight other = rms[0], another = peak[0];
      other.mass_moment = other.mass_moment + off;
      another.mass_moment = another.mass_moment + off;
      CHECK(left(other).rms_force > left(rms[0]).rms_force);
      CHECK(left(another).peak_force > (1.0 - 1e-9) * left(peak[0]).peak_force);
    }
  }
}
