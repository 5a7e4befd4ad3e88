// The energy that a moment brings over a cycle beyond its mean: what a flywheel has to take up and to give back.
#pragma once

#include <cstddef>
#include <span>

namespace loadpath::machine {

/// The moment at an angle; between neighbours it is a straight line. Two at one angle are a jump.
struct Sample {
  double phi = 0.0;  // rad
  double M = 0.0;    // N m
};

/// SI numbers of one cycle.
struct TurningEnergy {
  double mean = 0.0;                     // of the moment over the angle; zero where it is nothing but rounding
  double peak = 0.0;                     // largest magnitude of the moment
  double work = 0.0;                     // over the cycle
  double low = 0.0, high = 0.0;          // least and largest work of the moment beyond its mean
  double low_phi = 0.0, high_phi = 0.0;  // where they are reached
};

/// Of ascending samples, closed after `period`: the last goes on to the first. Exact for straight lines.
TurningEnergy turning_energy(std::span<const Sample> samples, double period);

/// The work beyond the mean from the first sample to sample i, for figures.
double energy_at(std::span<const Sample> samples, double mean, std::size_t i);

}  // namespace loadpath::machine
