#include "calculators/machine/energy_of_turning.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

namespace {

constexpr double no_mean = 1e-9;  // share of the largest moment: below, the mean is rounding

/// The moment between two samples, less a mean.
class Piece {
 public:
  Piece(const Sample& a, const Sample& b, double mean) : h_(b.phi - a.phi), a_(a.M - mean), b_(b.M - mean) {
    const double from = h_ * a.slope - (b.M - a.M), to = h_ * b.slope - (b.M - a.M);
    if (std::isfinite(from) && std::isfinite(to)) from_ = from, to_ = to;
  }

  [[nodiscard]] bool changes_sign() const { return a_ * b_ < 0.0; }
  /// The zero, as a fraction of the interval.
  [[nodiscard]] double zero() const {
    double s = a_ / (a_ - b_);
    if (from_ == 0.0 && to_ == 0.0) return s;
    for (double low = 0.0, high = 1.0; high - low > 1e-9; s = 0.5 * (low + high)) (at(s) * a_ > 0.0 ? low : high) = s;
    return s;
  }
  /// The work over this fraction of the interval.
  [[nodiscard]] double work(double s = 1.0) const {
    const double s2 = s * s, s3 = s2 * s, s4 = s3 * s;
    const double straight = a_ * s + 0.5 * (b_ - a_) * s2;
    const double bent = from_ * (s2 / 2.0 - 2.0 * s3 / 3.0 + s4 / 4.0) - to_ * (s3 / 3.0 - s4 / 4.0);
    return h_ * (straight + bent);
  }

 private:
  [[nodiscard]] double at(double s) const { return a_ + s * (b_ - a_) + s * (1.0 - s) * ((1.0 - s) * from_ - s * to_); }

  double h_, a_, b_;
  double from_ = 0.0, to_ = 0.0;  // slopes at both ends beyond that of the straight line, times h
};

void take(TurningEnergy& energy, double E, double phi) {
  if (numerics::exceeds(energy.low, E)) energy.low_phi = phi;
  if (numerics::exceeds(E, energy.high)) energy.high_phi = phi;
  energy.low = std::min(energy.low, E), energy.high = std::max(energy.high, E);
}

/// Calls `then` with each sample and the next, of the last with the first a period later.
template <class Then>
void each_pair(const std::function<Sample(std::size_t)>& sample, std::size_t count, double period, const Then& then) {
  const Sample first = sample(0);
  Sample a = first;
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    Sample b = last ? first : sample(i + 1);
    if (last) b.phi += period;
    then(a, b, last);
    a = b;
  }
}

}  // namespace

TurningEnergy turning_energy(const std::function<Sample(std::size_t)>& sample, std::size_t count, double period) {
  TurningEnergy energy;
  if (count == 0) return energy;
  each_pair(sample, count, period, [&](const Sample& a, const Sample& b, bool) {
    energy.work += Piece(a, b, 0.0).work();
    if (std::abs(a.M) > energy.peak) energy.peak = std::abs(a.M), energy.peak_phi = a.phi;
  });
  if (std::abs(energy.work) <= no_mean * energy.peak * period) energy.work = 0.0;
  energy.mean = energy.work / period;
  energy.low_phi = energy.high_phi = sample(0).phi;
  double E = 0.0;
  each_pair(sample, count, period, [&](const Sample& a, const Sample& b, bool last) {
    const Piece piece(a, b, energy.mean);
    if (piece.changes_sign()) {  // the extreme lies where the moment is the mean
      const double s = piece.zero();
      take(energy, E + piece.work(s), a.phi + s * (b.phi - a.phi));
    }
    E += piece.work();
    if (!last) take(energy, E, b.phi);
  });
  // The work begins and ends at zero; below this share of the largest moment over the period it is rounding.
  const double rounding = 1e-12 * energy.peak * period;
  if (energy.low >= -rounding) energy.low = 0.0, energy.low_phi = sample(0).phi;
  if (energy.high <= rounding) energy.high = 0.0, energy.high_phi = sample(0).phi;
  return energy;
}

TurningEnergy turning_energy(std::span<const Sample> samples, double period) {
  return turning_energy([&samples](std::size_t i) { return samples[i]; }, samples.size(), period);
}

double energy_at(std::span<const Sample> samples, double mean, std::size_t i) {
  double E = 0.0;
  for (std::size_t k = 0; k < i; ++k) E += Piece(samples[k], samples[k + 1], mean).work();
  return E;
}

}  // namespace loadpath::machine
