// The objective of a design under scatter: quantiles and shares of the outputs as outputs, to be minimised.
#pragma once

#include "lib/sweep/column_block.hpp"
#include "lib/sweep/function.hpp"
#include "lib/sweep/sensitivity/sampler.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::sweep {

/// The role of an input of the inner function: a design variable, scatter, or the sum of both.
struct Scattered {
  std::optional<std::size_t> design;   // an input of the robust function
  std::optional<std::size_t> scatter;  // a column of the sampler
  bool relative = false;               // design * (1 + scatter); else design + scatter
};

struct Statistic {
  enum class Kind {
    mean,
    deviation,  // the standard deviation, over the number less one
    quantile,   // p; linear between the sorted samples (definition 7 of Hyndman and Fan 1996)
    above_one,  // the share of samples that are above 1, or not available, over the share p that is allowed
    not_one     // the same for a flag that is not 1
  };
  std::size_t output = 0;
  Kind kind = Kind::mean;
  double p = 0.0;
};

/// The number of the first sample of a design.
using FirstSample = std::function<std::uint64_t(std::span<const double> design)>;

/// The same samples at every point (common random numbers), so that it is as smooth as the inner function, unless
/// `first` gives others. If a sample is not available, neither are mean, deviation and quantiles.
class Robust : public Function {
 public:
  Robust(Function& inner, std::size_t designs, std::vector<Scattered> inputs, std::size_t columns, Sampler sampler,
         std::size_t samples, std::vector<Statistic> statistics, FirstSample first = {});

  [[nodiscard]] std::size_t inputs() const override { return designs_; }
  [[nodiscard]] std::size_t outputs() const override { return statistics_.size(); }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override;

 private:
  void draw(std::span<const double* const> in, std::size_t k);
  [[nodiscard]] double value_of(const Statistic& statistic);

  Function& inner_;
  std::size_t designs_, samples_;
  std::vector<Scattered> from_;
  std::vector<Statistic> statistics_;
  Sampler sampler_;
  FirstSample first_;
  std::uint64_t drawn_ = 0;  // the first of the samples in the columns
  Columns scatter_, in_, out_;
  std::vector<double> sorted_;
};

}  // namespace loadpath::sweep
