#include "lib/mechanism/structure/structure.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using About = Finding::About;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Cranks of 0.2 m side by side, their tips on one coupler.
Model parallel_cranks(int count, double angle) {
  Model model;
  const Vec tip = turn(angle)({0.2, 0.0});
  const int coupler = add_link(model, "coupler", {tip.x, tip.y, 0.0}, 1.0);
  for (int k = 0; k < count; ++k) {
    const std::string name = std::to_string(k + 1);
    const Vec foot{0.3 * k, 0.0};
    const int crank = add_link(model, "crank" + name, {foot.x, foot.y, angle});
    pin(model, "O" + name, crank, {}, ground, foot);
    pin(model, "A" + name, coupler, foot, crank, {0.2, 0.0});
  }
  drive_turning(model, "motor", 1);
  return model;
}

struct Row {
  const char* what;
  std::function<void(Model&)> spoil;
  About about;
  std::size_t index;
  std::string message;
};

std::string only_message(const std::vector<Finding>& findings) {
  return findings.size() == 1 ? findings[0].message.text() : std::to_string(findings.size()) + " findings";
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("sound mechanisms give no findings") {
    for (const auto& model : {slider_crank(), four_bar(), six_bar(), slotted_lever(), slotted_lever(true)}) {
      CHECK(diagnose(model).empty());
    }
  }

  TEST_CASE("a faulty part is named with its error") {
    const Row rows[] = {
        {"mass", [](Model& m) { m.links[1].mass = -1.5; }, About::link, 1,
         "link 'rod': mass -1.5 kg: must be finite and not negative"},
        {"inertia", [](Model& m) { m.links[0].inertia = not_a_number; }, About::link, 0,
         "link 'crank': moment of inertia not available: must be finite and not negative"},
        {"inertia without mass", [](Model& m) { m.links[1].mass = 0.0; }, About::link, 1,
         "link 'rod' is not on a fixed pin and has a moment of inertia, but no mass"},
        {"pose", [](Model& m) { m.links[2].pose.x = not_a_number; }, About::link, 2,
         "link 'piston': its mass centre or its pose is not a finite number"},
        {"lone link", [](Model& m) { add_link(m, "spare", {}); }, About::link, 3, "link 'spare' has no joint"},
        {"joint with itself", [](Model& m) { m.joints[1].j = 1; }, About::joint, 1,
         "joint 'A' connects 'rod' with itself"},
        {"joint at nothing", [](Model& m) { m.joints[2].j = 7; }, About::joint, 2,
         "joint 'B' is at a link that does not exist"},
        {"joint not finite", [](Model& m) { m.joints[3].direction = not_a_number; }, About::joint, 3,
         "joint 'guide': a point or an angle of it is not a finite number"},
        {"driver with itself", [](Model& m) { m.drivers[0].j = 0; }, About::driver, 0,
         "driver 'motor' turns 'crank' against itself"},
        {"driver at nothing", [](Model& m) { m.drivers[0].i = 9; }, About::driver, 0,
         "driver 'motor' is at a link that does not exist"},
        {"driver against a guide", [](Model& m) { m.drivers[0].i = 2; }, About::driver, 0,
         "driver 'motor' turns 'piston' against 'ground', but the prismatic joint 'guide' holds that angle"},
        {"linear driver in a pin",
         [](Model& m) {
           m.drivers.clear();
           drive_sliding(m, "oil", 1);
         },
         About::driver, 0, "driver 'oil' is linear, but joint 'A' is revolute"},
        {"linear driver nowhere",
         [](Model& m) {
           m.drivers.clear();
           drive_sliding(m, "oil", -1);
         },
         About::driver, 0, "driver 'oil' is linear and names no joint"},
        {"driver offset", [](Model& m) { m.drivers[0].offset = not_a_number; }, About::driver, 0,
         "driver 'motor': its offset is not a finite number"},
        {"two drivers", [](Model& m) { drive_turning(m, "second", ground, 0); }, About::driver, 1,
         "drivers 'motor' and 'second' drive the same joint"},
        {"load on the ground", [](Model& m) { m.loads[0].link = ground; }, About::load, 0,
         "load 'gas' acts on no link"},
        {"load not finite", [](Model& m) { m.loads[0].force.x = not_a_number; }, About::load, 0,
         "load 'gas': its point, force or moment is not a finite number"},
        {"friction", [](Model& m) { m.joints[1].friction.coefficient = -0.1; }, About::joint, 1,
         "joint 'A': its friction and the sizes for it must be finite and not negative"},
        {"wheel without a radius", [](Model& m) { m.joints[1].kind = JointKind::gear; }, About::joint, 1,
         "joint 'A' has a wheel without a radius"},
        {"wheel not finite",
         [](Model& m) {
           m.joints[1].kind = JointKind::rack;
           m.joints[1].radius_i = not_a_number;
         },
         About::joint, 1, "joint 'A': a number of its wheels is not finite"},
        {"wheel that fills its ring",
         [](Model& m) {
           m.joints[1].kind = JointKind::rolling;
           m.joints[1].radius_i = 0.05;
           m.joints[1].radius_j = -0.05;
         },
         About::joint, 1, "joint 'A': a wheel fills its ring, and cannot roll in it"},
        {"spring at one link",
         [](Model& m) {
           m.springs.push_back({"k", Spring::Kind::linear, 1, 1, {}, {}, 1.0, 0.0, 0.0});
         },
         About::spring, 0, "spring 'k' does not act between two links"},
        {"spring that pushes",
         [](Model& m) {
           m.springs.push_back({"k", Spring::Kind::linear, 1, 0, {}, {}, -1.0, 0.0, 0.0});
         },
         About::spring, 0, "spring 'k': its rate and damping must be finite and not negative"},
        {"gravity", [](Model& m) { m.gravity.y = not_a_number; }, About::model, 0,
         "the gravity is not a finite number"},
    };
    for (const auto& row : rows) {
      CAPTURE(row.what);
      Model model = slider_crank();
      row.spoil(model);
      const auto findings = diagnose(model);
      CHECK(only_message(findings) == row.message);
      if (findings.size() != 1) continue;
      CHECK(findings[0].about == row.about);
      CHECK(findings[0].index == row.index);
    }
  }

  TEST_CASE("a model without links has nothing to solve") {
    CHECK(only_message(diagnose({})) == "the mechanism has no links");
  }

  TEST_CASE("all errors of the parts are found at once") {
    Model model = slider_crank();
    model.links[0].mass = -1.0;
    model.joints[1].j = 1;
    model.loads[0].link = ground;
    CHECK(diagnose(model).size() == 3);
  }

  TEST_CASE("a part that is connected in itself but not to the ground is named") {
    Model model = slider_crank();
    const int a = add_link(model, "left", {1.0, 1.0, 0.0});
    const int b = add_link(model, "right", {1.0, 1.0, 0.5});
    pin(model, "loose", a, {}, b, {});
    const auto findings = diagnose(model);
    CHECK(only_message(findings) == "no joint connects 'left', 'right' with the ground");
    CHECK(findings[0].index == 3);
  }

  TEST_CASE("mobility by count and by rank agree for a sound mechanism") {
    const Structure structure = analyse(six_bar());
    CHECK(structure.mobility_by_count == 1);
    CHECK(structure.mobility == 1);
    CHECK(structure.closes);
    CHECK(structure.loose.empty());
    CHECK(structure.redundant.empty());
  }

  TEST_CASE("a missing driver is reported with the links that can still move") {
    Model model = slider_crank();
    model.drivers.clear();
    const auto findings = diagnose(model);
    CHECK(only_message(findings) == "mobility 1, number of drives 0");
    CHECK(findings[0].hint.text() == "add a drive or a joint: 'crank', 'rod', 'piston' can still move");
  }

  TEST_CASE("a link that turns idly is the only one that can still move") {
    Model model = four_bar();
    const int roller = add_link(model, "roller", {0.33, 0.29, 0.0}, 0.1, 1e-4);
    pin(model, "R", roller, {}, 2, {0.3, 0.0});
    const auto findings = diagnose(model);
    CHECK(only_message(findings) == "mobility 2, number of drives 1");
    CHECK(findings[0].hint.text() == "add a drive or a joint: 'roller' can still move");
  }

  TEST_CASE("a driver too many is reported") {
    Model model = four_bar();
    drive_turning(model, "second", 2);
    const auto findings = diagnose(model);
    CHECK(only_message(findings) == "mobility 1, number of drives 2");
    CHECK(findings[0].hint.text() == "remove a drive: 'motor', 'second'");
  }

  TEST_CASE("two drivers on one degree of freedom leave the other one free") {
    Model model = four_bar();
    drive_turning(model, "second", 2);
    const int roller = add_link(model, "roller", {0.33, 0.29, 0.0}, 0.1, 1e-4);
    pin(model, "R", roller, {}, 2, {0.3, 0.0});
    CHECK(only_message(diagnose(model)) == "the drivers 'motor', 'second' do not hold 'roller' at the stated position");
  }

  TEST_CASE("three parallel cranks: the set of joints is named, not one of them") {
    const Model model = parallel_cranks(3, 1.1);
    const Structure structure = analyse(model);
    REQUIRE(structure.redundant.size() == 1);
    CHECK(names_of(model.joints, structure.redundant[0]) == "'O1', 'A1', 'O2', 'A2', 'O3', 'A3'");
    CHECK(diagnose(model).empty());  // released.cpp
    CHECK(structure.mobility_by_count == 0);
    CHECK(structure.mobility == 1);
    CHECK_FALSE(structure.singular);
  }

  TEST_CASE("redundancies in separate places are separate sets") {
    Model model = parallel_cranks(3, 1.1);
    const int bar = add_link(model, "bar", {2.0, 0.0, 0.0});
    pin(model, "P", bar, {}, ground, {2.0, 0.0});
    pin(model, "Q", bar, {0.5, 0.0}, ground, {2.5, 0.0});
    const Structure structure = analyse(model);
    REQUIRE(structure.redundant.size() == 2);
    CHECK(structure.redundant[0].size() == 6);
    CHECK(structure.redundant[1] == std::vector<std::size_t>{6, 7});
  }

  TEST_CASE("a change point is singular, not redundant") {
    const auto findings = diagnose(parallel_cranks(2, 0.0));
    CHECK(only_message(findings) ==
          "the stated position is singular: 'coupler', 'crank2' can move in more than one direction");
    CHECK(diagnose(parallel_cranks(2, 0.1)).empty());
  }

  TEST_CASE("a frame with only infinitesimal mobility is singular") {
    Model model;
    const int left = add_link(model, "left", {0.0, 0.0, 0.0});
    const int right = add_link(model, "right", {1.0, 0.0, 0.0});
    pin(model, "A", left, {}, ground, {});
    pin(model, "B", right, {}, left, {1.0, 0.0});
    pin(model, "C", right, {1.0, 0.0}, ground, {2.0, 0.0});
    CHECK(only_message(diagnose(model)) ==
          "the stated position is singular: 'left', 'right' can move in more than one direction");
  }

  TEST_CASE("a dead point of the drive is named with the freedom that it does not control") {
    Model model = slider_crank();
    model.drivers.clear();
    drive_sliding(model, "cylinder", 3);
    model.links[0].pose = {0.0, 0.0, 0.0};
    model.links[1].pose = {0.1, 0.0, 0.0};
    model.links[2].pose = {0.4, 0.0, 0.0};
    CHECK(only_message(diagnose(model)) == "the drivers 'cylinder' do not hold 'crank', 'rod' at the stated position");
  }

  TEST_CASE("a mechanism that cannot close names a joint of the loop and its gap") {
    Model model = four_bar();
    model.joints[1].point_j.x = 0.8;
    const auto findings = diagnose(model);
    const std::string message = only_message(findings);
    CHECK(message.find(" does not close: a gap of ") != std::string::npos);
    CHECK(message.find(" mm remains") != std::string::npos);
  }

  TEST_CASE("a frame without drivers is legal") {
    Model model;
    const int left = add_link(model, "left", {0.0, 0.0, 0.9});
    const int right = add_link(model, "right", {2.0, 0.0, 2.2});
    pin(model, "A", left, {}, ground, {});
    pin(model, "B", right, {}, ground, {2.0, 0.0});
    pin(model, "C", left, {std::sqrt(2.0), 0.0}, right, {std::sqrt(2.0), 0.0});
    CHECK(diagnose(model).empty());
    CHECK(analyse(model).mobility == 0);
  }

  TEST_CASE("mass without inertia is a point mass and not an error") {
    Model model = slider_crank();
    model.links[0].inertia = 0.0;
    CHECK(diagnose(model).empty());
  }

  TEST_CASE("large mechanisms have the mobility and the redundancy of their count") {
    Model model = chain(30);
    const Structure sound = analyse(model);
    CHECK(sound.closes);
    CHECK(sound.mobility == 1);
    CHECK(sound.redundant.empty());
    CHECK(sound.loose.empty());
    model.joints.pop_back();  // the last rocker's pin to the ground
    const Structure open = analyse(model);
    CHECK(open.mobility == 3);
    CHECK(open.loose.size() == 2);
    const Structure repeated = analyse(parallel_cranks(30, 1.0));
    CHECK(repeated.mobility_by_count == -27);
    CHECK(repeated.mobility == 1);
    CHECK(repeated.redundant.size() == 28);
  }
}
