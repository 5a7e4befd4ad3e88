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
template <class Scalar>
struct BasicPlaced {
  BasicTurn<Scalar> turned;
  BasicVec<Scalar> origin;
  Scalar phi = 0.0;
  [[nodiscard]] BasicVec<Scalar> point(BasicVec<Scalar> own) const { return origin + turned(own); }
};
using Placed = BasicPlaced<double>;

/// How a link's frame moves.
template <class Scalar>
struct BasicSpeeds {
  BasicVec<Scalar> origin;
  Scalar omega = 0.0;
};
using Speeds = BasicSpeeds<double>;

enum class PairKind { joint, turning_drive, sliding_drive };

/// What joints and drives have in common; the numbers of a Joint, ready for use.
template <class Scalar>
struct BasicPairShape {
  using Kind = PairKind;
  Kind kind = Kind::joint;
  JointKind joint = JointKind::revolute;
  BasicVec<Scalar> point_i, point_j;  // frames of i and j
  BasicVec<Scalar> line{1.0, 0.0};    // frame of j
  Scalar angle = 0.0;                 // prismatic and rigid: of i against j
  BasicTurn<Scalar> turned;           // the same
  Scalar radius_i = 0.0;              // of the wheels
  Scalar radius_j = 0.0;
  Scalar phase = 0.0;   // wheels: what their rolling keeps constant, m
  Scalar offset = 0.0;  // of a drive

  [[nodiscard]] std::size_t rows() const {
    return kind == Kind::joint ? static_cast<std::size_t>(constraint_count(joint)) : 1;
  }
};
using PairShape = BasicPairShape<double>;

template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicJoint<Scalar>& joint);
/// Of a drive; a sliding one acts on this joint.
template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicDriver<Scalar>& driver, const BasicJoint<Scalar>* joint);

/// One equation: a force of 1 along e and a couple m on link i, the opposite on link j.
template <class Scalar>
struct BasicPairRow {
  BasicVec<Scalar> e;
  Scalar m = 0.0;
};
using PairRow = BasicPairRow<double>;

/// Which of a row's values can differ from zero.
struct RowPattern {
  bool x = true, y = true, phi = true;
};
template <class Scalar>
RowPattern pattern_of(const BasicPairShape<Scalar>& shape, std::size_t row);

/// A pair at a position, global axes.
template <class Scalar>
struct BasicPairPlace {
  BasicVec<Scalar> at;     // where the forces of its rows act on i: its pin, the point where wheels touch
  BasicVec<Scalar> at_j;   // and on j: the same once the pair is closed
  BasicVec<Scalar> seat;   // point_j
  BasicVec<Scalar> apart;  // from the seat to the pin of link i
  BasicVec<Scalar> along;  // the line of link j; of the belt; wheels: from the centre of i towards the other pitch
                           // circle, a unit vector
  Scalar centres = 0.0;    // wheels: angle of the line of centres, continuous
  std::array<BasicPairRow<Scalar>, 3> rows;
};
using PairPlace = BasicPairPlace<double>;

/// Sets the rows that never change.
template <class Scalar>
void prepare(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at);
/// Goes with the links; wheels: to the angle of the line of centres next to the one before.
template <class Scalar>
void place(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
           BasicPairPlace<Scalar>& at);
/// Wheels at a closed position: chooses the whole turns of the line of centres.
template <class Scalar>
void count_turns(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                 BasicPairPlace<Scalar>& at);
/// Sets the phase of every joint that has one to what it is at the stated poses.
template <class Scalar>
void take_phases(BasicModel<Scalar>& model);
/// How far each of the equations is from holding; `target`: the coordinate that a drive should have.
template <class Scalar>
void open(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at, const BasicPlaced<Scalar>& i,
          const BasicPlaced<Scalar>& j, std::type_identity_t<Scalar> target,
          std::span<std::type_identity_t<Scalar>> residual);
/// The acceleration with which the points of i and j at `at` part along each row in the motion that the pair allows.
template <class Scalar>
void held_acceleration(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at,
                       const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j, const BasicSpeeds<Scalar>& speed_i,
                       const BasicSpeeds<Scalar>& speed_j, std::span<std::type_identity_t<Scalar>> along);

}  // namespace loadpath::mechanism
