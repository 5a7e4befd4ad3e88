// The search of belt.v_sizing over all sections, pulleys and lengths of a basis (at most 20 ms), and one drive of
// belt.v.
#include "calculators/belt/v/sizing.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace loadpath;

belt::VSizing::Input wide_question(belt::Basis basis) {
  belt::VSizing::Input in;
  in.basis = basis;
  if (basis == belt::Basis::iso) in.belt_class = belt::V::BeltClass::IV;
  in.P = 30e3 * W;
  in.K_A = 1.2;
  in.n_1 = 1000.0 * rpm, in.n_2_set = 500.0 * rpm;
  in.tol_n = 0.1;
  in.a_set = 1.5 * m, in.tol_a = 0.5;
  in.z_max = 20;
  return in;
}

void sizing(benchmark::State& state, belt::Basis basis) {
  const auto in = wide_question(basis);
  NoTrace trace;
  double tried = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const auto r = belt::VSizing::evaluate(in, trace);
    tried = r.tried;
    benchmark::DoNotOptimize(r.candidates.data());
  }
  state.counters["tried"] = tried;
}

void one_drive(benchmark::State& state) {
  belt::V::Input in;
  in.basis = belt::Basis::optibelt;
  in.section = "SPB";
  in.P = 30e3 * W;
  in.K_A = 1.2;
  in.n_1 = 1460.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = 400.0 * mm, in.L = 2650.0 * mm;
  NoTrace trace;
  for ([[maybe_unused]] auto _ : state) {
    const auto r = belt::V::evaluate(in, trace);
    benchmark::DoNotOptimize(r.u_P);
  }
}

}  // namespace

BENCHMARK_CAPTURE(sizing, iso, belt::Basis::iso);
BENCHMARK_CAPTURE(sizing, optibelt, belt::Basis::optibelt);
BENCHMARK(one_drive);
BENCHMARK_MAIN();
