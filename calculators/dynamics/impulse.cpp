#include "calculators/dynamics/impulse.hpp"

#include "calculators/motion/path_figures.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/quadrature.hpp"
#include "lib/quantity/expression/resolved.hpp"

#include <cmath>

// The mass m hides the unit of its name where the formulas are.
#pragma GCC diagnostic ignored "-Wshadow"

namespace loadpath::dynamics {

namespace {

using motion::Written;

std::array<Written, 3> laws_of(const Impulse::Input& in) {
  return {{{"F_x", &in.F_x}, {"F_y", &in.F_y}, {"F_z", &in.F_z}}};
}

constexpr double followed = 1e-5;  // share of the largest force: smaller pulses may be missed

/// Nothing where the law is empty or is none.
Resolved resolved(const Written& law, const Impulse::Input& in) {
  const Law* const read = law.text->empty() ? nullptr : law.text->law();
  return read == nullptr ? Resolved{} : resolve(*read, in_si(in.t_1), in_si(in.t_2), followed);
}

/// Places between two corners, denser towards both: the tail of a pulse ends next to a long interval.
template <class Take>
void for_each_graded(double from, double to, const Take& take) {
  constexpr int halvings = 24;
  const double half = 0.5 * (to - from);
  for (int k = 0; k <= halvings; ++k) {
    const double outer = std::ldexp(half, -k), inner = k < halvings ? 0.5 * outer : 0.0;
    take(from + inner, from + outer);
    take(to - outer, to - inner);
  }
}

/// Piece by piece where the force is a pulse that places far from one another could miss.
Momentum impulse_of(const Written& law, const Impulse::Input& in) {
  constexpr std::size_t few = 65;
  const auto value = [](const void* of, double t) { return motion::at(*static_cast<const Written*>(of), t).value; };
  const Resolved pieces = resolved(law, in);
  if (pieces.corners.size() <= few) return motion::integral(value, &law, in_si(in.t_1), in_si(in.t_2)) * N_s;
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < pieces.corners.size(); ++k) {
    for_each_graded(pieces.corners[k].first, pieces.corners[k + 1].first, [&](double from, double to) {
      numerics::for_each_gauss_8(from, to, [&](double t, double weight) { sum += weight * motion::at(law, t).value; });
    });
  }
  return sum * N_s;
}

/// A law with more waves than can be followed between its ends.
FieldFault unresolved(const Impulse::Input& in) {
  for (const Written& law : laws_of(in)) {
    if (!resolved(law, in).complete)
      return {law.key, say("the law has a pole or too many oscillations between t_1 and t_2"),
              say("shorten the time, or give a smoother law")};
  }
  return {};
}

template <class Tracer>
void take_mean(const Impulse::Input& in, Impulse::Result& r, Tracer& trace) {
  STEP_TO(r, I, sqrt(r.I_x * r.I_x + r.I_y * r.I_y + r.I_z * r.I_z), "magnitude");
  STEP_TO(r, F_mx, r.I_x / (in.t_2 - in.t_1), "the constant force of the same impulse");
  STEP_TO(r, F_my, r.I_y / (in.t_2 - in.t_1), "the constant force of the same impulse");
  STEP_TO(r, F_mz, r.I_z / (in.t_2 - in.t_1), "the constant force of the same impulse");
  STEP_TO(r, F_m, I / (in.t_2 - in.t_1), "the constant force of the same impulse");
}

}  // namespace

bool Impulse::laws_read(const Input& in) { return law_fault(in).message.empty(); }
FieldFault Impulse::law_fault(const Input& in) { return motion::reading_fault(laws_of(in)); }
bool Impulse::laws_are_smooth(const Input& in) { return gap(in).message.empty(); }
FieldFault Impulse::gap(const Input& in) {
  FieldFault fault = motion::gap_fault(laws_of(in), in_si(in.t_1), in_si(in.t_2));
  const bool asked = laws_read(in) && in_si(in.t_2) > in_si(in.t_1);
  return fault.message.empty() && asked ? unresolved(in) : fault;
}

template <class Tracer>
Impulse::Result Impulse::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto m = in.mass;
  constexpr const char* integral = "integral of the force over the time, [B33]";
  const Momentum I_x = r.I_x = trace.value("I_x", impulse_of(laws_of(in)[0], in), integral);
  const Momentum I_y = r.I_y = trace.value("I_y", impulse_of(laws_of(in)[1], in), integral);
  const Momentum I_z = r.I_z = trace.value("I_z", impulse_of(laws_of(in)[2], in), integral);
  take_mean(in, r, trace);
  STEP_TO(r, q_1x, m * in.v_1x, "momentum before, [B33]");
  STEP_TO(r, q_1y, m * in.v_1y, "momentum before, [B33]");
  STEP_TO(r, q_1z, m * in.v_1z, "momentum before, [B33]");
  STEP_TO(r, q_2x, q_1x + I_x, "theorem of momentum, [B33]");
  STEP_TO(r, q_2y, q_1y + I_y, "theorem of momentum, [B33]");
  STEP_TO(r, q_2z, q_1z + I_z, "theorem of momentum, [B33]");
  STEP_TO(r, v_2x, q_2x / m, "momentum after, [B33]");
  STEP_TO(r, v_2y, q_2y / m, "momentum after, [B33]");
  STEP_TO(r, v_2z, q_2z / m, "momentum after, [B33]");
  STEP_TO(r, v_2, sqrt(v_2x * v_2x + v_2y * v_2y + v_2z * v_2z), "magnitude");
  STEP_TO(r, A, 0.5 * m * (v_2 * v_2 - in.v_1x * in.v_1x - in.v_1y * in.v_1y - in.v_1z * in.v_1z),
          "change of the kinetic energy, [B34] (11)");
  return r;
}

template Impulse::Result Impulse::evaluate(const Input&, NoTrace&);
template Impulse::Result Impulse::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Impulse::figures(const Input& in, const Result& r) {
  figure::Plot plot = motion::over_time("F", "force", "N");
  const bool one = in.F_y.empty() && in.F_z.empty();
  for (const Written& law : laws_of(in)) {
    if (law.text->empty()) continue;
    const auto force = [&](double t) { return motion::at(law, t).value; };
    plot.curves.push_back(motion::curve_over(in_si(in.t_1), in_si(in.t_2), 181, law.key, force));
    plot.curves.back().filled = one;
  }
  if (one) plot.bounds.push_back({in_si(r.F_mx), "mean"});
  return {{"force", "Force over time; its area is the impulse", std::move(plot)}};
}

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::Impulse>();
