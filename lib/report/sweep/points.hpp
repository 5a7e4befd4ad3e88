// The points of a sweep that its figures show: a bounded number, the same on every computer. They are solved once
// more, since a point is a function of its number.
#pragma once

#include "lib/project/sweep/statistics.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace loadpath::report {

struct SolvedPoints {
  std::vector<std::uint64_t> numbers;                // rising
  std::vector<std::vector<double>> inputs, results;  // column by column; requested results, then verdicts
  [[nodiscard]] std::size_t size() const { return numbers.size(); }
};

/// The points of two crossed inputs, without other inputs.
struct Plane {
  std::size_t across = 0, up = 0;  // inputs
  std::size_t columns = 0;
  SolvedPoints points;  // row by row, both rising
};

struct DrawnPoints {
  SolvedPoints cloud;  // for two objectives: an even selection, the Pareto set, the worst
  std::optional<Plane> plane;
};

/// `blocks`: those that were solved.
DrawnPoints points_to_draw(const project::SweepPlan& plan, const project::SweepStatistics& found,
                           const project::BlockRange& blocks, const project::ReadAgain& read);

}  // namespace loadpath::report
