// The motion of a pin along its guide, taken apart as the composition of motions does: the pin moves along the guide,
// relative motion, while the guide carries it along, transport motion.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

namespace loadpath::mechanism {

/// The motion of the pin point_i of link i against link j, global axes, m/s and m/s^2. The absolute velocity is v_r +
/// v_e, the absolute acceleration a_r + a_e + a_C. Technical mechanics (in Bulgarian), chapter 31.
struct RelativeMotion {
  double s = 0.0;                    // m: place of the pin from point_j along the guide
  double s_dot = 0.0, s_ddot = 0.0;  // its rates
  Vec along;                         // the guide's direction, a unit vector
  Vec v_r, v_e;                      // relative and transport velocity
  Vec a_r, a_e, a_C;                 // relative, transport and Coriolis acceleration
};

/// Whether the joint is a slot or a slide.
bool is_guided(const Joint& joint);

/// For a slot or a slide.
RelativeMotion relative_motion(const Joint& joint, const Position& at);

}  // namespace loadpath::mechanism
