// Calculators with lists: at least 10 million elements a second, without an allocation (tests/contract/evaluation.cpp).
#include "calculators/column/buckling.hpp"
#include "calculators/drive/train.hpp"
#include "calculators/section/built_up.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace loadpath;

template <class C>
void elements(benchmark::State& state, const typename C::Input& in, std::size_t count) {
  NoTrace trace;
  for ([[maybe_unused]] auto _ : state) {
    const auto r = C::evaluate(in, trace);
    benchmark::DoNotOptimize(&r);
    benchmark::ClobberMemory();
  }
  state.counters["elements"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

void train(benchmark::State& state) {
  drive::Train::Input in;
  in.P = 5.5e3 * W, in.n_1 = from_si<AngularSpeed>(150.0);
  for (int k = 0; k < 4; ++k) {
    drive::Train::Stage stage;
    stage.z_1 = 20, stage.z_2 = 57, stage.m_n = 2.0 * mm, stage.eta = 0.97;
    in.stages.push_back(stage);
    stage.kind = drive::Train::StageKind::belt, stage.z_1 = stage.z_2 = 0, stage.i = 2.5;
    in.stages.push_back(stage);
  }
  elements<drive::Train>(state, in, in.stages.size());
}

void plates(benchmark::State& state) {
  section::BuiltUp::Input in;
  for (int k = 0; k < 8; ++k) {
    section::BuiltUp::Part plate;
    plate.shape = section::BuiltUp::Shape::rectangle;
    plate.b = 100.0 * mm, plate.h = 10.0 * mm;
    plate.z = 20.0 * k * mm;
    in.parts.push_back(plate);
  }
  elements<section::BuiltUp>(state, in, in.parts.size());
}

/// A bar about both axes, by every method that its data allow.
void bar(benchmark::State& state) {
  column::Buckling::Input in;
  in.b = 40.0 * mm, in.h = 60.0 * mm, in.l = 1.8 * m, in.P = 10.0 * kN;
  in.beta_y = 2.0, in.beta_z = 1.0, in.n_st = 3.0;
  in.E = 210.0 * GPa, in.sigma_P = 200.0 * MPa, in.R_e = 235.0 * MPa;
  in.method = column::Method::euler;
  NoTrace off;
  const auto r = column::Buckling::evaluate(in, off);
  elements<column::Buckling>(state, in, r.axes.size() + r.methods.size());
}

}  // namespace

BENCHMARK(bar);
BENCHMARK(train);
BENCHMARK(plates);
BENCHMARK_MAIN();
