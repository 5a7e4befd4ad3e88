#include "calculators/dynamics/lift.hpp"

#include "calculators/motion/laws.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::dynamics {

namespace {

using Input = Lift::Input;
using Moves = Lift::Moves;
using Result = Lift::Result;

/// Everything reduced to the path s: what has the same work and the same kinetic energy.
template <class Tracer>
void reduce(const Input& in, Result& r, Tracer& trace) {
  r.m_red = trace.value("m_red", Lift::reduced_mass(in), "sum of m i^2 and J (i/r)^2: the same kinetic energy, [B37]");
  r.F_G = r.F_d = r.F_f = 0.0 * N;
  for (const auto& w : in.weights) {
    const double hang = motion::without_rounding(cos(w.alpha), 1.0);
    r.F_G += w.mass * in.g * sin(w.alpha) * w.i;
    r.F_f += w.mu * w.mass * in.g * hang * std::abs(w.i);
  }
  for (const auto& w : in.wheels) {
    r.F_d += w.M_d * w.i / w.r;
    r.F_f += w.M_f * std::abs(w.i) / w.r;
  }
  trace.value("F_G", r.F_G, "sum of m g sin(alpha) i: the same work, [B37]");
  trace.value("F_d", r.F_d, "sum of M_d i/r: the same work, [B37]");
  trace.value("F_f", r.F_f, "sum of M_f |i|/r and mu m g cos(alpha) |i|: the same work, [B37]");
}

/// From rest friction holds what the other forces do not exceed.
Moves moves_of(const Input& in, const Result& r) {
  if (in_si(in.v_0) > 0.0) return Moves::forwards;
  const Force pull = r.F_G + r.F_d;
  if (abs(pull) <= r.F_f) return Moves::stands;
  return in_si(pull) > 0.0 ? Moves::forwards : Moves::backwards;
}

template <class Tracer>
void accelerate(Result& r, Tracer& trace) {
  if (r.moves == Moves::stands) {
    STEP_TO(r, F, 0.0 * N, "friction holds the lift at rest");
    r.a = 0.0 * m_per_s2;
    return;
  }
  STEP(sense, r.moves == Moves::forwards ? 1.0 : -1.0, "1 forwards, -1 backwards");
  STEP_TO(r, F, r.F_G + r.F_d - sense * r.F_f, "friction is against the motion, [B37]");
  STEP_TO(r, a, F / r.m_red, "theorem of kinetic energy over a small path, [B37]");
}

/// Speed and time over the path, where the lift gets to its end.
template <class Tracer>
void run(const Input& in, Result& r, Tracer& trace) {
  const auto v_0 = in.v_0;
  if (r.moves == Moves::forwards) r.u_s = 0.0;  // backwards it never gets to s
  if (r.moves == Moves::forwards && in_si(r.a) < 0.0) {
    STEP_TO(r, s_stop, v_0 * v_0 / (-2.0 * r.a), "all of the kinetic energy is used up");
    STEP_TO(r, u_s, in.s / s_stop, "path over the one to a standstill");
    if (u_s > 1.0) return;
  }
  const double sense = r.moves == Moves::backwards ? -1.0 : 1.0;
  STEP_TO(r, A, sense * r.F * in.s, "work of all forces, [B37]");
  STEP(v_end, sqrt(max(v_0 * v_0 + 2.0 * sense * r.a * in.s, 0.0 * v_0 * v_0)), "theorem of kinetic energy, [B37]");
  r.v = sense * v_end;
  if (!(in_si(v_0 + v_end) > 0.0)) return;
  STEP_TO(r, t, 2.0 * in.s / (v_0 + v_end), "mean speed of a constant acceleration");
}

/// The least force of the threads, of hanging loads and of loads on a slope.
void take_least(Force T, const Lift::Weight& w, Result& r) {
  if (Lift::is_level(w)) return;
  Force& least = Lift::hangs(w) ? r.T_hang : r.T_slope;
  if (!(T >= least)) least = T;
}

void take_parts(const Input& in, Result& r) {
  const double sense = r.moves == Moves::stands ? 0.0 : r.moves == Moves::forwards ? 1.0 : -1.0;
  for (const auto& w : in.weights) {
    const double way = w.i * sense > 0.0 ? 1.0 : w.i * sense < 0.0 ? -1.0 : 0.0;
    const double hang = motion::without_rounding(cos(w.alpha), 1.0);
    const Speed v = w.i * r.v;
    Lift::WeightState state{w.name, v, 0.5 * w.mass * v * v, unset<Force>};
    if (r.moves != Moves::stands || Lift::hangs(w)) {
      const Force T = w.mass * (in.g * (sin(w.alpha) - way * w.mu * hang) - w.i * r.a);
      state.T = motion::without_rounding(T / (w.mass * in.g), 1.0 + std::abs(w.i * r.a / in.g)) * (w.mass * in.g);
      take_least(state.T, w, r);
    }
    r.weight_states.push_back(state);
  }
  for (const auto& w : in.wheels) {
    const AngularSpeed omega = w.i * r.v / w.r;
    r.wheel_states.push_back({w.name, omega, omega, 0.5 * w.J * omega * omega, w.M_d * omega});
  }
}

}  // namespace

Mass Lift::reduced_mass(const Input& in) {
  Mass sum = 0.0 * kg;
  for (const Weight& w : in.weights) sum += w.mass * w.i * w.i;
  for (const Wheel& w : in.wheels) sum += w.J * (w.i / w.r) * (w.i / w.r);
  return sum;
}

template <class Tracer>
Lift::Result Lift::evaluate(const Input& given, Tracer& trace) {
  Result r;
  Input in = given;
  in.g = r.g = gravity_of(given, trace);
  reduce(in, r, trace);
  r.moves = moves_of(in, r);
  accelerate(r, trace);
  if (r.moves != Moves::stands) {
    run(in, r, trace);
  } else {
    r.v = 0.0 * m_per_s;
  }
  take_parts(in, r);
  return r;
}

template Lift::Result Lift::evaluate(const Input&, NoTrace&);
template Lift::Result Lift::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::Lift>();
