#include "calculators/mechanism/pictures/plans.hpp"

#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/pictures/animation.hpp"
#include "lib/draw/canvas/typeset.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace loadpath;
using namespace loadpath::planar;
namespace models = loadpath::mechanism::models;
using mechanism::length;
using mechanism::Vec;

namespace {

/// A rocker on a spring with a damper, and a turning one: they belong to the plans as loads do.
mechanism::Model sprung() {
  mechanism::Model model = models::four_bar();
  using Kind = mechanism::Spring::Kind;
  model.springs.push_back({"spring", Kind::linear, 2, mechanism::ground, {0.15, 0.0}, {0.6, 0.2}, 2e3, 0.1, 50.0});
  model.springs.push_back({"bush", Kind::turning, 1, 2, {}, {}, 8.0, 0.0, 0.3});
  return model;
}

/// Every model at positions over its revolution, at a speed with significant inertia.
void at_positions(const std::function<void(const PlanSubject&)>& check) {
  const std::vector<TracedPoint> points{{"A", 0, {0.1, 0.0}}};
  for (const mechanism::Model& model : {models::slider_crank(), models::four_bar(), models::six_bar(),
                                        models::class_three(), models::slotted_lever(), sprung()}) {
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    const double start = system.coordinate(0);
    mechanism::Position at = system.blank();
    for (int k = 0; k < 12; ++k) {
      const mechanism::Drive drive{start + 0.1 * k, 30.0, 50.0};
      if (system.solve({&drive, 1}, at, false) != mechanism::Status::closed) break;
      CAPTURE(model.links[1].name);
      CAPTURE(k);
      check({model, points, at, false});
    }
  }
}

double side(const figure::Plan::Vector& v) { return std::hypot(v.to.x - v.from.x, v.to.y - v.from.y); }

/// The moments of the drawn forces about the pole and of the couples at their angular velocities, over their
/// magnitudes.
double left_on_lever(const PlanSubject& subject) {
  double sum = 0.0, magnitudes = 0.0;
  const auto add = [&](double moment) { sum += moment, magnitudes += std::abs(moment); };
  for (const auto& f : zhukovsky_lever(subject).forces) add(f.at.x * f.force.y - f.at.y * f.force.x);
  for (std::size_t k = 0; k < subject.model.links.size(); ++k) {
    for (const ActingForce& acting : external_forces(subject.model, subject.at, static_cast<int>(k), subject.statics))
      add(acting.couple * subject.at.velocity[k].phi);
  }
  return std::abs(sum) / magnitudes;
}

figure::Point last_of(const figure::Plan& plan) {
  return plan.vectors.empty() ? figure::Point{} : plan.vectors.back().to;
}

}  // namespace

