#include "calculators/gear/planetary.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::gear {

namespace {

using Member = Planetary::Member;

template <class Tracer>
void fill_speed(AngularSpeed& n, const char* symbol, AngularSpeed given, bool held, Tracer& trace) {
  n = held ? 0.0 * rpm : given;
  if (is_set(n)) trace.value(symbol, n, held ? "held" : "given");
}

/// The third speed from the two that are known.
template <class Tracer>
void all_speeds(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double i_0 = r.i_0;
  fill_speed(r.n_s, "n_s", in.n_s, in.fixed == Member::sun, trace);
  fill_speed(r.n_c, "n_c", in.n_c, in.fixed == Member::carrier, trace);
  fill_speed(r.n_r, "n_r", in.n_r, in.fixed == Member::ring, trace);
  const auto n_s = r.n_s, n_c = r.n_c, n_r = r.n_r;
  if (!is_set(n_s)) {
    r.n_s = NAMED_STEP("n_s", n_c + i_0 * (n_r - n_c), "[Willis]");
  } else if (!is_set(n_c)) {
    r.n_c = NAMED_STEP("n_c", (n_s - i_0 * n_r) / (1.0 - i_0), "[Willis]");
  } else {
    r.n_r = NAMED_STEP("n_r", n_c + (n_s - n_c) / i_0, "[Willis]");
  }
}

template <class Tracer>
void planet_speeds(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double z_s = in.z_s, z_p = in.z_p;
  const auto n_s = r.n_s, n_c = r.n_c;
  STEP(n_pc, -z_s / z_p * (n_s - n_c), "the planet rolls on the sun");
  STEP(n_p, n_c + n_pc, "with the carrier");
  r.n_pc = n_pc, r.n_p = n_p;
}

template <class Tracer>
void ratio_of(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double i_0 = r.i_0;
  if (in.fixed == Member::ring) r.i = NAMED_STEP("i", 1.0 - i_0, "sun over carrier, ring held");
  if (in.fixed == Member::carrier) r.i = NAMED_STEP("i", i_0, "sun over ring, carrier held");
  if (in.fixed == Member::sun) r.i = NAMED_STEP("i", 1.0 - 1.0 / i_0, "ring over carrier, sun held");
}

/// Which way the power rolls in the set as seen from the carrier: 1 from sun to ring, -1 back, 0 where nothing rolls.
/// The torque on the sun has the sign of that on the ring and the opposite of that on the carrier, whatever the losses.
double way_of_power(const Planetary::Input& in, const Planetary::Result& r) {
  const Moment like_sun = is_set(in.T_s) ? in.T_s : is_set(in.T_r) ? in.T_r : -in.T_c;
  const Power rolling = like_sun * (r.n_s - r.n_c);
  const Power zero = from_si<Power>(0.0);
  return rolling > zero ? 1.0 : rolling < zero ? -1.0 : 0.0;
}

template <class Tracer>
void torques(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double i_0 = r.i_0, eta_0 = is_set(in.eta_0) ? in.eta_0 : 1.0, w = way_of_power(in, r);
  const auto T_given_s = in.T_s, T_given_c = in.T_c, T_given_r = in.T_r;
  trace.value("eta_0", eta_0, is_set(in.eta_0) ? "given" : "no losses");
  trace.value("w", w, "1: power rolls from sun to ring, -1: from ring to sun, 0: nothing rolls, [Mueller]");
  STEP(k, -i_0 * pow(eta_0, w), "torque on the ring over that on the sun, with losses, [Mueller]");
  r.T_s = T_given_s;
  if (is_set(T_given_s)) trace.value("T_s", r.T_s, "given");
  if (is_set(T_given_r)) {
    const auto T_r = T_given_r;
    r.T_s = NAMED_STEP("T_s", T_r / k, "from that on the ring");
  }
  if (is_set(T_given_c)) {
    const auto T_c = T_given_c;
    r.T_s = NAMED_STEP("T_s", -T_c / (1.0 + k), "from that on the carrier");
  }
  const auto T_s = r.T_s;
  STEP(T_r, k * T_s, "on the ring");
  STEP(T_c, -(T_s + T_r), "equilibrium of the set");
  r.T_r = T_r, r.T_c = T_c;
}

template <class Tracer>
void powers(Planetary::Result& r, Tracer& trace) {
  const auto T_s = r.T_s, T_c = r.T_c, T_r = r.T_r;
  const auto n_s = r.n_s, n_c = r.n_c, n_r = r.n_r;
  STEP(P_s, T_s * n_s, "into the sun");
  STEP(P_c, T_c * n_c, "into the carrier");
  STEP(P_r, T_r * n_r, "into the ring");
  STEP(P_w, T_s * (n_s - n_c), "rolls in the teeth");
  STEP(P_in, max(P_s, 0.0 * W) + max(P_c, 0.0 * W) + max(P_r, 0.0 * W), "power that enters");
  STEP(P_loss, P_s + P_c + P_r, "enters and does not come out");
  r.P_s = P_s, r.P_c = P_c, r.P_r = P_r, r.P_w = P_w, r.P_in = P_in, r.P_loss = P_loss;
  if (!(P_in > 0.0 * W)) return;
  STEP(eta, 1.0 - P_loss / P_in, "efficiency");
  r.eta = eta;
}

template <class Tracer>
void tooth_force(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const auto m_n = in.m_n;
  const auto T_s = r.T_s;
  const double z_s = in.z_s, N_p = in.N_p, beta = in.beta, K_gamma = in.K_gamma;
  if (!is_set(m_n) || !is_set(T_s)) return;
  STEP(F_t, K_gamma * 2.0 * abs(T_s) * cos(beta) / (N_p * m_n * z_s), "at the reference circle of the sun");
  r.F_t = F_t;
}

Planetary::Coaxial coaxial_by(double z_gap) {
  if (z_gap == 0.0) return Planetary::Coaxial::exact;
  return std::abs(z_gap) <= Planetary::most_shifted ? Planetary::Coaxial::by_shift : Planetary::Coaxial::none;
}

/// Evenly spaced planets need a whole number of tooth steps of sun and ring together between them.
template <class Tracer>
void assembly(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double z_s = in.z_s, z_p = in.z_p, z_r = r.z_r, N_p = in.N_p, h_aP = in.h_aP, x_p = in.x_p;
  STEP(q, (z_s + z_r) / N_p, "steps of assembly between two planets; whole for even spacing, [Assembly]");
  r.q = q;
  r.spacing = Planetary::evenly_spaced(in) ? Planetary::Spacing::even : Planetary::Spacing::uneven;
  const double steps = std::round(q);
  trace.value("steps", steps, "the nearest whole number of steps");
  STEP(phi_2, 2.0 * pi * steps / (z_s + z_r), "where the second planet can be put in");
  STEP(z_gap, z_r - z_s - 2.0 * z_p, "zero where sun, planet and ring come to one axis by their teeth, [Assembly]");
  r.phi_2 = phi_2, r.z_gap = z_gap;
  r.coaxial = coaxial_by(z_gap);
  if (in.N_p == 1) {
    r.u_N = 0.0;
    return trace.value("u_N", r.u_N, "a single planet has no neighbour");
  }
  STEP(u_N, (z_p + 2.0 * (h_aP + x_p)) / ((z_s + z_p) * sin(pi / N_p)),
       "tip circle of a planet over the distance to its neighbour, [Assembly]");
  r.u_N = u_N;
}

}  // namespace

