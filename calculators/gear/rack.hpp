// The rack that a gear is cut by.
#pragma once

namespace loadpath::gear {

/// In one plane: its dedendum becomes the root of the tooth. Lengths in modules.
struct Rack {
  double alpha = 0.0;  // pressure angle, rad
  double h_f = 0.0;    // dedendum
  double rho = 0.0;    // radius of its rounded corner
};

}  // namespace loadpath::gear
