#include "lib/draw/canvas/ticks.hpp"

#include "lib/draw/canvas/display.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::draw {
namespace {

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }
/// The magnitude of zero is that of 1.
int magnitude(double value) { return value > 0.0 ? static_cast<int>(std::floor(std::log10(value) + 1e-9)) : 0; }

double decimal_step(double least) {
  const double unit = power_of_ten(magnitude(least));
  for (const double k : {1.0, 2.0, 5.0}) {
    if (k * unit >= least * (1.0 - 1e-9)) return k * unit;
  }
  return 10.0 * unit;
}

double degree_step(double least) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0}) {
    if (least > 0.5 && step >= least) return step;
  }
  return least > 360.0 ? 360.0 * decimal_step(least / 360.0) : decimal_step(least);
}

/// A range that can be divided: a single value is shown with zero, and zero with one on both sides.
Range opened(Range data) {
  const double size = std::max(std::fabs(data.low), std::fabs(data.high));
  if (!(size > 1e-100)) return {-1.0, 1.0};
  if (data.high - data.low > 1e-9 * size) return data;
  return data.low > 0.0 ? Range{0.0, 2.0 * data.high} : Range{2.0 * data.low, 0.0};
}

double to_tick(double end, double tick, double reach) { return std::fabs(tick - end) <= reach ? tick : end; }

/// The power of ten, a multiple of three, that keeps tick texts short; 0 for numbers that are written out.
int written_power(const Range& range) {
  const double size = std::max(std::fabs(range.low), std::fabs(range.high));
  if (size < 1e5 && size >= 1e-2) return 0;
  return 3 * static_cast<int>(std::floor((magnitude(size)) / 3.0));
}

/// Numbers that are short without a power of ten.
bool is_written_out(const Range& range) { return range.low >= 1e-3 && range.high < 1e5; }

std::string power_text(int exponent) { return "10" + superscript(exponent); }

/// The positions of ticks within a decade: the fewer decades, the more ticks.
std::vector<double> parts_of_decade(const Range& data) {
  const double decades = std::log10(data.high / data.low);
  if (!is_written_out(data) || decades > 4.0) return {1.0};
  if (decades > 1.5) return {1.0, 2.0, 5.0};
  return {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0};
}

std::vector<double> logarithmic_ticks(const Range& data) {
  std::vector<double> ticks;
  const std::vector<double> parts = parts_of_decade(data);
  for (int power = magnitude(data.low) - 1; power <= magnitude(data.high) + 1; ++power) {
    for (const double part : parts) ticks.push_back(part * power_of_ten(power));
  }
  return ticks;
}

}  // namespace

double Axis::fraction(double value) const {
  if (logarithmic) return std::log(value / range.low) / std::log(range.high / range.low);
  return (value - range.low) / (range.high - range.low);
}

std::string Axis::text(double tick) const {
  if (logarithmic) return is_written_out(range) ? format_number(tick, 3) : power_text(magnitude(tick));
  const double size = std::max(std::fabs(range.low), std::fabs(range.high));
  const int digits = std::clamp(magnitude(size) - magnitude(step) + 3, 3, 15);
  return format_number(power == 0 ? tick : tick / power_of_ten(power), digits);
}

double round_below(double value) {
  const double unit = power_of_ten(magnitude(value));
  for (const double k : {5.0, 2.0}) {
    if (k * unit <= value * (1.0 + 1e-9)) return k * unit;
  }
  return unit;
}

Axis logarithmic_axis(Range data, Ends ends) {
  constexpr double slack = 1e-9;
  if (!(data.high > data.low * 1.2)) data = {data.low / 1.5, data.high * 1.5};
  const std::vector<double> ticks = logarithmic_ticks(data);
  Axis result;
  result.logarithmic = true;
  result.range = data;
  if (ends == Ends::ticks) {
    result.range.low = *std::prev(std::upper_bound(ticks.begin(), ticks.end(), data.low * (1.0 + slack)));
    result.range.high = *std::lower_bound(ticks.begin(), ticks.end(), data.high * (1.0 - slack));
  }
  for (const double t : ticks) {
    if (t >= result.range.low * (1.0 - slack) && t <= result.range.high * (1.0 + slack)) result.ticks.push_back(t);
  }
  return result;
}

Axis axis(Range data, int most, Steps steps, Ends ends) {
  const Range shown = opened(data);
  const double extent = shown.high - shown.low;
  Axis result;
  result.step = steps == Steps::degrees ? degree_step(extent / most) : decimal_step(extent / most);
  const double step = result.step, slack = 1e-6;
  const double reach = ends == Ends::ticks ? step : 0.03 * extent;
  result.range.low = to_tick(shown.low, step * std::floor(shown.low / step + slack), reach);
  result.range.high = to_tick(shown.high, step * std::ceil(shown.high / step - slack), reach);
  const double first = std::ceil(result.range.low / step - slack), last = std::floor(result.range.high / step + slack);
  for (int i = 0; i <= static_cast<int>(last - first); ++i) result.ticks.push_back((first + i) * step + 0.0);
  result.power = written_power(result.range);
  return result;
}

}  // namespace loadpath::draw
