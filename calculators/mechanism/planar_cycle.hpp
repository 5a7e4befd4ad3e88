// Takes a mechanism through its positions: a turn of the crank, strokes of cylinders, or the positions that are asked
// for.
#pragma once

#include "calculators/mechanism/planar.hpp"
#include "lib/issue.hpp"
#include "lib/mechanism/group_system.hpp"
#include "lib/mechanism/proof/proof.hpp"
#include "lib/quantity/series.hpp"

#include <string>
#include <vector>

namespace loadpath {

/// The solved positions. Where the mechanism does not close there is none.
struct Cycle {
  std::vector<mechanism::Position> positions;
  std::vector<std::vector<mechanism::Drive>> drives;  // with which they are solved
  std::vector<mechanism::Proof> proofs;
  std::vector<bool> closed;
  bool returns = true;         // after a whole turn, to where it began
  std::vector<bool> in_steps;  // closed, but near a change point: followed from the position before in small steps
  std::vector<bool> jams;      // closed, but friction lets no drive move it: it has no forces there
  mechanism::Status first_failure = mechanism::Status::closed;
  mechanism::WholeSystem::Gap gap;  // at the first failure
  double worst_condition = 0.0;     // largest condition number of the constraints; 0: no position is closed
  std::size_t worst_at = 0;         // where that is

  [[nodiscard]] bool has_forces(std::size_t k) const { return closed[k] && !jams[k]; }
};

/// Whether the positions make series, and over what: the name of the axis; empty where there is one position.
std::string axis_name(const PlanarMechanism::Input& in);

/// The crank angle of the first position, as the user counts it.
double first_crank_angle(const PlanarMechanism::Crank& crank);

/// Whether the positions are those of a whole turn of the crank.
bool is_whole_turn(const PlanarMechanism::Input& in);

/// Whether a drive follows a law of motion; the axis is time then.
bool has_law(const PlanarMechanism::Input& in);
/// Laws of motion with too few moments, or moments that do not follow one another. Needs values.
std::vector<FieldFault> check_laws(const PlanarMechanism::Input& in);

/// Fills the places of the axis and solves there. `axis` is null where there is one position.
Cycle solve_cycle(const PlanarMechanism::Input& in, const mechanism::Model& model, Axis* axis);

}  // namespace loadpath
