// The dimensions, masses and loads of a mechanism, one number each, as stated with a tolerance on a drawing.
#pragma once

#include "lib/mechanism/model/model.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

/// In the units of the model: m, rad, kg, kg m^2, 1, N, N m, and those of springs. Points and mass centres are in the
/// frames of their links. Increasing the coordinate of a driver is equivalent to decreasing its offset, at the same
/// speed.
struct Parameter {
  enum class Dimension {
    point_i_x,  // parameters of joints, to `friction_coefficient`
    point_i_y,
    point_j_x,
    point_j_y,
    direction,
    angle,
    radius_i,
    radius_j,
    pressure_angle,
    pin_radius,
    friction_coefficient,
    mass,  // parameters of links, to `centre_y`
    inertia,
    centre_x,
    centre_y,
    offset,      // parameters of drivers
    spring_i_x,  // parameters of springs, from here on
    spring_i_y,
    spring_j_x,
    spring_j_y,
    rate,
    free,
    damping,
    load_x,  // parameters of loads, in the axes of the load, from here on
    load_y,
    load_moment,
    load_at_x,  // point of action, link frame
    load_at_y,
  };
  Dimension dimension = Dimension::mass;
  std::size_t index = 0;  // index of the joint, link, driver, spring or load

  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// All of these that positions or forces of this mechanism can depend on; gravity, belt tension, the sizes of guides
/// that affect only friction and those of a cam's profile are excluded.
std::vector<Parameter> parameters_of(const Model& model);

template <class Scalar>
Scalar& number(BasicModel<Scalar>& model, const Parameter& parameter) {
  using enum Parameter::Dimension;
  const std::size_t k = parameter.index;
  switch (parameter.dimension) {
    case point_i_x:
      return model.joints[k].point_i.x;
    case point_i_y:
      return model.joints[k].point_i.y;
    case point_j_x:
      return model.joints[k].point_j.x;
    case point_j_y:
      return model.joints[k].point_j.y;
    case direction:
      return model.joints[k].direction;
    case angle:
      return model.joints[k].angle;
    case radius_i:
      return model.joints[k].radius_i;
    case radius_j:
      return model.joints[k].radius_j;
    case pressure_angle:
      return model.joints[k].pressure_angle;
    case pin_radius:
      return model.joints[k].friction.pin_radius;
    case friction_coefficient:
      return model.joints[k].friction.coefficient;
    case mass:
      return model.links[k].mass;
    case inertia:
      return model.links[k].inertia;
    case centre_x:
      return model.links[k].centre.x;
    case centre_y:
      return model.links[k].centre.y;
    case offset:
      return model.drivers[k].offset;
    case spring_i_x:
      return model.springs[k].point_i.x;
    case spring_i_y:
      return model.springs[k].point_i.y;
    case spring_j_x:
      return model.springs[k].point_j.x;
    case spring_j_y:
      return model.springs[k].point_j.y;
    case rate:
      return model.springs[k].rate;
    case free:
      return model.springs[k].free;
    case damping:
      return model.springs[k].damping;
    case load_x:
      return model.loads[k].force.x;
    case load_y:
      return model.loads[k].force.y;
    case load_moment:
      return model.loads[k].moment;
    case load_at_x:
      return model.loads[k].point.x;
    case load_at_y:
      break;
  }
  return model.loads[k].point.y;
}

}  // namespace loadpath::mechanism
