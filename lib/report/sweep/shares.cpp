#include "lib/report/sweep/shares.hpp"

#include "lib/quantity/format.hpp"
#include "lib/sweep/statistics/confidence.hpp"

#include <cmath>

namespace loadpath::report {

std::string in_percent(double share) { return std::isnan(share) ? "-" : format_number(100.0 * share, 3) + " %"; }

std::string share_text(std::uint64_t met, std::uint64_t n, bool is_sample) {
  if (n == 0) return "-";
  const std::string share = in_percent(static_cast<double>(met) / static_cast<double>(n));
  if (!is_sample) return share;
  const sweep::Interval bounds = sweep::share_bounds(met, n, confidence_of_shares);
  return share + " (" + format_number(100.0 * bounds.low, 3) + " to " + in_percent(bounds.high) + ")";
}

}  // namespace loadpath::report
