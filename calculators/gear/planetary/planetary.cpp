#include "calculators/gear/planetary/planetary.hpp"

#include "calculators/gear/planetary/meshes.hpp"
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
  fill_speed(r.n_s, "n_s", in.n_s, in.fixed == Member::sun, trace);
  fill_speed(r.n_c, "n_c", in.n_c, in.fixed == Member::carrier, trace);
  fill_speed(r.n_r, "n_r", in.n_r, in.fixed == Member::ring, trace);
  if (!is_set(r.n_s)) {
    STEP_TO(r, n_s, r.n_c + r.i_0 * (r.n_r - r.n_c), "[Willis]");
  } else if (!is_set(r.n_c)) {
    STEP_TO(r, n_c, (r.n_s - r.i_0 * r.n_r) / (1.0 - r.i_0), "[Willis]");
  } else {
    STEP_TO(r, n_r, r.n_c + (r.n_s - r.n_c) / r.i_0, "[Willis]");
  }
}

template <class Tracer>
void planet_speeds(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  STEP_TO(r, n_pc, -in.z_s / in.z_p * (r.n_s - r.n_c), "the planet rolls on the sun");
  STEP_TO(r, n_p, r.n_c + n_pc, "with the carrier");
}

template <class Tracer>
void ratio_of(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  if (in.fixed == Member::ring) r.i = NAMED_STEP("i", 1.0 - r.i_0, "sun over carrier, ring held");
  if (in.fixed == Member::carrier) r.i = NAMED_STEP("i", r.i_0, "sun over ring, carrier held");
  if (in.fixed == Member::sun) r.i = NAMED_STEP("i", 1.0 - 1.0 / r.i_0, "ring over carrier, sun held");
}

/// Rolling power in the set, seen from the carrier: 1 from sun to ring, -1 back, 0 where nothing rolls. The torque on
/// the sun has the sign of that on the ring and the opposite of that on the carrier, whatever the losses.
double way_of_power(const Planetary::Input& in, const Planetary::Result& r) {
  const Moment like_sun = is_set(in.T_s) ? in.T_s : is_set(in.T_r) ? in.T_r : -in.T_c;
  const Power rolling = like_sun * (r.n_s - r.n_c);
  const Power zero = from_si<Power>(0.0);
  return rolling > zero ? 1.0 : rolling < zero ? -1.0 : 0.0;
}

template <class Tracer>
void torques(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const double eta_0 = is_set(in.eta_0) ? in.eta_0 : 1.0, w = way_of_power(in, r);
  trace.value("eta_0", eta_0, is_set(in.eta_0) ? "given" : "no losses");
  trace.value("w", w, "1: power rolls from sun to ring, -1: from ring to sun, 0: nothing rolls, [Mueller]");
  STEP(k, -r.i_0 * pow(eta_0, w), "torque on the ring over that on the sun, with losses, [Mueller]");
  r.T_s = in.T_s;
  if (is_set(in.T_s)) trace.value("T_s", r.T_s, "given");
  if (is_set(in.T_r)) {
    STEP_TO(r, T_s, in.T_r / k, "from that on the ring");
  }
  if (is_set(in.T_c)) {
    STEP_TO(r, T_s, -in.T_c / (1.0 + k), "from that on the carrier");
  }
  STEP_TO(r, T_r, k * r.T_s, "on the ring");
  STEP_TO(r, T_c, -(r.T_s + T_r), "equilibrium of the set");
}

template <class Tracer>
void powers(Planetary::Result& r, Tracer& trace) {
  STEP_TO(r, P_s, r.T_s * r.n_s, "into the sun");
  STEP_TO(r, P_c, r.T_c * r.n_c, "into the carrier");
  STEP_TO(r, P_r, r.T_r * r.n_r, "into the ring");
  STEP_TO(r, P_w, r.T_s * (r.n_s - r.n_c), "rolls in the teeth");
  STEP_TO(r, P_in, max(P_s, 0.0 * W) + max(P_c, 0.0 * W) + max(P_r, 0.0 * W), "input power");
  STEP_TO(r, P_loss, P_s + P_c + P_r, "enters and does not come out");
  if (!(P_in > 0.0 * W)) return;
  STEP_TO(r, eta, 1.0 - P_loss / P_in, "efficiency");
}

template <class Tracer>
void tooth_force(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  if (!is_set(in.m_n) || !is_set(r.T_s)) return;
  STEP_TO(r, F_t, in.K_gamma * 2.0 * abs(r.T_s) * cos(in.beta) / (in.N_p * in.m_n * in.z_s),
          "at the reference circle of the sun");
}

Planetary::Coaxial coaxial_by(double z_gap) {
  if (z_gap == 0.0) return Planetary::Coaxial::exact;
  return std::abs(z_gap) <= Planetary::most_shifted ? Planetary::Coaxial::by_shift : Planetary::Coaxial::none;
}

