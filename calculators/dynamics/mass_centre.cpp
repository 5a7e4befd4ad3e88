#include "calculators/dynamics/mass_centre.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::dynamics {

template <class Tracer>
MassCentre::Result MassCentre::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Mass M = 0.0 * kg;
  MassArm S_x = 0.0 * kg_mm, S_y = S_x, S_s = S_x;
  for (const Body& body : in.bodies) {
    M += body.mass;
    S_x += body.mass * body.x;
    S_y += body.mass * body.y;
    S_s += body.mass * body.s;
  }
  r.M = trace.value("M", M, "sum of the masses");
  trace.value("S_x", S_x, "sum of m x");
  trace.value("S_y", S_y, "sum of m y");
  trace.value("S_s", S_s, "sum of m s, of the paths along the carrier");
  STEP_TO(r, x_C, S_x / M, "centre of mass, [B35]");
  STEP_TO(r, y_C, S_y / M, "centre of mass, [B35]");
  STEP_TO(r, Delta_x, -S_s / M, "the centre of mass stays: sum of m (Delta_x + s) is zero, [B35]");
  for (const Body& body : in.bodies) r.after.push_back({body.name, Delta_x + body.s, body.x + Delta_x + body.s});
  return r;
}

template MassCentre::Result MassCentre::evaluate(const Input&, NoTrace&);
template MassCentre::Result MassCentre::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::MassCentre>();
