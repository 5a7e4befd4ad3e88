// A section of a shaft by methods in addition to [Shigley7] and DIN 743: FKM and Serensen.
#pragma once

#include "calculators/fatigue/din743/section.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/calculator/trace.hpp"

#include <cmath>

namespace loadpath::shaft {

/// Amplitude and mean of each stress; bending and torsion as magnitudes.
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

/// `section` is that of DIN 743, `rated` its result, `outside` the number of its ranges exceeded. If the method is
/// one of both, x_DIN reports the exceeded ranges.
template <class Tracer>
void other_schools(const DesignInput& in, const fatigue::Din743Section& section, const Stressed& stressed,
                   const fatigue::Din743Safety& rated, double outside, Safety& s, Tracer& trace);

}  // namespace loadpath::shaft
