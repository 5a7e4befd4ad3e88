// The samples of the designs that a search chooses from: those of the sweep over all of them.
#pragma once

#include "lib/project/sweep/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::project {

class DrawnSamples {
 public:
  /// Ranges that only a search chooses from are not part of the grid: the samples are those of a sweep at their values.
  /// Errors in the settings become issues.
  DrawnSamples(const std::vector<SweptInput>& inputs, const SweepSettings& settings, std::vector<Issue>& issues);

  /// The first sample of a design with these values of the chosen inputs.
  [[nodiscard]] std::uint64_t first_of(std::span<const double> chosen) const;
  /// A column for each uncertain input.
  void fill(std::uint64_t first, std::size_t n, std::span<double* const> columns) const;

 private:
  struct Digit {
    std::size_t chosen;    // input among the chosen ones
    std::size_t variable;  // of the space
    sweep::Axis axis;
  };

  sweep::Space space_;
  std::vector<Digit> digits_;
  std::vector<std::size_t> uncertain_;  // variables of the space
};

}  // namespace loadpath::project
