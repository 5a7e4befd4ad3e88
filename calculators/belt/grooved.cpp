#include "calculators/belt/grooved.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/initial_tension.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::belt {

namespace {

Pulleys grooved_pulleys(const Grooved::Input& in) { return {in.d_1, in.d_2, in.a, in.L, Arrangement::open}; }

template <class Tracer>
void grooved_geometry(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.d_2 / in.d_1 / (1.0 - in.epsilon), "transmission ratio with slip, [B40]");
  STEP_TO(r, n_2, in.n_1 / i, "speed of the driven pulley");
  STEP_TO(r, v, in.n_1 * in.d_1 / 2.0, "belt speed");
  lay(grooved_pulleys(in), r, trace);
  STEP_TO(r, f_B, 2.0 * v / r.L, "two bends per belt revolution");
}

template <class Tracer>
void wedge(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  if (is_set(in.T_1)) {
    STEP_TO(r, F_t, 2.0 * in.K_A * in.T_1 / in.d_1, "force that the belts transmit");
  } else {
    STEP_TO(r, F_t, in.K_A * in.P / r.v, "force that the belts transmit");
  }
  if (is_set(in.phi)) {
    STEP_TO(r, mu_w, in.mu / sin(in.phi / 2.0), "wedge friction of the groove sides, [Tribology-V]");
  } else if (in.kind == Grooved::Kind::ribbed) {
    STEP_TO(r, mu_w, in.mu / sin(pi / 9.0), "wedge friction of grooves of 40°, [Tribology-V]");
  } else {
    STEP_TO(r, mu_w, in.mu, "smooth rim");
  }
  STEP_TO(r, m_e, exp(r.mu_w * min(r.alpha_1, r.alpha_2)), "Euler's condition at the smaller wrap, [B40]");
}

/// Allowable tension of one belt or rib, and the parts of it that bending and its own mass use.
template <class Tracer>
void allowable_tension(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  if (is_set(in.q)) {
    STEP_TO(r, F_c, in.q * r.v * r.v, "centrifugal tension; it does not press the belt into the grooves");
  } else {
    STEP_TO(r, F_c, in.rho * pi / 4.0 * in.d_b * in.d_b * r.v * r.v,
            "centrifugal tension; it does not press the belt into the grooves");
  }
  r.S_b = 0.0 * N.one;
  if (is_set(in.sigma_adm)) {
    STEP_TO(r, S_all, in.sigma_adm * pi / 4.0 * in.d_b * in.d_b, "allowable tension of the section");
    if (is_set(in.E_b)) {
      STEP(sigma_b, in.E_b * in.d_b / min(in.d_1, in.d_2), "bending around the smaller pulley");
      STEP_TO(r, S_b, sigma_b * pi / 4.0 * in.d_b * in.d_b, "tension of the same stress");
      STEP_TO(r, u_b, sigma_b / in.sigma_adm, "bending only");
    }
  } else if (is_set(in.S_adm)) {
    STEP_TO(r, S_all, in.S_adm, "as given");
    if (is_set(in.E_b)) {
      STEP(sigma_b, in.E_b * in.d_b / min(in.d_1, in.d_2), "bending around the smaller pulley");
      STEP_TO(r, S_b, sigma_b * pi / 4.0 * in.d_b * in.d_b, "tension of the same stress");
      STEP_TO(r, u_b, S_b / S_all, "bending only");
    }
  }
  if (!is_set(r.S_all)) return;
  trace.value("S_b", r.S_b, is_set(in.E_b) ? "bending" : "the allowable tension applies to the given pulleys");
  STEP_TO(r, S_N, r.S_all - r.S_b - r.F_c, "left for the effective pull");
}

/// The required number by the allowable tension and by the rating, whichever is larger.
template <class Tracer>
void required_number(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  double required = 0.0;
  if (r.S_N > from_si<Force>(0.0)) {
    STEP(z_S, r.F_t / (r.S_N * (1.0 - 1.0 / r.m_e)), "tension and friction both at their limit");
    required = z_S;
  }
  if (is_set(in.P_R)) {
    STEP(z_P, r.F_t * r.v / in.P_R, "design power / power rating of one belt or rib");
    required = std::max(required, double{z_P});
  }
  if (required > 0.0) r.z_0 = trace.value("z_0", required, "required number, not rounded");
  constexpr double rounding = 1e-9, most = 100.0;
  const double least = std::clamp(std::ceil(required - rounding), 1.0, most);
  r.z = in.z > 0 ? in.z : Whole(static_cast<int>(least));
  trace.value("z", r.z, in.z > 0 ? "as given" : "smallest number that transmits the power");
  if (is_set(in.p_r)) {
    STEP_TO(r, b, r.z * in.p_r, "width of the ribs");
  }
  if (is_set(in.P_R)) {
    STEP_TO(r, u_P, r.F_t * r.v / (r.z * in.P_R), "power condition");
  }
}

template <class Tracer>
void grooved_tensions(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  tension_spans(r.F_t / r.z, in.S_0, in.tensioning == Grooved::Tensioning::fixed, r, trace);
  if (r.S_2 > r.F_c) {
    STEP_TO(r, mu_req, in.mu / r.mu_w * log((r.S_1 - r.F_c) / (r.S_2 - r.F_c)) / min(r.alpha_1, r.alpha_2),
            "friction that is used");
  }
  if (is_set(r.S_all)) {
    STEP_TO(r, u_T, (r.S_1 + r.S_b) / r.S_all, "strength condition");
  }
}

