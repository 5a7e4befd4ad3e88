// How a mechanism with one drive moves with it: derivatives of position functions, signs of assemblies, strokes.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/mechanism/studies/strokes.hpp"

#include <vector>

namespace loadpath::planar {

/// Kinematics of a mechanism with one drive; empty where it has none or several.
struct Kinematics {
  std::vector<mechanism::Position> derivatives;  // as mechanism::PositionFunctions derives them; without forces
  std::vector<bool> known;                       // at which positions
  /// Groups without closed form: the first link, and where known the sign that changes with the assembly.
  struct Iterated {
    std::size_t link = 0;
    std::vector<double> signs;
  };
  std::vector<Iterated> iterated;
  std::vector<mechanism::Stroke> strokes;  // over the cycle

  /// At a position; null where it is not known.
  [[nodiscard]] const mechanism::Position* derivative(std::size_t k) const {
    return k < known.size() && known[k] ? &derivatives[k] : nullptr;
  }
};

/// `axis` is null where there is one position. `goes_by_drive`: it is the coordinate of the drive, not time; without it
/// there are no strokes.
Kinematics kinematics_of(const mechanism::Model& model, const Cycle& cycle, const Axis* axis, bool goes_by_drive);

}  // namespace loadpath::planar
