#include "calculators/machine/disc.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::machine {

namespace {

using Input = Disc::Input;
using Result = Disc::Result;
using Form = Disc::Form;

/// Factors of the stresses: density times the square of the angular velocity, and functions of Poisson's ratio.
struct Rotation {
  decltype(Density() * AngularSpeed() * AngularSpeed()) q;
  double c_1, c_3;
};

template <class Tracer>
Rotation rotation_of(const Input& in, Tracer& trace) {
  STEP(q, in.rho * pow<2>(in.n), "centrifugal force per volume and radius");
  double nu_p = 0.0;
  if (in.form == Form::cylinder) {
    nu_p = NAMED_STEP("nu_p", in.nu / (1.0 - in.nu), "sections stay plane, [Hearn-2]");
  } else {
    nu_p = NAMED_STEP("nu_p", in.nu, "plane stress");
  }
  STEP(c_3, (3.0 + nu_p) / 8.0, "[Timoshenko-II]");
  STEP(c_1, (1.0 + 3.0 * nu_p) / 8.0, "[Timoshenko-II]");
  return {q, c_1, c_3};
}

template <class Tracer>
void inertia(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, R_a, in.D / 2.0, "outside");
  STEP_TO(r, R_i, in.d_i / 2.0, "bore");
  r.mass = NAMED_STEP("m", pi * in.rho * in.b * (pow<2>(R_a) - pow<2>(R_i)), "mass of a ring");
  STEP_TO(r, J_z, pi / 2.0 * in.rho * in.b * (pow<2>(R_a) - pow<2>(R_i)) * (pow<2>(R_a) + pow<2>(R_i)),
          "of a ring about its axis");
  STEP_TO(r, W_k, J_z * pow<2>(in.n) / 2.0, "kinetic energy");
  STEP_TO(r, v_a, abs(in.n) * R_a, "circumferential speed");
}

template <class Tracer>
void stresses(const Input& in, const Rotation& rotation, Result& r, Tracer& trace) {
  const Length R_a = r.R_a, R_i = r.R_i;
  const auto q = rotation.q;
  const double c_1 = rotation.c_1, c_3 = rotation.c_3;
  if (in.d_i > 0.0 * mm) {
    STEP_TO(r, sigma_ti, q * (c_3 * (2.0 * pow<2>(R_a) + pow<2>(R_i)) - c_1 * pow<2>(R_i)),
            "at the bore, [Timoshenko-II]");
  } else {
    STEP_TO(r, sigma_ti, q * c_3 * pow<2>(R_a), "at the axis, in all directions of the section, [Timoshenko-II]");
  }
  STEP_TO(r, sigma_rm, q * c_3 * pow<2>(R_a - R_i),
          "radial, at the axis or at the mean radius sqrt(R_i R_a), [Timoshenko-II]");
  if (in.d_i > 0.0 * mm) {
    STEP_TO(r, sigma_ta, q * (c_3 * (pow<2>(R_a) + 2.0 * pow<2>(R_i)) - c_1 * pow<2>(R_a)),
            "at the outside, [Timoshenko-II]");
  } else {
    STEP_TO(r, sigma_ta, q * (c_3 - c_1) * pow<2>(R_a), "at the outside, [Timoshenko-II]");
  }
  if (in.form == Form::cylinder) {
    STEP_TO(r, sigma_zm, q * in.nu / (4.0 * (1.0 - in.nu)) * (pow<2>(R_a) - pow<2>(R_i)),
            "axial, plane sections without a force along the axis, [Timoshenko-II]");
  }
}

