#include "lib/project/sweep/ranges.hpp"

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

bool is_continuous(const SweptInput& input) { return input.distribution && sweep::is_design(*input.distribution); }

std::vector<double> middles_of(const std::vector<SweptInput>& inputs) {
  std::vector<double> middles;
  middles.reserve(inputs.size());
  for (const SweptInput& input : inputs) middles.push_back(middle_of(input));
  return middles;
}

std::vector<double> correlation_matrix(const std::vector<SweptInput>& inputs, const std::vector<std::size_t>& among,
                                       const std::vector<Correlated>& pairs) {
  const std::size_t n = among.size();
  std::vector<double> matrix(n * n);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1.0;
  const auto place = [&](const Placed& name) {
    const auto found =
        std::find_if(among.begin(), among.end(), [&](std::size_t i) { return inputs[i].name == name.text; });
    return static_cast<std::size_t>(found - among.begin());
  };
  for (const Correlated& pair : pairs) {
    const std::size_t i = place(pair.first), j = place(pair.second);
    if (i < n && j < n) matrix[i * n + j] = matrix[j * n + i] = pair.r;
  }
  return matrix;
}

}  // namespace loadpath::project
