// A group of links in the structure of a mechanism.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::mechanism {

/// Links that only hold together: none of them has its place before the others have theirs.
struct Group {
  std::vector<std::size_t> links;    // ascending
  std::vector<std::size_t> joints;   // inside, and to the ground or to earlier groups; ascending
  std::vector<std::size_t> drivers;  // drivers that move it; empty for an Assur group
  /// Numbers of joints with two constraints and with one: statically determinate when 3 n = 2 p5 + p4 + drivers.
  int p5 = 0;
  int p4 = 0;
  /// By the closed contour with most sides, as in Artobolevsky: 1 for an initial link, 2 for a dyad, 3 if a link
  /// carries three pairs, 4 if four links form a loop. A pin in a slot counts as the equivalent slider.
  int contour_class = 0;
  int order = 0;     // number of joints by which it is attached
  std::string kind;  // type of a dyad: "RRP", its joints from end to end; else empty
};

}  // namespace loadpath::mechanism
