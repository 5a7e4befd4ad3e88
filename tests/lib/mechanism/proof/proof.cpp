#include "lib/mechanism/proof/proof.hpp"

#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/reference.hpp"
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

struct Proven {
  Solved solved;
  Proof proof;
};

Proven prove(const Model& model, const std::vector<Drive>& drives, bool statics = false) {
  Proven proven{solve(model, drives, statics), {}};
  REQUIRE(proven.solved.status == Status::closed);
  proven.proof = Prover(model).prove(drives, statics, proven.solved.at);
  return proven;
}

const std::vector<Drive> turning{{1.3, 20.0, -35.0}};

/// The proof of a position of the six-bar with a falsified value.
template <class Change>
Proof prove_changed(Change change) {
  const Model model = six_bar();
  Proven proven = prove(model, turning);
  change(proven.solved.at, proven.proof.largest_force);
  return Prover(model).prove(turning, false, proven.solved.at);
}

bool agrees(const Proof& proof, Proof::Method method) { return proof.part(method) <= Proof::tolerance; }

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("all proofs agree on random mechanisms") {
    for (const auto& path : reference::files()) {
      CAPTURE(path.filename().string());
      const auto file = reference::read(path);
      const Model model = reference::model_of(file.at("model")).model;
      WholeSystem system(model);
      REQUIRE(system.assemble() == Status::closed);
      Position at = system.blank();
      Prover prover(model);
      const auto& answers = file.at("answers").as_array();
      for (std::size_t k = 0; k < answers.size(); k += answers.size() / 4) {
        const Drive drive =
            reference::drive_at(file.at("model").at("drivers").at(0), reference::number(answers[k], "t"));
        REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
        check_trustworthy(prover.prove({&drive, 1}, false, at));
      }
    }
  }

  TEST_CASE("all proofs agree with slots, cylinders and several drives, in motion and in statics") {
    const struct {
      const char* name;
      Model model;
      std::vector<Drive> drives;
    } cases[] = {{"slotted lever", slotted_lever(), {{0.9, 45.0, 3.0}}},
                 {"slotted lever with slider", slotted_lever(true), {{0.9, 45.0, 3.0}}},
                 {"slot on a moving link", slot_on_a_moving_link(false), {{0.5, 12.0, -40.0}}},
                 {"driven piston", driven_piston(), {{0.37, 0.7, 2.0}}},
                 {"boom", boom(), {{1.15, 0.2, -0.1}}},
                 {"five-bar", five_bar(), {{2.1, 3.0, 10.0}, {0.9, -4.0, 6.0}}},
                 {"trammel", trammel(), {{0.22, 0.4, -0.7}}},
                 {"telescope", telescope(), {{0.8, 0.5, -1.0}, {0.6, 0.3, 0.4}}}};
    for (const auto& c : cases) {
      CAPTURE(c.name);
      check_trustworthy(prove(c.model, c.drives).proof);
      check_trustworthy(prove(c.model, c.drives, true).proof);
    }
  }

  TEST_CASE("all proofs agree on a frame without drives and on a mechanism without any force") {
    check_trustworthy(prove(group_with_outer_sliding_pair(), {}).proof);
    Model idle = five_bar();
    idle.gravity = {};
    idle.loads.clear();
    const Proof proof = prove(idle, {{2.1, 3.0, 10.0}, {0.9, -4.0, 6.0}}, true).proof;
    CHECK(proof.largest_force == 0.0);
    CHECK(proof.trustworthy());
  }

  TEST_CASE("a position in which all accelerations cancel is proved like its neighbours") {
    for (const double crank : {-1e-9, 0.0, 1e-9}) check_trustworthy(prove(slotted_lever(), {{crank, 45.0, 0.0}}).proof);
  }

  TEST_CASE("a load that changes between positions is seen by the next proof") {
    Model model = four_bar();
    Prover prover(model);
    check_trustworthy(prover.prove(turning, false, solve(model, turning).at));
    model.loads[0].moment = 55.0;
    check_trustworthy(prover.prove(turning, false, solve(model, turning).at));
  }

  TEST_CASE("proofs do not depend on the unit of length") {
    const Proof metres = prove(six_bar(), turning).proof;
    const Proof millimetres = prove(in_unit_of_length(six_bar(), 0.0009765625), turning).proof;
    CHECK(millimetres.condition == doctest::Approx(metres.condition).epsilon(1e-12));
    CHECK(millimetres.trustworthy());
  }

  TEST_CASE("the condition number is close to the estimate of the solver") {
    const Model model = six_bar();
    const Proven proven = prove(model, turning);
    WholeSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    REQUIRE(system.move(turning) == Status::closed);
    const double estimate = 1.0 / system.condition();
    CHECK(proven.proof.condition >= estimate / 3.0);
    CHECK(proven.proof.condition <= 3.0 * estimate);
  }

  TEST_CASE("a reaction that is off by a millionth is caught") {
    for (std::size_t joint = 0; joint < six_bar().joints.size(); ++joint) {
      CAPTURE(joint);
      const Proof proof =
          prove_changed([&](Position& at, double force) { at.reactions[joint].force.y += 1e-6 * force; });
      CHECK_FALSE(agrees(proof, Proof::whole_system));
      CHECK_FALSE(agrees(proof, Proof::released_constraints));
      CHECK_FALSE(agrees(proof, Proof::opened_chain));
      CHECK(proof.part(proof.unbalanced) > Proof::tolerance);
      CHECK(agrees(proof, Proof::virtual_power));
      CHECK_FALSE(proof.trustworthy());
    }
  }

  TEST_CASE("a couple or a point of action of a reaction that is off by a millionth is caught") {
    const std::size_t guide = 6;
    for (const bool place : {false, true}) {
      const Proof proof = prove_changed([&](Position& at, double) {
        if (place) at.reactions[guide].at.x += 1e-6;
        if (!place) at.reactions[guide].couple += 1e-6 * length(at.reactions[guide].force);
      });
      CHECK_FALSE(agrees(proof, Proof::whole_system));
      CHECK_FALSE(agrees(proof, Proof::released_constraints));
      CHECK_FALSE(agrees(proof, Proof::opened_chain));
    }
  }

  TEST_CASE("an effort that is off by a millionth, or reversed, is caught by every method") {
    for (const double factor : {1.0 + 1e-5, -1.0}) {
      const Proof proof = prove_changed([&](Position& at, double) { at.effort[0] *= factor; });
      for (std::size_t method = 0; method < Proof::methods; ++method) {
        CAPTURE(method);
        CHECK_FALSE(agrees(proof, static_cast<Proof::Method>(method)));
      }
    }
  }

  TEST_CASE("a reaction with the wrong sign is caught") {
    const Proof proof = prove_changed([](Position& at, double) { at.reactions[2].force = -at.reactions[2].force; });
    CHECK_FALSE(agrees(proof, Proof::whole_system));
    CHECK_FALSE(agrees(proof, Proof::released_constraints));
    CHECK_FALSE(agrees(proof, Proof::opened_chain));
  }

  TEST_CASE("a position, a velocity or an acceleration that is off by a millionth is caught") {
    for (const int order : {0, 1, 2}) {
      const Proof proof = prove_changed([&](Position& at, double) {
        if (order == 0) at.pose[2].phi += 1e-6;
        if (order == 1) at.velocity[3].phi += 1e-6 * 20.0;
        if (order == 2) at.acceleration[4].x *= 1.0 + 1e-6;
      });
      CHECK(proof.motion > Proof::tolerance);
      CHECK_FALSE(proof.trustworthy());
    }
  }

  TEST_CASE("a drive that is not where it should be, or not as fast, is caught") {
    const Model model = boom();
    const Proven proven = prove(model, {{1.15, 0.2, -0.1}});
    for (const Drive& drive : {Drive{1.16, 0.2, -0.1}, Drive{1.15, 0.21, -0.1}, Drive{1.15, 0.2, -0.11}}) {
      CHECK(Prover(model).prove({&drive, 1}, false, proven.solved.at).motion > 1e-3);
    }
  }

  TEST_CASE("forces of statics are not those of motion") {
    const Model model = six_bar();
    const Proven proven = prove(model, turning, true);
    CHECK_FALSE(Prover(model).prove(turning, false, proven.solved.at).trustworthy());
  }

  TEST_CASE("a position that is not a number, and a dead point, are not trustworthy") {
    CHECK_FALSE(prove_changed([](Position& at, double) { at.reactions[1].force.x = NAN; }).trustworthy());
    CHECK_FALSE(prove_changed([](Position& at, double) { at.pose[1].phi = NAN; }).trustworthy());
    Model stretched = slider_crank();
    stretched.drivers.clear();
    drive_sliding(stretched, "cylinder", 3);
    Position at = blank_position(stretched);
    at.pose = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.4, 0.0, 0.0}};
    CHECK_FALSE(Prover(stretched).prove(std::vector<Drive>(1), false, at).trustworthy());
  }
}
