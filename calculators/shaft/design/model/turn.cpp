#include "calculators/shaft/design/model/turn.hpp"

#include "calculators/shaft/design/model/positions.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// Between its extremes; `r`: least over largest, where it starts and stops too. The mean of opposite extremes is zero,
/// not what rounding leaves of their sum.
template <class Quantity>
Swing<Quantity> between(Quantity least, Quantity most, double r = unset<double>) {
  if (is_set(r)) {
    const Quantity back = r * (abs(least) > abs(most) ? least : most);
    least = min(least, back), most = max(most, back);
  }
  constexpr double rounding = 1e-11;  // of the difference
  const bool are_opposite = abs(most + least) <= rounding * (most - least);
  return {(most - least) / 2.0, are_opposite ? 0.0 * most : (most + least) / 2.0};
}

/// The points around a section at which bending is looked for: per half circumference, for the other half has opposite
/// means.
constexpr std::size_t directions = 90;
double direction(std::size_t k) { return pi * static_cast<double>(k) / static_cast<double>(directions); }

/// Cosines and sines of them, the same for every section.
using OfDirections = std::array<double, directions>;
struct Headings {
  OfDirections c{}, s{};
  Headings() {
    for (std::size_t k = 0; k < directions; ++k) c[k] = std::cos(direction(k)), s[k] = std::sin(direction(k));
  }
};

/// The least and the largest bending moment in each direction.
struct Extremes {
  OfDirections least{}, most{};
  void take(double along_x, double along_y, bool is_first) {
    static const Headings headings;
    OfDirections M;
    for (std::size_t k = 0; k < directions; ++k) M[k] = along_x * headings.c[k] + along_y * headings.s[k];
    if (is_first) least = M, most = M;
    for (std::size_t k = 0; k < directions; ++k) least[k] = std::min(least[k], M[k]), most[k] = std::max(most[k], M[k]);
  }
};

template <class Of>
std::pair<double, double> extremes(std::size_t positions, const Of& of) {
  std::pair<double, double> found{of(0), of(0)};
  for (std::size_t i = 1; i < positions; ++i) {
    const double value = of(i);
    found.first = std::min(found.first, value), found.second = std::max(found.second, value);
  }
  return found;
}

}  // namespace

Turn::Turn(const Input& in, std::size_t nodes)
    : nodes_(nodes), positions_(positions_of(in)), varies_(shaft::varies(in)) {
  internal_forces_.reserve(nodes_ * positions_);
  for (std::size_t i = 0; varies_ && i < positions_; ++i) psi_.push_back(psi_of(in, i));
  for (const double psi : psi_) axes_.push_back({Heading::of(0.0 + psi), Heading::of(pi / 2.0 + psi)});
}

void Turn::take(const Loaded& loaded, double most) {
  for (std::size_t n = 0; n < nodes_; ++n) internal_forces_.push_back(loaded.internal_forces(n));
  if (numerics::exceeds(most, largest_)) largest_ = most, most_bent_ = internal_forces_.size() / nodes_ - 1;
}

double Turn::moment(std::size_t node, std::size_t position, double theta) const {
  const InternalForces& f = internal_forces(node, position);
  return f.M_x * std::cos(theta + psi_[position]) + f.M_y * std::sin(theta + psi_[position]);
}

Swings Turn::along(std::size_t node, double r_T) const {
  const auto N = extremes(positions_, [&](std::size_t i) { return internal_forces(node, i).N; });
  const auto T = extremes(positions_, [&](std::size_t i) { return internal_forces(node, i).T; });
  Swings all;
  all.N = between(from_si<Force>(N.first), from_si<Force>(N.second));
  all.T = between(from_si<Moment>(T.first), from_si<Moment>(T.second), r_T);
  return all;
}

std::vector<Swings> Turn::swings(std::size_t node, double r_T) const {
  constexpr double finest = 1e-3;  // share of amplitude and mean: closer points are one
  Extremes M;
  for (std::size_t i = 0; i < positions_; ++i) {
    const InternalForces& f = internal_forces(node, i);
    const auto& [x, y] = axes_[i];  // of the shaft
    M.take(f.M_x * x.c + f.M_y * x.s, f.M_x * y.c + f.M_y * y.s, i == 0);
  }
  std::vector<Swings> all(directions, along(node, r_T));
  for (std::size_t k = 0; k < directions; ++k) {
    all[k].theta = direction(k);
    all[k].M = between(from_si<Moment>(M.least[k]), from_si<Moment>(M.most[k]));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Swings& a, const Swings& b) { return numerics::exceeds(in_si(a.M.a), in_si(b.M.a)); });
  std::vector<Swings> front;
  for (const Swings& s : all) {
    if (front.empty() || abs(s.M.m) > abs(front.back().M.m) + finest * (s.M.a + abs(s.M.m))) front.push_back(s);
  }
  return front;
}

}  // namespace loadpath::shaft