template <class Tracer>
void load_grooved_shafts(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  STEP_TO(r, R_0, 2.0 * r.z * r.S_0 * r.l_s / r.a, "two spans of every belt or rib at standstill");
  STEP(N_1, r.z * (r.S_1 - r.F_c), "tight side tensions less centrifugal tension");
  STEP(N_2, r.z * (r.S_2 - r.F_c), "slack side tensions less centrifugal tension");
  load_shaft(N_1, N_2, r.gamma, r, trace);
  hand_over(r.F_t * in.d_1 / 2.0, r.F_t * in.d_2 / 2.0, largest_pull(r, r.R_0), in.d_1, in.d_2, in.n_1, r);
}

template <class Tracer>
void limit_grooved(const Grooved::Input& in, Grooved::Result& r, Tracer& trace) {
  if (is_set(in.d_min)) {
    STEP_TO(r, x_d, in.d_min / min(in.d_1, in.d_2), "minimum / smaller diameter");
  }
  if (is_set(in.v_max)) {
    STEP_TO(r, x_v, r.v / in.v_max, "speed / maximum speed");
  }
  if (is_set(in.p_r)) {
    STEP_TO(r, x_b, r.b / min(in.d_1, in.d_2), "width / smaller diameter");
    STEP_TO(r, g_x, r.a - (in.d_1 + in.d_2) / 2.0 - in.p_r,
            "gap of the tension lines, less the backs of the belt: half a rib pitch each, from memory");
  } else if (is_set(in.d_b)) {
    STEP_TO(r, g_x, r.a - (in.d_1 + in.d_2) / 2.0 - in.d_b, "gap of the tension lines, less two belt radii");
  } else {
    STEP_TO(r, g_x, r.a - (in.d_1 + in.d_2) / 2.0, "gap of the tension lines; the size of the belt is not given");
  }
}

}  // namespace

namespace {

/// Without it, that of a belt of 1200 kg/m^3.
double round_diameter(const Grooved::Input& in) {
  constexpr double rho = 1200.0;
  return is_set(in.d_b) ? in_si(in.d_b) : std::sqrt(4.0 * in_si(in.q) / (pi * rho));
}

}  // namespace

/// Pull of a rib or a round belt at its rated power: ribs PK have some 30 N per mm of pitch, from memory.
double Grooved::most_rating(const Input& in) {
  const Speed v = in.n_1 * in.d_1 / 2.0;
  if (is_set(in.p_r)) return in_si(60.0 * N_per_mm * in.p_r * v);
  const double d_b = round_diameter(in);
  return 10e6 * pi / 4.0 * d_b * d_b * in_si(v);
}

/// Round belts of plastic bend around six to ten times their diameter, from memory.
double Grooved::least_bend(const Input& in) {
  constexpr double diameters = 5.0;
  return in.kind == Kind::ribbed ? unset<double> : diameters * round_diameter(in);
}

/// The spans are inclined by 30 deg where the difference of the diameters is the centre distance.
double Grooved::least_centre_distance(const Input& in) { return in_si(abs(in.d_2 - in.d_1)); }
/// Longer spans of round belts vibrate and sag, from memory; ribbed belts are shorter.
double Grooved::most_centre_distance(const Input& in) { return in_si(10.0 * (in.d_1 + in.d_2)); }
double Grooved::least_length(const Input& in) {
  const Length a = abs(in.d_2 - in.d_1), around = (in.d_1 + in.d_2) / 2.0;
  if (!(a > around)) return unset<double>;
  return in_si(std::sqrt(3.0) * a + pi * around + pi / 6.0 * a);
}

bool Grooved::pulleys_clear(const Input& in) {
  return is_set(in.a) == is_set(in.L) || stand_clear(grooved_pulleys(in));  // another rule names a and L
}
FieldFault Grooved::pulleys_overlap(const Input& in) { return overlap(grooved_pulleys(in)); }

FieldFault Grooved::no_capacity(const Input& in) {
  if (in.kind == Kind::ribbed)
    return {"P_R", say("the capacity of a rib is missing"),
            say("give the manufacturer's power rating P_R or allowable tension S_adm of one rib")};
  return {"S_adm", say("the capacity of the belt is missing"),
          say("give the allowable tension S_adm, or sigma_adm and d_b of a round belt, or the rating P_R")};
}

template <class Tracer>
Grooved::Result Grooved::evaluate(const Input& in, Tracer& trace) {
  Result r;
  grooved_geometry(in, r, trace);
  wedge(in, r, trace);
  allowable_tension(in, r, trace);
  required_number(in, r, trace);
  grooved_tensions(in, r, trace);
  load_grooved_shafts(in, r, trace);
  limit_grooved(in, r, trace);
  return r;
}

template Grooved::Result Grooved::evaluate(const Input&, NoTrace&);
template Grooved::Result Grooved::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Grooved::figures(const Input& in, const Result& r) {
  TwoWheels w;
  w.d_1 = in_si(in.d_1), w.d_2 = in_si(in.d_2), w.a = in_si(r.a);
  w.alpha_1 = r.alpha_1, w.alpha_2 = r.alpha_2;
  w.n_1 = in_si(in.n_1), w.n_2 = in_si(r.n_2);
  Pulls pulls;
  pulls.tight = in_si(r.S_1), pulls.slack = in_si(r.S_2);
  pulls.of_one_belt = r.z > 1;
  pulls.R = in_si(r.R), pulls.R_x = in_si(r.R_x), pulls.R_y = in_si(r.R_y);
  return {drive_figure(w, pulls)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Grooved>();
