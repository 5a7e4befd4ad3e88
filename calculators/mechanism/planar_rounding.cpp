#include "calculators/mechanism/planar_rounding.hpp"

#include "lib/quantity/decimal.hpp"
#include "lib/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

namespace {

constexpr double rounding = 1e-13;  // of the largest term: some hundred times the spacing of doubles

/// The largest magnitude of a dimension among the results.
double largest_of(const Dimension& dimension, const std::vector<project::Entry>& results) {
  double most = 0.0;
  for (const project::Entry& e : results) {
    if (e.value.signature.dimension != dimension) continue;
    for (const double x : e.value.si) most = std::abs(x) > most ? std::abs(x) : most;
  }
  return most;
}

struct Scale {
  Dimension dimension;
  double largest = 0.0;
};

std::vector<Scale> scales_of(const std::vector<project::Entry>& results) {
  const auto of = [&](const Dimension& dimension) { return largest_of(dimension, results); };
  const double length = of(mm.dimension()), force = of(N.dimension());
  const double speed = of(m_per_s.dimension()), turning = of(rad_per_s.dimension());
  const double moment = std::max(of(N_m.dimension()), force * length);
  return {{mm.dimension(), length},
          {deg.dimension(), 1.0},
          {m_per_s.dimension(), std::max(speed, turning * length)},
          {rad_per_s.dimension(), turning},
          {m_per_s2.dimension(), std::max(of(m_per_s2.dimension()), turning * turning * length)},
          {rad_per_s2.dimension(), std::max(of(rad_per_s2.dimension()), turning * turning)},
          {N.dimension(), force},
          {N_m.dimension(), moment},
          {kg_m2.dimension(), of(kg_m2.dimension())},
          {W.dimension(), std::max({of(W.dimension()), force * speed, moment * turning})}};
}

}  // namespace

Rounding rounding_at(const mechanism::Position& p) {
  constexpr double part = 1e-12;  // a reaction comes out of a chain of equations
  Rounding least;
  for (const mechanism::Reaction& r : p.reactions) {
    const double force = part * mechanism::length(r.force);
    least.force = std::max(least.force, force);
    least.moment = std::max(least.moment, force * mechanism::length(r.at));
  }
  return least;
}

double direction_of(mechanism::Vec v) {
  constexpr double part = 1e-9;
  if (std::abs(v.y) <= part * std::abs(v.x)) return v.x < 0.0 ? pi : 0.0;
  return std::atan2(v.y, v.x);
}

void clear_rounding(std::vector<project::Entry>& results) {
  const std::vector<Scale> scales = scales_of(results);
  for (project::Entry& e : results) {
    const auto scale = std::find_if(scales.begin(), scales.end(),
                                    [&](const Scale& s) { return s.dimension == e.value.signature.dimension; });
    if (scale == scales.end()) continue;
    e.value.rounding = rounding * scale->largest;
    const bool direction = e.path.starts_with("links.") && e.path.ends_with(".phi");
    const Decimals decimals = Decimals::within(e.value.rounding);
    for (double& x : e.value.si) {
      if (direction && std::abs(x + pi) <= e.value.rounding) x = pi;
      x = std::abs(x) <= e.value.rounding ? 0.0 : decimals.nearest(x);
    }
  }
}

}  // namespace loadpath
