// A joint or a drive between two links as numbers: its shape, where its links are, and where it is itself.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <array>
#include <cstddef>

namespace loadpath::mechanism {

/// The pose of a link's frame, global axes.
template <class Scalar>
struct BasicPlaced {
  BasicTurn<Scalar> turned;
  BasicVec<Scalar> origin;
  Scalar phi = 0.0;
  [[nodiscard]] BasicVec<Scalar> point(BasicVec<Scalar> own) const { return origin + turned(own); }
};
using Placed = BasicPlaced<double>;

/// The motion of a link's frame.
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

/// Data common to joints and drives; the numbers of a Joint, ready for use.
template <class Scalar>
struct BasicPairShape {
  using Kind = PairKind;
  Kind kind = Kind::joint;
  JointKind joint = JointKind::revolute;
  BasicVec<Scalar> point_i, point_j;  // frames of i and j
  BasicVec<Scalar> line{1.0, 0.0};    // frame of j
  Scalar angle = 0.0;                 // prismatic and rigid: of i against j
  BasicTurn<Scalar> turned;           // the same
  Scalar radius_i = 0.0;              // radii of the wheels
  Scalar radius_j = 0.0;
  Scalar phase = 0.0;   // wheels: constant of rolling, m
  Scalar offset = 0.0;  // offset of a drive
  CamContact contact = CamContact::round;
  const Profile* profile = nullptr;  // profile of a cam; owned by the joint
  Scalar metre = 1.0;                // profile: 1 m in the unit of length

  [[nodiscard]] std::size_t rows() const {
    return kind == Kind::joint ? static_cast<std::size_t>(constraint_count(joint)) : 1;
  }
};
using PairShape = BasicPairShape<double>;

/// One equation: a force of 1 along e and a couple m on link i, the opposite on link j.
template <class Scalar>
struct BasicPairRow {
  BasicVec<Scalar> e;
  Scalar m = 0.0;
};
using PairRow = BasicPairRow<double>;

/// The values of a row that can differ from zero.
struct RowPattern {
  bool x = true, y = true, phi = true;
};
/// The contact of a follower with its cam.
template <class Scalar>
struct BasicTouch {
  Scalar parameter = Profile::anywhere;  // parameter of the profile's curve; nearest to the previous one
  Scalar gap = 0.0;                      // between them, negative where they overlap
  Scalar bend = 0.0;                     // round: curvature of the path of its centre; flat: radius of the profile's
};

/// A pair at a position, global axes.
template <class Scalar>
struct BasicPairPlace {
  BasicVec<Scalar> at;     // point of action of its rows' forces on i: its pin, the contact of wheels
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

}  // namespace loadpath::mechanism
