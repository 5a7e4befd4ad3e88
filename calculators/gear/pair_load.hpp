// Speeds, torques, tooth forces and Lewis' bending stress of a pair of gears.
#pragma once

#include "calculators/gear/lewis.hpp"
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace load {

/// A negative speed, as of a shaft of a train: gear 1 rotates opposite to `turns`.
inline bool turns_back(const PairInput& in) { return in.n_1 < 0.0 * rpm; }

/// Positive where gear 1 drives. For reverse rotation the torque may be given with or without its sign.
template <class Tracer>
Moment torque(const PairInput& in, Tracer& trace) {
  if (turns_back(in)) {
    if (!is_set(in.P))
      return is_set(in.T_1) ? NAMED_STEP("T_1", abs(in.T_1), "gear 1 drives in the reverse direction") : unset<Moment>;
    return NAMED_STEP("T_1", in.P / abs(in.n_1), "torque from the power, nominal");
  }
  if (!is_set(in.P)) return in.T_1;
  return NAMED_STEP("T_1", in.P / in.n_1, "torque from the power, nominal");
}

template <class Tracer>
void speeds(const PairInput& in, PairResult& r, Tracer& trace) {
  if (turns_back(in)) {
    STEP_TO(r, v, abs(in.n_1) * r.d_w1 / 2.0, "pitch line velocity");
  } else {
    STEP_TO(r, v, in.n_1 * r.d_w1 / 2.0, "pitch line velocity");
  }
  if (in.mesh == Mesh::rack) return;
  const double g = trace.value("g", sign_of(in.mesh), "1 with a wheel, -1 with a ring");
  STEP_TO(r, n_2, -g * in.n_1 * in.z_1 / in.z_2, "wheels turn against each other, wheel and ring alike");
}

/// Loads on the shafts, each in its own frame. The axes of the results point from axis 1 to the pitch point, towards
/// axis 2 of an external gear, away from the axis of a ring gear around gear 1. `w`: 1 where gear 1 turns
/// counter-clockwise, else -1.
inline void hand_over(const PairInput& in, Moment T_1, double w, PairResult& r) {
  const double K_A = in.K_A, to_2 = K_A * sign_of(in.mesh);
  const double forward = turns_back(in) ? -w : w;  // direction of the speeds, which are signed
  r.gear_1 =
      shaft_load(K_A * T_1, {to_2 * r.F_x1, to_2 * r.F_y1, K_A * r.F_z1}, r.d_w1, forward * in.n_1, sign_of(in.mesh));
  r.gear_1.d_f = r.d_f1, r.gear_1.h_t = (r.d_a1 - r.d_f1) / 2.0;
  r.gear_1.kind = Mounted::gear, r.gear_1.b_r = r.b, r.gear_1.bore = in.bore_1;
  if (in.mesh == Mesh::rack) return;
  r.gear_2 = shaft_load(K_A * r.T_2, {-to_2 * r.F_x2, -to_2 * r.F_y2, K_A * r.F_z2}, r.d_w2, forward * r.n_2);
  r.gear_2.d_f = unset<Length>, r.gear_2.kind = Mounted::gear, r.gear_2.b_r = r.b, r.gear_2.bore = in.bore_2;
  if (in.mesh == Mesh::external) r.gear_2.d_f = r.d_f2, r.gear_2.h_t = (r.d_a2 - r.d_f2) / 2.0;
}

/// [Vortarus], with the hand of the helix and the direction of rotation; the working circle gives the bearing loads.
template <class Tracer>
void forces(const PairInput& in, Moment T_1, PairResult& r, Tracer& trace) {
  const double w = turns_back(in)
                       ? NAMED_STEP("w", in.turns == Turns::ccw ? -1.0 : 1.0, "n_1 is negative: the reverse of turns")
                       : NAMED_STEP("w", in.turns == Turns::ccw ? 1.0 : -1.0,
                                    "1 where gear 1 turns counter-clockwise, -1 clockwise");
  STEP(h, in.hand == Hand::right ? 1.0 : -1.0, "1 for a right-hand helix of gear 1, -1 for a left-hand one");
  STEP_TO(r, F_t, 2.0 * abs(T_1) / r.d_1, "at the reference circle");
  STEP_TO(r, F_tw, 2.0 * abs(T_1) / r.d_w1, "at the working circle");
  STEP_TO(r, F_rw, F_tw * tan(r.alpha_wt), "radial, at the working circle, [Vortarus]");
  STEP_TO(r, F_a, F_t * tan(in.beta), "axial, [Vortarus]");
  STEP_TO(r, F_bn, F_tw / cos(r.alpha_wt) * sqrt(1.0 + pow<2>(tan(in.beta) * cos(r.alpha_t))),
          "along the normal of the tooth");
  STEP_TO(r, F_x1, -F_rw, "radial force on a tooth, towards its own gear centre");
  STEP_TO(r, F_y1, -w * 2.0 * T_1 / r.d_w1, "against the rotation where gear 1 drives");
  STEP_TO(r, F_z1, -h * F_y1 * r.d_w1 / r.d_1 * tan(in.beta), "along the axis: the force is normal to the helix");
  r.F_x2 = -F_x1, r.F_y2 = -F_y1, r.F_z2 = -F_z1;
  if (in.mesh != Mesh::rack) {
    STEP_TO(r, T_2, abs(T_1) * r.u, "without losses");
  }
  hand_over(in, T_1, w, r);
}

/// [Shigley14] (14-4a) to (14-6b); the speeds up to which they are used are recalled.
template <class Tracer>
void velocity_factor(const PairInput& in, PairResult& r, Tracer& trace) {
  if (in.cutting == Cutting::none) {
    const bool runs = is_set(in.n_1);
    if (!(runs && asks_strength(in))) r.v_share = 0.0;  // else the limiting speed of such teeth is unknown
    r.K_v = trace.value("K_v", 1.0, runs ? "not counted: how the teeth are cut is not given" : "load at rest");
  } else if (in.cutting == Cutting::cast) {
    STEP_TO(r, K_v, (3.05 + r.v / m_per_s) / 3.05, "cast teeth, Barth, [Shigley14]");
    STEP_TO(r, v_share, r.v / (10.0 * m_per_s), "used up to 10 m/s");
  } else if (in.cutting == Cutting::milled) {
    STEP_TO(r, K_v, (6.1 + r.v / m_per_s) / 6.1, "cut teeth, Barth, [Shigley14]");
    STEP_TO(r, v_share, r.v / (20.0 * m_per_s), "used up to 20 m/s");
  } else if (in.cutting == Cutting::hobbed) {
    STEP_TO(r, K_v, (3.56 + sqrt(r.v / m_per_s)) / 3.56, "hobbed or shaped teeth, [Shigley14]");
    STEP_TO(r, v_share, r.v / (25.0 * m_per_s), "used up to 25 m/s");
  } else {
    STEP_TO(r, K_v, sqrt((5.56 + sqrt(r.v / m_per_s)) / 5.56), "shaved or ground teeth, [Shigley14]");
    STEP_TO(r, v_share, r.v / (50.0 * m_per_s), "used up to 50 m/s");
  }
}

/// Lewis' factor of a wheel, from the spur gear with the same normal section.
inline double form_factor(const PairInput& in, double z, double x, double k) {
  const double c = cos(in.beta), z_n = z / (c * c * c);
  const Rack rack{in.alpha_n, in.h_fP, in.rho_fP};
  return lewis_factor(rack, z_n, x, 0.5 * z_n + in.h_aP + x - k);
}

inline constexpr const char* from_form =
    "minimum s^2/(6 h m_n) of the tooth with the load at its tip, z/cos^3(beta) teeth, [Lewis]";

/// A tooth for Lewis' formula, and the symbols of its results.
struct Tooth {
  double z, x, k, Y_given;
  Stress sigma_adm;
  bool both_ways;
  const char *Y, *sigma, *u;
};
struct Bending {
  double Y;
  Stress sigma;
  double u = unset<double>;
};

template <class Tracer>
Bending bend(const PairInput& in, const PairResult& r, const Tooth& tooth, Tracer& trace) {
  const double Y = is_set(tooth.Y_given) ? tooth.Y_given : form_factor(in, tooth.z, tooth.x, tooth.k);
  trace.value("Y", Y, is_set(tooth.Y_given) ? "Lewis' factor as given" : from_form);
  trace.value(tooth.Y, Y, "of this gear");
  const Stress sigma_F =
      NAMED_STEP(tooth.sigma, in.K_A * r.K_v * in.K_f * r.F_t / (r.b * in.m_n * Y), "bending, [Lewis]");
  Bending bent{Y, sigma_F};
  if (!is_set(tooth.sigma_adm)) return bent;
  const double Y_A = tooth.both_ways ? 0.7 : 1.0;
  trace.value("sigma_F", sigma_F, "this stress");
  trace.value("sigma_adm", tooth.sigma_adm, "allowable for teeth bent in one direction");
  trace.value("Y_A", Y_A,
              tooth.both_ways ? "teeth under reversed bending: 0.7 of it, not checked against ISO 6336-5"
                              : "teeth bent in one direction");
  bent.u = NAMED_STEP(tooth.u, sigma_F / (Y_A * tooth.sigma_adm), "bending by Lewis");
  return bent;
}

template <class Tracer>
void bend_all(const PairInput& in, PairResult& r, Tracer& trace) {
  const Tooth first{in.z_1, in.x_1,     r.k,   in.Y_1, in.sigma_adm_1, is_idler(in.idler, Idler::gear_1),
                    "Y_1",  "sigma_F1", "u_F1"};
  const Bending one = bend(in, r, first, trace);
  r.Y_1 = one.Y, r.sigma_F1 = one.sigma, r.u_F1 = one.u;
  if (in.mesh != Mesh::external) return;
  const double k_2 = in.h_aP + r.x_2 - (r.d_a2 - r.d_2) / (2.0 * in.m_n);  // its tip circle may be its own
  const Tooth second{in.z_2, r.x_2,      k_2,   in.Y_2, in.sigma_adm_2, is_idler(in.idler, Idler::gear_2),
                     "Y_2",  "sigma_F2", "u_F2"};
  const Bending two = bend(in, r, second, trace);
  r.Y_2 = two.Y, r.sigma_F2 = two.sigma, r.u_F2 = two.u;
}

}  // namespace load

