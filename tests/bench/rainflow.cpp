// Counting and damage of ten million samples, as share of time that adding them up takes in the same process: at
// least 0.30 with AVX2 (the first lines, where the machine has it), 0.09 without (portable); and the time to read as
// many lines of text.
#include "lib/rainflow/counter.hpp"
#include "lib/rainflow/damage.hpp"
#include "lib/rainflow/series/read_series.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace loadpath::rainflow;

constexpr std::size_t samples = 10'000'000;

/// Gaussian noise of up to a tenth of the sampling rate: by a Blackman-windowed sinc. 15 % of it are reversals.
std::vector<double> band_limited_noise() {
  constexpr int half = 64;
  constexpr double cut = 0.1, pi = std::numbers::pi;
  std::vector<float> taps;
  for (int k = -half; k <= half; ++k) {
    const double x = 2.0 * pi * cut * k, w = pi * k / half;
    const double window = 0.42 + 0.5 * std::cos(w) + 0.08 * std::cos(2.0 * w);
    taps.push_back(static_cast<float>(window * (k == 0 ? 2.0 * cut : std::sin(x) / (pi * k))));
  }
  std::mt19937 random(20261120);
  std::normal_distribution<float> normal(0.0F, 224.0F);
  std::vector<float> white(samples + taps.size());
  for (float& x : white) x = normal(random);
  std::vector<float> filtered(samples, 0.0F);
  constexpr std::size_t block = 4096;
  for (std::size_t from = 0; from < samples; from += block) {
    const std::size_t to = std::min(samples, from + block);
    for (std::size_t k = 0; k < taps.size(); ++k) {
      for (std::size_t i = from; i < to; ++i) filtered[i] += taps[k] * white[i + k];
    }
  }
  std::vector<double> series(filtered.begin(), filtered.end());
  // Digits that a float has not, so that no two samples are equal.
  for (std::size_t i = 0; i < samples; ++i) series[i] *= 1.0 + 1e-9 * static_cast<double>(i % 1009);
  return series;
}

const std::vector<double>& series() {
  static const std::vector<double> noise = band_limited_noise();
  return noise;
}

double add_up(const std::vector<double>& x) {
  constexpr std::size_t lanes = 32;
  double sums[lanes] = {};
  for (std::size_t i = 0; i + lanes <= x.size(); i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) sums[k] += x[i + k];
  }
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return sum;
}

/// Time of this thread: other work of the computer does not count.
double worked() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Job>
double seconds(const Job& job) {
  const double start = worked();
  job();
  return worked() - start;
}

/// Share of the time of adding up, from the fastest runs of both, which take turns.
void report(benchmark::State& state, Instructions instructions, const std::vector<SnCurve::Branch>& branches,
            bool blocks) {
  const auto curve = SnCurve::make(Measure::amplitude, {1.0, 1.0}, branches);
  double counting = 1e9, adding = 1e9, damage = 0.0, cycles = 0.0;
  for ([[maybe_unused]] const auto& turn : state) {
    adding = std::min(adding, seconds([] { benchmark::DoNotOptimize(add_up(series())); }));
    counting = std::min(counting, seconds([&] {
                          Rules rules;
                          rules.instructions = instructions, rules.blocks = blocks;
                          DamageSum sum(*curve, instructions);
                          Counter counter(rules, sum);
                          if (counter.feed(series())) state.SkipWithError("refused");
                          counter.finish();
                          damage = *sum.total(), cycles = sum.cycles();
                        }));
  }
  state.counters["share"] = adding / counting;
  state.counters["Msamples/s"] = static_cast<double>(samples) / counting / 1e6;
  state.counters["adding_Ms/s"] = static_cast<double>(samples) / adding / 1e6;
  state.counters["cycles"] = cycles;
  state.counters["damage"] = damage;
}

void slope_5(benchmark::State& state) { report(state, best_instructions(), {{5.0}}, true); }
void slope_5_portable(benchmark::State& state) { report(state, Instructions::portable, {{5.0}}, true); }
void slope_5_portable_stack_alone(benchmark::State& state) { report(state, Instructions::portable, {{5.0}}, false); }
void two_slopes(benchmark::State& state) { report(state, best_instructions(), {{5.0, 1e-10}, {9.0}}, true); }
void slope_4_7(benchmark::State& state) { report(state, best_instructions(), {{4.7}}, true); }

/// A text in memory.
class Text : public Source {
 public:
  explicit Text(const std::string& text) : rest_(text) {}
  loadpath::Outcome<std::size_t> read(std::span<char> room) override {
    const std::size_t count = std::min(room.size(), rest_.size());
    std::copy_n(rest_.begin(), count, room.begin());
    rest_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view rest_;
};

/// `columns` of six digits each, the last of which is read.
void read_lines(benchmark::State& state, int columns) {
  std::string text;
  for (const double x : series()) {
    for (int k = 1; k <= columns; ++k) {
      std::array<char, 32> digits{};
      const auto end =
          std::to_chars(digits.data(), digits.data() + digits.size(), x / k, std::chars_format::fixed, 3).ptr;
      text.append(digits.data(), end);
      text += k == columns ? '\n' : ',';
    }
  }
  double reading = 1e9;
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& turn : state) {
    count = 0;
    reading = std::min(reading, seconds([&] {
                         Form form;
                         form.column = std::to_string(columns);
                         const auto reader = read_series(std::make_unique<Text>(text), form);
                         for (auto part = (*reader)->next(); part && !part->empty(); part = (*reader)->next())
                           count += part->size();
                       }));
    if (count != samples) state.SkipWithError("not all lines");
  }
  state.counters["s"] = reading;
  state.counters["Mlines/s"] = static_cast<double>(count) / reading / 1e6;
  state.counters["MB/s"] = static_cast<double>(text.size()) / reading / 1e6;
}

void csv_one_column(benchmark::State& state) { read_lines(state, 1); }
void csv_third_column(benchmark::State& state) { read_lines(state, 3); }

}  // namespace

BENCHMARK(csv_one_column)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(csv_third_column)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(slope_5)->Iterations(15)->Unit(benchmark::kMillisecond);
BENCHMARK(slope_5_portable)->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK(slope_5_portable_stack_alone)->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK(two_slopes)->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK(slope_4_7)->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
