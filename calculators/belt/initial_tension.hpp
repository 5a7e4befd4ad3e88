// Initial tension of a friction belt, and what becomes of it in operation.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::belt {

/// Tensions of a belt that transmits F_1, by the initial tension at standstill, given or the minimum by Euler's
/// condition. `fixed`: centres that are fixed when running, else a tensioner with a constant force.
template <class Result, class Tracer>
void tension_spans(Force effective_pull, Force given, bool fixed, Result& r, Tracer& trace) {
  const Force F_1 = trace.value("F_1", effective_pull, "effective pull of one belt or rib");
  STEP(N_min, F_1 / 2.0 * (r.m_e + 1.0) / (r.m_e - 1.0),
       "minimum mean of the tensions less centrifugal tension, Euler's condition, [Shigley-17]");
  const Force F_lost = trace.value(
      "F_lost", fixed ? r.F_c : 0.0 * r.F_c,
      fixed ? "on fixed centres the centrifugal part relieves the pulleys" : "the tensioner makes up for it");
  STEP_TO(r, S_0_min, N_min + F_lost, "minimum initial tension at standstill");
  r.S_0 = trace.value("S_0", is_set(given) ? given : S_0_min, is_set(given) ? "as given" : "the minimum");
  STEP_TO(r, S_1, r.S_0 - F_lost + r.F_c + F_1 / 2.0, "tight span");
  STEP_TO(r, S_2, S_1 - F_1, "slack span");
  STEP_TO(r, u_S, S_0_min / r.S_0, "friction condition");
}

}  // namespace loadpath::belt
