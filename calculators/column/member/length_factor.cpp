#include "calculators/column/member/length_factor.hpp"

namespace loadpath::column {

Bar bar_of(Ends ends) {
  constexpr End pinned{held, 0.0}, fixed{held, held}, guided{0.0, held}, free{0.0, 0.0};
  switch (ends) {
    case Ends::unsaid:
    case Ends::pinned_pinned:
      return {pinned, pinned, {}};
    case Ends::fixed_free:
      return {fixed, free, {}};
    case Ends::fixed_pinned:
      return {fixed, pinned, {}};
    case Ends::fixed_fixed:
      return {fixed, fixed, {}};
    case Ends::fixed_guided:
      return {fixed, guided, {}};
    case Ends::pinned_guided:
      return {pinned, guided, {}};
  }
  return {};
}

}  // namespace loadpath::column
