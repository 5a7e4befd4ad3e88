// Positions and motion of the drives of a mechanism, position by position.
#pragma once

#include "calculators/mechanism/completion/courses.hpp"
#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/groups/released_system.hpp"
#include "lib/quantity/series.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace loadpath::planar {

/// The states of all drives at every position.
struct Schedule {
  std::vector<std::vector<mechanism::Drive>> drives;
  std::vector<double> at;  // values of the axis: crank angles, or the first cylinder's places, or times
  double turns = 0.0;      // by which the drive's coordinate is ahead of the crank angle, rad
  double period = 0.0;     // period of the crank angle, signed; 0: not a full turn
  bool is_uneven = false;  // with inserted positions between the requested ones
};

bool has_crank(const Mechanism::Input& in);
/// Whether the positions are those of a full revolution of the crank.
bool is_whole_turn(const Mechanism::Input& in);
/// The coordinate of a driver where the mechanism was assembled.
using Assembled = std::function<double(std::size_t driver)>;
/// Drives without a stated place begin where they are.
Schedule schedule_of(const Mechanism::Input& in, const Assembled& assembled);
/// At other places: 2.5 is the midpoint between the positions 2 and 3, counted from 0.
Schedule schedule_of(const Mechanism::Input& in, const Assembled& assembled, const std::vector<double>& places);
/// Number of requested positions.
std::size_t positions_of(const Mechanism::Input& in);

/// 1 forward, -1 backward: in which order the positions follow.
double turning_sense(const planar::Crank& crank);
/// The crank at a place.
mechanism::Drive drive_of(const planar::Crank& crank, double coordinate);

/// The places of the axis.
void fill_axis(const Schedule& schedule, Axis& axis);

/// The task of a solution: a mechanism, its drives at every position, with inertia or without.
struct CycleTask {
  const Mechanism::Input& in;
  const mechanism::Model& model;
  bool redundant;  // joints hold too much
  const Schedule& schedule;
  bool statics;
  const LoadCourses& courses;
};

/// Loads that vary over the cycle, at position k, with the drives at these values. `place` is solved first where a
/// load goes by a stroke.
void set_loads(const CycleTask& task, mechanism::ReleasedSystem& system, const std::vector<mechanism::Drive>& drives,
               std::size_t k, mechanism::Position& place);

}  // namespace loadpath::planar
