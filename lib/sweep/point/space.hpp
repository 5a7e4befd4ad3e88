// The points of a sweep: a grid of levels, and samples of uncertain inputs at each of its points.
//
// A point is a pure function of its index: the digits of the index select the values of the grid, the first level
// being the slowest, and random values come from a counter-based generator. So points can be made in any order, by
// any number of threads and computers, and repeated.
#pragma once

#include "lib/sweep/point/axis.hpp"
#include "lib/sweep/point/correlation.hpp"
#include "lib/sweep/point/distribution.hpp"
#include "lib/sweep/point/sobol.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::sweep {

enum class Sampling {
  random,           // plain Monte Carlo
  latin_hypercube,  // each variable once in each of `samples` parts of equal probability
  sobol,            // all variables together spread evenly, best with a power of two of samples
};

class Space {
 public:
  struct Random {
    std::vector<Distribution> variables;
    Correlation correlation;    // empty, or of the size of `variables`
    std::uint64_t samples = 1;  // at each point of the grid
    std::uint64_t seed = 0;
    Sampling sampling = Sampling::random;
    bool common = false;  // the same samples at each point of the grid; else others at each
  };
  using Level = std::vector<Axis>;  // they run together, and have as many values

  /// One point without variables.
  Space() = default;
  static Outcome<Space> of(std::vector<Level> levels, Random random);

  /// Variables in their order: those of the levels, one level after the other, then the random ones.
  [[nodiscard]] std::size_t variables() const { return digits_.size() + random_.variables.size(); }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Of the random variables at each point of the grid, successive points; 1 without random variables.
  [[nodiscard]] std::uint64_t samples() const { return random_.variables.empty() ? 1 : random_.samples; }
  /// A column for each variable takes the values of the points first ... first + n - 1.
  void fill(std::uint64_t first, std::size_t n, std::span<double* const> columns) const;
  [[nodiscard]] std::vector<double> point(std::uint64_t index) const;
  /// The first of the points at a place of the grid: the number of the value of each variable of the levels. Of
  /// variables that run together the first decides.
  [[nodiscard]] std::uint64_t first_at(std::span<const std::uint64_t> values) const;

 private:
  struct Digit {
    Axis axis;
    std::uint64_t stride;  // number of points for which it is constant
  };
  Message put_above(Level level);
  void sample(std::uint64_t first, std::size_t n, std::span<double* const> columns) const;
  void draw(std::uint64_t first, std::size_t variable, std::span<double> column) const;
  void draw_run(std::size_t variable, std::uint64_t first, std::uint64_t cube, std::uint64_t sample,
                std::span<double> column) const;

  std::vector<Digit> digits_;
  Random random_;
  Sobol sobol_;
  std::uint64_t count_ = 1;
};

}  // namespace loadpath::sweep
