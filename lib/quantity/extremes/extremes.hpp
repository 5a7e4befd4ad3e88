// Extremes of a series whose values lie in other memory, as those of a Value (lib/quantity/series.hpp).
#pragma once

#include "lib/quantity/series.hpp"

#include <span>

namespace loadpath {

struct SeriesView {
  std::span<const double> si;
  const Axis* axis = nullptr;  // null: one value
  double rounding = 0.0;       // of Value
};

Extreme maximum(const SeriesView& series);
Extreme minimum(const SeriesView& series);
Extreme largest(const SeriesView& series);

}  // namespace loadpath
