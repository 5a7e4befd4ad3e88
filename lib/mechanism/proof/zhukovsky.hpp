// The proof by Zhukovsky's lever: the plan of velocities, turned by a right angle, is a lever about its pole that the
// forces, carried over to the images of their points without being turned, keep in balance.
#pragma once

#include "lib/mechanism/proof/instant.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

/// The plan for one driver that moves by itself at 1 rad/s or 1 m/s. Images are in m for a rotary driver and plain
/// ratios for a linear one; the pole is at the origin. Rotated clockwise: the moment about the pole is the power.
struct ZhukovskyLever {
  /// A force at the image of its point. A couple is a pair of forces at two points of its link.
  struct Force {
    ActiveForce::Kind kind;
    std::size_t index;  // as in ActiveForce
    std::size_t link;
    bool of_couple;
    Vec image;
    Vec force;         // N
    double arm = 0.0;  // lever arm of the force about the pole, positive counter-clockwise
  };
  std::vector<Force> forces;
  double effort = 0.0;  // balancing effort, N m or N
};

void find_lever(const Instant& instant, std::size_t driver, ZhukovskyLever& lever);

/// The image of the point of a link in that plan; `arm`: from the origin of the link's frame, global axes, m.
Vec image(const Instant& instant, std::size_t driver, std::size_t link, Vec arm);

}  // namespace loadpath::mechanism