TEST_SUITE("mechanism plans") {
  TEST_CASE("the forces on every link form a closed polygon") {
    at_positions([](const PlanSubject& subject) {
      for (std::size_t k = 0; k < subject.model.links.size(); ++k) {
        const figure::Plan plan = force_plan(subject, static_cast<int>(k));
        double largest = 0.0;
        for (const auto& v : plan.vectors) largest = std::max(largest, side(v));
        const figure::Point end = last_of(plan);
        CHECK(std::hypot(end.x, end.y) <= 1e-9 * largest);
      }
    });
  }

  TEST_CASE("the sides of a force plan are the loads, the weight, the inertia and the joint forces by name") {
    const mechanism::Model model = models::slider_crank();
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    mechanism::Position at = system.blank();
    const mechanism::Drive drive{1.0, 30.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == mechanism::Status::closed);
    std::vector<std::string> names;
    for (const ActingForce& a : acting_on(model, at, 2, false)) names.push_back(a.label);
    REQUIRE(names.size() == 5);
    CHECK(names[0] == "gas");
    CHECK(names[1] == "G_piston");
    CHECK(names[3] == "R_B");
    CHECK(names[4] == "R_guide");
    CHECK(acting_on(model, at, 2, true).size() == 4);  // without inertia
    const auto on_piston = acting_on(model, at, 2, false), on_rod = acting_on(model, at, 1, false);
    const auto named = [](const auto& all, const char* name) {
      return *std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.label == name; });
    };
    CHECK(named(on_piston, "R_B").sense == -named(on_rod, "R_B").sense);
    CHECK(length(named(on_piston, "R_B").force + named(on_rod, "R_B").force) == 0.0);
  }

  TEST_CASE("the velocity image of a link is similar to it, scaled by its angular velocity and turned by 90 deg") {
    const mechanism::Model model = models::class_three();
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    mechanism::Position at = system.blank();
    const mechanism::Drive drive{system.coordinate(0), 20.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == mechanism::Status::closed);
    const figure::Plan plan = velocity_plan({model, {{"B", 2, {}}}, at, false});
    const auto& image = plan.images[2].points;  // points of the plate: B, C, E
    const Vec own[] = {{}, {0.259, 0.0}, {0.091, 0.3013}};
    REQUIRE(image.size() == 3);
    const double omega = at.velocity[2].phi;
    for (std::size_t n = 1; n < 3; ++n) {
      const Vec expected = omega * mechanism::normal(mechanism::turn(at.pose[2].phi)(own[n]));
      CHECK(image[n].x - image[0].x == doctest::Approx(expected.x).epsilon(1e-12));
      CHECK(image[n].y - image[0].y == doctest::Approx(expected.y).epsilon(1e-12));
    }
  }

  TEST_CASE("no two points of a plan have the same label, nor that of the pole") {
    const mechanism::Model model = models::slider_crank();
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    mechanism::Position at = system.blank();
    const mechanism::Drive drive{1.0, 30.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == mechanism::Status::closed);
    const std::vector<TracedPoint> points{
        {"P", 0, {0.1, 0.0}}, {"p", 0, {0.2, 0.0}}, {"A", 0, {0.3, 0.0}}, {"P_a", 0, {0.4, 0.0}}};
    const auto names = [](const figure::Plan& plan) {
      std::vector<std::string> all;
      for (const auto& p : plan.points) all.push_back(draw::plain(p.name));
      return all;
    };
    CHECK(names(velocity_plan({model, points, at, false})) == std::vector<std::string>{"p", "p′", "p′′", "a", "p_a′"});
    CHECK(names(acceleration_plan({model, points, at, false})) ==
          std::vector<std::string>{"p_a", "p′", "p′′", "a", "p_a′"});
  }

  TEST_CASE("the components of an acceleration lead from the image of one point to that of the other") {
    at_positions([](const PlanSubject& subject) {
      const figure::Plan plan = acceleration_plan(subject);
      for (std::size_t n = 0; n + 1 < plan.vectors.size(); ++n) {
        const auto &first = plan.vectors[n], &second = plan.vectors[n + 1];
        const bool pair =
            first.label.ends_with("_n") && second.label == first.label.substr(0, first.label.size() - 1) + "t";
        if (!pair) continue;
        CHECK(first.to.x == second.from.x);
        const double across = (first.to.x - first.from.x) * (second.to.x - second.from.x) +
                              (first.to.y - first.from.y) * (second.to.y - second.from.y);
        CHECK(std::abs(across) <= 1e-9 * side(first) * side(second));
      }
    });
  }

  TEST_CASE("where a pin slides, its acceleration is that of the slot, Coriolis and the relative one along the slot") {
    const mechanism::Model model = models::slotted_lever();
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    mechanism::Position at = system.blank();
    const mechanism::Drive drive{system.coordinate(0), 45.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == mechanism::Status::closed);
    const figure::Plan plan = acceleration_plan({model, {{"A", 0, {0.03, 0.0}}}, at, false});
    const auto relative = std::find_if(plan.vectors.begin(), plan.vectors.end(),
                                       [](const auto& v) { return v.label.starts_with("a_r_"); });
    REQUIRE(relative != plan.vectors.end());
    const double slot = at.pose[1].phi;
    const double off =
        -std::sin(slot) * (relative->to.x - relative->from.x) + std::cos(slot) * (relative->to.y - relative->from.y);
    CHECK(std::abs(off) <= 1e-9 * side(*relative));
  }

  TEST_CASE("the moments on Zhukovsky's lever sum to zero with the effort of the drive, and with no other") {
    at_positions([](const PlanSubject& subject) {
      CHECK(left_on_lever(subject) <= 1e-9);
      mechanism::Position wrong = subject.at;
      wrong.effort[0] *= 1.01;
      if (std::abs(subject.at.effort[0]) > 1.0)
        CHECK(left_on_lever({subject.model, subject.points, wrong, false}) > 1e-4);
    });
  }

  TEST_CASE("a lever is the velocity plan rotated clockwise by a right angle") {
    at_positions([](const PlanSubject& subject) {
      const figure::Plan velocities = velocity_plan(subject), lever = zhukovsky_lever(subject);
      REQUIRE(velocities.points.size() == lever.points.size());
      for (std::size_t n = 0; n < lever.points.size(); ++n) {
        CHECK(lever.points[n].at.x == velocities.points[n].at.y);
        CHECK(lever.points[n].at.y == -velocities.points[n].at.x);
      }
    });
  }

  TEST_CASE("frames are the closed positions, thinned where there are many, with the governing one") {
    Cycle cycle;
    cycle.positions.resize(1000);
    cycle.closed.assign(1000, true);
    cycle.jams.assign(1000, false);
    cycle.undirected = cycle.jams;
    for (std::size_t k = 0; k < 100; ++k) cycle.closed[k] = false;
    const auto all = frames_of(cycle, 501, 2000);
    CHECK(all.size() == 900);
    CHECK(all.front() == 100);
    const auto some = frames_of(cycle, 500, 300);
    CHECK(some.size() == 301);
    CHECK(std::count(some.begin(), some.end(), 500U) == 1);
    CHECK(std::is_sorted(some.begin(), some.end()));
  }
}
