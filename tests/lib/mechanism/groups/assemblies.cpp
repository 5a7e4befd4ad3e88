#include "lib/mechanism/groups/assemblies.hpp"

#include "lib/mechanism/groups/closing.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

std::vector<std::string> names(const Assemblies& found) {
  std::vector<std::string> all;
  for (const Assembly& a : found.list) all.push_back(a.name());
  return all;
}

using Names = std::vector<std::string>;

Model at_poses(Model model, const Assembly& assembly) {
  for (std::size_t k = 0; k < model.links.size(); ++k) model.links[k].pose = assembly.poses[k];
  return model;
}

/// Each is closed as it is, on its own, and has the drives at their positions.
void check_closed(const Model& model, const Assemblies& found) {
  WholeSystem stated(model);
  REQUIRE(stated.assemble() == Status::closed);
  for (const Assembly& assembly : found.list) {
    CAPTURE(assembly.name());
    WholeSystem system(at_poses(model, assembly));
    REQUIRE(system.assemble() == Status::closed);
    std::vector<Pose> poses(model.links.size());
    system.store_poses(poses);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      CHECK(std::hypot(poses[k].x - assembly.poses[k].x, poses[k].y - assembly.poses[k].y) <= 1e-9);
      CHECK(std::abs(poses[k].phi - assembly.poses[k].phi) <= 1e-9);
    }
    for (std::size_t d = 0; d < model.drivers.size(); ++d) {
      CHECK(std::cos(system.coordinate(d) - stated.coordinate(d)) == doctest::Approx(1.0));
    }
  }
}

/// The class III group with other lengths, where all six of its assemblies are real.
Model six_fold() {
  Model model = class_three();
  model.links[0].pose = {0.0, 0.0, 0.0};
  model.links[1].pose = {0.064, 0.0, 1.1413};
  model.links[2].pose = {0.293, 0.5001, -0.0013};
  model.links[3].pose = {0.664, 0.09, 1.5244};
  model.links[4].pose = {0.394, 0.29, 1.592};
  model.joints[2].point_j = {0.55, 0.0};  // B of the bar
  model.joints[3].point_i = {0.41, 0.0};  // C
  model.joints[3].point_j = {0.39, 0.0};
  model.joints[4].point_j = {0.664, 0.09};  // D
  model.joints[5].point_i = {0.5, 0.0};     // E
  model.joints[5].point_j = {0.09, 0.29};
  model.joints[6].point_j = {0.394, 0.29};  // F
  return model;
}

