#include "lib/mechanism/model/spring.hpp"

#include "lib/mechanism/model/frames.hpp"
#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A span negligible against the sizes of the spring: the rounding errors have no direction.
template <class Scalar>
bool coincide(const Scalar& span, const BasicSpring<Scalar>& spring) {
  using std::sqrt;
  const Scalar size =
      sqrt(spring.free * spring.free + dot(spring.point_i, spring.point_i)) + sqrt(dot(spring.point_j, spring.point_j));
  return !(span > 1e-9 * size);
}

}  // namespace

template <class Scalar>
BasicSpringNow<Scalar> spring_now(const BasicSpring<Scalar>& spring, const BasicPlaced<Scalar>& i,
                                  const BasicPlaced<Scalar>& j, const BasicSpeeds<Scalar>& speed_i,
                                  const BasicSpeeds<Scalar>& speed_j) {
  using std::sqrt;
  BasicSpringNow<Scalar> now{.at_i = i.point(spring.point_i), .at_j = j.point(spring.point_j), .force = {}};
  if (spring.kind == SpringKind::turning) {
    now.stretch = i.phi - j.phi - spring.free;
    now.effort = spring.rate * now.stretch + spring.damping * (speed_i.omega - speed_j.omega);
    now.couple = -now.effort;
    return now;
  }
  const BasicVec<Scalar> apart = now.at_i - now.at_j;
  const Scalar span = sqrt(dot(apart, apart));
  now.stretch = span - spring.free;
  const bool vanishes =
      spring.damping == 0.0 && (spring.rate == 0.0 || spring.free == 0.0);  // its force, with the span
  if (coincide(span, spring)) {
    if (vanishes) return now;
    now.effort = none;
    now.force = {none, none};
    return now;
  }
  const BasicVec<Scalar> along = (1.0 / span) * apart;
  const BasicVec<Scalar> speed = speed_i.origin + speed_i.omega * normal(now.at_i - i.origin) - speed_j.origin -
                                 speed_j.omega * normal(now.at_j - j.origin);
  now.effort = spring.rate * now.stretch + spring.damping * dot(along, speed);
  now.force = -now.effort * along;
  return now;
}

template SpringNow spring_now(const Spring&, const Placed&, const Placed&, const Speeds&, const Speeds&);
template BasicSpringNow<Dual> spring_now(const BasicSpring<Dual>&, const BasicPlaced<Dual>&, const BasicPlaced<Dual>&,
                                         const BasicSpeeds<Dual>&, const BasicSpeeds<Dual>&);

SpringNow spring_now(const Spring& spring, const Position& at) {
  return spring_now(spring, placed_at(at, spring.i), placed_at(at, spring.j), speeds_at(at, spring.i),
                    speeds_at(at, spring.j));
}

bool some_spring_has_no_direction(const Model& model, const Position& at) {
  return std::any_of(model.springs.begin(), model.springs.end(),
                     [&](const Spring& spring) { return std::isnan(spring_now(spring, at).effort); });
}

}  // namespace loadpath::mechanism
