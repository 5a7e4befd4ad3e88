#include "calculators/vessel/thick/autofrettage.hpp"

#include "calculators/vessel/thick/lame_constants.hpp"
#include "calculators/vessel/thick/plastic.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = Autofrettage::Input;
using Result = Autofrettage::Result;

template <class Tracer>
Stress first_yield(Stress Y, Length R_i, Length R_a, Tracer& trace) {
  return NAMED_STEP("p_y", Y / 2.0 * (1.0 - pow<2>(R_i / R_a)), "first yield at the bore, [Lame]");
}

/// Pressure at which the wall is plastic up to the radius r_p.
template <class Tracer>
Stress pressure_of(Stress Y, Length R_i, Length R_a, Length r_p, Tracer& trace) {
  return NAMED_STEP("p_A", Y / 2.0 * (1.0 - pow<2>(r_p / R_a)) + Y * log(r_p / R_i),
                    "plastic up to r_p, elastic beyond, [Hearn-2]");
}

/// The plastic radius of a pressure between first yield and full plasticity, which rises with the radius: by bisection.
Length radius_of(Stress Y, Length R_i, Length R_a, Stress p_A) {
  NoTrace off;
  Length low = R_i, high = R_a;
  for (int i = 0; i < 200; ++i) {
    const Length middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (pressure_of(Y, R_i, R_a, middle, off) < p_A ? low : high) = middle;
  }
  return high;
}

template <class Tracer>
void plastic_zone(const Input& in, Stress Y, Result& r, Tracer& trace) {
  if (is_set(in.p_A)) {
    r.p_A = trace.value("p_A", in.p_A, "as given");
    r.r_p = trace.value("r_p", radius_of(Y, in.R_i, in.R_a, in.p_A), "plastic radius of this pressure, [Hearn-2]");
  } else {
    if (is_set(in.w)) {
      STEP_TO(r, r_p, in.R_i + in.w * (in.R_a - in.R_i), "plastic share of the wall");
    } else {
      r.r_p = trace.value("r_p", in.r_p, "as given");
    }
    r.p_A = pressure_of(Y, in.R_i, in.R_a, r.r_p, trace);
  }
  if (is_set(in.w)) {
    r.w = trace.value("w", in.w, "as given");
  } else {
    STEP_TO(r, w, (r.r_p - in.R_i) / (in.R_a - in.R_i), "plastic share of the wall");
  }
}

/// The stresses under the autofrettage pressure less the elastic ones that its removal takes back.
template <class Tracer>
void residual_stresses(const Input& in, Stress Y, Result& r, Tracer& trace) {
  const Length r_p = r.r_p;
  const Stress p_A = r.p_A;
  STEP(K_A, p_A / (pow<2>(in.R_a / in.R_i) - 1.0), "mean of hoop and radial stress by p_A, elastic, [Lame]");
  STEP_TO(r, sigma_ri, Y - p_A - K_A * (1.0 + pow<2>(in.R_a / in.R_i)), "bore: plastic stress less elastic unloading");
  STEP_TO(r, sigma_rp, Y / 2.0 * (1.0 + pow<2>(r_p / in.R_a)) - K_A * (1.0 + pow<2>(in.R_a / r_p)),
          "at r_p: yield of the elastic ring less elastic unloading");
  STEP_TO(r, sigma_ra, Y * pow<2>(r_p / in.R_a) - 2.0 * K_A,
          "outside: stress of the elastic ring less elastic unloading");
  STEP_TO(r, sigma_vr, abs(sigma_ri) * in.R_e / Y, "without a pressure the hoop stress is the difference");
}

template <class Tracer>
void service(const Input& in, Stress Y, Result& r, Tracer& trace) {
  if (in.p > r.p_A) return;  // it yields again, and these stresses are not reached
  const Length r_p = r.r_p;
  const Stress p_A = r.p_A;
  STEP(K_s, in.p / (pow<2>(in.R_a / in.R_i) - 1.0), "mean of hoop and radial stress in service, elastic, [Lame]");
  STEP_TO(r, sigma_ti, r.sigma_ri + K_s * (1.0 + pow<2>(in.R_a / in.R_i)), "bore, residual and elastic stress");
  STEP_TO(r, sigma_tp, r.sigma_rp + K_s * (1.0 + pow<2>(in.R_a / r_p)), "at r_p, residual and elastic stress");
  STEP_TO(r, sigma_ta, r.sigma_ra + 2.0 * K_s, "outside, residual and elastic stress");
  STEP(D_p, Y - 2.0 * (p_A - in.p) / (1.0 - pow<2>(in.R_i / in.R_a)) * pow<2>(in.R_i / r_p),
       "difference of hoop and radial stress at r_p, its maximum");
  STEP(D_i, Y - 2.0 * (p_A - in.p) / (1.0 - pow<2>(in.R_i / in.R_a)), "the same at the bore, its minimum");
  STEP_TO(r, sigma_v, max(abs(D_p), abs(D_i)) * in.R_e / Y, "equivalent of the larger one");
}

