#include "calculators/fatigue/wohler.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/quantile.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Wohler::Input;
using Result = Wohler::Result;
using End = Wohler::End;

/// As the steps say it: at a tested stress both are the same, but for the rounding of its unit.
double lg_stress(Stress S) { return std::log(S / MPa) / std::log(10.0); }

/// The highest level with a run-out; zero where every specimen failed.
Stress highest_runout(const Input& in) {
  Stress highest = 0.0 * MPa;
  for (const auto& t : in.tests) highest = t.end == End::runout ? max(highest, t.S) : highest;
  return highest;
}

/// Sums of the regression over the failures above the run-outs.
struct Sums {
  int n = 0;
  double X = 0.0, Y = 0.0;              // means of lg S and lg N
  double xx = 0.0, xy = 0.0, yy = 0.0;  // sums of products about the means
  double X_low = 1e300, X_high = -1e300, Y_high = -1e300;
};

template <class Visit>
void for_finite(const Input& in, const Visit& visit) {
  const Stress above = highest_runout(in);
  for (const auto& t : in.tests) {
    if (t.end == End::failure && t.S > above) visit(lg_stress(t.S), std::log10(t.N));
  }
}

Sums sums_of(const Input& in) {
  Sums s;
  for_finite(in, [&](double X, double Y) {
    ++s.n, s.X += X, s.Y += Y;
    s.X_low = std::min(s.X_low, X), s.X_high = std::max(s.X_high, X), s.Y_high = std::max(s.Y_high, Y);
  });
  s.X /= s.n, s.Y /= s.n;
  for_finite(in, [&](double X, double Y) {
    s.xx += (X - s.X) * (X - s.X), s.xy += (X - s.X) * (Y - s.Y), s.yy += (Y - s.Y) * (Y - s.Y);
  });
  return s;
}

/// Sum of squares about the line, one by one: the difference of large sums would lose a small scatter.
double squares_about(const Input& in, double A, double B) {
  double sum = 0.0;
  for_finite(in, [&](double X, double Y) { sum += (Y - A - B * X) * (Y - A - B * X); });
  return sum;
}

template <class Tracer>
void fit(const Input& in, const Sums& sums, Result& r, Tracer& trace) {
  const double n = r.n = sums.n;
  trace.value("n", n, "failures above the highest run-out, X = lg(S/MPa), Y = lg N");
  const double X_m = trace.value("X_m", sums.X, "mean of X");
  const double Y_m = trace.value("Y_m", sums.Y, "mean of Y");
  const double Q_xx = trace.value("Q_xx", sums.xx, "sum of (X - X_m)^2");
  const double Q_xy = trace.value("Q_xy", sums.xy, "sum of (X - X_m)(Y - Y_m)");
  STEP_TO(r, B, Q_xy / Q_xx, "least squares, life as the dependent variable, [E739]");
  STEP_TO(r, A, Y_m - B * X_m, "the line goes through the means, [E739]");
  STEP_TO(r, k, -B, "N S^k is constant along the line");
  const double Q = trace.value("Q", squares_about(in, A, B), "sum of (Y - A - B X)^2");
  STEP_TO(r, s, sqrt(Q / (n - 2.0)), "two of the n points are spent on the line, [E739]");
  const double t_C = numerics::student_quantile(0.5 * (1.0 + in.C), sums.n - 2);
  trace.value("t_C", t_C, "Student's t of n - 2 degrees of freedom for the confidence C");
  STEP(b_C, t_C * s / sqrt(Q_xx), "half the confidence interval of the slope, [E739]");
  STEP_TO(r, B_low, B - b_C, "lower end");
  STEP_TO(r, B_high, B + b_C, "upper end");
}

template <class Tracer>
void scatter(const Input& in, Result& r, Tracer& trace) {
  using std::pow;
  const double z_90 = trace.value("z_90", numerics::normal_quantile(0.9), "standard normal deviate of 90 %");
  STEP_TO(r, T_N, pow(10.0, 2.0 * z_90 * r.s), "lives at 10 % and 90 % survival, log-normal, [ISO12107]");
  STEP_TO(r, T_S, pow(T_N, 1.0 / r.k), "the same along the stress");
  const double z_P = trace.value("z_P", numerics::normal_quantile(in.P_s), "standard normal deviate of P_s");
  STEP_TO(r, A_P, r.A - z_P * r.s, "line of survival P_s, parallel to that of 50 %");
  STEP_TO(r, P_f, 1.0 - in.P_s, "no percentile below the fifth, [E739]");
}

/// The lowest stress of a failure, wherever it lies.
Stress lowest_failure(const Input& in) {
  Stress lowest = from_si<Stress>(std::numeric_limits<double>::infinity());
  for (const auto& t : in.tests) lowest = t.end == End::failure ? min(lowest, t.S) : lowest;
  return lowest;
}

double longest(const Input& in) {
  double most = 0.0;
  for (const auto& t : in.tests) most = std::max(most, t.N);
  return most;
}

