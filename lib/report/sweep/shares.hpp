// How a share of points is printed.
#pragma once

#include <cstdint>
#include <string>

namespace loadpath::report {

inline constexpr double confidence_of_shares = 0.95;

/// "12.5 %"; "-" of NaN.
std::string in_percent(double share);

/// "2.1 % (1.9 to 2.3 %)"; without bounds for a grid, which is not a sample.
std::string share_text(std::uint64_t met, std::uint64_t n, bool is_sample);

}  // namespace loadpath::report
