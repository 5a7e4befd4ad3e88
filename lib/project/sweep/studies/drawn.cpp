#include "lib/project/sweep/studies/drawn.hpp"

#include "lib/project/sweep/ranges.hpp"

namespace loadpath::project {

DrawnSamples::DrawnSamples(const std::vector<SweptInput>& inputs, const SweepSettings& settings,
                           std::vector<Issue>& issues) {
  std::vector<SweptInput> drawn;
  std::vector<std::size_t> chosen_as;  // input among the chosen ones
  std::size_t chosen = 0;
  for (const SweptInput& input : inputs) {
    if (!is_continuous(input)) {
      drawn.push_back(input);
      chosen_as.push_back(chosen);
    }
    if (is_continuous(input) || !input.distribution) ++chosen;
  }
  std::vector<std::size_t> variables;
  space_ = space_of(drawn, settings, variables, issues);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i].distribution)
      uncertain_.push_back(variables[i]);
    else
      digits_.push_back({chosen_as[i], variables[i], drawn[i].axis});
  }
}

std::uint64_t DrawnSamples::first_of(std::span<const double> chosen) const {
  std::vector<std::uint64_t> places(digits_.size());
  for (const Digit& digit : digits_) {
    std::uint64_t& place = places[digit.variable];
    while (place + 1 < digit.axis.size() && digit.axis.at(place) != chosen[digit.chosen]) ++place;
  }
  return space_.first_at(places);
}

void DrawnSamples::fill(std::uint64_t first, std::size_t n, std::span<double* const> columns) const {
  std::vector<std::vector<double>> others(digits_.size(), std::vector<double>(n));
  std::vector<double*> all(digits_.size() + uncertain_.size());
  for (std::size_t k = 0; k < digits_.size(); ++k) all[k] = others[k].data();
  for (std::size_t k = 0; k < uncertain_.size(); ++k) all[uncertain_[k]] = columns[k];
  if (!uncertain_.empty()) space_.fill(first, n, all);
}

}  // namespace loadpath::project
