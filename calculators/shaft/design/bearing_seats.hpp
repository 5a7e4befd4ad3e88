// What a shaft offers the inner ring of a bearing: its diameter, the room on the segment, and the shoulder.
#pragma once

#include "calculators/shaft/design/model/input.hpp"

namespace loadpath::shaft {

struct BearingSeat {
  Length d = unset<Length>;
  Length l = unset<Length>;  // width of a ring centred there; unset at an end of the shaft, where no seat is drawn
  Length r_f = unset<Length>, d_f = unset<Length>;  // of the nearer shoulder; unset if neither end has one
};

/// All unset on a taper, which does not determine the bore.
BearingSeat bearing_seat(const DesignInput& in, const Support& support);

}  // namespace loadpath::shaft
