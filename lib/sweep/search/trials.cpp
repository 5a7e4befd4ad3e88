#include "lib/sweep/search/trials.hpp"

#include <algorithm>

namespace loadpath::sweep {

Trials::Trials(const Problem& problem, std::uint64_t most)
    : searched(problem),
      budget(most),
      in(problem.function.inputs(), block),
      out(problem.function.outputs(), block),
      row(problem.function.outputs()) {}

template <class PlacesOf, class Take>
void Trials::run(std::size_t n, const PlacesOf& places_of, const Take& take) {
  for (std::size_t first = 0; first < n; first += block) {
    const std::size_t size = std::min(block, n - first);
    for (std::size_t k = 0; k < size; ++k) {
      const Places& at = places_of(first + k);
      for (std::size_t i = 0; i < at.size(); ++i) in[i][k] = searched.variables[i].at(at[i]);
    }
    searched.function.evaluate(in.read(), out.write(), size);
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = out[i][k];
      take(first + k);
    }
  }
  evaluated += n;
}

void Trials::judge(std::span<Trial> trials) {
  run(
      trials.size(), [&](std::size_t k) -> const Places& { return trials[k].at; },
      [&](std::size_t k) { trials[k].standing = sweep::judge(searched, row); });
}

Trial Trials::judged(Places at) {
  Trial trial{std::move(at), {}};
  judge({&trial, 1});
  return trial;
}

std::vector<double> Trials::outputs(std::span<const Places> points) {
  std::vector<double> all;
  all.reserve(points.size() * row.size());
  run(
      points.size(), [&](std::size_t k) -> const Places& { return points[k]; },
      [&](std::size_t) { all.insert(all.end(), row.begin(), row.end()); });
  return all;
}

}  // namespace loadpath::sweep
