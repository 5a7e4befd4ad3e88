// A section of a shaft by schools that stand beside those of [Shigley7] and DIN 743: FKM and Serensen.
#pragma once

#include "calculators/fatigue/din743/section.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/calculator/trace.hpp"

#include <cmath>

namespace loadpath::shaft {

/// What varies of each stress, and what stays; bending and torsion as magnitudes.
struct Stressed {
  Swing<Stress> bending, axial, torsion;
};

/// How many of its ranges a rated section is outside of.
template <class Rated, class Fields>
double ranges_left(const Rated& rated, const Fields& fields) {
  const auto is_outside = [&](const auto& field) {
    if constexpr (requires { field.role == Role::limit&& field.bounds.holds(rated.*field.at); })
      return field.role == Role::limit && !std::isnan(rated.*field.at) && !field.bounds.holds(rated.*field.at);
    else
      return false;
  };
  return loadpath::apply([&](const auto&... field) { return (0.0 + ... + (is_outside(field) ? 1.0 : 0.0)); }, fields);
}

/// `section` is that of DIN 743, `rated` what was found of it, `outside` how many of its ranges were left. Where the
/// method is one of both x_DIN tells the ranges that it has left.
template <class Tracer>
void other_schools(const DesignInput& in, const fatigue::Din743Section& section, const Stressed& stressed,
                   const fatigue::Din743Safety& rated, double outside, Safety& s, Tracer& trace);

}  // namespace loadpath::shaft
