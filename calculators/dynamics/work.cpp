#include "calculators/dynamics/work.hpp"

#include "calculators/motion/laws.hpp"
#include "lib/calculator/calculator_of.hpp"

// The mass m hides the unit of its name where the formulas are.
#pragma GCC diagnostic ignored "-Wshadow"

namespace loadpath::dynamics {

namespace {

using Input = WorkAndEnergy::Input;
using Result = WorkAndEnergy::Result;

/// The spring, where there is one.
template <class Tracer>
void take_spring(const Input& in, Result& r, Tracer& trace) {
  r.A_c = 0.0 * J;
  if (!is_set(in.c)) return;
  const auto c = in.c;
  const auto z_1 = in.z_1, z_2 = in.z_2;
  STEP(A_c, -0.5 * c * (z_2 * z_2 - z_1 * z_1), "work of a spring, [B34] (6) with the squares apart");
  r.A_c = A_c;
}

/// Works against the motion and energies that carry it: the body gets to the end where these suffice.
double reach(const Result& r) {
  double against = 0.0, with = in_si(r.E_1);
  for (const Moment& work : {r.A_G, r.A_T, r.A_F, r.A_c}) {
    against -= std::min(0.0, in_si(work));
    with += std::max(0.0, in_si(work));
  }
  if (against == 0.0) return 0.0;
  return with > 0.0 ? against / with : unset<double>;
}

/// Time and powers of a constant acceleration; the path to a standstill.
template <class Tracer>
void take_times(const Input& in, Result& r, Tracer& trace) {
  const auto s = in.s;
  const auto v_1 = in.v_1, v_2 = r.v_2;
  const auto A = r.A, E_1 = r.E_1, A_F = r.A_F;
  if (in_si(A) < 0.0) {
    STEP(s_stop, -E_1 * s / A, "the same forces take all of the kinetic energy");
    r.s_stop = s_stop;
  }
  if (!(in_si(v_1 + v_2) > 0.0)) return;
  STEP(t, 2.0 * s / (v_1 + v_2), "mean speed of a constant acceleration");
  STEP(P_m, A_F / t, "mean power, [B34]");
  r.t = t, r.P_m = P_m;
}

}  // namespace

template <class Tracer>
WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input& in, Tracer& trace) {
  const auto& [m, s, alpha, mu, F, v_1, c, z_1, z_2, g] = in;
  Result r;
  const double c_alpha = motion::without_rounding(cos(alpha), 1.0);
  trace.value("c_alpha", c_alpha, "cosine of the slope, nothing on a vertical path");
  STEP(R, m * g * c_alpha, "part of the weight across the path");
  STEP(T, mu * R, "friction, [B34]");
  STEP(A_G, -m * g * s * sin(alpha), "work of the weight, [B34] (5)");
  STEP(A_T, -T * s, "friction is against the motion, [B34]");
  STEP(A_F, F * s, "work of a constant force, [B34]");
  r.R = R, r.T = T, r.A_G = A_G, r.A_T = A_T, r.A_F = A_F;
  take_spring(in, r, trace);
  const auto A_c = r.A_c;
  if (!is_set(c)) trace.value("A_c", A_c, "no spring");
  STEP(A, A_G + A_T + A_F + A_c, "all forces; that of the plane does no work, [B34]");
  STEP(E_1, 0.5 * m * v_1 * v_1, "kinetic energy, [B34] (9)");
  STEP(E_2, E_1 + A, "theorem of kinetic energy, [B34] (11)");
  r.A = A, r.E_1 = E_1, r.E_2 = E_2;
  r.u_s = reach(r);
  if (in_si(E_2) >= 0.0) {
    STEP(v_2, sqrt(2.0 * E_2 / m), "kinetic energy, [B34] (9)");
    STEP(P_2, F * v_2, "power, [B34] (7)");
    r.v_2 = v_2, r.P_2 = P_2;
  }
  if (!is_set(c)) take_times(in, r, trace);
  return r;
}

template WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input&, NoTrace&);
template WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::WorkAndEnergy>();
