#include "calculators/machine/law_period.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::machine {

namespace {

constexpr std::array eighths{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
/// Multiples of the period after which a law may repeat. One that is written for a single period repeats after none.
constexpr std::array longer_periods{2, 3, 4, 5, 6, 8};

}  // namespace

std::optional<Unrepeated> unrepeated(const Law& law, double period) {
  const auto at = [&](double periods) { return law.at(period * periods).value; };
  const double first = at(0.0), last = at(1.0 - 1e-12);
  double most = std::max(std::abs(first), std::abs(last));
  for (const double share : eighths) most = std::max(most, std::abs(at(share)));
  const auto differ = [&](double one, double other) { return std::abs(one - other) > 1e-6 * most; };
  if (differ(first, last)) return Unrepeated{true, period, last, first};
  for (const double share : eighths) {
    const auto repeats = [&](int periods) { return !differ(at(periods + share), at(share)); };
    if (!repeats(1) && std::ranges::any_of(longer_periods, repeats))
      return Unrepeated{false, period * share, at(share), at(1.0 + share)};
  }
  return std::nullopt;
}

}  // namespace loadpath::machine
