// Every method of the proof by itself.
#pragma once

#include "lib/mechanism/proof/proof.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace loadpath::mechanism::models {

struct FoundBy {
  std::string method;
  Forces forces;
};

/// The reactions and efforts by each method that finds all of them; none of them is read from the position.
inline std::vector<FoundBy> forces_by_every_method(const Model& model, const Position& at, bool statics = false) {
  Instant instant(model);
  instant.take(at, statics);
  std::vector<FoundBy> found;
  for (const char* method : {"whole system", "released constraints", "opened chain"}) {
    found.push_back({method, blank_forces(model)});
  }
  AllEquations(instant).find_forces(instant, found[0].forces);
  ReleasedConstraints().find_forces(instant, found[1].forces);
  OpenedChain(instant).find_forces(instant, found[2].forces);
  return found;
}

struct EffortBy {
  std::string method;
  double effort;
};

/// The effort of a driver by every method.
inline std::vector<EffortBy> efforts_by_every_method(const Model& model, const Position& at, std::size_t driver,
                                                     bool statics = false) {
  std::vector<EffortBy> found;
  for (const FoundBy& by : forces_by_every_method(model, at, statics)) {
    found.push_back({by.method, by.forces.effort[driver]});
  }
  Instant instant(model);
  instant.take(at, statics);
  found.push_back({"virtual power", effort_by_virtual_power(instant, driver)});
  ZhukovskyLever lever;
  find_lever(instant, driver, lever);
  found.push_back({"lever", lever.effort});
  return found;
}

inline void check_trustworthy(const Proof& proof) {
  for (std::size_t method = 0; method < Proof::methods; ++method) {
    CAPTURE(method);
    CHECK(proof.part(static_cast<Proof::Method>(method)) <= 1e-12);
  }
  CHECK(proof.part(proof.unbalanced) <= 1e-12);
  CHECK(proof.motion <= 1e-12);
  CHECK(proof.trustworthy());
}

}  // namespace loadpath::mechanism::models
