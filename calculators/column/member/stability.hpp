// The elastic buckling of a uniform bar with springs at its ends and rigid supports between them.
//
// The exact stiffness of a bar under a compressive force is transcendental in u = l sqrt(F/(E I)); the smallest u at
// which it is singular, or the u of a higher mode, is found by counting eigenvalues (Wittrick and Williams), which
// misses none. Small elastic deflections, a force that keeps its direction, no deflection of the supports between the
// ends.
#pragma once

#include "lib/calculator/list.hpp"

#include <limits>
#include <vector>

namespace loadpath::column {

inline constexpr std::size_t most_supports = 8;
inline constexpr double held = std::numeric_limits<double>::infinity();

/// The springs of one end over those of the bar: k l^3/(E I) across it and c l/(E I) against turning; infinite: held.
struct End {
  double across = held;
  double turning = 0.0;
};

struct Bar {
  End start, end;
  List<double, most_supports> supports;  // x/l of rigid supports across the bar, ascending, between 0 and 1
};

/// u = l sqrt(F/(E I)) at the critical force of a mode, 1 at the smallest: pi for hinged ends. NaN where the bar moves
/// without a load.
double buckling_parameter(const Bar& bar, int mode = 1);

/// Deflections of the mode at u at even steps in each span, the largest 1; x is x/l.
struct Shape {
  std::vector<double> x, w;
};
Shape buckled_shape(const Bar& bar, double u);

}  // namespace loadpath::column
