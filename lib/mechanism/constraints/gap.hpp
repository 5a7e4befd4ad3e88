// The gap that remains open in a mechanism.
#pragma once

namespace loadpath::mechanism {

/// After a failure: the joint with the widest gap when the mechanism is closed as far as possible, and the part of
/// the last move, 0 to 1, up to which it closes.
struct Gap {
  int joint = -1;
  double size = 0.0;  // m
  double reached = 0.0;
};

}  // namespace loadpath::mechanism
