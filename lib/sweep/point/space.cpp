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

Message refusal_of(const Space::Random& random) {
  const std::size_t variables = random.variables.size(), rows = random.correlation.size();
  if (random.samples == 0) return say("the number of samples must be > 0");
  if (random.samples > most_points) return say("these are more than 2^63 points");
  if (variables == 0 && random.samples != 1) return say("samples are given, and nothing is random");
  if (rows != 0 && rows != variables) return say("the correlation matrix must have a row for each random variable");
  if (random.sampling == Sampling::sobol &&
      (variables > Sobol::most_variables || random.samples > Sobol::most_samples)) {
    return say("a Sobol sequence has {1} variables and 2^52 samples at most", std::to_string(Sobol::most_variables));
  }
  return {};
}

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
  if (Message message = refusal_of(random); !message.empty()) return refused(std::move(message));
  Space space;
  space.count_ = random.samples;
  for (std::size_t i = levels.size(); i-- > 0;) {
    if (Message message = space.put_above(std::move(levels[i])); !message.empty()) return refused(std::move(message));
  }
  std::reverse(space.digits_.begin(), space.digits_.end());
  if (random.sampling == Sampling::sobol) space.sobol_ = Sobol(random.variables.size(), random.seed);
  space.random_ = std::move(random);
  return space;
}

/// Adds a level slower than the existing ones; the digits are in reverse order until all levels are there.
Message Space::put_above(Level level) {
  if (level.empty()) return {};
  const std::uint64_t size = level.front().size();
  for (const Axis& axis : level) {
    if (axis.size() == size) continue;
    return say("values varied in parallel must be equal in number: {1} and {2}", std::to_string(size),
               std::to_string(axis.size()));
  }
  if (count_ > most_points / size) return say("these are more than 2^63 points");
  std::for_each(level.rbegin(), level.rend(), [&](Axis& axis) { digits_.push_back({std::move(axis), count_}); });
  count_ *= size;
  return {};
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
  std::vector<double*> columns(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) columns[k] = &values[k];
  fill(index, 1, columns);
  return values;
}

std::uint64_t Space::first_at(std::span<const std::uint64_t> values) const {
  std::uint64_t first = 0;
  for (std::size_t k = 0; k < digits_.size(); ++k) {
    const bool runs_along = k > 0 && digits_[k].stride == digits_[k - 1].stride;  // or it is a single value
    if (!runs_along) first += values[k] * digits_[k].stride;
  }
  return first;
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
    draw_run(variable, first + at, random_.common ? 0 : cube, at_sample, column.subspan(at, run));
    ++cube;
    at_sample = 0;
  });
}

/// Samples that follow one another at one point of the grid.
void Space::draw_run(std::size_t variable, std::uint64_t first, std::uint64_t cube, std::uint64_t sample,
                     std::span<double> column) const {
  if (random_.sampling == Sampling::sobol) {
    sobol_.fill(variable, sample, cube, column);
    return;
  }
  uniform(random_.seed, random_.common ? sample : first, variable, column);
  if (random_.sampling == Sampling::random) return;
  const Permutation stratum(random_.samples, random_.seed, variable, cube);
  for (double& u : column) u = inside_part(stratum(sample++), u, random_.samples);
}

}  // namespace loadpath::sweep
