// Some inputs of a project as a function of their own; the others stay.
#pragma once

#include "lib/project/sweep/axes.hpp"
#include "lib/sweep/function.hpp"
#include "lib/sweep/sensitivity/sampler.hpp"

#include <vector>

namespace loadpath::project {

/// Only the first of the requested results: searches do not need every failure mode.
class Slice final : public sweep::Function {
 public:
  /// `inputs`: which of them vary; the others stay at their value in `point`.
  Slice(sweep::Function& all, std::vector<double> point, std::vector<std::size_t> inputs, std::size_t outputs);

  [[nodiscard]] std::size_t inputs() const override { return inputs_.size(); }
  [[nodiscard]] std::size_t outputs() const override { return outputs_; }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override;

 private:
  sweep::Function& all_;
  std::vector<std::size_t> inputs_;
  std::size_t outputs_;
  std::vector<double> rest_;  // values of all inputs
};

/// Samples of uncertain inputs, `which` of all, each as if the others were not there.
sweep::Sampler sampler_of(const std::vector<SweptInput>& inputs, const std::vector<std::size_t>& which,
                          std::uint64_t seed);

}  // namespace loadpath::project
