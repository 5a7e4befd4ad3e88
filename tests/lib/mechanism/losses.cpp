// Efficiency of teeth and belts: what a designer reckons with M_out = eta i M_in, and what a planetary gear makes of
// it.
#include "lib/mechanism/groups/system.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

constexpr double eta = 0.9;

void lose(Joint& joint, double efficiency, double backward) {
  joint.friction.loss = 1.0 - efficiency;
  joint.friction.loss_back = 1.0 - backward;
}

/// Two wheels on fixed axes; the drive turns the first, a moment acts on the second.
Model two_wheels(JointKind kind, double radius_i, double radius_j, double apart, double moment) {
  Model model;
  const int first = add_link(model, "first", {});
  const int second = add_link(model, "second", {apart, 0.0, 0.0});
  pin(model, "O", first, {}, ground, {});
  pin(model, "C", second, {}, ground, {apart, 0.0});
  mesh(model, kind, first, {}, radius_i, second, {}, radius_j, kind == JointKind::gear ? 0.349 : 0.0);
  lose(model.joints.back(), eta, 0.8);
  drive_turning(model, "motor", first);
  load(model, "work", second, {}, {}, moment);
  take_phases(model);
  return model;
}

Position position_of(const Model& model, Drive drive, bool statics = false) {
  GroupSystem groups(model);
  WholeSystem whole(model);
  Position at = blank_position(model), other = at;
  REQUIRE(groups.assemble() == Status::closed);
  REQUIRE(whole.assemble() == Status::closed);
  REQUIRE(groups.solve({&drive, 1}, at, statics) == Status::closed);
  REQUIRE(whole.solve({&drive, 1}, other, statics) == Status::closed);
  CHECK(at.effort[0] == doctest::Approx(other.effort[0]).epsilon(1e-11));
  Prover prover(model);
  check_trustworthy(prover.prove({&drive, 1}, statics, at));
  return at;
}

struct Train {
  const char* name;
  JointKind kind;
  double radius_i, radius_j, apart;
};
const std::vector<Train> trains{
    {"gears", JointKind::gear, 0.02, 0.05, 0.07},          {"ring", JointKind::gear, 0.02, -0.05, -0.03},
    {"tight ring", JointKind::gear, 0.029, -0.03, -0.001}, {"belt", JointKind::belt, 0.04, 0.06, 0.3},
    {"equal pulleys", JointKind::belt, 0.05, 0.05, 0.3},   {"crossed belt", JointKind::belt, 0.04, -0.06, 0.3}};

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the output power is the efficiency times the input power, whichever gear drives in either direction") {
    for (const Train& p : trains) {
      CAPTURE(p.name);
      for (const double moment : {12.0, -12.0}) {
        for (const double speed : {10.0, -10.0}) {
          CAPTURE(moment * speed);
          const Model model = two_wheels(p.kind, p.radius_i, p.radius_j, p.apart, moment);
          const Position at = position_of(model, {0.3, speed, 0.0});
          const double useful = -moment * at.velocity[1].phi, drive = at.effort[0] * speed;
          CHECK((drive > 0.0) == (useful > 0.0));
          if (drive > 0.0) {
            CHECK(useful == doctest::Approx(eta * drive).epsilon(1e-12));
          } else {
            CHECK(drive == doctest::Approx(0.8 * useful).epsilon(1e-12));
          }
        }
      }
    }
  }

  TEST_CASE("a rack gets the power of the pinion times the efficiency, and in reverse likewise") {
    for (const double force : {-100.0, 100.0}) {
      Model model = pinion_and_rack();
      model.loads.clear();
      lose(model.joints.back(), eta, 0.8);
      load(model, "cut", 1, {}, {force, 0.0});
      const Position at = position_of(model, {0.2, 4.0, 0.0}, true);
      const double useful = -force * at.velocity[1].x, drive = at.effort[0] * 4.0;
      CHECK((useful > 0.0 ? useful / drive : drive / useful) == doctest::Approx(useful > 0.0 ? eta : 0.8));
    }
  }

  TEST_CASE("a planetary gear with the arm as output: eta = (1 - i0 eta0) / (1 - i0), i0 = -5/2 with the arm fixed") {
    Model model = planetary();
    for (Joint& joint : model.joints) {
      if (joint.kind == JointKind::gear) lose(joint, 0.97, 0.97);
    }
    const double standing = 0.97 * 0.97, i0 = -2.5;
    const Position at = position_of(model, {0.1, 50.0, 0.0}, true);
    const double useful = 10.0 * at.velocity[1].phi, drive = at.effort[0] * 50.0;
    CHECK(useful / drive == doctest::Approx((1.0 - i0 * standing) / (1.0 - i0)).epsilon(1e-12));
  }

  TEST_CASE("a worm: its reverse efficiency, 2 - 1/eta, means self-locking for eta below one half") {
    for (const double forward : {0.8, 0.5, 0.4}) {
      CAPTURE(forward);
      Model model = two_wheels(JointKind::gear, 0.02, 0.4, 0.42, -30.0);
      lose(model.joints.back(), forward, 2.0 - 1.0 / forward);
      // Lifting and lowering at rest; the first wheel turns the second in the opposite direction.
      const double lift = position_of(model, {0.3, 0.0, 0.0, -1.0}).effort[0];
      const double lower = position_of(model, {0.3, 0.0, 0.0, 1.0}).effort[0];
      const double held = position_of(model, {0.3, 0.0, 0.0}).effort[0];
      CHECK(lift == doctest::Approx(held / forward).epsilon(1e-12));
      CHECK(lower == doctest::Approx(held * (2.0 - 1.0 / forward)).epsilon(1e-12));
      CHECK((lower * held <= 0.0) == (forward <= 0.5));
    }
  }

  TEST_CASE("without losses nothing changes, and a gear at rest loses nothing") {
    const Model without = gear_train(0.349);
    Model lossless = without, lossy = without;
    lose(lossless.joints.back(), 1.0, 1.0);
    lose(lossy.joints.back(), 0.9, 0.9);
    CHECK(position_of(without, {0.5, 20.0, 0.0}).effort[0] == position_of(lossless, {0.5, 20.0, 0.0}).effort[0]);
    CHECK(position_of(without, {0.5, 0.0, 0.0}).effort[0] ==
          doctest::Approx(position_of(lossy, {0.5, 0.0, 0.0}).effort[0]).epsilon(1e-12));
    CHECK(position_of(without, {0.5, 20.0, 0.0}).effort[0] != position_of(lossy, {0.5, 20.0, 0.0}).effort[0]);
  }
}
