// A cam and its follower as a pair (pair_place.hpp): their contact, and the part of the follower's acceleration due
// to the shape of the profile.
#pragma once

#include "lib/mechanism/model/pair_place.hpp"

namespace loadpath::mechanism {

/// The contact of a cam, with given profile and pin: nearest to the previous one, its row, the point of action of its
/// force.
template <class Scalar>
void place_cam(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
               BasicPairPlace<Scalar>& at);

/// As held_acceleration, along the normal of the contact.
template <class Scalar>
Scalar acceleration_on_cam(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at,
                           const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                           const BasicSpeeds<Scalar>& speed_i, const BasicSpeeds<Scalar>& speed_j);

}  // namespace loadpath::mechanism
