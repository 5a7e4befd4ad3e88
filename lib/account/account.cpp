#include "lib/account/account.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::account {

bool is_open(const Entry& entry) {
  const auto& si = entry.values().si;
  return entry.word.empty() && !si.empty() && std::all_of(si.begin(), si.end(), [](double x) { return std::isnan(x); });
}

}  // namespace loadpath::account
