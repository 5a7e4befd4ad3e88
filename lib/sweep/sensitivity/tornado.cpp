#include "lib/sweep/sensitivity/tornado.hpp"

#include "lib/sweep/column_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::sweep {

namespace {

Bar bar_of(std::size_t input, double base, double low, double high) {
  Bar bar{input, low, high, std::numeric_limits<double>::quiet_NaN(), false};
  const auto [least, most] = std::minmax({low, base, high});
  if (std::isfinite(low) && std::isfinite(base) && std::isfinite(high)) {
    bar.swing = most - least;
    bar.turns = base < std::min(low, high) || base > std::max(low, high);
  }
  return bar;
}

bool before(const Bar& a, const Bar& b) {
  if (std::isnan(a.swing) != std::isnan(b.swing)) return std::isnan(a.swing);
  return a.swing > b.swing;
}

}  // namespace

std::vector<Tornado> tornado(Function& function, const std::vector<double>& base, const std::vector<double>& lows,
                             const std::vector<double>& highs) {
  const std::size_t k = base.size(), n = 2 * k + 1;
  Columns in(k, n), out(function.outputs(), n);
  for (std::size_t i = 0; i < k; ++i) {
    std::fill_n(in[i], n, base[i]);
    in[i][2 * i + 1] = lows[i], in[i][2 * i + 2] = highs[i];
  }
  function.evaluate(in.read(), out.write(), n);
  std::vector<Tornado> all;
  for (std::size_t o = 0; o < function.outputs(); ++o) {
    Tornado& next = all.emplace_back();
    next.base = out[o][0];
    for (std::size_t i = 0; i < k; ++i) next.bars.push_back(bar_of(i, next.base, out[o][2 * i + 1], out[o][2 * i + 2]));
    std::stable_sort(next.bars.begin(), next.bars.end(), before);
  }
  return all;
}

}  // namespace loadpath::sweep
