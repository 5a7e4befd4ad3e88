#include "lib/mechanism/model/cam.hpp"

#include "lib/numerics/dual.hpp"

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

template <class Scalar>
Vec value_of(const BasicVec<Scalar>& v) {
  return {numerics::value_of(v.x), numerics::value_of(v.y)};
}

/// The nearest point of the curve: found in numbers; one step more brings the derivatives.
template <class Scalar>
BasicCurvePoint<Scalar> nearest(const Profile& profile, BasicVec<Scalar> pin, Scalar& parameter) {
  parameter = profile.nearest(value_of(pin), numerics::value_of(parameter));
  BasicCurvePoint<Scalar> on = profile.at(parameter);
  if constexpr (!std::is_same_v<Scalar, double>) {
    const BasicVec<Scalar> away = pin - on.at;
    parameter += dot(on.tangent, away) / (on.pace + on.turning * dot(outward(on.tangent), away));
    on = profile.at(parameter);
  }
  return on;
}

/// The point of the curve with this normal direction, likewise.
template <class Scalar>
BasicCurvePoint<Scalar> facing(const Profile& profile, BasicVec<Scalar> out, Scalar& parameter) {
  parameter = profile.facing(value_of(out), numerics::value_of(parameter));
  BasicCurvePoint<Scalar> on = profile.at(parameter);
  if constexpr (!std::is_same_v<Scalar, double>) {
    parameter += cross(outward(on.tangent), out) / on.turning;
    on = profile.at(parameter);
  }
  return on;
}

/// Offset by its radius from the profile, which lies inside the curve.
template <class Scalar>
void place_round(const BasicPairShape<Scalar>& shape, const BasicTurn<Scalar>& turned, BasicPairPlace<Scalar>& at) {
  const BasicVec<Scalar> pin = (1.0 / shape.metre) * turned.back()(at.apart);
  const auto on = nearest<Scalar>(*shape.profile, pin, at.touch.parameter);
  const Scalar distance = shape.radius_i / shape.metre - shape.profile->inset();
  at.touch.gap = shape.metre * (dot(outward(on.tangent), pin - on.at) - distance);
  at.touch.bend = on.turning / ((on.pace + on.turning * distance) * shape.metre);
  at.along = turned(on.tangent);
  at.rows[0].e = outward(at.along);
  at.at = at.at - shape.radius_i * at.rows[0].e;
}

template <class Scalar>
void place_flat(const BasicPairShape<Scalar>& shape, const BasicTurn<Scalar>& turned, const BasicPlaced<Scalar>& i,
                BasicPairPlace<Scalar>& at) {
  const double inset = shape.profile->inset();
  at.along = -i.turned(shape.turned(BasicVec<Scalar>{1.0, 0.0}));
  at.rows[0].e = outward(at.along);
  const BasicVec<Scalar> out = turned.back()(at.rows[0].e);
  const auto on = facing<Scalar>(*shape.profile, out, at.touch.parameter);
  const BasicVec<Scalar> flank = shape.metre * turned(on.at - inset * out);
  at.touch.gap = dot(at.rows[0].e, at.apart - flank);
  at.touch.bend = shape.metre * (on.pace / on.turning - inset);
  at.at = at.seat + flank;
}

}  // namespace

template <class Scalar>
void place_cam(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
               BasicPairPlace<Scalar>& at) {
  const BasicTurn<Scalar> turned = j.turned * BasicTurn<Scalar>{shape.line.x, shape.line.y};
  if (shape.contact == CamContact::flat) return place_flat(shape, turned, i, at);
  place_round(shape, turned, at);
}

// The centre of a roller moves on its path, which rotates with the cam; a face slides on the profile, and rolls.
template <class Scalar>
Scalar acceleration_on_cam(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at,
                           const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                           const BasicSpeeds<Scalar>& speed_i, const BasicSpeeds<Scalar>& speed_j) {
  const bool flat = shape.contact == CamContact::flat;
  const BasicVec<Scalar> place = flat ? at.at : at.seat + at.apart;
  const Scalar sliding = dot(at.along, velocity_at(place, i, speed_i) - velocity_at(place, j, speed_j));
  if (flat) {
    const Scalar turning = speed_i.omega - speed_j.omega;
    return at.touch.bend * turning * turning - 2.0 * speed_i.omega * sliding;
  }
  return -2.0 * speed_j.omega * sliding - at.touch.bend * sliding * sliding +
         shape.radius_i * (speed_i.omega * speed_i.omega - speed_j.omega * speed_j.omega);
}

template void place_cam(const BasicPairShape<double>&, const BasicPlaced<double>&, const BasicPlaced<double>&,
                        BasicPairPlace<double>&);
template double acceleration_on_cam(const BasicPairShape<double>&, const BasicPairPlace<double>&,
                                    const BasicPlaced<double>&, const BasicPlaced<double>&, const BasicSpeeds<double>&,
                                    const BasicSpeeds<double>&);
template void place_cam(const BasicPairShape<Dual>&, const BasicPlaced<Dual>&, const BasicPlaced<Dual>&,
                        BasicPairPlace<Dual>&);
template Dual acceleration_on_cam(const BasicPairShape<Dual>&, const BasicPairPlace<Dual>&, const BasicPlaced<Dual>&,
                                  const BasicPlaced<Dual>&, const BasicSpeeds<Dual>&, const BasicSpeeds<Dual>&);

}  // namespace loadpath::mechanism
