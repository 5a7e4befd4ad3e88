#include "calculators/shaft/design/design.hpp"

#include "calculators/shaft/design/bending.hpp"
#include "calculators/shaft/design/sections.hpp"
#include "calculators/shaft/design/torsion.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;
using Result = Design::Result;

template <class Element>
double slope_over(double beta, const Element& element) {
  return is_set(element.beta_adm) ? beta / element.beta_adm : unset<double>;
}

void carry(const Input& in, const Loaded& loaded, Result& r) {
  for (std::size_t i = 0; i < in.supports.size(); ++i) {
    const Support& support = in.supports[i];
    Carried c;
    c.name = support.name, c.x = support.x, c.holds = support.holds, c.n = r.n;
    c.R_x = from_si<Force>(loaded.x.reactions[i]), c.R_y = from_si<Force>(loaded.y.reactions[i]);
    c.F_r = sqrt(c.R_x * c.R_x + c.R_y * c.R_y);
    c.F_a = from_si<Force>(support.holds == Holds::both ? loaded.thrust : 0.0);
    c.F_r0 = in.k_max * c.F_r, c.F_a0 = in.k_max * c.F_a;
    c.beta = loaded.slope(loaded.stations.at(support.x));
    c.u_beta = slope_over(c.beta, support);
    r.bearings.push_back(c);
  }
}

void seat(const Input& in, const Loaded& loaded, Result& r) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    const std::size_t node = loaded.stations.at(seat.x);
    const double beta = loaded.slope(node);
    const bool turns = is_set(seat.T) || seat.way == Way::balances;
    const Moment T = turns ? in.K_A * torque_of(in, i) : unset<Moment>;
    r.seats.push_back({seat.name, seat.x, T, from_si<Length>(loaded.deflection(node)), beta, slope_over(beta, seat)});
  }
}

/// Of all sections the largest.
void extremes(const Loaded& loaded, const Input& in, Result& r) {
  double M = 0.0, T = 0.0, v = 0.0, twist = 0.0;
  for (std::size_t n = 0; n < loaded.stations.x.size(); ++n) {
    const Felt felt = loaded.felt(n);
    M = std::max(M, std::hypot(felt.M_x, felt.M_y));
    T = std::max(T, std::abs(felt.T));
    v = std::max(v, loaded.deflection(n));
  }
  for (std::size_t s = 0; s + 1 < loaded.phi.size(); ++s) {
    const double l = loaded.stations.x[s + 1] - loaded.stations.x[s];
    twist = std::max(twist, std::abs(loaded.phi[s + 1] - loaded.phi[s]) / l);
  }
  const auto [least, most] = std::minmax_element(loaded.phi.begin(), loaded.phi.end());
  r.M_max = from_si<Moment>(M), r.T_max = from_si<Moment>(T), r.v_max = from_si<Length>(v);
  r.theta_max = from_si<Twist>(twist), r.phi = *most - *least;
  r.l = length_of(in);
}

template <class Tracer>
void stiffness(const Input& in, Result& r, Tracer& trace) {
  trace.value("v_max", r.v_max, "largest of the shaft, with shear");
  trace.value("theta_max", r.theta_max, "largest of the shaft");
  if (is_set(in.v_adm)) {
    STEP_TO(r, u_y, r.v_max / in.v_adm, "deflection");
  }
  if (is_set(in.theta_adm)) {
    STEP_TO(r, u_theta, r.theta_max / in.theta_adm, "stiffness in torsion");
  }
}

template <class Tracer>
void critical_speed(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.rho)) return;
  r.mass = trace.value("mass", mass_of(in), "of the cylinders");
  if (std::any_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return !is_set(s.mass); })) return;
  const beam::Frequencies found = critical_speeds(in);
  r.n_D = trace.speed("n_D", from_si<AngularSpeed>(found.dunkerley), "Dunkerley: each mass alone");
  r.n_c = trace.speed("n_c", from_si<AngularSpeed>(found.lowest), "of masses on the elastic line");
  r.n_R = trace.speed("n_R", from_si<AngularSpeed>(found.rayleigh), "Rayleigh: bent as by the weights");
  if (!is_set(r.n)) return;
  STEP_TO(r, u_n, in.k_n * r.n / r.n_c, "below the first critical speed, with its margin");
}

}  // namespace

template <class Tracer>
Design::Result Design::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.d_max = 0.0 * mm;
  for (const Piece& piece : in.pieces) r.d_max = max(r.d_max, piece.d);
  r.d_s = is_set(in.d_h) ? in.d_h : r.d_max;
  const auto found = loaded_shaft(in);
  if (!found) return r;
  const Loaded& loaded = *found;
  extremes(loaded, in, r);
  r.n = speed_of(in);
  if (is_set(r.n)) trace.speed("n", r.n, "of the shaft and all that sits on it");
  carry(in, loaded, r);
  seat(in, loaded, r);
  judge_sections(in, loaded, r, trace);
  stiffness(in, r, trace);
  critical_speed(in, r, trace);
  judge_torsion(in, r, trace);
  return r;
}

template Design::Result Design::evaluate(const Input&, NoTrace&);
template Design::Result Design::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Design>();
