#include "calculators/machine/motion/periodic_cells.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

double CellCubic::at(double u) const {
  const double w = 1.0 - u;
  return w * w * ((1.0 + 2.0 * u) * v_0 + u * d_0) + u * u * ((1.0 + 2.0 * w) * v_1 - w * d_1);
}

double CellCubic::slope(double u) const {
  const double w = 1.0 - u;
  return 6.0 * u * w * (v_1 - v_0) + w * (w - 2.0 * u) * d_0 + u * (u - 2.0 * w) * d_1;
}

namespace {

constexpr double same_angle = 1e-12;  // share of the period
constexpr int least_cells = 180;      // of a period, for its extremes

double wrapped(double phi, double period) {
  const double rest = phi - period * std::floor(phi / period);
  return rest < period * (1.0 - same_angle) ? rest : 0.0;
}

/// Samples of a closed curve as a cubic on any stretch between two neighbours.
class ClosedCurve {
 public:
  ClosedCurve(std::span<const Sample> samples, double period) : samples_(samples), period_(period) {}

  /// Over a stretch that contains no sample.
  [[nodiscard]] CellCubic over(double from, double width) const {
    const double start = samples_.front().phi, turn = period_ * std::floor((from + 0.5 * width - start) / period_);
    const double low = from - turn, middle = low + 0.5 * width;
    const auto next = std::upper_bound(samples_.begin(), samples_.end(), middle,
                                       [](double phi, const Sample& sample) { return phi < sample.phi; });
    const Sample& a = *(next == samples_.begin() ? next : next - 1);
    Sample b = next == samples_.end() ? samples_.front() : *next;
    if (next == samples_.end()) b.phi += period_;
    const double h = b.phi - a.phi, straight = b.M - a.M;
    const bool curved = std::isfinite(a.slope) && std::isfinite(b.slope);
    const CellCubic whole{a.M, b.M, curved ? h * a.slope : straight, curved ? h * b.slope : straight};
    const double u_0 = (low - a.phi) / h, u_1 = (low + width - a.phi) / h, scale = width / h;
    return {whole.at(u_0), whole.at(u_1), scale * whole.slope(u_0), scale * whole.slope(u_1)};
  }

 private:
  std::span<const Sample> samples_;
  double period_;
};

/// The angles at which either curve bends, and enough between them, from the beginning of the cycle.
std::vector<double> borders(std::span<const Sample> load, std::span<const Sample> inertia, double period,
                            double start) {
  std::vector<double> angles{0.0, period};
  for (const auto samples : {load, inertia}) {
    for (const Sample& sample : samples) angles.push_back(wrapped(sample.phi - start, period));
  }
  std::ranges::sort(angles);
  std::vector<double> all{0.0};
  for (const double angle : angles) {
    const double from = all.back(), width = angle - from;
    if (width <= same_angle * period) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(width / period * least_cells - 1e-6)));
    for (int k = 1; k < parts; ++k) all.push_back(from + width * k / parts);
    all.push_back(angle);
  }
  return all;
}

/// Slope of the parabola through three samples, at the middle one.
double three_point_slope(double before, double after, double rise_before, double rise_after) {
  return (rise_before / before * after + rise_after / after * before) / (before + after);
}

}  // namespace

std::vector<PeriodCell> period_cells(std::span<const Sample> load, std::span<const Sample> inertia, double constant,
                                     double period, double start) {
  const ClosedCurve loads(load, period), inertias(inertia, period);
  const std::vector<double> angles = borders(load, inertia, period, start);
  std::vector<PeriodCell> cells;
  cells.reserve(angles.size());
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const double from = angles[k], width = angles[k + 1] - from;
    PeriodCell cell{from, width, loads.over(start + from, width), inertias.over(start + from, width)};
    cell.J.v_0 += constant, cell.J.v_1 += constant;
    cells.push_back(cell);
  }
  return cells;
}

void add_slopes(std::span<Sample> samples, double period) {
  const std::size_t n = samples.size();
  if (n < 5) return;
  const auto at = [&](std::size_t i, std::size_t on) {  // the sample `on` - 2 places further, with its own turn
    const std::size_t k = i + n + on - 2;
    Sample sample = samples[k % n];
    const std::size_t turns = k / n;
    sample.phi += period * (static_cast<double>(turns) - 1.0);
    return sample;
  };
  std::vector<double> slopes(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Sample a = at(i, 0), b = at(i, 1), c = at(i, 2), d = at(i, 3), e = at(i, 4);
    const double h = c.phi - b.phi, unequal = 1e-6 * h;
    const bool even = std::abs(d.phi - c.phi - h) < unequal && std::abs(b.phi - a.phi - h) < unequal &&
                      std::abs(e.phi - d.phi - h) < unequal;
    slopes[i] = even ? (8.0 * (d.M - b.M) - (e.M - a.M)) / (12.0 * h)
                     : three_point_slope(h, d.phi - c.phi, c.M - b.M, d.M - c.M);
  }
  for (std::size_t i = 0; i < n; ++i) samples[i].slope = slopes[i];
}

double slope_at(std::span<const Sample> samples, double period, double phi) {
  if (samples.size() < 2) return 0.0;
  const double width = 1e-9 * period;
  return ClosedCurve(samples, period).over(phi, width).slope(0.0) / width;
}

}  // namespace loadpath::machine
