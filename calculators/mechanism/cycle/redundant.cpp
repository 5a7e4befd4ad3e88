#include "calculators/mechanism/cycle/redundant.hpp"

#include "lib/mechanism/structure/release.hpp"

#include <algorithm>

namespace loadpath::planar {

static void hide(const std::vector<mechanism::Uniqueness>& unique, mechanism::Position& p) {
  for (std::size_t k = 0; k < p.reactions.size(); ++k) {
    if (!unique[k].force) p.reactions[k].force = {none, none};
    if (!unique[k].couple) p.reactions[k].couple = none;
  }
}

Cycle without_what_is_not_unique(Cycle cycle) {
  for (mechanism::Position& p : cycle.positions) hide(cycle.unique, p);
  for (auto& ways : cycle.either_way) {
    for (mechanism::Position& way : ways) hide(cycle.unique, way);
  }
  return cycle;
}

mechanism::Model determinate(const mechanism::Model& model, const Cycle& cycle) {
  const auto closed = std::find(cycle.closed.begin(), cycle.closed.end(), true) - cycle.closed.begin();
  if (static_cast<std::size_t>(closed) == cycle.closed.size()) return model;
  return mechanism::release(model, cycle.positions[static_cast<std::size_t>(closed)].pose).value_or(model);
}

}  // namespace loadpath::planar
