// The forces of a spring with its damper at a position.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/model/position.hpp"

namespace loadpath::mechanism {

template <class Scalar>
struct BasicSpringNow {
  BasicVec<Scalar> at_i, at_j;  // its ends, global axes
  BasicVec<Scalar> force;       // on link i at its end, the opposite on link j, N
  Scalar couple = 0.0;          // on link i, N m
  Scalar stretch = 0.0;         // beyond its free length, m; turning: of phi_i - phi_j, rad
  Scalar effort = 0.0;          // with which it draws its ends together: N, or N m
};
using SpringNow = BasicSpringNow<double>;

/// If the ends of a spring with a free length or a damper coincide its force has no direction: the force and the
/// effort are NaN there.
template <class Scalar>
BasicSpringNow<Scalar> spring_now(const BasicSpring<Scalar>& spring, const BasicPlaced<Scalar>& i,
                                  const BasicPlaced<Scalar>& j, const BasicSpeeds<Scalar>& speed_i,
                                  const BasicSpeeds<Scalar>& speed_j);
SpringNow spring_now(const Spring& spring, const Position& at);

/// Whether the ends of some spring coincide there, and its force has no direction.
bool some_spring_has_no_direction(const Model& model, const Position& at);

}  // namespace loadpath::mechanism