template <class Tracer>
void checks(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.S)) {
    STEP_TO(r, u_p, in.S * in.p / r.p_A, "elastic up to the autofrettage pressure");
  }
  if (is_set(in.f_B)) {
    STEP_TO(r, u_B, r.sigma_vr / (in.f_B * in.R_e), "yielding in compression after the unloading");
  }
  STEP_TO(r, x_k, in.R_a / in.R_i, "the axial stress is the middle one up to 5.43, [Hill]");
}

}  // namespace

bool Autofrettage::yields_partly(const Input& in) {
  if (!is_set(in.p_A) || !(in.R_i < in.R_a)) return true;
  NoTrace off;
  const Stress Y = yield_difference(in.R_e, in.hypothesis, off);
  return in.p_A > first_yield(Y, in.R_i, in.R_a, off) && in.p_A <= plastic_pressure(Y, in.R_i, in.R_a, off);
}

FieldFault Autofrettage::range_of_pressure(const Input& in) {
  NoTrace off;
  const Stress Y = yield_difference(in.R_e, in.hypothesis, off);
  const auto shown = [](Stress p) { return format_quantity(in_si(p), MPa.symbol); };
  return {"p_A",
          say("autofrettage pressure {1}: first yield is at {2}, full plasticity at {3}", shown(in.p_A),
              shown(first_yield(Y, in.R_i, in.R_a, off)), shown(plastic_pressure(Y, in.R_i, in.R_a, off))),
          say("give a pressure between these")};
}

template <class Tracer>
Autofrettage::Result Autofrettage::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, k, in.R_a / in.R_i, "ratio of the radii");
  const Stress Y = yield_difference(in.R_e, in.hypothesis, trace);
  r.p_y = first_yield(Y, in.R_i, in.R_a, trace);
  r.p_pl = plastic_pressure(Y, in.R_i, in.R_a, trace);
  plastic_zone(in, Y, r, trace);
  residual_stresses(in, Y, r, trace);
  service(in, Y, r, trace);
  STEP(x_p, in.p / Y, "pressure in service over the difference that yields");
  STEP(r_0, in.R_i * exp(x_p), "the maximum difference, at r_p, is smallest for this plastic radius");
  if (r_0 < in.R_a) r.r_opt = trace.value("r_opt", r_0, "plastic radius of the minimum equivalent stress");
  checks(in, r, trace);
  return r;
}

template Autofrettage::Result Autofrettage::evaluate(const Input&, NoTrace&);
template Autofrettage::Result Autofrettage::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Autofrettage::figures(const Input& in, const Result& r) {
  if (!is_set(r.sigma_v)) return {};
  constexpr int count = 80;
  NoTrace off;
  const Stress Y = yield_difference(in.R_e, in.hypothesis, off), none = 0.0 * MPa;
  const Stress at_ring = Y / 2.0 * (1.0 - pow<2>(r.r_p / in.R_a));
  const Lame ring = lame_constants(at_ring, none, r.r_p, in.R_a, off);
  const Lame unloading = lame_constants(r.p_A, none, in.R_i, in.R_a, off);
  const Lame loading = lame_constants(in.p, none, in.R_i, in.R_a, off);
  figure::Plot plot;
  plot.x = {"r", "radius", "mm"};
  plot.y = {"sigma_t", "hoop stress", "MPa"};
  figure::Curve residual{"residual", {}, {}}, service_curve{"in service", {}, {}};
  for (int i = 0; i <= count; ++i) {
    const Length at = in.R_i + (in.R_a - in.R_i) * (static_cast<double>(i) / count);
    const Stress loaded = at < r.r_p ? Stress(Y - r.p_A + Y * log(at / in.R_i)) : ring.hoop(at);
    const Stress left = loaded - unloading.hoop(at);
    for (figure::Curve* curve : {&residual, &service_curve}) curve->x.push_back(in_si(at));
    residual.y.push_back(in_si(left));
    service_curve.y.push_back(in_si(left + loading.hoop(at)));
  }
  plot.curves = {std::move(residual), std::move(service_curve)};
  return {{"stresses", "Hoop stress through the wall after autofrettage", std::move(plot)}};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Autofrettage>();
