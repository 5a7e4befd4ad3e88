// Marin's factors after Shigley: what surface, size, load, temperature and reliability leave of a fatigue limit.
#pragma once

#include "calculators/fatigue/endurance_types.hpp"
#include "lib/numerics/quantile.hpp"

#include <cmath>

namespace loadpath::fatigue {

struct MarinSurface {
  double a, b;  // a in MPa
};

/// Table 6-2 of [Shigley6].
inline MarinSurface surface_of_9th(EnduranceTypes::Finish finish) {
  using F = EnduranceTypes::Finish;
  switch (finish) {
    case F::ground:
      return {1.58, -0.085};
    case F::machined:
      return {4.51, -0.265};
    case F::hot_rolled:
      return {57.7, -0.718};
    case F::forged:
      return {272.0, -0.995};
  }
  return {unset<double>, unset<double>};
}

/// The same of the 11th edition.
inline MarinSurface surface_of_11th(EnduranceTypes::Finish finish) {
  using F = EnduranceTypes::Finish;
  switch (finish) {
    case F::ground:
      return {1.38, -0.067};
    case F::machined:
      return {3.04, -0.217};
    case F::hot_rolled:
      return {38.6, -0.650};
    case F::forged:
      return {54.9, -0.758};
  }
  return {unset<double>, unset<double>};
}

template <class Tracer>
double marin_surface(const EnduranceTypes::Input& in, Tracer& trace) {
  using std::pow;
  if (is_set(in.k_a)) return trace.value("k_a", in.k_a, "surface, as given");
  const bool ninth = in.edition == EnduranceTypes::Edition::ninth;
  const auto [a, b] = ninth ? surface_of_9th(in.finish) : surface_of_11th(in.finish);
  const char* const why = ninth ? "for this finish, [Shigley6] table 6-2"
                                : "for this finish, 11th edition: ground as in [Shigley-SM6], the others not checked";
  trace.value("a", a, why);
  trace.value("b", b, why);
  STEP(k_s, a * pow(in.R_m / MPa, b), "surface, [Shigley6] (6-19)");
  return NAMED_STEP("k_a", min(k_s, 1.0), "capped at 1 (polished surface)");
}

/// A stationary part has only two highly stressed sides in bending: it is as strong as a thinner rotating bar.
template <class Tracer>
Length marin_diameter(const EnduranceTypes::Input& in, Tracer& trace) {
  const bool bends = in.loading == EnduranceTypes::Loading::bending;
  if (is_set(in.h)) return NAMED_STEP("d_e", 0.808 * sqrt(in.h * in.b), "non-rotating rectangle, [Shigley6] table 6-3");
  if (in.turning == EnduranceTypes::Turning::standing && bends)
    return NAMED_STEP("d_e", 0.370 * in.d, "non-rotating round bar, [Shigley6] (6-24)");
  return in.d;
}

template <class Tracer>
double marin_size(const EnduranceTypes::Input& in, EnduranceTypes::Result& r, Tracer& trace) {
  using std::pow;
  if (is_set(in.k_b)) return trace.value("k_b", in.k_b, "size, as given");
  const bool sized = is_set(in.d) || is_set(in.h);
  if (is_set(in.k_b)) {
    if (sized) r.x_d = 0.0;
    return trace.value("k_b", in.k_b, "given");
  }
  if (!sized || in.loading == EnduranceTypes::Loading::tension) {
    if (sized) r.x_d = 0.0;
    return NAMED_STEP("k_b", 1.0, "no size effect: tension, or no d given, [Shigley6]");
  }
  const Length d = marin_diameter(in, trace);
  if (d != in.d) r.d_e = trace.value("d", d, "of the bar that turns");
  STEP_TO(r, x_d, log(d / (2.79 * mm)) / log(254.0 / 2.79), "d from 2.79 to 254 mm on a logarithmic scale, [Shigley6]");
  if (d > 51.0 * mm) return NAMED_STEP("k_b", 1.51 * pow(d / mm, -0.157), "51 to 254 mm, [Shigley6] (6-20)");
  return NAMED_STEP("k_b", 1.24 * pow(d / mm, -0.107), "2.79 to 51 mm, [Shigley6] (6-20)");
}

/// Steels by the polynomial that [Shigley6] fits to tensile strengths, in degrees Fahrenheit.
template <class Tracer>
double marin_heat(const EnduranceTypes::Input& in, EnduranceTypes::Result& r, Tracer& trace) {
  if (!is_set(in.T)) return trace.value("k_d", 1.0, "no T given: R_m is that of the temperature of the part");
  STEP(T_F, in.T / kelvin * 1.8 - 459.67, "temperature in degF, in which the fit is published");
  STEP_TO(r, x_T, (T_F - 68.0) / (1000.0 - 68.0), "20 degC to 1000 degF, [Shigley6] (6-27)");
  if (T_F <= 70.0) return NAMED_STEP("k_d", 1.0, "room temperature, [Shigley6] table 6-4");
  return NAMED_STEP("k_d",
                    0.975 + 0.432e-3 * T_F - 0.115e-5 * pow<2>(T_F) + 0.104e-8 * pow<3>(T_F) - 0.595e-12 * pow<4>(T_F),
                    "tensile strength of steels over that of room temperature, [Shigley6] (6-27)");
}

template <class Tracer>
double marin_reliability(const EnduranceTypes::Input& in, Tracer& trace) {
  if (!is_set(in.P_s)) return trace.value("k_e", 1.0, "no P_s given: one half of the parts");
  const double z_a = trace.value("z_a", numerics::normal_quantile(in.P_s), "standard normal deviate of P_s");
  return NAMED_STEP("k_e", 1.0 - 0.08 * z_a, "fatigue limits scatter by 8 %, [Shigley6] (6-29)");
}

/// The full K_D including load, temperature or reliability.
template <class Tracer>
double marin_service(const EnduranceTypes::Input& in, EnduranceTypes::Result& r, Tracer& trace) {
  r.k_c = is_set(in.k_c) ? trace.value("k_c", in.k_c, "load: sigma_W was measured in rotating bending")
                         : trace.value("k_c", 1.0, "sigma_m1 is that of this loading already");
  r.k_d = marin_heat(in, r, trace);
  r.k_e = marin_reliability(in, trace);
  return NAMED_STEP("K_D", r.K_f / (r.k_a * r.k_b * r.k_c * r.k_d * r.k_e), "shape and all factors together");
}

}  // namespace loadpath::fatigue
