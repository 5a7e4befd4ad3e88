// The two bodies of a pair in the transverse plane, for pictures.
#pragma once

#include "calculators/gear/outline.hpp"
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

/// Gear 1 at the origin, the middle of a tooth along x.
[[nodiscard]] Body first_body(const PairInput& in, const PairResult& r);
/// Gear 2 at its centre distance, on the right, of a ring on the left; the middle of a space faces that tooth.
[[nodiscard]] Body second_body(const PairInput& in, const PairResult& r);

/// A closed polygon close to a circle.
[[nodiscard]] std::vector<figure::Point> rim_of(figure::Point centre, double radius);

}  // namespace loadpath::gear
