// Output errors from tolerances and clearances.
#include "lib/mechanism/accuracy/tolerance.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using Dimension = Parameter::Dimension;

constexpr double r = 0.1, l = 0.3;
const Output piston{.kind = Output::Kind::x, .index = 2};
const Parameter crank_length{Dimension::point_j_x, 1}, rod_length{Dimension::point_j_x, 2};

double stroke(double crank, double rod, double phi) {
  const double s = crank * std::sin(phi);
  return crank * std::cos(phi) + std::sqrt(rod * rod - s * s);
}

/// Massless but for the load on the piston.
Model light_slider_crank() {
  Model model = slider_crank();
  for (Link& link : model.links) link.mass = link.inertia = 0.0;
  return model;
}

Position at_rest(const Model& model, double coordinate) {
  const Solved s = solve(model, {{coordinate, 0.0, 0.0}});
  REQUIRE(s.status == Status::closed);
  return s.at;
}

OutputError error_of(const Model& model, double coordinate, const Output& output,
                     const std::vector<Tolerance>& tolerances, const std::vector<Clearance>& clearances = {}) {
  const Drive drive{coordinate, 0.0, 0.0};
  return ToleranceAnalysis(model).find(at_rest(model, coordinate), {&drive, 1}, output, tolerances, clearances);
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("tolerances of crank and rod: worst case and root of squares by hand") {
    const double phi = 1.1, t_r = 2e-5, t_l = 5e-5, s = std::sin(phi), root = std::sqrt(l * l - r * r * s * s);
    const double by_r = (std::cos(phi) - r * s * s / root) * t_r, by_l = l / root * t_l;
    const OutputError e = error_of(slider_crank(), phi, piston, {{{{crank_length}}, t_r}, {{{rod_length}}, t_l, 2.0}});
    CHECK(e.status == Status::closed);
    CHECK_FALSE(e.recomputed);
    CHECK(e.curvature < 1e-3);
    CHECK(e.nominal == doctest::Approx(stroke(r, l, phi)).epsilon(1e-13));
    CHECK(e.worst() == doctest::Approx(std::abs(by_r) + by_l).epsilon(1e-12));
    CHECK(e.worst_low == -e.worst_high);
    CHECK(e.deviation == doctest::Approx(std::hypot(by_r / 3.0, by_l / 2.0)).epsilon(1e-12));
    CHECK(e.statistical() == doctest::Approx(3.0 * e.deviation).epsilon(1e-15));
    REQUIRE(e.shares.size() == 2);
    CHECK(e.shares[0] == doctest::Approx(by_r).epsilon(1e-12));
  }

  TEST_CASE("a dimension that moves several numbers is one tolerance, and moves its point along") {
    // The full mechanism is shifted along x: both bearings on the ground, and the piston with them.
    const double t = 1e-4;
    const Tolerance shift{{{{Dimension::point_j_x, 0}}, {{Dimension::point_j_y, 0}, 0.0}}, t};
    const Tolerance doubled{{{{Dimension::point_j_x, 0}, 2.0}}, t};
    const double once = error_of(slider_crank(), 1.1, piston, {shift}).worst();
    CHECK(error_of(slider_crank(), 1.1, piston, {doubled}).worst() == doctest::Approx(2.0 * once).epsilon(1e-12));
    const Output tool{.kind = Output::Kind::y, .index = 2, .point = {0.03, 0.0}};
    const Tolerance own{{}, t, 3.0, Tolerance::Moved{2, {0.03, 0.0}, {0.6, 0.8}}};
    CHECK(error_of(slider_crank(), 1.1, tool, {own}).worst() == doctest::Approx(0.8 * t).epsilon(1e-12));
    CHECK(error_of(slider_crank(), 1.1, piston, {own}).worst() == 0.0);
  }

  TEST_CASE("a load changes the effort by its magnitude, and its point of application by the moment of it") {
    Model model = slider_crank();
    Sensitivity sensitivity(model);
    const Position at = at_rest(model, 1.1);
    REQUIRE(sensitivity.find(at) == Status::closed);
    const auto by = [&](Dimension dimension) {
      return sensitivity.by(sensitivity.find_parameter({dimension, 0})).effort[0];
    };
    for (const auto& [dimension, step] :
         {std::pair(Dimension::load_x, 1.0), std::pair(Dimension::load_y, 1.0), std::pair(Dimension::load_moment, 1.0),
          std::pair(Dimension::load_at_x, 1e-3), std::pair(Dimension::load_at_y, 1e-3)}) {
      Model other = model;
      number(other, {dimension, 0}) += step;
      CHECK(by(dimension) * step ==
            doctest::Approx(at_rest(other, 1.1).effort[0] - at.effort[0]).epsilon(1e-6).scale(std::abs(at.effort[0])));
    }
  }

  TEST_CASE("a mass affects the effort and not the position") {
    const Parameter mass{Dimension::mass, 1};
    const OutputError place = error_of(slider_crank(), 1.1, piston, {{{{mass}}, 0.01}});
    CHECK(place.worst() == 0.0);
    CHECK_FALSE(place.recomputed);
    const Output effort{.kind = Output::Kind::effort};
    CHECK(error_of(slider_crank(), 1.1, effort, {{{{mass}}, 0.01}}).worst() > 0.0);
    CHECK(error_of(slider_crank(), 1.1, effort, {{{{{Dimension::radius_i, 0}}}, 0.01}}).worst() == 0.0);
  }

  TEST_CASE("clearance in the pins of a rod under pressure shortens it") {
    const double phi = 1.1, c = 1e-4, s = std::sin(phi), root = std::sqrt(l * l - r * r * s * s);
    const OutputError e = error_of(light_slider_crank(), phi, piston, {}, {{.joint = 1, .clearance = c}, {2, c}});
    CHECK(e.shift == doctest::Approx(-c * l / root).epsilon(1e-9));
    CHECK(e.worst() == 0.0);
    // Of any direction: the piston goes by the projection on the rod, over the cosine of its angle.
    const Clearance any{2, c, Clearance::Direction::any_direction};
    const OutputError wide = error_of(light_slider_crank(), phi, piston, {}, {any});
    CHECK(wide.shift == 0.0);
    CHECK(wide.worst() == doctest::Approx(0.5 * c * l / root).epsilon(1e-9));
    CHECK(wide.deviation == doctest::Approx(wide.worst() / 3.0).epsilon(1e-12));
  }

  TEST_CASE("a link rests in the clearance of its pin") {
    Model model;
    model.gravity = {0.0, -9.81};
    const int bar = add_bar(model, "bar", {}, 1.0, 2.0);
    pin(model, "O", bar, {}, ground, {});
    drive_turning(model, "motor", bar);
    const Output end{.kind = Output::Kind::y, .index = 0, .point = {1.0, 0.0}};
    CHECK(error_of(model, 0.3, end, {}, {{.joint = 0, .clearance = 2e-4}}).shift ==
          doctest::Approx(-1e-4).epsilon(1e-12));
  }

  TEST_CASE("near a dead point corners are solved again") {
    // The piston drives; its coordinate is x + 0.05, the crank's angle the output.
    const Model model = driven_piston();
    const Output crank{.kind = Output::Kind::phi, .index = 0};
    const double x = 0.3999, t = 4e-5;
    const OutputError e = error_of(model, x + 0.05, crank, {{{{rod_length}}, t}});
    CHECK(e.recomputed);
    CHECK(e.curvature > ToleranceAnalysis::most_curvature);
    const auto angle = [&](double rod) { return std::acos((r * r + x * x - rod * rod) / (2.0 * r * x)); };
    CHECK(e.nominal == doctest::Approx(angle(l)).epsilon(1e-9));
    CHECK(e.worst_high == doctest::Approx(angle(l + t) - angle(l)).epsilon(1e-6));
    CHECK(e.worst_low == doctest::Approx(angle(l - t) - angle(l)).epsilon(1e-6));
    CHECK(e.deviation == doctest::Approx((angle(l + t) - angle(l - t)) / 6.0).epsilon(1e-6));
    // Closer than the tolerance some corners are not a mechanism.
    CHECK(error_of(model, x + 0.05, crank, {{{{rod_length}}, 2e-4}}).status == Status::does_not_close);
  }

  TEST_CASE("with many tolerances near a dead point, the worst corner is found") {
    const Model model = driven_piston();
    const Output crank{.kind = Output::Kind::phi, .index = 0};
    std::vector<Tolerance> tolerances;
    Sensitivity all(model);
    for (const Parameter& parameter : all.parameters()) {
      if (parameter.dimension <= Dimension::point_j_y) tolerances.push_back({{{parameter}}, 6e-6});
    }
    const OutputError e = error_of(model, 0.3999 + 0.05, crank, tolerances);
    CHECK(e.status == Status::closed);
    CHECK(tolerances.size() > ToleranceAnalysis::most_varied);
    double linear = 0.0;
    for (const double share : e.shares) linear += std::abs(share);
    CHECK(e.recomputed);
    CHECK(-e.worst_low > linear);  // towards the dead point it grows faster
    CHECK(e.worst_high < linear);
    CHECK(e.worst_high > 0.7 * linear);
  }

  TEST_CASE("at a dead point the tolerances of the output have no value, and this is reported") {
    Model model = driven_piston();
    Position at = blank_position(model);
    at.pose = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.4, 0.0, 0.0}};
    const Drive drive{0.45, 0.0, 0.0};
    const OutputError e =
        ToleranceAnalysis(model).find(at, {&drive, 1}, piston, std::vector<Tolerance>{{{{rod_length}}, 1e-5}});
    CHECK(e.status == Status::singular);
  }
}
