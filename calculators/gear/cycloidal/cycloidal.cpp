#include "calculators/gear/cycloidal/cycloidal.hpp"

#include "calculators/gear/cycloidal/flank.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::gear {

namespace {

using cycloidal::CycloidFlank;
using cycloidal::flank_of;
using cycloidal::middle_of;
using cycloidal::pointed_angle;
using cycloidal::tip_angle;
using std::numbers::pi;

template <class Tracer>
void take_wheel(const Cycloidal::Input& in, Cycloidal::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "numbers of teeth");
  STEP_TO(r, d_1, in.m * in.z_1, "pitch circle");
  STEP_TO(r, d_2, in.m * in.z_2, "pitch circle");
  STEP_TO(r, a, (d_1 + d_2) / 2.0, "the pitch circles touch");
  STEP_TO(r, p, pi * in.m, "definition of the module");
  if (Cycloidal::is_lantern(in)) {
    STEP_TO(r, s_2, p - in.d_p - in.j, "the pins fill the spaces but for the backlash");
  } else {
    STEP_TO(r, s_2, p / 2.0 - in.j, "half the pitch less the backlash, [BS978-2]");
    STEP_TO(r, s_1, in.z_1 <= 10.0 ? 1.05 * in.m : 1.25 * in.m, "[BS978-2]");
  }
  const Length r_s =
      trace.value("r_s", flank_of(in).radius(pointed_angle(in)) * m, "radius at which both flanks of a tooth meet");
  STEP_TO(r, f, (r_s - d_2 / 2.0) / in.m, "addendum of pointed teeth, by the module");
  STEP_TO(r, h_a2, in.k_a * f * in.m, "the tips keep k_a of it; 0.95 in [BS978-2]");
  STEP_TO(r, d_a2, d_2 + 2.0 * h_a2, "addendum on both sides");
  if (Cycloidal::is_lantern(in)) return;
  STEP_TO(r, r_f2, 1.40 * f * in.m, "[BS978-2]");
  STEP_TO(r, h_f1, h_a2 + 0.4 * in.m, "0.4 m of clearance, [BS978-2]");
}

}  // namespace

bool Cycloidal::has_teeth(const Input& in) {
  if (is_lantern(in) != is_set(in.d_p)) return true;  // another rule reports it
  const CycloidFlank flank = flank_of(in);
  const double middle = middle_of(in);
  return flank.polar(flank.start()) < middle && flank.polar(pi) > middle && flank.distance(pointed_angle(in)) > 0.0;
}

/// Wheels that drive pins have 8 to 12 teeth and more, and pins 1 to 1.7 modules in diameter; from memory.
double Cycloidal::least_teeth_of_wheel(const Input& in) { return is_lantern(in) ? 8.0 : std::nan(""); }
double Cycloidal::least_pins(const Input& in) { return is_lantern(in) ? 0.5 * in_si(in.m) : std::nan(""); }

Applies Cycloidal::leads(const Input& in) {
  constexpr double led_by_wheel = 0.7;
  if (is_lantern(in) || is_set(in.d_p) || !has_teeth(in)) return Applies::no;
  NoTrace none;
  const double eps = evaluate(in, none).eps;
  if (eps >= 1.0) return Applies::no;
  return eps >= led_by_wheel ? Applies::unseen : Applies::yes;
}

template <class Tracer>
Cycloidal::Result Cycloidal::evaluate(const Input& in, Tracer& trace) {
  Result r;
  take_wheel(in, r, trace);
  const CycloidFlank flank = flank_of(in);
  const Length rho = trace.value("rho", flank.rho * m,
                                 is_lantern(in) ? "radius of the rolling circle: that of the pitch circle of the pins"
                                                : "radius of the rolling circle: half that of the pitch circle");
  const double theta_a = trace.angle("theta_a", tip_angle(in, in_si(r.d_a2) / 2.0),
                                     "rotation of the rolling circle until the tip leaves the pinion");
  const double theta_e =
      trace.angle("theta_e", flank.start(), "rotation at which the flank begins, by its radius of curvature");
  STEP_TO(r, phi_a, 2.0 * rho * theta_a / r.d_1, "pitch circle of the pinion and rolling circle roll on each other");
  STEP_TO(r, alpha_a, theta_a / 2.0, "angle of the chord to the tangent");
  STEP_TO(r, eps, in.z_1 * rho * (theta_a - theta_e) / (pi * r.d_1), "rotation in contact, by that of one pitch");
  const Length L_a =
      trace.value("L_a", std::abs(flank.distance(theta_a)) * m, "distance of the last contact from the pitch point");
  STEP_TO(r, K_g, L_a * (2.0 / r.d_1 + 2.0 / r.d_2), "relative rotation about the pitch point");
  if (is_lantern(in)) {
    STEP_TO(r, eps_pins, eps, "the next pin must be in contact by then");
  } else {
    STEP_TO(r, phi_e, max(2.0 * pi / in.z_1 - phi_a, 0.0), "rest of one pitch");
  }
  return r;
}

template Cycloidal::Result Cycloidal::evaluate(const Input&, NoTrace&);
template Cycloidal::Result Cycloidal::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Cycloidal>();
