#include "lib/sweep/search/spread.hpp"

#include <cmath>

namespace loadpath::sweep {

Spread::Spread(std::size_t dimensions) {
  double root = 2.0;
  for (int i = 0; i < 60; ++i) root = std::pow(1.0 + root, 1.0 / (static_cast<double>(dimensions) + 1.0));
  double step = 1.0;
  for (std::size_t i = 0; i < dimensions; ++i) steps.push_back(step /= root);
}

double Spread::operator()(std::uint64_t index, std::size_t dimension) const {
  const double sum = 0.5 + static_cast<double>(index) * steps[dimension];
  return sum - std::floor(sum);
}

}  // namespace loadpath::sweep
