// The energy that a moment brings over a cycle beyond its mean: what a flywheel has to take up and to give back.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>

namespace loadpath::machine {

/// The moment at an angle. Between neighbours it is a straight line, or, where both have slopes, a cubic. Two at one
/// angle are a jump.
struct Sample {
  double phi = 0.0;                                         // rad
  double M = 0.0;                                           // N m
  double slope = std::numeric_limits<double>::quiet_NaN();  // N m/rad
};

/// SI numbers of one cycle.
struct TurningEnergy {
  double mean = 0.0;                     // integral of the moment over the angle; zero if it is only rounding
  double peak = 0.0, peak_phi = 0.0;     // largest magnitude of the moment among the samples, and where
  double work = 0.0;                     // over the cycle
  double low = 0.0, high = 0.0;          // least and largest work of the moment beyond its mean
  double low_phi = 0.0, high_phi = 0.0;  // where they are reached
};

/// Energy from ascending samples, closed after `period`: the last continues to the first. Exact for straight lines
/// and cubics.
TurningEnergy turning_energy(const std::function<Sample(std::size_t)>& sample, std::size_t count, double period);
TurningEnergy turning_energy(std::span<const Sample> samples, double period);

/// The work beyond the mean from the first sample to sample i, for figures.
double energy_at(std::span<const Sample> samples, double mean, std::size_t i);

}  // namespace loadpath::machine
