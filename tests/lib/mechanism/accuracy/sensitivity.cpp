// Derivatives with respect to every dimension and mass: against differences of mechanisms that are solved again, and
// against closed forms.
#include "lib/mechanism/accuracy/sensitivity.hpp"

#include "tests/allocations.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using Dimension = Parameter::Dimension;

std::vector<double> numbers_of(const Position& at) {
  std::vector<double> all;
  for (const auto* poses : {&at.pose, &at.velocity, &at.acceleration}) {
    for (const Pose& p : *poses) all.insert(all.end(), {p.x, p.y, p.phi});
  }
  for (const Reaction& r : at.reactions) all.insert(all.end(), {r.at.x, r.at.y, r.force.x, r.force.y, r.couple});
  all.insert(all.end(), at.effort.begin(), at.effort.end());
  return all;
}

struct Moved {
  Model model;
  std::vector<Drive> drives;
  bool statics = false;
};

Position solved(const Moved& moved) {
  const Solved s = solve(moved.model, moved.drives, moved.statics);
  REQUIRE(s.status == Status::closed);
  return s.at;
}

/// When the parameter is raised by this much.
std::vector<double> numbers_at(Moved moved, const Parameter& parameter, double change) {
  number(moved.model, parameter) += change;
  take_phases(moved.model);
  return numbers_of(solved(moved));
}

std::vector<double> difference_quotients(const Moved& moved, const Parameter& parameter) {
  constexpr double h = 2e-4;
  const auto far_back = numbers_at(moved, parameter, -2.0 * h), back = numbers_at(moved, parameter, -h);
  const auto on = numbers_at(moved, parameter, h), far_on = numbers_at(moved, parameter, 2.0 * h);
  std::vector<double> quotients(on.size());
  for (std::size_t k = 0; k < on.size(); ++k) {
    quotients[k] = (8.0 * (on[k] - back[k]) - (far_on[k] - far_back[k])) / (12.0 * h);
  }
  return quotients;
}

double largest(const std::vector<double>& x) {
  double most = 0.0;
  for (const double v : x) most = std::max(most, std::abs(v));
  return most;
}

void check_all_derivatives(const Moved& moved) {
  const Position at = solved(moved);
  const double scale = largest(numbers_of(at));
  Sensitivity sensitivity(moved.model);
  REQUIRE(sensitivity.find(at, moved.statics) == Status::closed);
  for (std::size_t p = 0; p < sensitivity.parameters().size(); ++p) {
    const Parameter& parameter = sensitivity.parameters()[p];
    CAPTURE(static_cast<int>(parameter.dimension));
    CAPTURE(parameter.index);
    const std::vector<double> exact = numbers_of(sensitivity.by(p)), near = difference_quotients(moved, parameter);
    const double tolerance = 1e-6 * std::max(largest(near), 1e-2 * scale);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      CAPTURE(k);
      CHECK(std::abs(exact[k] - near[k]) <= tolerance);
    }
  }
}

/// A little off the stated assembly, at rest and in motion.
std::vector<Moved> moved(const Model& model) {
  WholeSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  std::vector<Drive> still, moving;
  for (std::size_t k = 0; k < model.drivers.size(); ++k) {
    const double part = model.drivers[k].kind == Driver::Kind::linear ? 0.02 : 0.2;
    still.push_back({system.coordinate(k) + part, 0.0, 0.0});
    moving.push_back({system.coordinate(k) + part, 20.0 * part, 30.0 * part});
  }
  return {{model, still}, {model, moving}, {model, moving, true}};
}

