// Figures common to the vessels: stresses along the meridian.
#pragma once

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/section.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Sample {
  double r = 0.0, z = 0.0;              // m
  double sigma_o = 0.0, sigma_M = 0.0;  // Pa
};

/// Many places along the meridian, from its start to its end; none at the very ends, where a shape may be singular.
template <class Shape>
std::vector<Sample> samples(const Shape& shape, const WallInput& in, const WallResult& r) {
  constexpr int count = 200;
  NoTrace off;
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) {
    const Place place = shape.at((i + 0.5) / count, off);
    const Membrane s = membrane(place, in.p, r.delta_c, strength_of(in, r.sigma_all), off);
    all.push_back({in_si(place.r), in_si(place.z), in_si(s.o), in_si(s.M)});
  }
  return all;
}

/// The section of the vessel, and the stresses over the length of its meridian; nothing where none were computed.
std::vector<figure::Figure> pictures(const std::vector<Sample>& along, const WallInput& in, const WallResult& r,
                                     const Section& section);

}  // namespace loadpath::vessel
