#include "calculators/vessel/ends/end.hpp"

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/ends/torisphere.hpp"
#include "calculators/vessel/section.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/fixed_point.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = End::Input;
using Result = End::Result;
using Form = End::Form;

template <class Tracer>
Stress allowable_stress(const Input& in, Tracer& trace) {
  const bool by_steel = is_set(in.R_e) && is_set(in.R_m);
  if (!by_steel) return NAMED_STEP("f", in.sigma_adm, "as given");
  if (!is_set(in.sigma_adm)) return NAMED_STEP("f", min(in.R_e / 1.5, in.R_m / 2.4), "[EN13445-3], 6.2");
  return NAMED_STEP("f", min(in.sigma_adm, min(in.R_e / 1.5, in.R_m / 2.4)), "as given, at most [EN13445-3], 6.2");
}

/// The radii of a Klöpper or Korbbogen end follow from its outside.
template <class Tracer>
void radii_of_standard(const Input& in, Result& r, Tracer& trace) {
  if (in.form == Form::kloepper) {
    STEP_TO(r, R_c, r.D_a + in.c, "R = D_a, corroded, [DIN28011]");
    STEP_TO(r, r_c, 0.1 * r.D_a + in.c, "r = 0.1 D_a, corroded, [DIN28011]");
  } else {
    STEP_TO(r, R_c, 0.8 * r.D_a + in.c, "R = 0.8 D_a, corroded, [DIN28011]");
    STEP_TO(r, r_c, 0.154 * r.D_a + in.c, "r = 0.154 D_a, corroded, [DIN28011]");
  }
}

/// An ellipsoid counts as a torisphere of about its height.
template <class Tracer>
void radii_of_ellipsoid(const Input& in, Result& r, Tracer& trace) {
  const Length h_i = trace.value("h_i", is_set(in.h_i) ? in.h_i : in.D_i / 4.0, "inside height");
  STEP_TO(r, x_K, r.D_c / (2.0 * (h_i + in.c)), "diameter over twice the height, corroded");
  STEP_TO(r, R_c, r.D_c * (0.44 * r.x_K + 0.02), "crown of the torisphere it counts as, [EN13445-3], 7.5.4");
  STEP_TO(r, r_c, r.D_c * (0.5 / r.x_K - 0.08), "knuckle of the torisphere it counts as, [EN13445-3], 7.5.4");
}

template <class Tracer>
void radii(const Input& in, Length delta, Result& r, Tracer& trace) {
  STEP_TO(r, D_a, in.D_i + 2.0 * delta, "outside diameter");
  STEP_TO(r, D_c, in.D_i + 2.0 * in.c, "inside diameter, corroded");
  if (in.form == Form::kloepper || in.form == Form::korbbogen) {
    radii_of_standard(in, r, trace);
  } else if (in.form == Form::ellipsoidal) {
    radii_of_ellipsoid(in, r, trace);
  } else if (in.form == Form::hemispherical) {
    STEP_TO(r, R_c, r.D_c / 2.0, "half of a sphere");
  } else {
    STEP_TO(r, R_c, in.R + in.c, "crown, corroded");
    STEP_TO(r, r_c, in.r + in.c, "knuckle, corroded");
  }
}

bool is_bent_at_knuckle(const Input& in) { return End::has_knuckle(in) == Applies::yes; }

/// The thickness that crown and knuckle need if the radii and the stress factor are those of an end this thick.
Length needed(const Input& in, Stress f, Length e) {
  NoTrace off;
  Result r;
  radii(in, (e + in.c + in.c_t) / (1.0 - in.f_t), r, off);
  const Length crown = in.p * r.R_c / (2.0 * f * in.z - 0.5 * in.p);
  if (!is_bent_at_knuckle(in) || !(crown > 0.0 * mm)) return crown;
  const Torisphere end{r.R_c, r.r_c, r.D_c};
  const Length thinnest = 0.0005 * end.R;  // below the range of the factor
  const Length knuckle = knuckle_factor(end, max(e, thinnest), off) * in.p * end.scale() / f;
  if (!is_set(in.R_e)) return max(crown, knuckle);
  const Stress p_b = buckling_pressure(end, end.scale(), in.R_e, off);  // grows with the power 1.5 of the thickness
  return max(max(crown, knuckle), end.scale() * std::pow(in.p / p_b, 1.0 / 1.5));
}

