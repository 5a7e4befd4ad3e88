#include "lib/draw/chart/regions.hpp"

#include <limits>

namespace loadpath::draw {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Verdict = figure::Chart::Verdict;

bool is_known(Verdict verdict) { return verdict == Verdict::passes || verdict == Verdict::fails; }

/// The distance of a dot beyond its limit: by its utilisation if that agrees with the verdict.
double excess_of(const figure::Chart::Dot& dot, double utilisation) {
  constexpr double least = 1e-6, guess = 0.5;
  if (dot.verdict == Verdict::none) return nan;
  const double beyond = utilisation - 1.0;
  if (dot.verdict == Verdict::fails) return beyond > 0.0 && beyond < 1e6 ? std::max(beyond, least) : guess;
  return beyond <= 0.0 ? std::min(beyond, -least) : -guess;
}

}  // namespace

Regions::Regions(const figure::Chart& chart, Lattice lattice) : chart_(chart), lattice_(std::move(lattice)) {
  for (std::size_t i = 0; i < chart.dots.size(); ++i)
    excess_.push_back(excess_of(chart.dots[i], chart.is_limited ? chart.levels[i] : nan));
}

const figure::Chart::Dot& Regions::at(Point place) const {
  const InCell in = cell_at(lattice_, place);
  const std::size_t column = in.column + (in.across > 0.5 ? 1 : 0), row = in.row + (in.up > 0.5 ? 1 : 0);
  const figure::Chart::Dot& nearest = chart_.dots[lattice_.node(column, row)];
  const double excess = between(lattice_, excess_, in);
  const auto agrees = [&](const figure::Chart::Dot& dot) {
    return std::isnan(excess) || (excess > 0.0) == (dot.verdict == Verdict::fails);
  };
  if (agrees(nearest)) return nearest;
  for (const std::size_t other_row : {row, 2 * in.row + 1 - row}) {
    for (const std::size_t other : {2 * in.column + 1 - column, column}) {
      const figure::Chart::Dot& dot = chart_.dots[lattice_.node(other, other_row)];
      if (agrees(dot)) return dot;
    }
  }
  return nearest;
}

std::vector<std::vector<Point>> Regions::limit() const { return level_lines(lattice_, excess_, 0.0); }

std::vector<std::vector<Point>> Regions::unknown() const {
  std::vector<double> is_unknown;
  for (const figure::Chart::Dot& dot : chart_.dots)
    is_unknown.push_back(dot.verdict == Verdict::fails ? nan : is_known(dot.verdict) ? 0.0 : 1.0);
  return level_lines(lattice_, is_unknown, 0.5);
}

std::vector<std::vector<Point>> Regions::between_modes() const {
  std::vector<std::vector<Point>> all;
  for (std::size_t mode = 0; mode + 1 < chart_.modes.size(); ++mode) {
    std::vector<double> is_mode;
    for (const figure::Chart::Dot& dot : chart_.dots)
      is_mode.push_back(dot.verdict != Verdict::fails || dot.mode < mode ? nan : dot.mode == mode ? 1.0 : 0.0);
    for (auto& line : level_lines(lattice_, is_mode, 0.5)) all.push_back(std::move(line));
  }
  return all;
}

std::vector<std::vector<Point>> Regions::level(double value) const {
  return level_lines(lattice_, chart_.levels, value);
}

}  // namespace loadpath::draw
