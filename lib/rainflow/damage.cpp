#include "lib/rainflow/damage.hpp"

#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace loadpath::rainflow {

namespace {

double factor_of(Measure measure) { return measure == Measure::amplitude ? 0.5 : 1.0; }

/// The damage of the stresses of a lot.
LOADPATH_INLINE void weigh(std::span<const SnCurve::Segment> segments, DamageSum::Lots& lots) {
  auto& [stress, scaled, power, damage] = lots;
  damage.fill(0.0);
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment) {
    const double from = segment->from, unit = 1.0 / segment->point.stress, each = 1.0 / segment->point.cycles;
    for (std::size_t i = 0; i < lot; ++i) scaled[i] = stress[i] * unit;
    powers(scaled, segment->slope, power);
    for (std::size_t i = 0; i < lot; ++i) damage[i] = stress[i] >= from ? power[i] * each : damage[i];
  }
}

/// Adds the damage of up to a lot of loops; the lot is filled up with cycles of zero range.
LOADPATH_INLINE void add(std::span<const Loop> loops, std::span<const SnCurve::Segment> segments, double factor,
                         DamageSum::Lots& lots, DamageSum::Sums& sums) {
  auto& stress = lots.stress;
  for (std::size_t i = 0; i < loops.size(); ++i) stress[i] = std::abs(loops[i].to - loops[i].from) * factor;
  for (std::size_t i = loops.size(); i < lot; ++i) stress[i] = 0.0;
  weigh(segments, lots);
  const Lot& damage = lots.damage;
  DamageSum::Sums added = sums;
  for (std::size_t i = 0; i < lot; i += DamageSum::lanes) {
    for (std::size_t l = 0; l < DamageSum::lanes; ++l) {
      added.damage[l] += damage[i + l];
      added.largest[l] = stress[i + l] > added.largest[l] ? stress[i + l] : added.largest[l];
    }
  }
  sums = added;
}

#if defined(__x86_64__)
LOADPATH_AVX2 void add_avx2(std::span<const Loop> loops, std::span<const SnCurve::Segment> segments, double factor,
                            DamageSum::Lots& lots, DamageSum::Sums& sums) {
  add(loops, segments, factor, lots, sums);
}
__attribute__((target("avx2"))) void weigh_avx2(std::span<const SnCurve::Segment> segments, DamageSum::Lots& lots) {
  weigh(segments, lots);
}
#endif

}  // namespace

DamageSum::DamageSum(SnCurve curve, Instructions instructions)
    : curve_(std::move(curve)), instructions_(instructions) {}

void DamageSum::take(const Batch& batch) {
  const double factor = factor_of(curve_.measure());
  Sums sums;
  for (std::size_t i = 0; i < batch.loops.size(); i += lot) {
    const auto loops = batch.loops.subspan(i, std::min(lot, batch.loops.size() - i));
#if defined(__x86_64__)
    if (instructions_ == Instructions::avx2) {
      add_avx2(loops, curve_.segments(), factor, lots_, sums);
      continue;
    }
#endif
    add(loops, curve_.segments(), factor, lots_, sums);
  }
  for (std::size_t l = 0; l < lanes; ++l) {
    sums_.damage[l] += batch.count * sums.damage[l];
    sums_.largest[l] = std::max(sums_.largest[l], sums.largest[l]);
  }
  cycles_ += batch.count * static_cast<double>(batch.loops.size());
}

Outcome<double> DamageSum::total() const {
  double sum = 0.0;
  for (const double lane : sums_.damage) sum += lane;
  if (!std::isfinite(sum)) return Fault{0, 1, say("the damage exceeds the range of numbers"), {}};
  return sum;
}

double DamageSum::largest_stress() const { return *std::max_element(sums_.largest.begin(), sums_.largest.end()); }

void damages_of(const SnCurve& curve, DamageSum::Lots& lots, Instructions instructions) {
#if defined(__x86_64__)
  if (instructions == Instructions::avx2)
    weigh_avx2(curve.segments(), lots);
  else
#endif
    weigh(curve.segments(), lots);
  for (double& damage : lots.damage) damage = std::min(damage, std::numeric_limits<double>::max());
}

std::optional<double> equivalent_stress(const SnCurve& curve, double damage, double cycles) {
  return damage > 0.0 && cycles > 0.0 ? curve.stress(cycles / damage) : std::nullopt;
}

void LargestShares::take(const Batch& batch) {
  const double factor = factor_of(curve_.measure());
  for (std::size_t i = 0; i < batch.loops.size(); ++i) {
    const Loop& loop = batch.loops[i];
    const double damage = batch.count * curve_.damage(loop.range() * factor);
    if (!(damage > 0.0) || (shares_.size() == how_many_ && !(damage > shares_.back().damage))) continue;
    const Where where = batch.where.empty() ? Where{} : batch.where[i];
    const Share share{{loop.range(), loop.mean(), batch.count, where}, damage};
    const auto less = [](double a, const Share& b) { return a > b.damage; };
    shares_.insert(std::upper_bound(shares_.begin(), shares_.end(), damage, less), share);
    if (shares_.size() > how_many_) shares_.pop_back();
  }
}

}  // namespace loadpath::rainflow