double by(const Sensitivity& sensitivity, Dimension dimension, std::size_t index) {
  return sensitivity.by(sensitivity.find_parameter({dimension, index})).effort[0];
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("sensitivities agree with differences of mechanisms solved again") {
    for (const Model& model :
         {slider_crank(), four_bar(), six_bar(), slotted_lever(), slotted_lever(true), slot_on_a_moving_link(false),
          class_three(), five_bar(), boom(), telescope(), trammel(), driven_piston()}) {
      CAPTURE(model.links.back().name);
      for (const Moved& m : moved(model)) check_all_derivatives(m);
    }
  }

  TEST_CASE("sensitivities with gears, racks, belts, rolling wheels and rigid joints") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      for (const Moved& m : moved(c.model)) check_all_derivatives(m);
    }
  }

  TEST_CASE("sensitivities with friction, including the reactions that depend on it") {
    for (Model model : {slider_crank(), slotted_lever(), four_bar(), cam_with_flat_face(), cam_with_arm()}) {
      CAPTURE(model.links.back().name);
      for (Joint& joint : model.joints) {
        joint.friction = {.coefficient = 0.1, .pin_radius = 0.008, .viscous = 0.3};
        joint.guide_length = 0.08;
        joint.guide_width = 0.05;
      }
      for (const Moved& m : moved(model)) check_all_derivatives(m);
    }
  }

  TEST_CASE("sensitivities with losses of gears and belts") {
    for (Case c : cases()) {
      bool loses = false;
      for (Joint& joint : c.model.joints) {
        const bool passes =
            joint.kind == JointKind::gear || joint.kind == JointKind::rack || joint.kind == JointKind::belt;
        if (passes) joint.friction.loss = joint.friction.loss_back = 0.1;
        loses = loses || passes;
      }
      if (!loses) continue;
      CAPTURE(c.name);
      for (const Moved& m : moved(c.model)) check_all_derivatives(m);
    }
  }

  TEST_CASE("sensitivities with springs and dampers, and to their data") {
    Model model = slider_crank();
    model.springs.push_back({"a", Spring::Kind::linear, 1, ground, {0.1, 0.02}, {0.1, -0.3}, 2000.0, 0.2, 15.0});
    model.springs.push_back({"b", Spring::Kind::linear, 0, 2, {0.05, 0.0}, {0.0, 0.05}, 500.0, 0.1, 0.0});
    model.springs.push_back({"c", Spring::Kind::turning, 0, ground, {}, {}, 3.0, 0.2, 0.05});
    for (const Moved& m : moved(model)) check_all_derivatives(m);
  }

  TEST_CASE("a crank that carries a mass: its moment's derivatives in closed form") {
    Model model;
    model.gravity = {0.0, -9.81};
    const int crank = add_link(model, "crank", {0.0, 0.0, 0.3}, 4.0, 0.2, {0.5, 0.1});
    pin(model, "O", crank, {}, ground, {});
    drive_turning(model, "motor", crank);
    const double phi = 0.7, epsilon = 3.0, m = 4.0, g = 9.81, x = 0.5, y = 0.1;
    const Moved at{model, {{phi, 2.0, epsilon}}};
    Sensitivity sensitivity(model);
    REQUIRE(sensitivity.find(solved(at)) == Status::closed);
    // M = (J + m (x^2 + y^2)) epsilon + m g (x cos phi - y sin phi)
    const double c = std::cos(phi), s = std::sin(phi);
    CHECK(by(sensitivity, Dimension::inertia, 0) == doctest::Approx(epsilon).epsilon(1e-13));
    CHECK(by(sensitivity, Dimension::mass, 0) ==
          doctest::Approx((x * x + y * y) * epsilon + g * (x * c - y * s)).epsilon(1e-13));
    CHECK(by(sensitivity, Dimension::centre_x, 0) == doctest::Approx(2.0 * m * x * epsilon + m * g * c).epsilon(1e-13));
    CHECK(by(sensitivity, Dimension::centre_y, 0) == doctest::Approx(2.0 * m * y * epsilon - m * g * s).epsilon(1e-13));
    CHECK(by(sensitivity, Dimension::offset, 0) == doctest::Approx(m * g * (x * s + y * c)).epsilon(1e-13));
  }

  TEST_CASE("the stroke of a slider-crank by its crank and rod, in closed form") {
    const double r = 0.1, l = 0.3, phi = 1.1, s = std::sin(phi), root = std::sqrt(l * l - r * r * s * s);
    const Moved at{slider_crank(), {{phi, 0.0, 0.0}}};
    Sensitivity sensitivity(at.model);
    REQUIRE(sensitivity.find(solved(at)) == Status::closed);
    const auto piston = [&](Dimension dimension, std::size_t joint) {
      return sensitivity.by(sensitivity.find_parameter({dimension, joint})).pose[2].x;
    };
    CHECK(piston(Dimension::point_j_x, 1) == doctest::Approx(std::cos(phi) - r * s * s / root).epsilon(1e-13));
    CHECK(piston(Dimension::point_j_x, 2) == doctest::Approx(l / root).epsilon(1e-13));
    CHECK(piston(Dimension::offset, 0) == doctest::Approx(r * s + r * r * s * std::cos(phi) / root).epsilon(1e-13));
  }

  TEST_CASE("at a dead point there are no derivatives, and this is reported") {
    Model model = slider_crank();
    model.drivers.clear();
    drive_sliding(model, "cylinder", 3);
    Position at = blank_position(model);
    at.pose = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.4, 0.0, 0.0}};
    Sensitivity sensitivity(model);
    CHECK(sensitivity.find(at) == Status::singular);
  }

  TEST_CASE("sensitivities allocate nothing") {
    for (const Model& model : {six_bar(), gear_train(0.349)}) {
      const Position at = solved(moved(model)[1]);
      Sensitivity sensitivity(model);
      const std::size_t before = loadpath::tests::allocations();
      const Status status = sensitivity.find(at);
      CHECK(loadpath::tests::allocations() == before);
      CHECK(status == Status::closed);
    }
  }
}
