// Limits of a drive against closed forms, and the Jacobian of the group that stops it, which vanishes there.
#include "lib/mechanism/studies/drive_range.hpp"

#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/studies/group_jacobian.hpp"
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using std::numbers::pi;

struct Lengths {
  double crank, coupler, rocker, frame;

  /// The crank angle where coupler and rocker are in line, this far from end to end: law of cosines.
  [[nodiscard]] double crank_at(double apart) const {
    return std::acos((crank * crank + frame * frame - apart * apart) / (2.0 * crank * frame));
  }
};

/// With the rocker's tip to the left of the line from the crank pin to the fixed one.
Model linkage(const Lengths& of, double angle) {
  const Vec a = of.crank * Vec{std::cos(angle), std::sin(angle)}, c{of.frame, 0.0};
  const Vec apart = c - a;
  const double d = length(apart);
  const double along = (d * d + of.coupler * of.coupler - of.rocker * of.rocker) / (2.0 * d);
  const double across = std::sqrt(of.coupler * of.coupler - along * along);
  const Vec b = a + (along / d) * apart + (across / d) * normal(apart);
  Model model;
  const int crank = bar_between(model, "crank", {}, a);
  const int coupler = bar_between(model, "coupler", a, b);
  const int rocker = bar_between(model, "rocker", c, b);
  pin_at(model, "O", crank, ground, {});
  pin_at(model, "A", coupler, crank, a);
  pin_at(model, "B", rocker, coupler, b);
  pin_at(model, "C", rocker, ground, c);
  drive_turning(model, "motor", crank);
  return model;
}

DriveRange range_of(const Model& model) {
  const auto range = drive_range(model, 2.0 * pi, 2.0 * pi);
  REQUIRE(range.has_value());
  return *range;
}

constexpr double exact = 3e-8;  // rad

/// The share of the smallest Jacobian of a group that is left a hair before this coordinate of the drive.
double jacobian_left(const Model& model, double limit, double hair) {
  GroupSystem system(model);
  REQUIRE(system.assemble() == Status::closed);
  GroupJacobians jacobians(model);
  Position at = blank_position(model);
  for (std::size_t k = 0; k < model.links.size(); ++k) at.pose[k] = model.links[k].pose;
  const auto smallest = [&](const std::vector<double>& first) {
    double least = 1.0;
    for (std::size_t g = 0; g < first.size(); ++g) least = std::min(least, jacobians.magnitude(g) / first[g]);
    return least;
  };
  jacobians.take(at.pose);
  std::vector<double> first;
  for (std::size_t g = 0; g < jacobians.plan().groups.size(); ++g) first.push_back(jacobians.magnitude(g));
  const double way = limit - system.coordinate(0);
  const Drive there{limit - std::copysign(hair, way), 0.0, 0.0};
  REQUIRE(system.solve({&there, 1}, at, true) == Status::closed);
  jacobians.take(at.pose);
  return smallest(first);
}

}  // namespace

TEST_SUITE("mechanism range of a drive") {
  TEST_CASE("a crank that can revolve has no limits") {
    const DriveRange range = range_of(four_bar());
    CHECK(std::isinf(range.least));
    CHECK(std::isinf(range.most));
  }

  TEST_CASE("a four-bar that is stopped where coupler and rocker are stretched") {
    const Lengths bars{0.08, 0.06, 0.05, 0.1};
    const double limit = bars.crank_at(0.11);
    for (const double angle : {-0.9, 0.3, 0.9}) {
      const DriveRange range = range_of(linkage(bars, angle));
      CHECK(range.assembled == doctest::Approx(angle));
      CHECK(std::abs(range.most - limit) < exact);
      CHECK(std::abs(range.least + limit) < exact);
    }
  }

  TEST_CASE("a Grashof double rocker: stretched on one side, folded on the other") {
    const Lengths bars{0.04, 0.035, 0.03, 0.04};
    const DriveRange range = range_of(linkage(bars, 0.6));
    CHECK(std::abs(range.most - bars.crank_at(0.065)) < exact);
    CHECK(std::abs(range.least - bars.crank_at(0.005)) < exact);
  }

  TEST_CASE("a crank over the half turn away from the frame: coupler and rocker folded") {
    const Lengths bars{0.1, 0.05, 0.2, 0.12};
    const DriveRange range = range_of(linkage(bars, 2.5));
    CHECK(std::abs(range.least - bars.crank_at(0.15)) < exact);
    CHECK(std::abs(range.most - (2.0 * pi - bars.crank_at(0.15))) < exact);
  }

  TEST_CASE("a rod shorter than the crank: perpendicular to the guide") {
    Model model = slider_crank();
    model.joints[2].point_j = {0.08, 0.0};  // the rod's end, 0.08 m from the crank's pin at 0.1 m
    model.links[0].pose.phi = 0.2;
    model.links[1].pose = {0.098, 0.0199, -0.25};
    model.links[2].pose = {0.175, 0.0, 0.0};
    const DriveRange range = range_of(model);
    CHECK(std::abs(range.most - std::asin(0.8)) < exact);
    CHECK(std::abs(range.least + std::asin(0.8)) < exact);
  }

  TEST_CASE("less than a revolution is searched") {
    const Model model = linkage({0.08, 0.06, 0.05, 0.1}, 0.0);
    const auto range = drive_range(model, 0.5, 2.0);
    REQUIRE(range.has_value());
    CHECK(std::isinf(range->least));
    CHECK(std::isfinite(range->most));
  }

  TEST_CASE("at a limit the Jacobian of a group vanishes with the root of the distance from it") {
    Model six = crank_with_six_link_group();
    for (const Model& model : {linkage({0.08, 0.06, 0.05, 0.1}, 0.3), six}) {
      const DriveRange range = range_of(model);
      for (const double limit : {range.least, range.most}) {
        if (std::isinf(limit)) continue;
        const double near = jacobian_left(model, limit, 1e-5), nearer = jacobian_left(model, limit, 1e-6);
        CHECK(near < 0.05);
        CHECK(nearer / near == doctest::Approx(std::sqrt(0.1)).epsilon(0.05));
      }
    }
    CHECK(std::isfinite(range_of(six).most - range_of(six).least));  // the crank of text D does not turn round
  }
}
