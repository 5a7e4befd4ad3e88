#include "calculators/drive/friction_wheels.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::drive {

namespace {

using Wheels = FrictionWheels;
using Shape = FrictionWheels::Shape;

/// The lowest value of [Lueger] for dry rims on cast iron.
double lowest_friction(Wheels::Pair pair) {
  switch (pair) {
    case Wheels::Pair::cast_iron:
      return 0.10;
    case Wheels::Pair::paper:
      return 0.15;
    case Wheels::Pair::leather:
      return 0.20;
    case Wheels::Pair::wood:
      return 0.30;
    case Wheels::Pair::unsaid:
      break;
  }
  return unset<double>;
}

template <class Tracer>
void roll(const Wheels::Input& in, Wheels::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.d_2 / in.d_1 / (1.0 - in.epsilon), "ratio of the speeds: equal rims, less the creep");
  STEP_TO(r, n_2, in.n_1 / i, "speed of the driven wheel");
  STEP_TO(r, v, in.n_1 * in.d_1 / 2.0, "speed of the driving rim");
  if (in.shape != Shape::bevel) {
    STEP_TO(r, a, (in.d_1 + in.d_2) / 2.0, "centre distance of wheels that touch from outside");
    return;
  }
  STEP_TO(r, delta_1, atan(sin(in.Sigma) / (in.d_2 / in.d_1 + cos(in.Sigma))),
          "cones with a common apex roll without sliding");
  STEP_TO(r, delta_2, in.Sigma - delta_1, "cone angles add up to the shaft angle");
}

/// Pressing force over the normal force that it makes.
template <class Tracer>
double pressing_share(const Wheels::Input& in, const Wheels::Result& r, Tracer& trace) {
  if (in.shape == Shape::grooved) {
    return NAMED_STEP("k_p", sin(in.alpha) + in.c_r * r.mu * cos(in.alpha),
                      "across the line of contact of the flanks, with their friction, [Lueger]");
  }
  if (in.shape == Shape::bevel) {
    return NAMED_STEP("k_p", sin(r.delta_1), "along the driving shaft, against the normal of the cone");
  }
  return NAMED_STEP("k_p", 1.0, "along the line of centres, [Lueger]");
}

template <class Tracer>
void press(const Wheels::Input& in, Wheels::Result& r, Tracer& trace) {
  r.mu = trace.value("mu", is_set(in.mu) ? in.mu : lowest_friction(in.pair),
                     is_set(in.mu) ? "as given" : "the lowest value of the pair, [Lueger]");
  if (is_set(in.T_1)) {
    STEP_TO(r, F_t, 2.0 * in.K_A * in.T_1 / in.d_1, "tangential force transmitted by friction");
  } else {
    STEP_TO(r, F_t, in.K_A * in.P / r.v, "tangential force transmitted by friction");
  }
  STEP(F_nmin, in.S_min * r.F_t / r.mu, "normal force without slip, with the safety factor S_min, [Artobolevsky]");
  const double k_p = pressing_share(in, r, trace);
  STEP_TO(r, F_pmin, k_p * F_nmin, "minimum pressing force");
  STEP_TO(r, F_p, is_set(in.F_p) ? in.F_p : F_pmin, is_set(in.F_p) ? "as given" : "the minimum");
  STEP_TO(r, F_n, F_p / k_p, "normal force between the rims");
  STEP_TO(r, mu_req, r.F_t / F_n, "required coefficient of friction");
  STEP_TO(r, S_R, r.mu / mu_req, "safety factor against slip");
  STEP_TO(r, T_R, r.mu * F_n * in.d_1 / 2.0, "a larger torque slips");
  STEP_TO(r, u_S, F_pmin / F_p, "slip condition");
}