namespace load {

/// For the rating of an external pair.
inline RatedMesh mesh_of(const PairInput& in, Moment T_1, const PairResult& r) {
  if (in.mesh != Mesh::external || is_set(in.d_a2)) return {};
  RatedMesh mesh;
  mesh.z_1 = in.z_1, mesh.z_2 = in.z_2, mesh.m_n = in.m_n, mesh.alpha_n = in.alpha_n, mesh.beta = in.beta;
  mesh.x_1 = in.x_1, mesh.x_2 = r.x_2, mesh.a_w = r.a_w;
  mesh.h_aP = in.h_aP, mesh.h_fP = in.h_fP, mesh.rho_fP = in.rho_fP, mesh.shortening = in.shortening;
  mesh.b = r.b, mesh.T_1 = abs(T_1), mesh.n_1 = abs(in.n_1), mesh.K_A = in.K_A, mesh.idler = in.idler;
  return mesh;
}

}  // namespace load

/// Speeds, torques, forces, bending by Lewis; only what the load that is given allows.
template <class Tracer>
void load_teeth(const PairInput& in, PairResult& r, Tracer& trace) {
  using namespace load;
  if (is_set(in.n_1)) speeds(in, r, trace);
  const Moment T_1 = torque(in, trace);
  if (is_set(T_1)) forces(in, T_1, r, trace);
  r.mesh = mesh_of(in, T_1, r);
  velocity_factor(in, r, trace);
  if (!is_set(T_1) || !is_set(r.b) || !has_teeth(in, r)) return;
  bend_all(in, r, trace);
}

}  // namespace loadpath::gear