/// How often the third bar of the class III group fits, when the first goes once round: counted by sign changes, with
/// the plate on either side of its second bar.
int fits_of_class_three(const Model& model) {
  const auto point = [](const Pose& p, Vec own) { return Vec{p.x, p.y} + turn(p.phi)(own); };
  const Vec a = point(model.links[0].pose, {0.064, 0.0}), d{0.4977, 0.2425}, f{0.1394, -0.0662};
  constexpr int steps = 20000;
  int fits = 0;
  for (const double branch : {1.0, -1.0}) {
    double before = std::nan("");
    for (int k = 0; k <= steps; ++k) {
      const Vec b = a + 0.1824 * turn(2.0 * std::numbers::pi * k / steps)({1.0, 0.0});
      const Vec across = d - b;
      const double distance = length(across);
      const double cosine = (distance * distance + 0.259 * 0.259 - 0.3739 * 0.3739) / (2.0 * distance * 0.259);
      const Turn plate = turn(std::atan2(across.y, across.x) + branch * std::acos(cosine));
      const double open = length(b + plate({0.091, 0.3013}) - f) - 0.369;
      if (open * before < 0.0) ++fits;
      before = open;
    }
  }
  return fits;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a four-bar has two assemblies, as the law of cosines gives them") {
    const Assemblies found = assemblies(four_bar());
    CHECK(names(found) == Names{"B_left", "B_right"});
    CHECK(found.complete);
    CHECK(found.list[0].followed);
    CHECK_FALSE(found.list[1].followed);
    const Vec a = 0.1 * Vec{std::cos(1.0), std::sin(1.0)}, c{0.4, 0.0};
    const double f = length(a - c), cosine = (f * f + 0.3 * 0.3 - 0.35 * 0.35) / (2.0 * f * 0.3);
    const double to_a = std::atan2(a.y, a.x - c.x);
    CHECK(found.list[0].poses[2].phi == doctest::Approx(to_a - std::acos(cosine)));
    CHECK(std::cos(found.list[1].poses[2].phi) == doctest::Approx(std::cos(to_a + std::acos(cosine))));
    check_closed(four_bar(), found);
  }

  TEST_CASE("the piston is ahead of the crank pin or behind it") {
    const Assemblies found = assemblies(slider_crank());
    CHECK(names(found) == Names{"B_ahead", "B_behind"});
    const double root = std::sqrt(0.3 * 0.3 - std::pow(0.1 * std::sin(1.0), 2));
    CHECK(found.list[0].poses[2].x == doctest::Approx(0.1 * std::cos(1.0) + root));
    CHECK(found.list[1].poses[2].x == doctest::Approx(0.1 * std::cos(1.0) - root));
    check_closed(slider_crank(), found);
  }

  TEST_CASE("a slotted lever, also with a slider, reaches its pin forward or backward") {
    CHECK(names(assemblies(slotted_lever())) == Names{"A_ahead", "A_behind"});
    CHECK(names(assemblies(slotted_lever(true))) == Names{"slide_ahead", "slide_behind"});
    check_closed(slotted_lever(true), assemblies(slotted_lever(true)));
    check_closed(slot_on_a_moving_link(false), assemblies(slot_on_a_moving_link(false)));
  }

  TEST_CASE("groups multiply, and assemblies that do not close are left out") {
    CHECK(names(assemblies(six_bar())) ==
          Names{"B_left, D_ahead", "B_left, D_behind", "B_right, D_ahead", "B_right, D_behind"});
    check_closed(six_bar(), assemblies(six_bar()));
    Model high = six_bar();  // the bar does not reach the guide from the lower place of the rocker
    high.joints.back().point_j.y = 0.6;
    high.links[4].pose.y = 0.6;
    CHECK(names(assemblies(high)) == Names{"B_left, D_ahead", "B_left, D_behind"});
  }

  TEST_CASE("the names are unchanged while the mechanism moves, and another start gives the same list") {
    Model model = six_bar();
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    std::vector<Pose> poses(model.links.size());
    for (int k = 1; k <= 24; ++k) {
      const Drive drive{1.0 + k * std::numbers::pi / 12.0, 0.0, 0.0};
      REQUIRE(system.move({&drive, 1}) == Status::closed);
      system.store_poses(poses);
      for (std::size_t n = 0; n < poses.size(); ++n) model.links[n].pose = poses[n];
      CHECK(assemblies(model).list[0].name() == "B_left, D_ahead");
    }
    const Assemblies first = assemblies(six_bar());
    const Assemblies other = assemblies(at_poses(six_bar(), first.list[3]));
    CHECK(other.list[0].name() == "B_right, D_behind");
    CHECK(other.list.size() == first.list.size());
  }

  TEST_CASE("all assemblies of a class III group are found by iteration, as often as its last bar fits") {
    const Model model = class_three();
    const Assemblies found = assemblies(model);
    CHECK_FALSE(found.complete);
    CHECK(found.list[0].followed);
    CHECK(static_cast<int>(found.list.size()) == fits_of_class_three(model));
    CHECK(found.list.size() <= 6);
    CHECK(found.list[0].sides[0].starts_with("bar_"));
    check_closed(model, found);
  }

  TEST_CASE("a class III group with the maximum of six assemblies: all are found, numbered by the first link's angle") {
    const Assemblies found = assemblies(six_fold());
    // The bar's angles where the last bar fits, by going round in small steps as above.
    const double angles[] = {0.0176, 0.0386, 0.3292, 1.1413, 1.6584, 5.1751};
    REQUIRE(found.list.size() == 6);
    CHECK(found.list[0].name() == "bar_4");
    for (const Assembly& assembly : found.list) {
      const double angle = angles[assembly.sides[0].back() - '1'];
      CHECK(std::cos(assembly.poses[1].phi - angle) == doctest::Approx(1.0).epsilon(1e-7));
    }
    check_closed(six_fold(), found);
  }

  TEST_CASE("without a loop there is one assembly; of very many the first are listed, and this is reported") {
    CHECK(names(assemblies(telescope())) == Names{"the only one"});
    CHECK(assemblies(telescope()).complete);
    const Assemblies many = assemblies(chain(8));
    CHECK(many.list.size() == most_assemblies);
    CHECK_FALSE(many.complete);
    CHECK(many.list[0].followed);
  }

  TEST_CASE("a mechanism that does not close has no assembly") {
    Model model = four_bar();
    model.joints.back().point_j.x = 2.0;
    CHECK(assemblies(model).list.empty());
  }

  TEST_CASE("the transmission angle of a four-bar and of a slider-crank by their triangles") {
    const struct {
      Model model;
      double gamma;
    } rows[] = {{four_bar(), std::acos((0.35 * 0.35 + 0.3 * 0.3 - 0.01 - 0.16 + 0.08 * std::cos(1.0)) / 0.21)},
                {slider_crank(), std::acos(0.1 * std::sin(1.0) / 0.3)},
                {slotted_lever(), std::numbers::pi / 2.0},
                {slotted_lever(true), std::numbers::pi / 2.0}};
    for (const auto& row : rows) {
      const Plan plan = plan_of(row.model);
      const auto dyads = dyad_closings(row.model, plan);
      REQUIRE(dyads.size() == 1);
      const auto angle = closing_angle(row.model, dyads[0], assemblies(row.model).list[0].poses);
      CHECK(transmission_angle(angle) == doctest::Approx(row.gamma).epsilon(1e-12));
    }
  }
}