/// Forces on the shafts, and the records of their loads.
template <class Tracer>
void load_shafts(const Wheels::Input& in, Wheels::Result& r, Tracer& trace) {
  const Force none = 0.0 * N.one;
  if (in.shape == Shape::bevel) {
    STEP_TO(r, F_r1, r.F_n * cos(r.delta_1), "normal force across the driving shaft");
    STEP_TO(r, F_a1, r.F_n * sin(r.delta_1), "normal force along the driving shaft");
    STEP_TO(r, F_r2, r.F_n * cos(r.delta_2), "normal force across the driven shaft");
    STEP_TO(r, F_a2, r.F_n * sin(r.delta_2), "normal force along the driven shaft");
  } else {
    STEP_TO(r, F_r1, r.F_p, "separating force: the pressing force");
    STEP_TO(r, F_r2, r.F_p, "equal and opposite on the driven shaft");
    r.F_a1 = r.F_a2 = none;
  }
  r.shaft_1 = shaft_load(r.F_t * in.d_1 / 2.0, {-r.F_r1, -r.F_t, r.F_a1}, in.d_1, in.n_1);
  r.shaft_2 = shaft_load(r.F_t * in.d_2 / 2.0, {-r.F_r2, -r.F_t, r.F_a2}, in.d_2, -r.n_2);
}

/// The curvature of both rims together: cylinders, cones, or flanks, which are cones too.
template <class Tracer>
auto curvature(const Wheels::Input& in, const Wheels::Result& r, Tracer& trace) {
  if (in.shape == Shape::grooved) {
    return NAMED_STEP("kappa", 2.0 * sin(in.alpha) * (1.0 / in.d_1 + 1.0 / in.d_2),
                      "curvature of both flanks, normal to the cones");
  }
  if (in.shape == Shape::bevel) {
    return NAMED_STEP("kappa", 2.0 * (cos(r.delta_1) / in.d_1 + cos(r.delta_2) / in.d_2),
                      "curvature of both cones, normal to them");
  }
  return NAMED_STEP("kappa", 2.0 * (1.0 / in.d_1 + 1.0 / in.d_2), "curvature of both cylinders");
}

/// The larger of two, either of which may be unset.
template <class Quantity>
Quantity larger(Quantity a, Quantity b) {
  return !is_set(a) ? b : !is_set(b) ? a : max(a, b);
}

template <class Tracer>
void touch(const Wheels::Input& in, Wheels::Result& r, Tracer& trace) {
  const bool grooved = in.shape == Shape::grooved;
  const double n_L = grooved ? NAMED_STEP("n_L", 2.0 * in.z, "two flanks of each groove")
                             : NAMED_STEP("n_L", 1.0, "one line of contact");
  STEP_TO(r, q, r.F_n / (n_L * in.b), "line load, even along the contact");
  Length b_q = unset<Length>, b_p = unset<Length>;
  double u_q = unset<double>, u_H = unset<double>;
  if (is_set(in.q_adm)) {
    u_q = NAMED_STEP("u_q", q / in.q_adm, "contact condition of soft rims");
    b_q = NAMED_STEP("b_q", r.F_n / (n_L * in.q_adm), "minimum contact length by the line load");
  }
  if (is_set(in.E_1)) {
    const auto kappa = curvature(in, r, trace);
    STEP(C, (1.0 - pow<2>(in.nu_1)) / in.E_1 + (1.0 - pow<2>(in.nu_2)) / in.E_2, "compliance of both rims, [Hertz]");
    STEP_TO(r, p_H, sqrt(q * kappa / (pi * C)), "largest pressure of the line contact, [Hertz]");
    STEP_TO(r, b_H, 2.0 * q / (pi * p_H), "half contact width, [Hertz]");
    if (is_set(in.p_adm)) {
      u_H = NAMED_STEP("u_H", p_H / in.p_adm, "contact condition of elastic rims");
      b_p = NAMED_STEP("b_p", r.F_n * kappa / (n_L * pi * C * pow<2>(in.p_adm)),
                       "minimum contact length by the Hertzian pressure");
    }
  }
  const bool both = is_set(b_q) && is_set(b_p);
  const char* const why = both ? "the larger governs" : "the only limit that is given";
  if (is_set(b_q) || is_set(b_p)) {
    r.b_min = trace.value("b_min", larger(b_q, b_p), why);
    r.u_p = trace.value("u_p", larger(u_q, u_H), why);
  }
}

}  // namespace

