// What a joint, or a drive, demands of its two links, for every kind in one place: its equations as forces and couples
// that do no work in the motions that it allows, how far it is open, and what its acceleration owes to the velocities.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/vec.hpp"

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

template <class Scalar>
BasicVec<Scalar> velocity_at(BasicVec<Scalar> point, const BasicPlaced<Scalar>& link,
                             const BasicSpeeds<Scalar>& speed) {
  return speed.origin + speed.omega * normal(point - link.origin);
}

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
  CamContact contact = CamContact::round;
  const Profile* profile = nullptr;  // of a cam; the joint that it belongs to keeps it
  Scalar metre = 1.0;                // of the profile, in the unit of length

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

/// Where a follower touches its cam.
template <class Scalar>
struct BasicTouch {
  Scalar parameter = Profile::anywhere;  // of the profile's curve; next to the one before
  Scalar gap = 0.0;                      // between them, negative where they overlap
  Scalar bend = 0.0;                     // round: curvature of the path of its centre; flat: radius of the profile's
};

/// A pair at a position, global axes.
template <class Scalar>
struct BasicPairPlace {
  BasicVec<Scalar> at;     // where the forces of its rows act on i: its pin, the point where wheels touch
  BasicVec<Scalar> at_j;   // and on j: the same once the pair is closed
  BasicVec<Scalar> seat;   // point_j
  BasicVec<Scalar> apart;  // from the seat to the pin of link i
  BasicVec<Scalar> along;  // the line of link j; of the belt; wheels: from the centre of i towards the other pitch
                           // circle, a unit vector; the tangent of a cam, which runs round it counter-clockwise
  Scalar centres = 0.0;    // wheels: angle of the line of centres, continuous
  BasicTouch<Scalar> touch;
  std::array<BasicPairRow<Scalar>, 3> rows;
};
using PairPlace = BasicPairPlace<double>;

/// Sets the rows that never change.
template <class Scalar>
void prepare(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at);
/// Goes with the links; wheels: to the angle of the line of centres next to the one before; cams: to the contact next
/// to the one before, at first to the nearest of all.
template <class Scalar>
void place(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
           BasicPairPlace<Scalar>& at);
/// Wheels at a closed position: chooses the whole turns of the line of centres.
template <class Scalar>
void count_turns(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                 BasicPairPlace<Scalar>& at);
/// Whether the first of its equations keeps a phase: wheels.
template <class Scalar>
bool has_phase(const BasicPairShape<Scalar>& shape);
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