Length least(const Input& in, Stress f) {
  if (!(2.0 * f * in.z > 0.5 * in.p)) return unset<Length>;
  const auto by_si = [&](double e) { return in_si(needed(in, f, from_si<Length>(e))); };
  return from_si<Length>(numerics::fixed_point(by_si, in_si(in.D_i)));
}

template <class Tracer>
void knuckle(const Input& in, Result& r, Tracer& trace) {
  const Torisphere end{r.R_c, r.r_c, r.D_c};
  r.beta = knuckle_factor(end, r.e, trace);
  STEP_TO(r, p_y, r.f * r.e / (r.beta * (0.75 * r.R_c + 0.2 * r.D_c)), "knuckle, yielding, [EN13445-3], 7.5.3");
  STEP_TO(r, u_y, in.p / r.p_y, "knuckle, yielding");
  r.p_max = min(r.p_max, r.p_y);
  if (is_set(in.R_e)) {
    r.p_b = buckling_pressure(end, r.e, in.R_e, trace);
    STEP_TO(r, u_b, in.p / r.p_b, "knuckle, plastic buckling");
    r.p_max = min(r.p_max, r.p_b);
  }
  STEP_TO(r, x_r, r.r_c / r.D_c, "knuckles of 0.06 to 0.2, [EN13445-3], 7.5.3");
  STEP_TO(r, x_k, r.r_c / r.e, "knuckles of two thicknesses at least, [EN13445-3], 7.5.3");
}

/// A short flange is held by the dish.
template <class Tracer>
void flange(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.l_f)) return;
  STEP(l_0, 0.2 * sqrt(r.D_c * r.e), "a longer flange counts as a cylinder, [EN13445-3], 7.5.3");
  if (in.l_f <= l_0) {
    r.u_f = trace.value("u_f", 0.0, "short: the dish holds it");
    return;
  }
  STEP(p_f, 2.0 * r.f * in.z * r.e / (r.D_c + r.e), "allowable pressure of the cylinder, [EN13445-3], 7.4.2");
  STEP_TO(r, u_f, in.p / p_f, "straight flange");
}

/// Crown, knuckle and flange of the thickness and radii of r, at the allowable stress r.f.
template <class Tracer>
void capacities(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, p_s, 2.0 * r.f * in.z * r.e / (r.R_c + 0.5 * r.e), "crown, [EN13445-3], 7.5.3");
  STEP_TO(r, u_s, in.p / r.p_s, "crown, membrane stress");
  r.p_max = r.p_s;
  if (is_bent_at_knuckle(in)) knuckle(in, r, trace);
  flange(in, r, trace);
}

/// The new end, not yet corroded, at its test pressure: the same formulas with the stress of the test.
template <class Tracer>
void hydrostatic_test(const Input& in, Length delta, Result& r, Tracer& trace) {
  if (!is_set(in.p_t)) return;
  NoTrace off;
  const Stress p_w = test_requirements(in, !(in.R_e / 1.5 > in.R_m / 2.4), r, trace);
  Input fresh = in;
  fresh.p = p_w, fresh.c = 0.0 * mm, fresh.R_e = 1.5 * r.f_test;  // the design stress of buckling is R_e/1.5
  Result n;
  n.f = r.f_test;
  n.e = delta * (1.0 - in.f_t) - in.c_t;
  radii(fresh, delta, n, off);
  capacities(fresh, n, off);
  double u = n.u_s;
  for (const double other : {n.u_y, n.u_b, n.u_f}) u = is_set(other) ? std::max(u, other) : u;
  r.u_t = trace.value("u_t", u, "crown, knuckle and flange of the new end at f_test, [EN13445-3], 7.5.3");
}

}  // namespace

