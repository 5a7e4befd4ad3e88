// The search of gear.sizing over its whole range (at most 200 ms): with a pair that carries the load, and without one,
// where every combination is rated.
#include "calculators/gear/sizing/sizing.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace loadpath;
using namespace loadpath::gear;

PairSizing::Input wide_question(double kilowatts) {
  PairSizing::Input in;
  in.P = kilowatts * 1e3 * W, in.n_1 = 1450.0 * rpm, in.i_set = 4.1, in.K_A = 1.25;
  in.betas = {{0.0}, {12.0 * deg.one}};
  in.grade = 6, in.finish = Finish::ground, in.R_z1 = in.R_z2 = 5.0 * um;
  in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.quality_1 = in.quality_2 = Quality::MQ, in.H_1 = in.H_2 = 720, in.place = gear::Place::middle;
  in.S_Hmin = 1.1, in.S_Fmin = 1.4;
  return in;
}

void sizing(benchmark::State& state, double kilowatts, RatingStandard standard) {
  auto in = wide_question(kilowatts);
  in.standard = standard, in.nu_40 = 150.0 * mm2_per_s.one;
  NoTrace trace;
  for ([[maybe_unused]] auto _ : state) {
    const auto r = PairSizing::evaluate(in, trace);
    benchmark::DoNotOptimize(r.candidates.data());
  }
}

}  // namespace

BENCHMARK_CAPTURE(sizing, din3990, 15.0, RatingStandard::din3990);
BENCHMARK_CAPTURE(sizing, iso6336, 15.0, RatingStandard::iso6336);
BENCHMARK_CAPTURE(sizing, none_passes, 1e9, RatingStandard::iso6336);
BENCHMARK_MAIN();