template <class Tracer>
void knee(const Input& in, Result& r, Tracer& trace) {
  using std::pow;
  const Stress S_r = highest_runout(in), S_f = lowest_failure(in);
  if (is_set(in.S_D)) {
    STEP_TO(r, S_D, in.S_D, "as given");
  } else if (S_r > 0.0 * MPa) {
    trace.value("S_r", S_r, "highest stress with a run-out");
    trace.value("S_f", S_f, "lowest stress with a failure");
    STEP_TO(r, S_D, (S_r + S_f) / 2.0,
            "mean of the two: a first estimate of the asymptote of [B20], no staircase statistics");
  } else {
    return;
  }
  STEP_TO(r, N_D, pow(10.0, r.A + r.B * log(r.S_D / MPa) / log(10.0)), "the line at the fatigue limit");
  const double N_max = trace.value("N_max", longest(in), "longest test");
  STEP_TO(r, x_D, N_D / N_max, "the line is not followed beyond the tests, [E739]");
}

template <class Tracer>
void life(const Input& in, const Sums& sums, Result& r, Tracer& trace) {
  using std::pow;
  trace.value("X_low", sums.X_low, "minimum X of the regression");
  trace.value("X_high", sums.X_high, "maximum X of the regression");
  if (is_set(in.S)) {
    STEP(X_S, log(in.S / MPa) / log(10.0), "lg of the stress");
    STEP(x_S, (X_S - sums.X_low) / (sums.X_high - sums.X_low), "the line holds between the tested stresses, [E739]");
    r.x_S = std::abs(x_S) < 1e-9 ? 0.0 : x_S;
    if (!is_set(r.S_D) || in.S > r.S_D) {
      STEP_TO(r, N_50, pow(10.0, r.A + r.B * X_S), "life of one in two");
      STEP_TO(r, N_P, pow(10.0, r.A_P + r.B * X_S), "life that the share P_s survives, with 50 % confidence");
    }
  }
  if (!is_set(in.N_0)) return;
  STEP_TO(r, S_0, pow(10.0, (log(in.N_0) / log(10.0) - r.A) / r.B) * MPa,
          "conventional fatigue limit, [B20]: the line at N_0");
  trace.value("Y_high", sums.Y_high, "maximum lg N of the regression");
  STEP_TO(r, x_N, in.N_0 / pow(10.0, sums.Y_high), "lives beyond those tested are not on the line, [E739]");
  STEP(S_most, pow(10.0, sums.X_high) * MPa, "maximum stress of the regression");
  STEP_TO(r, x_0, S_0 / S_most, "stresses beyond those tested are not on the line, [E739]");
}

/// Straight where both scales are logarithmic.
figure::Curve line(const std::string& label, double A, double B, double X_from, double X_to) {
  const auto N = [&](double X) { return std::pow(10.0, A + B * X); };
  const auto S = [](double X) { return in_si(std::pow(10.0, X) * MPa); };
  return {label, {N(X_from), N(X_to)}, {S(X_from), S(X_to)}};
}

/// Points of one kind, not joined.
figure::Curve dots(const Input& in, End end, const std::string& label) {
  figure::Curve points{label, {}, {}};
  for (const auto& t : in.tests) {
    if (t.end != end) continue;
    points.x.insert(points.x.end(), {t.N, unset<double>});
    points.y.insert(points.y.end(), {in_si(t.S), unset<double>});
  }
  return points;
}

}  // namespace

bool Wohler::enough(const Input& in) { return sums_of(in).n >= 3; }

bool Wohler::spread(const Input& in) {
  const Sums s = sums_of(in);
  return s.n < 3 || (s.X_high - s.X_low > 1e-9 && s.xy < 0.0);
}

bool Wohler::limit_is_below(const Input& in) {
  const Sums s = sums_of(in);
  return !is_set(in.S_D) || s.n < 3 || lg_stress(in.S_D) <= s.X_low + 1e-12;
}

Applies Wohler::has_knee(const Input& in) { return where(is_set(in.S_D) || highest_runout(in) > 0.0 * MPa); }

template <class Tracer>
Wohler::Result Wohler::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Sums sums = sums_of(in);
  fit(in, sums, r, trace);
  scatter(in, r, trace);
  knee(in, r, trace);
  life(in, sums, r, trace);
  return r;
}

template Wohler::Result Wohler::evaluate(const Input&, NoTrace&);
template Wohler::Result Wohler::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Wohler::figures(const Input& in, const Result& r) {
  const Sums sums = sums_of(in);
  figure::Plot plot;
  plot.x = {"N", "cycles", "-", true};
  plot.y = {"S", "stress", "MPa", true};
  const double X_low = is_set(r.S_D) && r.S_D > 0.0 * MPa ? std::min(lg_stress(r.S_D), sums.X_low) : sums.X_low;
  plot.curves.push_back(line("50 %", r.A, r.B, sums.X_high, X_low));
  plot.curves.push_back(line("P_s", r.A_P, r.B, sums.X_high, X_low));
  plot.curves.push_back(line("1 - P_s", 2.0 * r.A - r.A_P, r.B, sums.X_high, X_low));
  plot.curves.push_back(dots(in, End::failure, "failures"));
  if (highest_runout(in) > 0.0 * MPa) plot.curves.push_back(dots(in, End::runout, "run-outs"));
  if (is_set(r.S_D)) plot.bounds.push_back({in_si(r.S_D), "S_D"});
  return {{"wohler", "Test points, lines of survival and fatigue limit", std::move(plot)}};
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Wohler>();
