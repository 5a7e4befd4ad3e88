#include "calculators/dynamics/momentum.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::dynamics {

namespace {

using Input = SystemMomentum::Input;
using Result = SystemMomentum::Result;

/// Sums over the bodies.
template <class Tracer>
void add_up(const Input& in, Result& r, Tracer& trace) {
  Momentum Q_1 = 0.0 * N_s, q_k = 0.0 * N_s;
  Mass M = 0.0 * kg, m_k = 0.0 * kg;
  Moment E_1 = 0.0 * J;
  for (const auto& body : in.bodies) {
    M += body.mass;
    Q_1 += body.mass * body.v_1;
    E_1 += 0.5 * body.mass * body.v_1 * body.v_1;
    if (is_set(body.v_2)) {
      q_k += body.mass * body.v_2;
    } else {
      m_k += body.mass;
    }
  }
  r.M = trace.value("M", M, "sum of the masses");
  r.Q_1 = trace.value("Q_1", Q_1, "sum of m v before, [B35]");
  r.q_k = trace.value("q_k", q_k, "sum of m v after, of the bodies whose velocity is given");
  r.m_k = trace.value("m_k", m_k, "mass of the bodies whose velocity is to be found");
  r.E_1 = E_1;
}

/// The two bodies of an impact part by e times the velocity that they met with.
template <class Tracer>
void part(const Input& in, Result& r, Tracer& trace) {
  const auto m_1 = trace.value("m_1", in.bodies[0].mass, "mass of the first body");
  const auto m_2 = trace.value("m_2", in.bodies[1].mass, "mass of the second body");
  const Speed v_11 = trace.value("v_11", in.bodies[0].v_1, "velocity of the first body before");
  const Speed v_21 = trace.value("v_21", in.bodies[1].v_1, "velocity of the second body before");
  STEP(v_12, r.V_k - in.e * m_2 / (m_1 + m_2) * (v_11 - v_21), "first body: the bodies part by e times their approach");
  STEP(v_22, r.V_k + in.e * m_1 / (m_1 + m_2) * (v_11 - v_21),
       "second body: the bodies part by e times their approach");
  r.after[0].v_2 = v_12, r.after[1].v_2 = v_22;
}

void finish(const Input& in, Result& r) {
  r.E_2 = 0.0 * J;
  for (std::size_t i = 0; i < in.bodies.size(); ++i) {
    auto& after = r.after[i];
    after.I = in.bodies[i].mass * (after.v_2 - in.bodies[i].v_1);
    r.E_2 += 0.5 * in.bodies[i].mass * after.v_2 * after.v_2;
  }
}

bool is_impact(const Input& in) { return is_set(in.e); }

}  // namespace

bool SystemMomentum::some_are_open(const Input& in) {
  return std::any_of(in.bodies.begin(), in.bodies.end(), [](const Body& body) { return !is_set(body.v_2); });
}
bool SystemMomentum::impact_is_of_two(const Input& in) {
  return !is_impact(in) || (in.bodies.size() == 2 && !is_set(in.bodies[0].v_2) && !is_set(in.bodies[1].v_2));
}
bool SystemMomentum::bodies_meet(const Input& in) {
  return !is_impact(in) || in.bodies.size() != 2 || in.bodies[0].v_1 != in.bodies[1].v_1;
}

template <class Tracer>
SystemMomentum::Result SystemMomentum::evaluate(const Input& in, Tracer& trace) {
  Result r;
  add_up(in, r, trace);
  STEP_TO(r, V_1, r.Q_1 / r.M, "Q = M V_C, [B35]");
  STEP_TO(r, Q_2, r.Q_1 + in.S, "theorem of momentum of a system, [B35]");
  STEP_TO(r, V_k, (Q_2 - r.q_k) / r.m_k, "momentum that is left for the bodies to be found, [B35]");
  for (const Body& body : in.bodies)
    r.after.push_back({body.name, is_set(body.v_2) ? body.v_2 : Speed(V_k), unset<Momentum>});
  if (is_impact(in)) part(in, r, trace);
  finish(in, r);
  trace.value("E_1", r.E_1, "sum of m v^2/2 before");
  trace.value("E_2", r.E_2, "sum of m v^2/2 after");
  STEP_TO(r, Delta_E, r.E_2 - r.E_1, "energy released or lost by internal forces");
  return r;
}

template SystemMomentum::Result SystemMomentum::evaluate(const Input&, NoTrace&);
template SystemMomentum::Result SystemMomentum::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::SystemMomentum>();
