#include "lib/sweep/search/neighbours.hpp"

namespace loadpath::sweep {

namespace {

std::vector<double> others(const Variable& variable, double place, int reach) {
  std::vector<double> found;
  if (!variable.is_discrete()) return found;
  const auto last = static_cast<double>(variable.values.size()) - 1.0;
  for (int by = 1; variable.ordered && by <= reach; ++by) {
    if (place - by >= 0.0) found.push_back(place - by);
    if (place + by <= last) found.push_back(place + by);
  }
  for (double word = 0.0; !variable.ordered && word <= last; ++word) {
    if (word != place) found.push_back(word);
  }
  return found;
}

}  // namespace

std::vector<Places> neighbours_of(const std::vector<Variable>& variables, const Places& at, int reach) {
  std::vector<Places> all;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const double place : others(variables[i], at[i], reach)) {
      all.push_back(at);
      all.back()[i] = place;
    }
  }
  return all;
}

std::vector<Places> across(const std::vector<Variable>& variables, const Places& at) {
  std::vector<Places> all;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const double first : others(variables[i], at[i], 1)) {
      for (std::size_t k = i + 1; k < at.size(); ++k) {
        for (const double second : others(variables[k], at[k], 1)) {
          all.push_back(at);
          all.back()[i] = first, all.back()[k] = second;
        }
      }
    }
  }
  return all;
}

}  // namespace loadpath::sweep
