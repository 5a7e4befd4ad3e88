#include "calculators/fatigue/scatter/staircase.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/quantile.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Staircase::Input;
using Result = Staircase::Result;
using End = Staircase::End;

bool is_log(const Input& in) { return in.steps == Staircase::Steps::logarithmic; }

/// Quantity with equal steps: the stress in MPa, or its lg.
double height(const Input& in, const Staircase::Test& test) {
  return is_log(in) ? std::log10(test.S / MPa) : test.S / MPa;
}

int tests_that(const Input& in, End end) {
  return static_cast<int>(
      std::count_if(in.tests.begin(), in.tests.end(), [&](const Staircase::Test& test) { return test.end == end; }));
}

/// The rarer outcome; of as many of both, failures.
End rarer(const Input& in) {
  return tests_that(in, End::failure) <= tests_that(in, End::runout) ? End::failure : End::runout;
}

double step_of(const Input& in) { return std::abs(height(in, in.tests[1]) - height(in, in.tests[0])); }

struct Counts {
  double lowest = HUGE_VAL;
  double N = 0.0, A = 0.0, B = 0.0;
};

Counts counted(const Input& in, End end, double step) {
  Counts c;
  for (const auto& test : in.tests) {
    if (test.end == end) c.lowest = std::min(c.lowest, height(in, test));
  }
  for (const auto& test : in.tests) {
    if (test.end != end) continue;
    const double i = std::round((height(in, test) - c.lowest) / step);
    c.N += 1.0, c.A += i, c.B += i * i;
  }
  return c;
}

/// Normal in stress.
template <class Tracer>
void linear(const Input& in, const Counts& c, double half, bool has_scatter, Result& r, Tracer& trace) {
  const Stress S_0 = trace.value("S_0", c.lowest * MPa, "lowest stress with that outcome");
  const Stress d = r.d = trace.value("d", step_of(in) * MPa, "step between neighbouring tests");
  STEP_TO(r, S_50, S_0 + d * (r.A / r.N + half), "mean strength, [DixonMood]");
  if (!has_scatter) return;
  STEP_TO(r, s, 1.62 * d * (r.D + 0.029), "from D = 0.3 on, [DixonMood]");
  const double z_90 = trace.value("z_90", numerics::normal_quantile(0.9), "standard normal deviate of 90 %");
  STEP(S_90, S_50 - z_90 * s, "strength at 90 % survival");
  if (S_90 > 0.0 * MPa) {
    STEP_TO(r, T_S, (S_50 + z_90 * s) / S_90, "strengths at 10 % and at 90 % survival");
  }
  const double z_P = trace.value("z_P", numerics::normal_quantile(in.P_s), "standard normal deviate of P_s");
  STEP(S_P, S_50 - z_P * s, "strength that the share P_s survives");
  if (S_P > 0.0 * MPa) r.S_P = S_P;
}

/// Normal in the logarithm of stress.
template <class Tracer>
void logarithmic(const Input& in, const Counts& c, double half, bool has_scatter, Result& r, Tracer& trace) {
  using std::pow;
  const double X_0 = trace.value("X_0", c.lowest, "lg of the lowest stress in MPa with that outcome");
  const double d_lg = trace.value("d_lg", step_of(in), "step of lg S between neighbouring tests");
  STEP_TO(r, q, pow(10.0, d_lg), "ratio of neighbouring stresses");
  STEP(X_50, X_0 + d_lg * (r.A / r.N + half), "mean of lg S, [DixonMood]");
  STEP_TO(r, S_50, pow(10.0, X_50) * MPa, "mean strength");
  if (!has_scatter) return;
  STEP_TO(r, s_lg, 1.62 * d_lg * (r.D + 0.029), "from D = 0.3 on, [DixonMood]");
  const double z_90 = trace.value("z_90", numerics::normal_quantile(0.9), "standard normal deviate of 90 %");
  STEP_TO(r, T_S, pow(10.0, 2.0 * z_90 * s_lg), "strengths at 10 % and at 90 % survival");
  const double z_P = trace.value("z_P", numerics::normal_quantile(in.P_s), "standard normal deviate of P_s");
  STEP_TO(r, S_P, pow(10.0, X_50 - z_P * s_lg) * MPa, "strength that the share P_s survives");
}

/// Tests of one outcome in their order.
figure::Curve dots(const Input& in, End end, const char* label) {
  figure::Curve curve{label, {}, {}};
  for (std::size_t i = 0; i < in.tests.size(); ++i) {
    if (in.tests[i].end != end) continue;
    curve.x.insert(curve.x.end(), {static_cast<double>(i + 1), unset<double>});
    curve.y.insert(curve.y.end(), {in_si(in.tests[i].S), unset<double>});
  }
  return curve;
}

}  // namespace

bool Staircase::has_both(const Input& in) {
  return tests_that(in, End::failure) > 0 && tests_that(in, End::runout) > 0;
}

bool Staircase::goes_up_and_down(const Input& in) {
  if (in.tests.size() < 2) return false;
  const double step = step_of(in);
  if (!(step > 0.0)) return false;
  for (std::size_t i = 1; i < in.tests.size(); ++i) {
    const double up = height(in, in.tests[i]) - height(in, in.tests[i - 1]);
    const double due = in.tests[i - 1].end == End::failure ? -step : step;
    if (!(std::abs(up - due) <= 0.02 * step)) return false;
  }
  return true;
}

template <class Tracer>
Staircase::Result Staircase::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.n = r.x_n = trace.value("n", static_cast<double>(in.tests.size()), "tests");
  const End end = rarer(in);
  const Counts c = counted(in, end, step_of(in));
  r.N = trace.value("N", c.N, end == End::failure ? "failures, the rarer outcome" : "run-outs, the rarer outcome");
  r.A = trace.value("A", c.A, "sum of i f_i, i in steps above the lowest of them");
  r.B = trace.value("B", c.B, "sum of i^2 f_i");
  STEP_TO(r, D, (r.N * r.B - pow<2>(r.A)) / pow<2>(r.N), "[DixonMood]");
  r.x_s = trace.value("x_s", D, "the formula of the standard deviation holds from 0.3 on, [DixonMood]");
  const bool has_scatter = D >= 0.3 - 1e-9;
  const double half =
      trace.value("half", end == End::failure ? -0.5 : 0.5, "failures lie above the mean, run-outs below");
  is_log(in) ? logarithmic(in, c, half, has_scatter, r, trace) : linear(in, c, half, has_scatter, r, trace);
  STEP_TO(r, P_f, 1.0 - in.P_s, "few tests do not support a tail");
  return r;
}

template Staircase::Result Staircase::evaluate(const Input&, NoTrace&);
template Staircase::Result Staircase::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Staircase::figures(const Input& in, const Result& r) {
  figure::Plot plot;
  plot.x = {"test", "tests in their order", "-"};
  plot.y = {"S", "stress", "MPa"};
  plot.curves = {dots(in, End::failure, "failures"), dots(in, End::runout, "run-outs")};
  plot.bounds.push_back({in_si(r.S_50), "S_50"});
  return {{"staircase", "The staircase, and its mean", std::move(plot)}};
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Staircase>();
