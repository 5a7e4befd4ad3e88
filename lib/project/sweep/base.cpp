#include "lib/project/sweep/base.hpp"

#include <algorithm>

namespace loadpath::project {

double middle_of(const SweptInput& input) {
  if (input.distribution) return input.distribution->mean();
  return input.axis.at(input.words.empty() ? input.axis.size() / 2 : 0);
}

double low_of(const SweptInput& input) {
  if (input.distribution) return input.distribution->quantile(0.05);
  return std::min(input.axis.at(0), input.axis.at(input.axis.size() - 1));
}

double high_of(const SweptInput& input) {
  if (input.distribution) return input.distribution->quantile(0.95);
  return std::max(input.axis.at(0), input.axis.at(input.axis.size() - 1));
}

double sd_of(const SweptInput& input) { return input.distribution ? input.distribution->sd() : 0.0; }

bool is_continuous(const SweptInput& input) {
  return input.distribution && std::holds_alternative<sweep::Uniform>(input.distribution->law());
}

std::vector<double> middles_of(const std::vector<SweptInput>& inputs) {
  std::vector<double> middles;
  middles.reserve(inputs.size());
  for (const SweptInput& input : inputs) middles.push_back(middle_of(input));
  return middles;
}

}  // namespace loadpath::project