/// Evenly spaced planets need an integer number of tooth steps of sun and ring together between them.
template <class Tracer>
void assembly(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  STEP_TO(r, q, (in.z_s + r.z_r) / in.N_p, "assembly steps between two planets; integer for even spacing, [Assembly]");
  r.spacing = Planetary::evenly_spaced(in) ? Planetary::Spacing::even : Planetary::Spacing::uneven;
  const double steps = trace.value("steps", std::round(q), "the nearest integer number of steps");
  STEP_TO(r, phi_2, 2.0 * pi * steps / (in.z_s + r.z_r), "where the second planet can be put in");
  STEP_TO(r, z_gap, r.z_r - in.z_s - 2.0 * in.z_p,
          "zero where sun, planet and ring come to one axis by their teeth, [Assembly]");
  r.coaxial = coaxial_by(z_gap);
  if (in.N_p == 1) {
    r.u_N = trace.value("u_N", 0.0, "a single planet has no neighbour");
    return;
  }
  const double least = trace.value("least", std::floor(q), "integer steps between the closest planets");
  STEP(phi_min, 2.0 * pi * least / (in.z_s + r.z_r), "the minimum angle between two neighbours");
  STEP_TO(r, u_N, (in.z_p + 2.0 * (in.h_aP + in.x_p)) / ((in.z_s + in.z_p) * sin(phi_min / 2.0)),
          "tip circle of a planet over the distance to its neighbour, [Assembly]");
}

/// Torque of one mesh on a gear of z teeth, from the sun's or the ring's T on all planets, and its speed against the
/// carrier. A set at rest has no speed.
void load_mesh(MeshOfSet& mesh, const Planetary::Input& in, Moment T, double z, double way, AngularSpeed n) {
  mesh.T_1 = (way < 0.0 ? -1.0 : 1.0) * in.K_gamma * abs(T) / in.N_p * mesh.z_1 / z;
  if (abs(n) > 0.0 * rpm) mesh.n_1 = abs(n);
}

MeshOfSet mesh_of(const Pair::Input& pair, double x_2, const Planetary::Input& in) {
  MeshOfSet mesh{pair.mesh, pair.z_1, pair.z_2, in.m_n, in.beta, pair.x_1, x_2, in.h_aP};
  if (is_set(in.m_n)) mesh.d_a2 = pair.d_a2;
  return mesh;
}

/// Records for gear.pair. A planet drives the ring where the sun drives the planet.
void hand_over(const Planetary::Input& in, Planetary::Result& r) {
  r.sun_mesh.idler = Idler::gear_2, r.ring_mesh.idler = Idler::gear_1;
  if (!is_set(r.T_s)) return;
  const double way = way_of_power(in, r);
  load_mesh(r.sun_mesh, in, r.T_s, in.z_s, way, r.n_s - r.n_c);
  load_mesh(r.ring_mesh, in, r.T_r, r.z_r, way, r.n_pc);
  r.gear_s.T = abs(r.T_s), r.gear_s.n = r.n_s;
}

constexpr const char* as_pair = "as gear.pair finds it";

/// Sun with planet, and planet with ring at the same centre distance.
template <class Tracer>
void meshes(const Planetary::Input& in, Planetary::Result& r, Tracer& trace) {
  const auto [sun, ring, with_sun, with_ring, full] = meshes_of(in);
  r.f_sp = trace.value("f_sp", with_sun.f_int, as_pair);
  r.eps_sp = trace.value("eps_sp", with_sun.eps_alpha, as_pair);
  r.x_free = trace.value("x_free", with_sun.x_free, as_pair);
  r.f_pr = trace.value("f_pr", with_ring.f_int, as_pair);
  r.eps_pr = trace.value("eps_pr", with_ring.eps_alpha, as_pair);
  const Length c_s = min(with_sun.c_1, with_sun.c_2), c_r = min(with_ring.c_1, with_ring.c_2);
  r.c_a = trace.value("c_a", min(c_s, c_r) / ring.m_n, as_pair);
  r.s_a = trace.value("s_a", min(with_sun.s_a, with_ring.s_a), as_pair);
  r.h_clear = trace.value("h_clear", in.h_aP + (full - with_ring.d_clear) / (2.0 * ring.m_n), as_pair);
  if (is_set(in.m_n)) r.gear_s.d_f = with_sun.d_f1, r.gear_s.h_t = (with_sun.d_a1 - with_sun.d_f1) / 2.0;
  r.sun_mesh = mesh_of(sun, in.x_p, in), r.ring_mesh = mesh_of(ring, with_ring.x_2, in);
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
  r.z_r = ring_teeth(in);
  if (in.z_r > 0) {
    trace.value("z_r", r.z_r, "as given");
  } else {
    STEP_TO(r, z_r, in.z_s + 2.0 * in.z_p, "sun, planets and ring come to one axis");
  }
  STEP_TO(r, i_0, -r.z_r / in.z_s, "sun and ring turn against each other with the carrier at rest, [Willis]");
  all_speeds(in, r, trace);
  planet_speeds(in, r, trace);
  ratio_of(in, r, trace);
  if (is_set(in.T_s) || is_set(in.T_c) || is_set(in.T_r)) {
    torques(in, r, trace);
    powers(r, trace);
    tooth_force(in, r, trace);
  }
  assembly(in, r, trace);
  meshes(in, r, trace);
  hand_over(in, r);
  return r;
}

template Planetary::Result Planetary::evaluate(const Input&, NoTrace&);
template Planetary::Result Planetary::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Planetary>();
