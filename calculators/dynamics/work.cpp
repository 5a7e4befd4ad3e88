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
  STEP_TO(r, A_c, is_set(in.c) ? -0.5 * in.c * (in.z_2 * in.z_2 - in.z_1 * in.z_1) : 0.0 * N_m,
          is_set(in.c) ? "work of a spring, [B34] (6) with the squares apart" : "no spring");
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
  if (in_si(r.A) < 0.0) {
    STEP_TO(r, s_stop, -r.E_1 * in.s / r.A, "the same forces take all of the kinetic energy");
  }
  if (!(in_si(in.v_1 + r.v_2) > 0.0)) return;
  STEP_TO(r, t, 2.0 * in.s / (in.v_1 + r.v_2), "mean speed of a constant acceleration");
  STEP_TO(r, P_m, r.A_F / t, "mean power, [B34]");
}

}  // namespace

template <class Tracer>
WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input& in, Tracer& trace) {
  const auto& [m, s, alpha, mu, F, v_1, c, z_1, z_2, given, latitude, altitude] = in;
  Result r;
  const Acceleration g = r.g = gravity_of(in, trace);
  const double c_alpha = motion::without_rounding(cos(alpha), 1.0);
  trace.value("c_alpha", c_alpha, "cosine of the slope, nothing on a vertical path");
  STEP_TO(r, R, m * g * c_alpha, "part of the weight across the path");
  STEP_TO(r, T, mu * R, "friction, [B34]");
  STEP_TO(r, A_G, -m * g * s * sin(alpha), "work of the weight, [B34] (5)");
  STEP_TO(r, A_T, -T * s, "friction is against the motion, [B34]");
  STEP_TO(r, A_F, F * s, "work of a constant force, [B34]");
  take_spring(in, r, trace);
  STEP_TO(r, A, A_G + A_T + A_F + r.A_c, "all forces; that of the plane does no work, [B34]");
  STEP_TO(r, E_1, 0.5 * m * v_1 * v_1, "kinetic energy, [B34] (9)");
  STEP_TO(r, E_2, E_1 + A, "theorem of kinetic energy, [B34] (11)");
  r.u_s = reach(r);
  if (in_si(E_2) >= 0.0) {
    STEP_TO(r, v_2, sqrt(2.0 * E_2 / m), "kinetic energy, [B34] (9)");
    STEP_TO(r, P_2, F * v_2, "power, [B34] (7)");
  }
  if (!is_set(c)) take_times(in, r, trace);
  return r;
}

template WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input&, NoTrace&);
template WorkAndEnergy::Result WorkAndEnergy::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::WorkAndEnergy>();
