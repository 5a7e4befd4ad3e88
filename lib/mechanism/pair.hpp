// What a joint, or a drive, demands of its two links, for every kind in one place: its equations as forces and couples
// that do no work in the motions that it allows, how far it is open, and what its acceleration owes to the velocities.
#pragma once

#include "lib/mechanism/model.hpp"
#include "lib/mechanism/vec.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace loadpath::mechanism {

/// Where a link's frame is, global axes.
struct Placed {
  Turn turned;
  Vec origin;
  double phi = 0.0;
  [[nodiscard]] Vec point(Vec own) const { return origin + turned(own); }
};

/// How a link's frame moves.
struct Speeds {
  Vec origin;
  double omega = 0.0;
};

/// What joints and drives have in common; the numbers of a Joint, ready for use.
struct PairShape {
  enum class Kind { joint, turning_drive, sliding_drive };
  Kind kind = Kind::joint;
  JointKind joint = JointKind::revolute;
  Vec point_i, point_j;   // frames of i and j
  Vec line{1.0, 0.0};     // frame of j
  double angle = 0.0;     // prismatic and rigid: of i against j
  Turn turned;            // the same
  double radius_i = 0.0;  // of the wheels
  double radius_j = 0.0;
  double phase = 0.0;   // wheels: what their rolling keeps constant, m
  double offset = 0.0;  // of a drive

  [[nodiscard]] std::size_t rows() const {
    return kind == Kind::joint ? static_cast<std::size_t>(constraint_count(joint)) : 1;
  }
};

PairShape shape_of(const Joint& joint);
/// Of a drive; a sliding one acts on this joint.
PairShape shape_of(const Driver& driver, const Joint* joint);

/// One equation: a force of 1 along e and a couple m on link i, the opposite on link j.
struct PairRow {
  Vec e;
  double m = 0.0;
};

/// Which of a row's values can differ from zero.
struct RowPattern {
  bool x = true, y = true, phi = true;
};
RowPattern pattern_of(const PairShape& shape, std::size_t row);

/// A pair at a position, global axes.
struct PairPlace {
  Vec at;     // where the forces of its rows act on i: its pin, the point where wheels touch
  Vec at_j;   // and on j: the same once the pair is closed
  Vec seat;   // point_j
  Vec apart;  // from the seat to the pin of link i
  Vec along;  // the line of link j; wheels: from the centre of i towards that of j, over the sum of the radii
  double centres = 0.0;  // wheels: angle of the line of centres, continuous
  std::array<PairRow, 3> rows;
};

/// Sets the rows that never change.
void prepare(const PairShape& shape, PairPlace& at);
/// Goes with the links; wheels: to the angle of the line of centres next to the one before.
void place(const PairShape& shape, const Placed& i, const Placed& j, PairPlace& at);
/// Wheels at a closed position: chooses the whole turns of the line of centres.
void count_turns(const PairShape& shape, const Placed& i, const Placed& j, PairPlace& at);
/// Sets the phase of every joint that has one to what it is at the stated poses.
void take_phases(Model& model);
/// How far each of the equations is from holding; `target`: the coordinate that a drive should have.
void open(const PairShape& shape, const PairPlace& at, const Placed& i, const Placed& j, double target,
          std::span<double> residual);
/// The acceleration with which the points of i and j at `at` part along each row in the motion that the pair allows.
void held_acceleration(const PairShape& shape, const PairPlace& at, const Placed& i, const Placed& j,
                       const Speeds& speed_i, const Speeds& speed_j, std::span<double> along);

}  // namespace loadpath::mechanism
