#include "calculators/column/member/length_factor.hpp"

#include "lib/quantity/units.hpp"

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

double length_factor(Ends ends, Basis basis) {
  const bool real = basis == Basis::recommended;
  switch (ends) {
    case Ends::unsaid:
      return unset<double>;
    case Ends::pinned_pinned:
      return 1.0;
    case Ends::fixed_free:
      return real ? 2.1 : 2.0;
    case Ends::fixed_pinned:
      return basis == Basis::exact ? 0.699155659642841 : real ? 0.80 : 0.7;  // pi over the first root of tan u = u
    case Ends::fixed_fixed:
      return real ? 0.65 : 0.5;
    case Ends::fixed_guided:
      return real ? 1.2 : 1.0;
    case Ends::pinned_guided:
      return 2.0;
  }
  return unset<double>;
}

const char* length_factor_reason(Basis basis) {
  switch (basis) {
    case Basis::exact:
      return "pi over the first root of the characteristic equation of the ends";
    case Basis::text:
      return "as the textbook rounds it, [B25]";
    case Basis::recommended:
      return "recommended for real ends, [AISC360]";
  }
  return "";
}

}  // namespace loadpath::column
