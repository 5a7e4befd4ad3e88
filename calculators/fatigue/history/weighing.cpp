#include "calculators/fatigue/history/weighing.hpp"

#include "calculators/fatigue/history/cycles.hpp"
#include "calculators/fatigue/history/means.hpp"
#include "lib/rainflow/damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::fatigue {

using Input = HistoryTypes::Input;
using rainflow::Cycle;

template <class Tracer>
Stress on_curve(const Input& in, const Haigh& haigh, const Cycle& cycle, Tracer& trace) {
  const Stress sigma_a0 = trace.value("sigma_a0", amplitude_of(cycle), "amplitude, as counted");
  const Stress sigma_mc = trace.value("sigma_mc", mean_of(cycle), "mean stress, as counted");
  STEP(sigma_a, in.K_A * sigma_a0, "with the application factor");
  if (!HistoryTypes::is_of_part(in))
    return NAMED_STEP("S_1", 2.0 * in.S_D * sigma_a, "range, with the safety on stress");
  if (!counts_means(in) || sigma_a == 0.0 * MPa)
    return NAMED_STEP("S_1", in.S_D * sigma_a, "with the safety on stress; its mean is not counted");
  STEP(sigma_s, in.stress == Stresses::shear ? in.K_A * abs(sigma_mc) : in.K_A * sigma_mc,
       "with the application factor; of shear its magnitude");
  STEP(sigma_m, in.mean == HistoryTypes::Means::fkm ? sigma_s : max(sigma_s, 0.0 * MPa),
       "the benefit of compression is considered by FKM only");
  if (in.stress == Stresses::shear && is_set(haigh.R_m)) trace.value("R_m", haigh.R_m, "of shear, [Shigley6] (6-54)");
  if (in.stress == Stresses::shear && is_set(haigh.R_e)) trace.value("R_e", haigh.R_e, "of shear, [Mises]");
  const Stress sigma_ar = equivalent(rule_of(in), haigh, {sigma_a, sigma_m}, trace);
  return NAMED_STEP("S_1", in.S_D * sigma_ar, "amplitude at r = −1, with the safety on stress");
}
template Stress on_curve(const Input&, const Haigh&, const Cycle&, NoTrace&);
template Stress on_curve(const Input&, const Haigh&, const Cycle&, Trace&);

namespace {

/// Hands each cycle to a function, those of blocks too.
template <class Take>
class EachCycle final : public rainflow::Consumer {
 public:
  explicit EachCycle(const Take& take) : take_(take) {}
  void take(const rainflow::Batch& batch) override {
    for (std::size_t i = 0; i < batch.loops.size(); ++i) {
      const rainflow::Loop& loop = batch.loops[i];
      take_(Cycle{loop.range(), loop.mean(), batch.count, batch.where.empty() ? rainflow::Where{} : batch.where[i]});
    }
  }

 private:
  const Take& take_;
};

/// `placed`: with the places of the cycles, which costs a multiple of their counting.
template <class Take>
void for_each_cycle(const Input& in, bool placed, const Take& take) {
  for (const Cycle& cycle : cycles_of_blocks(in)) take(cycle);
  if (!in.sigma.is_series()) return;
  EachCycle<Take> consumer(take);
  count_into(in, consumer, placed);
}

/// Cycles above the omission level in lots, whose damage is computed together.
class Lots {
 public:
  Lots(std::span<const rainflow::SnCurve> curves, HistoryDamage& weighed) : curves_(curves), weighed_(weighed) {
    weighed_.damage.assign(curves.size(), 0.0);
  }

  void add(const Cycle& cycle, double stress) {
    cycles_[filled_] = cycle;
    lots_.stress[filled_++] = stress;
    if (filled_ == rainflow::lot) weigh();
  }
  /// The cycles since the last full lot.
  void finish() {
    std::fill(lots_.stress.begin() + static_cast<std::ptrdiff_t>(filled_), lots_.stress.end(), 0.0);
    weigh();
  }

 private:
  void weigh() {
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      damages_of(curves_[k], lots_, instructions_);
      double sum = 0.0;
      for (std::size_t i = 0; i < filled_; ++i) sum += cycles_[i].count * lots_.damage[i];
      weighed_.damage[k] += sum;
      if (k == 0) take_worst();
    }
    filled_ = 0;
  }

  void take_worst() {
    std::vector<DamagingCycle>& worst = weighed_.worst;
    for (std::size_t i = 0; i < filled_; ++i) {
      const DamagingCycle one{cycles_[i], lots_.stress[i], cycles_[i].count * lots_.damage[i]};
      const bool is_full = worst.size() == HistoryTypes::most_worst;
      if (is_full && !outweighs(one, worst.back())) continue;
      if (is_full) worst.pop_back();
      worst.insert(std::upper_bound(worst.begin(), worst.end(), one, outweighs), one);
    }
  }

  static bool outweighs(const DamagingCycle& a, const DamagingCycle& b) {
    return a.damage > b.damage || (a.damage == b.damage && a.stress > b.stress);
  }

  std::span<const rainflow::SnCurve> curves_;
  HistoryDamage& weighed_;
  std::array<Cycle, rainflow::lot> cycles_;
  rainflow::DamageSum::Lots lots_{};
  std::size_t filled_ = 0;
  rainflow::Instructions instructions_ = rainflow::best_instructions();
};

}  // namespace

double largest_on_curve(const Input& in) {
  const Haigh haigh = haigh_of(in);
  NoTrace quiet;
  double largest = 0.0;
  for_each_cycle(in, false, [&](const Cycle& cycle) {
    if (!(cycle.range < in_si(in.gate))) largest = std::max(largest, on_curve(in, haigh, cycle, quiet) / MPa);
  });
  return largest;
}

HistoryDamage weigh(const Input& in, std::span<const rainflow::SnCurve> curves, bool keeps_levels) {
  const Haigh haigh = haigh_of(in);
  const double gate = in_si(in.gate);
  NoTrace quiet;
  HistoryDamage weighed, left_out;
  Lots kept(curves, weighed), small(curves.first(1), left_out);
  const Stress end = counts_means(in) ? largest_mean(haigh, rule_of(in)) : unset<Stress>;
  if (is_set(end)) weighed.largest_mean = 0.0;
  for_each_cycle(in, true, [&](const Cycle& cycle) {
    const Stress mean = in.K_A * mean_of(cycle);
    if (is_set(end))
      weighed.largest_mean =
          std::max(weighed.largest_mean, reduced((in.stress == Stresses::shear ? abs(mean) : mean) / end));
    const double stress = on_curve(in, haigh, cycle, quiet) / MPa;
    if (cycle.range < gate) return small.add(cycle, stress);
    weighed.cycles += cycle.count;
    weighed.largest = std::max(weighed.largest, stress);
    if (keeps_levels) weighed.levels.push_back({stress, cycle.count});
    kept.add(cycle, stress);
  });
  kept.finish();
  small.finish();
  weighed.small = left_out.damage[0];
  return weighed;
}

bool has_tensile_mean(const Input& in) {
  bool found = false;
  for_each_cycle(in, false, [&](const Cycle& cycle) {
    const double mean = in.stress == Stresses::shear ? std::abs(cycle.mean) : cycle.mean;
    found = found || mean > 1e-9 * cycle.range;
  });
  return found;
}

}  // namespace loadpath::fatigue
