#include "lib/mechanism/spring.hpp"

#include "lib/mechanism/frames.hpp"
#include "lib/numerics/dual.hpp"

#include <cmath>

namespace loadpath::mechanism {

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
  if (span == 0.0) return now;
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

}  // namespace loadpath::mechanism