template <class Tracer>
End::Result End::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.f = allowable_stress(in, trace);
  const Length delta_0 = trace.value("delta_0", least(in, r.f), "thickness that crown and knuckle need, by iteration");
  STEP_TO(r, delta_min, (delta_0 + in.c + in.c_t) / (1.0 - in.f_t), "with its allowances, each once");
  r.delta = is_set(in.delta) ? in.delta : r.delta_min;
  const Length delta = trace.value("delta", r.delta, "nominal");
  STEP_TO(r, e, delta * (1.0 - in.f_t) - in.c - in.c_t, "less corrosion and under-tolerance");
  radii(in, delta, r, trace);
  capacities(in, r, trace);
  STEP_TO(r, x_e, r.e / r.D_a, "ends of 0.001 to 0.08, [EN13445-3], 7.5.3");
  STEP_TO(r, x_R, (r.R_c - in.c) / r.D_a, "crowns no flatter than the diameter, [EN13445-3], 7.5.3");
  hydrostatic_test(in, delta, r, trace);
  return r;
}

template End::Result End::evaluate(const Input&, NoTrace&);
template End::Result End::evaluate(const Input&, Trace&);

namespace {

/// Middle of the carrying wall, from the pole to the end of the flange; heights from the lower edge of the dish.
std::vector<figure::Point> meridian(const Input& in, const Result& r) {
  constexpr int count = 90;
  std::vector<figure::Point> points;
  const double half = 0.5 * in_si(r.e), a = 0.5 * in_si(r.D_c) + half;
  if (is_bent_at_knuckle(in) && in.form != Form::ellipsoidal) {
    const double R = in_si(r.R_c) + half, k = in_si(r.r_c) + half;
    const double phi = std::asin((a - k) / (R - k)), below = (R - k) * std::cos(phi);
    for (int i = 0; i <= count; ++i)
      points.push_back({R * std::sin(phi * i / count), R * std::cos(phi * i / count) - below});
    for (int i = 1; i <= count; ++i) {
      const double theta = phi + (0.5 * pi - phi) * i / count;
      points.push_back({a - k + k * std::sin(theta), k * std::cos(theta)});
    }
  } else {
    const double b = in.form == Form::ellipsoidal ? in_si(r.D_c) / (2.0 * r.x_K) + half : a;
    for (int i = 0; i <= count; ++i)
      points.push_back({a * std::sin(0.5 * pi * i / count), b * std::cos(0.5 * pi * i / count)});
  }
  if (is_set(in.l_f) && in.l_f > 0.0 * mm) points.push_back({a, -in_si(in.l_f)});
  return points;
}

Section section_of(const Input& in, const Result& r) {
  Section s;
  s.middle = meridian(in, r);
  s.within = {0.0, 0.5 * s.middle.front().y};
  s.broken_end = true;
  s.radius = "D_i";
  const double inside = 0.5 * in_si(in.D_i), low = s.middle.back().y;
  s.dimensioned.lengths.push_back(
      {{-inside, low}, {inside, low}, {"D_i", 2.0 * inside, "mm"}, figure::Drawing::Side::below});
  return s;
}

}  // namespace

std::vector<figure::Figure> End::figures(const Input& in, const Result& r) {
  if (!is_set(r.u_s) || !std::isfinite(in_si(r.delta))) return {};
  WallInput wall;
  wall.p = in.p, wall.delta = r.delta, wall.c = in.c, wall.c_t = in.c_t, wall.f_t = in.f_t;
  wall.measured = Measured::inner;
  WallResult carrying;
  carrying.delta = r.delta, carrying.delta_c = r.e;
  return {section_figure(wall, carrying, section_of(in, r))};
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::End>();