template <class Tracer>
void at_radius(const Input& in, const Rotation& rotation, Result& r, Tracer& trace) {
  if (!is_set(in.r) || in.r < r.R_i || in.r > r.R_a) return;
  const Length R_a = r.R_a, R_i = r.R_i;
  const auto q = rotation.q;
  const double c_1 = rotation.c_1, c_3 = rotation.c_3;
  if (in.d_i > 0.0 * mm) {
    STEP_TO(r, sigma_tr, q * (c_3 * (pow<2>(R_a) + pow<2>(R_i) + pow<2>(R_a * R_i / in.r)) - c_1 * pow<2>(in.r)),
            "hoop stress at r, [Timoshenko-II]");
    STEP_TO(r, sigma_rr, q * c_3 * (pow<2>(R_a) + pow<2>(R_i) - pow<2>(R_a * R_i / in.r) - pow<2>(in.r)),
            "radial stress at r, [Timoshenko-II]");
  } else {
    STEP_TO(r, sigma_tr, q * (c_3 * pow<2>(R_a) - c_1 * pow<2>(in.r)), "hoop stress at r, [Timoshenko-II]");
    STEP_TO(r, sigma_rr, q * c_3 * (pow<2>(R_a) - pow<2>(in.r)), "radial stress at r, [Timoshenko-II]");
  }
}

/// A long cylinder also contracts by its axial stress, which is the opposite at the outside.
template <class Tracer>
void growth(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.E)) return;
  const Stress sigma_z = trace.value("sigma_z", is_set(r.sigma_zm) ? r.sigma_zm : 0.0 * MPa, "axial stress inside");
  STEP_TO(r, w_i, r.R_i / in.E * (r.sigma_ti - in.nu * sigma_z), "Hooke, at the bore");
  STEP_TO(r, w_a, r.R_a / in.E * (r.sigma_ta + in.nu * sigma_z), "Hooke, at the outside");
}

template <class Tracer>
void yielding(const Input& in, Result& r, Tracer& trace) {
  if (in.form == Form::disc) {
    STEP_TO(r, x_b, in.b / in.D, "up to 1/4 the middle plane has at most 1.5 % more, [Timoshenko-II]");
  }
  if (!is_set(in.R_e)) return;
  STEP_TO(r, S_F, in.R_e / r.sigma_ti, "Tresca, the least stress taken as zero");
  STEP_TO(r, n_F, abs(in.n) * sqrt(S_F), "stresses grow with the square of the speed");
  STEP_TO(r, n_pl, sqrt(3.0 * in.R_e / (in.rho * (pow<2>(r.R_a) + r.R_a * r.R_i + pow<2>(r.R_i)))),
          "equilibrium of half the body, the hoop stress all R_e");
  if (!is_set(in.S)) return;
  STEP_TO(r, u_v, in.S * r.sigma_ti / in.R_e, "against first yield");
}

}  // namespace

template <class Tracer>
Disc::Result Disc::evaluate(const Input& in, Tracer& trace) {
  Result r;
  inertia(in, r, trace);
  const Rotation rotation = rotation_of(in, trace);
  stresses(in, rotation, r, trace);
  at_radius(in, rotation, r, trace);
  growth(in, r, trace);
  yielding(in, r, trace);
  return r;
}

template Disc::Result Disc::evaluate(const Input&, NoTrace&);
template Disc::Result Disc::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Disc::figures(const Input& in, const Result& r) {
  if (!is_set(r.sigma_ti)) return {};
  constexpr int count = 60;
  NoTrace off;
  const Rotation rotation = rotation_of(in, off);
  figure::Plot plot;
  plot.x = {"r", "radius", "mm"};
  plot.y = {"sigma", "stress", "MPa"};
  figure::Curve hoop{"sigma_t", {}, {}}, radial{"sigma_r", {}, {}};
  Input at = in;
  for (int i = 0; i <= count; ++i) {
    Result there = r;
    at.r = r.R_i + (r.R_a - r.R_i) * (static_cast<double>(i) / count);
    if (i == count) at.r = r.R_a;
    at_radius(at, rotation, there, off);
    for (figure::Curve* curve : {&hoop, &radial}) curve->x.push_back(in_si(at.r));
    hoop.y.push_back(in_si(there.sigma_tr));
    radial.y.push_back(in_si(there.sigma_rr));
  }
  plot.curves = {std::move(hoop), std::move(radial)};
  return {{"stresses", "Hoop and radial stress over the radius", std::move(plot)}};
}

}  // namespace loadpath::machine

template const loadpath::Calculator& loadpath::erased<loadpath::machine::Disc>();
