// The drive as it stands: pulleys and belt to scale.
#pragma once

#include "calculators/belt/geometry.hpp"
#include "lib/figure/figure.hpp"

namespace loadpath::belt {

draw::Figure drive_figure(Length d_1, Length d_2, Length a, Arrangement arrangement);

}  // namespace loadpath::belt
