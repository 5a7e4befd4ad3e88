#include "lib/sweep/point/space.hpp"

#include "lib/sweep/point/latin.hpp"
#include "lib/sweep/point/probit.hpp"
#include "lib/sweep/point/uniform.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace loadpath::sweep {

namespace {

constexpr std::uint64_t most_points = std::uint64_t{1} << 63;
// A part of a column is sampled while it is in the cache.
constexpr std::size_t chunk = 1024;

Fault refused(Message message) { return {0, 1, std::move(message), {}}; }

/// The share u of one of `parts` parts of (0, 1); rounding must not reach 1.
double inside_part(std::uint64_t part, double u, std::uint64_t parts) {
  return std::min((static_cast<double>(part) + u) / static_cast<double>(parts), 1.0 - 0x1p-53);
}

/// Calls work(at, n) for runs of at most `longest`, the first of which is `left` long at most.
template <class Work>
void in_runs(std::uint64_t left, std::uint64_t longest, std::size_t n, const Work& work) {
  for (std::size_t at = 0; at < n;) {
    const auto run = static_cast<std::size_t>(std::min<std::uint64_t>(left, n - at));
    work(at, run);
    at += run;
    left = longest;
  }
}

}  // namespace

Outcome<Space> Space::of(std::vector<Level> levels, Random random) {
  Space space;
  if (random.samples == 0) return refused(say("the number of samples must be > 0"));
  if (random.variables.empty() && random.samples != 1) return refused(say("samples are given, and nothing is random"));
  if (random.correlation.size() != 0 && random.correlation.size() != random.variables.size())
    return refused(say("the correlation matrix must have a row for each random variable"));
  space.count_ = random.samples;
  for (std::size_t i = levels.size(); i-- > 0;) {
    if (levels[i].empty()) continue;
    const std::uint64_t size = levels[i].front().size();
    for (const Axis& axis : levels[i]) {
      if (axis.size() != size) {
        return refused(say("values that run together must be as many: {1} and {2}", std::to_string(size),
                           std::to_string(axis.size())));
      }
    }
    if (space.count_ > most_points / size) return refused(say("these are more than 2^63 points"));
    for (std::size_t k = levels[i].size(); k-- > 0;) space.digits_.push_back({std::move(levels[i][k]), space.count_});
    space.count_ *= size;
  }
  if (space.count_ > most_points) return refused(say("these are more than 2^63 points"));
  std::reverse(space.digits_.begin(), space.digits_.end());
  space.random_ = std::move(random);
  return space;
}

void Space::fill(std::uint64_t first, std::size_t n, std::span<double* const> columns) const {
  for (std::size_t k = 0; k < digits_.size(); ++k) {
    const auto& [axis, stride] = digits_[k];
    std::uint64_t value = first / stride % axis.size();
    in_runs(stride - first % stride, stride, n, [&, &on = axis](std::size_t at, std::size_t run) {
      std::fill_n(columns[k] + at, run, on.at(value));
      value = value + 1 == on.size() ? 0 : value + 1;
    });
  }
  if (random_.variables.empty()) return;
  std::vector<double*> part(columns.begin() + static_cast<std::ptrdiff_t>(digits_.size()), columns.end());
  in_runs(chunk, chunk, n, [&](std::size_t at, std::size_t run) {
    sample(first + at, run, part);
    for (double*& column : part) column += run;
  });
}

std::vector<double> Space::point(std::uint64_t index) const {
  std::vector<double> values(variables());
  std::vector<double*> columns;
  for (double& value : values) columns.push_back(&value);
  fill(index, 1, columns);
  return values;
}

void Space::sample(std::uint64_t first, std::size_t n, std::span<double* const> columns) const {
  const auto& variables = random_.variables;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const std::span<double> column{columns[k], n};
    draw(first, k, column);
    if (random_.correlation.correlated(k))
      probit(column, column);
    else
      variables[k].quantile(column, column);
  }
  random_.correlation.apply(columns, n);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const std::span<double> column{columns[k], n};
    if (random_.correlation.correlated(k)) variables[k].of_normal(column, column);
  }
}

/// Probabilities of a variable: each sample of a point of the grid has its own, or its own part of them.
void Space::draw(std::uint64_t first, std::size_t variable, std::span<double> column) const {
  const std::uint64_t samples = random_.samples, within = first % samples;
  std::uint64_t cube = first / samples, at_sample = within;
  in_runs(samples - within, samples, column.size(), [&](std::size_t at, std::size_t run) {
    const auto part = column.subspan(at, run);
    uniform(random_.seed, random_.common ? at_sample : first + at, variable, part);
    if (random_.sampling == Sampling::latin_hypercube) {
      const Permutation stratum(samples, random_.seed, variable, random_.common ? 0 : cube);
      for (std::size_t i = 0; i < run; ++i) part[i] = inside_part(stratum(at_sample + i), part[i], samples);
    }
    ++cube;
    at_sample = 0;
  });
}

}  // namespace loadpath::sweep
