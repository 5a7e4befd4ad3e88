// The constraints of a joint, or a drive, on its two links, for every kind in one place: its equations as forces and
// couples that do no work in the permitted motions, its gap, and the part of its acceleration due to the velocities.
#pragma once

#include "lib/mechanism/model/pair_place.hpp"

#include <cstddef>
#include <span>
#include <type_traits>

namespace loadpath::mechanism {

template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicJoint<Scalar>& joint);
/// The pair of a drive; a sliding one acts on this joint.
template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicDriver<Scalar>& driver, const BasicJoint<Scalar>* joint);

template <class Scalar>
RowPattern pattern_of(const BasicPairShape<Scalar>& shape, std::size_t row);

/// Sets the rows that never change.
template <class Scalar>
void prepare(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at);
/// Goes with the links; wheels: to the angle of the line of centres next to the one before; cams: to the contact next
/// to the one before, at first to the nearest of all.
template <class Scalar>
void place(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
           BasicPairPlace<Scalar>& at);
/// Wheels at a closed position: chooses the full revolutions of the line of centres.
template <class Scalar>
void count_turns(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                 BasicPairPlace<Scalar>& at);
/// Whether the first of its equations keeps a phase: wheels.
template <class Scalar>
bool has_phase(const BasicPairShape<Scalar>& shape);
/// Sets the phase of every joint that has one to its value at the stated poses.
template <class Scalar>
void take_phases(BasicModel<Scalar>& model);
/// The residual of each equation; `target`: the required coordinate of a drive.
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