bool Planetary::speeds_determined(const Input& in) {
  const bool s = is_set(in.n_s), c = is_set(in.n_c), r = is_set(in.n_r);
  switch (in.fixed) {
    case Member::ring:
      return !r && s != c;
    case Member::carrier:
      return !c && s != r;
    case Member::sun:
      return !s && c != r;
    case Member::none:
      return s + c + r == 2;
  }
  return false;
}

FieldFault Planetary::wrong_speeds(const Input& in) {
  const bool held = (in.fixed == Member::ring && is_set(in.n_r)) || (in.fixed == Member::carrier && is_set(in.n_c)) ||
                    (in.fixed == Member::sun && is_set(in.n_s));
  if (!held) return {};
  return {in.fixed == Member::ring      ? "n_r"
          : in.fixed == Member::carrier ? "n_c"
                                        : "n_s",
          say("this member is held, and cannot have a speed"),
          say("leave it out, or hold another member with fixed, or none")};
}

template <class Tracer>
Planetary::Result Planetary::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const double z_s = in.z_s, z_r = r.z_r = ring_teeth(in);
  trace.value("z_r", z_r, in.z_r > 0 ? "as given" : "z_s + 2 z_p: sun, planets and ring come to one axis");
  STEP(i_0, -z_r / z_s, "sun and ring turn against each other with the carrier at rest, [Willis]");
  r.i_0 = i_0;
  all_speeds(in, r, trace);
  planet_speeds(in, r, trace);
  ratio_of(in, r, trace);
  if (is_set(in.T_s) || is_set(in.T_c) || is_set(in.T_r)) {
    torques(in, r, trace);
    powers(r, trace);
    tooth_force(in, r, trace);
  }
  assembly(in, r, trace);
  return r;
}

template Planetary::Result Planetary::evaluate(const Input&, NoTrace&);
template Planetary::Result Planetary::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Planetary>();
