#include "calculators/machine/energy_of_turning.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

namespace {

constexpr double no_mean = 1e-9;  // of the largest moment: below, the mean is rounding

/// Sample i, or the first one again a period later.
Sample at(std::span<const Sample> samples, double period, std::size_t i) {
  if (i < samples.size()) return samples[i];
  return {samples.front().phi + period, samples.front().M};
}

double work_of(const Sample& a, const Sample& b) { return 0.5 * (a.M + b.M) * (b.phi - a.phi); }

void take(TurningEnergy& energy, double E, double phi) {
  if (E < energy.low) energy.low = E, energy.low_phi = phi;
  if (E > energy.high) energy.high = E, energy.high_phi = phi;
}

}  // namespace

TurningEnergy turning_energy(std::span<const Sample> samples, double period) {
  TurningEnergy energy;
  if (samples.empty()) return energy;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    energy.work += work_of(samples[i], at(samples, period, i + 1));
    energy.peak = std::max(energy.peak, std::abs(samples[i].M));
  }
  if (std::abs(energy.work) <= no_mean * energy.peak * period) energy.work = 0.0;
  energy.mean = energy.work / period;
  energy.low_phi = energy.high_phi = samples.front().phi;
  double E = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample a = samples[i], b = at(samples, period, i + 1);
    a.M -= energy.mean, b.M -= energy.mean;
    if (a.M * b.M < 0.0) {  // the extreme lies where the moment is the mean
      const double share = a.M / (a.M - b.M), phi = a.phi + share * (b.phi - a.phi);
      take(energy, E + 0.5 * a.M * (phi - a.phi), phi);
    }
    E += work_of(a, b);
    if (i + 1 < samples.size()) take(energy, E, b.phi);
  }
  constexpr double even = 1e-12;  // of the largest moment over the period: below, the moment is constant
  if (energy.high - energy.low <= even * energy.peak * period) energy.low = energy.high = 0.0;
  return energy;
}

double energy_at(std::span<const Sample> samples, double mean, std::size_t i) {
  double E = 0.0;
  for (std::size_t k = 0; k < i; ++k)
    E += work_of(samples[k], samples[k + 1]) - mean * (samples[k + 1].phi - samples[k].phi);
  return E;
}

}  // namespace loadpath::machine
