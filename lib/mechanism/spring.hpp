// What a spring with its damper does at a position.
#pragma once

#include "lib/mechanism/model.hpp"
#include "lib/mechanism/pair.hpp"
#include "lib/mechanism/position.hpp"

namespace loadpath::mechanism {

struct SpringNow {
  Vec at_i, at_j;        // its ends, global axes
  Vec force;             // on link i at its end, the opposite on link j, N
  double couple = 0.0;   // on link i, N m
  double stretch = 0.0;  // beyond its free length, m; turning: of phi_i - phi_j, rad
  double effort = 0.0;   // with which it draws its ends together: N, or N m
};

/// A spring whose ends coincide pulls nowhere.
SpringNow spring_now(const Spring& spring, const Placed& i, const Placed& j, const Speeds& speed_i,
                     const Speeds& speed_j);
SpringNow spring_now(const Spring& spring, const Position& at);

}  // namespace loadpath::mechanism
