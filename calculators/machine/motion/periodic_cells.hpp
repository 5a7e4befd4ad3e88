// Load and reduced moment of inertia of a machine over one period of its crank, cell by cell: within a cell both are
// cubics without a jump or a bend, so that the equation of motion is smooth there. SI numbers.
#pragma once

#include "calculators/machine/energy_of_turning.hpp"

#include <span>
#include <vector>

namespace loadpath::machine {

/// A cubic over a cell, by its values and its slopes, each times the width, at both ends.
struct CellCubic {
  double v_0 = 0.0, v_1 = 0.0, d_0 = 0.0, d_1 = 0.0;
  [[nodiscard]] double at(double u) const;
  [[nodiscard]] double slope(double u) const;  // with respect to u
  [[nodiscard]] double integral() const { return 0.5 * (v_0 + v_1) + (d_0 - d_1) / 12.0; }
};

struct PeriodCell {
  double from = 0.0, width = 0.0;  // rad, from the beginning of the cycle
  CellCubic M, J;                  // load, N m; moment of inertia, kg m^2

  [[nodiscard]] double load(double phi) const { return M.at((phi - from) / width); }
  [[nodiscard]] double inertia(double phi) const { return J.at((phi - from) / width); }
  [[nodiscard]] double inertia_slope(double phi) const { return J.slope((phi - from) / width) / width; }
};

/// The cells of a period that begins at `start`. Samples ascend over at most a period and are closed after it; a single
/// one is a constant, two at one angle are a jump. `constant` is added to the inertia.
std::vector<PeriodCell> period_cells(std::span<const Sample> load, std::span<const Sample> inertia, double constant,
                                     double period, double start);

/// Gives samples that have none the slopes of the curve through their neighbours.
void add_slopes(std::span<Sample> samples, double period);

/// The slope of closed samples at an angle.
double slope_at(std::span<const Sample> samples, double period, double phi);

}  // namespace loadpath::machine
