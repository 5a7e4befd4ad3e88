#include "calculators/shaft/design/model/turn.hpp"

#include "calculators/shaft/design/model/positions.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// Between its extremes; `r`: least over largest, where it starts and stops too.
template <class Quantity>
Swing<Quantity> between(Quantity least, Quantity most, double r = unset<double>) {
  if (is_set(r)) {
    const Quantity back = r * (abs(least) > abs(most) ? least : most);
    least = min(least, back), most = max(most, back);
  }
  return {(most - least) / 2.0, (most + least) / 2.0};
}

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
  felt_.reserve(nodes_ * positions_);
  for (std::size_t i = 0; varies_ && i < positions_; ++i) psi_.push_back(psi_of(in, i));
}

void Turn::take(const Loaded& loaded) {
  for (std::size_t n = 0; n < nodes_; ++n) felt_.push_back(loaded.felt(n));
  const double M = loaded.largest_moment();
  if (numerics::exceeds(M, largest_)) largest_ = M, most_bent_ = felt_.size() / nodes_ - 1;
}

double Turn::moment(std::size_t node, std::size_t position, double theta) const {
  const Felt& f = felt(node, position);
  return f.M_x * std::cos(theta + psi_[position]) + f.M_y * std::sin(theta + psi_[position]);
}

Swings Turn::along(std::size_t node, double r_T) const {
  const auto N = extremes(positions_, [&](std::size_t i) { return felt(node, i).N; });
  const auto T = extremes(positions_, [&](std::size_t i) { return felt(node, i).T; });
  Swings all;
  all.N = between(from_si<Force>(N.first), from_si<Force>(N.second));
  all.T = between(from_si<Moment>(T.first), from_si<Moment>(T.second), r_T);
  return all;
}

std::vector<Swings> Turn::swings(std::size_t node, double r_T) const {
  constexpr int directions = 90;         // per half circumference: the other half has opposite means
  constexpr double finest = 1e-3;        // share of amplitude and mean: closer points are one
  std::vector<double> along_x, along_y;  // the moment in the axes of the shaft
  for (std::size_t i = 0; i < positions_; ++i) {
    along_x.push_back(moment(node, i, 0.0));
    along_y.push_back(moment(node, i, pi / 2.0));
  }
  std::vector<Swings> all(directions, along(node, r_T));
  for (int k = 0; k < directions; ++k) {
    Swings& swing = all[static_cast<std::size_t>(k)];
    swing.theta = pi * k / directions;
    const double c = std::cos(swing.theta), s = std::sin(swing.theta);
    const auto M = extremes(positions_, [&](std::size_t i) { return along_x[i] * c + along_y[i] * s; });
    swing.M = between(from_si<Moment>(M.first), from_si<Moment>(M.second));
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
