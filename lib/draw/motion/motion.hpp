// A moving mechanism in a page: two pictures of the printed position with marked parts, and the numbers that a script
// needs to move them to any other frame.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

struct MotionPictures {
  std::string scheme;  // <svg>: groups with data-carried, data-force, data-name, data-couple
  std::string plan;    // <svg>: a group with data-plan for every link; empty if there is no plan
  std::string data;    // JSON of numbers only: it cannot contain a user's text
};

/// `figure` holds a Motion.
MotionPictures motion_pictures(const figure::Figure& figure);

}  // namespace loadpath::draw
