#include "calculators/mechanism/results/aspect.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace loadpath;
using namespace loadpath::planar;

namespace loadpath::planar::aspects {
extern const Aspect equations;
}

namespace {

struct OnePosition {
  mechanism::Position position;
  mechanism::Residuals residuals;
};

Cycle cycle_of(const OnePosition& first, const OnePosition& second) {
  Cycle cycle;
  cycle.positions = {first.position, second.position};
  cycle.proofs.resize(2);
  cycle.proofs[0].residuals = first.residuals;
  cycle.proofs[1].residuals = second.residuals;
  cycle.closed = {true, true};
  cycle.jams = cycle.undirected = cycle.at_change_point = {false, false};
  return cycle;
}

/// One joint whose reaction is 100 N at an arm of 1 m.
OnePosition balanced() {
  OnePosition s;
  s.position.reactions.resize(1);
  s.position.reactions[0].force = {100.0, 0.0};
  s.position.reactions[0].at = {0.0, 1.0};
  s.residuals.power_scale = 50.0;
  return s;
}

planar::Mechanism::Input driven() {
  planar::Mechanism::Input in;
  in.crank.joint = "O";
  return in;
}

std::vector<account::Verdict> proof(const std::string& step, const Mechanism::Input& in, const Cycle& cycle,
                                    const Axis* axis) {
  const mechanism::Structure structure;
  const mechanism::Model model;
  const Kinematics kinematics;
  std::vector<account::Verdict> verdicts;
  aspects::equations.judge({step, in, structure, model, model, cycle, cycle, kinematics, axis}, verdicts);
  return verdicts;
}

account::State state_of(const char* symbol, const Cycle& cycle) {
  for (const account::Verdict& v : proof("press", driven(), cycle, nullptr)) {
    if (v.symbol == symbol) return v.state;
  }
  FAIL("no such proof");
  return account::State::fail;
}

Axis crank_angles() { return {"press", "crank angle", "deg", {0.0, pi / 2.0}, {}, 2.0 * pi}; }

/// Two positions with forces of 100 N.
Cycle proven() {
  Cycle cycle = cycle_of(balanced(), balanced());
  for (mechanism::Proof& p : cycle.proofs) p.largest_force = 100.0;
  return cycle;
}

account::Verdict verdict_of(const std::string& symbol, const Cycle& cycle) {
  const Axis axis = crank_angles();
  for (const account::Verdict& v : proof("press", driven(), cycle, &axis)) {
    if (v.symbol == symbol) return v;
  }
  FAIL("no such proof");
  return {};
}

}  // namespace

TEST_SUITE("mechanism report") {
  TEST_CASE("the proof of equilibrium passes without a residual, and fails with one") {
    OnePosition off = balanced();
    off.residuals.force = off.residuals.moment = off.residuals.power = -1e-3;
    for (const char* symbol : {"force_balance", "moment_balance", "power_balance"}) {
      CAPTURE(symbol);
      CHECK(state_of(symbol, cycle_of(balanced(), balanced())) == account::State::pass);
      CHECK(state_of(symbol, cycle_of(balanced(), off)) == account::State::fail);
    }
  }

  TEST_CASE("the force of a cylinder counts as a force; a residual without forces does not pass") {
    OnePosition off = balanced();
    off.position.reactions[0].force = {};
    off.residuals.force = off.residuals.moment = 1e-3;
    planar::Mechanism::Input pushed;
    pushed.cylinders.resize(1);
    off.position.effort = {1e9};
    for (const account::Verdict& v : proof("press", pushed, cycle_of(off, off), nullptr)) {
      if (std::string(v.symbol) == "force_balance") CHECK(v.state == account::State::pass);
      if (std::string(v.symbol) == "moment_balance") CHECK(v.state == account::State::not_available);
    }
  }

  TEST_CASE("a residual or a scale that is not a number never passes, at any position") {
    for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      OnePosition residual = balanced(), scale = balanced();
      residual.residuals.force = residual.residuals.moment = residual.residuals.power = none;
      scale.position.reactions[0].force.x = scale.residuals.power_scale = none;
      for (const char* symbol : {"force_balance", "moment_balance", "power_balance"}) {
        CAPTURE(symbol);
        for (const OnePosition& s : {residual, scale}) {
          CHECK(state_of(symbol, cycle_of(s, balanced())) == account::State::not_available);
          CHECK(state_of(symbol, cycle_of(balanced(), s)) == account::State::not_available);
        }
      }
    }
  }

  TEST_CASE("each method has its verdict, over the largest force times the condition number") {
    const struct {
      const char* symbol;
      mechanism::Proof::Method method;
    } methods[] = {{"whole_system", mechanism::Proof::whole_system},
                   {"opened_chain", mechanism::Proof::opened_chain},
                   {"released_constraints", mechanism::Proof::released_constraints},
                   {"virtual_power", mechanism::Proof::virtual_power},
                   {"zhukovsky_lever", mechanism::Proof::zhukovsky}};
    for (const auto& m : methods) {
      CAPTURE(m.symbol);
      Cycle cycle = proven();
      CHECK(verdict_of(m.symbol, cycle).state == account::State::pass);
      cycle.proofs[1].disagreement[m.method] = 2e-8;
      CHECK(verdict_of(m.symbol, cycle).state == account::State::fail);
      CHECK(verdict_of(m.symbol, cycle).note.text() == "at 90°");
      cycle.proofs[1].condition = 3.0;
      CHECK(verdict_of(m.symbol, cycle).state == account::State::pass);
      cycle.proofs[0].disagreement[m.method] = std::numeric_limits<double>::quiet_NaN();
      CHECK(verdict_of(m.symbol, cycle).state == account::State::not_available);
    }
  }

  TEST_CASE("positions that are not trustworthy are reported with their crank angles") {
    Cycle cycle = proven();
    CHECK(verdict_of("trustworthy", cycle).state == account::State::pass);
    cycle.proofs[1].motion = 1e-9;
    CHECK(verdict_of("trustworthy", cycle).state == account::State::fail);
    CHECK(verdict_of("trustworthy", cycle).note.text() == "not trustworthy at 90°");
    cycle.proofs[0].unbalanced = 1.0;
    CHECK(verdict_of("trustworthy", cycle).note.text() == "not trustworthy at 2 positions, first at 0°, last at 90°");
    cycle.closed = {false, false};
    CHECK(verdict_of("trustworthy", cycle).state == account::State::not_available);
  }

  TEST_CASE("a frame has no drive to be solved for again") {
    for (const account::Verdict& v : proof("frame", {}, proven(), nullptr)) {
      CHECK(std::string(v.symbol) != "virtual_power");
      CHECK(std::string(v.symbol) != "zhukovsky_lever");
    }
  }
}