/// Both half cone angles below 90 deg: beyond, one cone lies in the other.
bool Wheels::cones_meet(const Input& in) {
  if (in.shape != Shape::bevel || !is_set(in.d_1) || !is_set(in.d_2)) return true;
  const double turn = cos(in.Sigma), least = 1e-6;
  return in.d_2 / in.d_1 + turn > least && in.d_1 / in.d_2 + turn > least;
}

namespace {

bool is_soft(const Wheels::Input& in) { return in.pair != Wheels::Pair::unsaid && in.pair != Wheels::Pair::cast_iron; }

/// From the apex to the middle of the contact.
Length mean_cone_distance(const Wheels::Input& in) {
  const double delta_1 = std::atan2(std::sin(in.Sigma), in.d_2 / in.d_1 + std::cos(in.Sigma));
  return in.d_1 / (2.0 * std::sin(delta_1));
}

}  // namespace

/// The diameters are those of the middle of the contact, half of which lies nearer to the axis.
bool Wheels::ends_before_axis(const Input& in) {
  if (!is_set(in.b) || !is_set(in.d_1) || !is_set(in.d_2)) return true;
  if (in.shape == Shape::bevel) return !cones_meet(in) || in.b < 2.0 * mean_cone_distance(in);
  if (in.shape != Shape::grooved || !is_set(in.alpha)) return true;
  return in.b * std::cos(in.alpha) < min(in.d_1, in.d_2);
}

/// A longer contact does not bear evenly: of rollers, from memory.
double Wheels::most_length_of_cylinders(const Input& in) {
  return in.shape == Shape::cylindrical ? in_si(min(in.d_1, in.d_2)) : unset<double>;
}

/// A third of the outer cone distance, as of bevel gears: b = (R_m + b/2)/3.
double Wheels::most_length_of_cones(const Input& in) {
  if (in.shape != Shape::bevel || !is_set(in.d_1) || !is_set(in.d_2) || !cones_meet(in)) return unset<double>;
  return in_si(0.4 * mean_cone_distance(in));
}

/// Grooves that reach a quarter of the radius to both sides slide by a quarter of the rim speed at their ends.
double Wheels::most_length_of_flanks(const Input& in) {
  if (in.shape != Shape::grooved || !is_set(in.alpha) || !is_set(in.d_1) || !is_set(in.d_2)) return unset<double>;
  return in_si(0.25 * min(in.d_1, in.d_2) / std::cos(in.alpha));
}

/// Twice what books allow for laminated fabric, the hardest of the soft rims: 40 to 80 N/mm, from memory.
double Wheels::most_line_load(const Input& in) { return is_soft(in) ? in_si(160.0 * N_per_mm) : unset<double>; }

/// The same by Hertz, at its modulus of some 7 GPa.
double Wheels::most_pressure(const Input& in) { return is_soft(in) ? in_si(150.0 * MPa) : unset<double>; }

/// Rims of cast iron, as of pulleys, from memory; of steel discs the strength in rotation is a reason.
double Wheels::most_speed(const Input& in) {
  constexpr double most = 35.0;  // m/s
  if (!is_set(in.d_1)) return unset<double>;
  return most / (0.5 * in_si(in.d_1));
}

template <class Tracer>
Wheels::Result Wheels::evaluate(const Input& in, Tracer& trace) {
  Result r;
  roll(in, r, trace);
  press(in, r, trace);
  load_shafts(in, r, trace);
  touch(in, r, trace);
  return r;
}

template FrictionWheels::Result FrictionWheels::evaluate(const Input&, NoTrace&);
template FrictionWheels::Result FrictionWheels::evaluate(const Input&, Trace&);

}  // namespace loadpath::drive

template const loadpath::Calculator& loadpath::erased<loadpath::drive::FrictionWheels>();
