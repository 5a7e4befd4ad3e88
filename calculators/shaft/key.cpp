#include "calculators/shaft/key.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::shaft {

namespace {

using Input = Key::Input;
using Result = Key::Result;

/// Pressures and the shear stress at the force that counts.
template <class Tracer>
void stresses(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, l_tr, in.form == Key::Form::A ? in.l - in.b : in.l,
          in.form == Key::Form::A ? "between the round ends" : "up to the straight ends");
  STEP_TO(r, phi, in.i > 1 ? 0.75 : 1.0, "two keys do not share the load equally, method C of [DIN6892]");
  torque_that_counts(in, r, trace);
  const Moment T_eq = r.T_eq;
  STEP_TO(r, F_t, 2.0 * T_eq / in.d, "at the surface of the shaft");
  STEP_TO(r, p_1, F_t / (in.t_1 * l_tr * in.i * phi), "on the height in the shaft keyway");
  STEP_TO(r, p_2, F_t / ((in.h - in.t_1) * l_tr * in.i * phi), "on the height above the shaft, method C of [DIN6892]");
  STEP_TO(r, tau, F_t / (in.b * l_tr * in.i * phi), "across its width, round ends not counted");
}

/// Against what shaft, hub and key allow.
template <class Tracer>
void strengths(const Input& in, Result& r, Tracer& trace) {
  const Stress p_1 = r.p_1, p_2 = r.p_2, tau = r.tau;
  const Stress p_a1 = allowed_pressure("p_a1", in.p_adm_1, in.R_e_1, trace);
  const Stress p_a2 = allowed_pressure("p_a2", in.p_adm_2, in.R_e_2, trace);
  const Stress p_ak = allowed_pressure("p_ak", in.p_adm_k, in.R_e_k, trace);
  if (is_set(p_a1)) {
    STEP_TO(r, u_1, p_1 / p_a1, "shaft: bearing pressure / allowable pressure");
  }
  if (is_set(p_a2)) {
    STEP_TO(r, u_2, p_2 / p_a2, "hub: bearing pressure / allowable pressure");
  }
  if (is_set(p_ak)) {
    STEP_TO(r, u_k, max(p_1, p_2) / p_ak, "key: bearing pressure / allowable pressure");
  }
  if (is_set(in.tau_adm)) {
    STEP_TO(r, u_tau, tau / in.tau_adm, "shear stress / allowable shear stress of the key");
  } else if (is_set(p_ak)) {
    STEP_TO(r, u_tau, sqrt(3.0) * tau / p_ak, "equivalent stress of pure shear, [Mises]");
  }
}

/// Where the torque changes its sense every side allows less.
template <class Tracer>
void reversal(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.f_W) || !is_set(r.u_1) || !is_set(r.u_2) || !is_set(r.u_k)) return;
  STEP_TO(r, u_W, max(max(r.u_1, r.u_2), r.u_k) / in.f_W, "largest of shaft, hub and key, divided by f_W of method B");
}

/// The shaft itself: the round that lies inside of the seats.
template <class Tracer>
void torsion_of_shaft(const Input& in, Result& r, Tracer& trace) {
  STEP(d_k, in.d - (in.i > 1 ? 2.0 : 1.0) * in.t_1, "the circle inside of the keyways");
  STEP_TO(r, tau_t, 16.0 * r.T_eq / (pi * pow<3>(d_k)), "of a shaft of that diameter, on the safe side");
  yielding_of_shaft(in, r, trace);
}

/// Wall of the hub above the keyway, whose depth includes the clearance above the key.
template <class Tracer>
void wall_of(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.d_f)) return;
  const Length s_N = wall_under_root(in, in.d, is_set(in.t_2) ? in.t_2 : in.h - in.t_1, r, trace);
  STEP(t_n, is_set(in.t_2) ? in.t_2 : in.h - in.t_1, "depth of the keyway");
  STEP_TO(r, x_R, t_n / s_N, "wall at least as thick as the keyway is deep");
}

/// Fit of the sizes: shaft, hub, keyways.
template <class Tracer>
void fits(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, x_l, r.l_tr / in.d, "uniform pressure up to 1.3, [DIN6892]");
  if (is_set(in.l_n)) {
    STEP_TO(r, u_n, in.l / in.l_n, "key length / hub length");
  }
  if (is_set(in.d_over)) {
    STEP_TO(r, x_d, (in.d - in.d_over) / (in.d_to - in.d_over), "between the shafts that the key belongs to");
  } else {
    STEP_TO(r, x_b, in.b / in.d, "as wide as the standard's at most");
    STEP_TO(r, x_t, in.t_1 / in.d, "as deep as the standard's at most");
  }
  if (in.d_bore > 0.0 * mm) {
    STEP_TO(r, x_w, in.t_1 / ((in.d - in.d_bore) / 2.0 - in.t_1),
            "remaining wall at least as thick as the keyway depth");
  }
  if (!is_set(in.t_2)) return;
  STEP_TO(r, x_h, in.h / (in.t_1 + in.t_2), "with clearance above the key");
}

}  // namespace

bool Key::sizes_given(const Input& in) { return is_set(in.b) && is_set(in.h) && is_set(in.t_1); }

FieldFault Key::other_length(const Input& in) {
  const auto format = [](Length x) { return format_quantity(in_si(x), mm.symbol); };
  return {"l",
          say("the standard has no key of this section and length: l = {1}, and it is made from {2} to {3}",
              format(in.l), format(in.l_min), format(in.l_max)),
          {}};
}

Applies Key::twisted(const Input& in) {
  const Length d = core(in);
  const Moment T = is_set(in.T_max) ? max(in.K_A * abs(in.T), abs(in.T_max)) : in.K_A * abs(in.T);
  return torsion_of(16.0 / pi * T / (d * d * d));
}

template <class Tracer>
Key::Result Key::evaluate(const Input& in, Tracer& trace) {
  Result r;
  stresses(in, r, trace);
  strengths(in, r, trace);
  reversal(in, r, trace);
  torsion_of_shaft(in, r, trace);
  fits(in, r, trace);
  wall_of(in, r, trace);
  r.connection = connection_for(in.i == 2 ? Fastening::two_keys : Fastening::key, in.K_A * abs(in.T), in.d, in.d_bore);
  r.connection.T_peak = r.T_eq, r.connection.l_c = in.l, r.connection.t_c = in.t_2;
  r.connection.r_c = least_ratio(in.torque);
  if (is_set(in.R_e_1)) r.connection.R_c = in.R_e_1;
  r.notch.kind = in.i == 2 ? Notch::two_keyways : Notch::keyway;
  r.notch.d = in.d, r.notch.t = in.t_1, r.notch.l = in.l;
  if (in.torque == Sense::reversing) r.notch.r_T = -1.0;
  return r;
}

template Key::Result Key::evaluate(const Input&, NoTrace&);
template Key::Result Key::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Key>();
