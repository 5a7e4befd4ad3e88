// Nominal stresses of a section for DIN 743: of what acts there over the net section, or as they are given.
#pragma once

#include "calculators/fatigue/din743/section.hpp"

namespace loadpath::fatigue {

/// Section of a bar with a transverse hole of radius r, which removes a strip.
template <class Tracer>
Area net_area_at_hole(const char* symbol, Length d, Length r, Tracer& trace) {
  return NAMED_STEP(symbol, pi * pow<2>(d) / 4.0 - 2.0 * r * d, "net area, [DIN743] part 2 section 5.2.3");
}
template <class Tracer>
SectionModulus net_modulus_at_hole(const char* symbol, double c, Length d, Length r, Tracer& trace) {
  const double c_W = trace.value("c_W", c, "bending 32, torsion 16");
  return NAMED_STEP(symbol, pi * pow<3>(d) / c_W - r * pow<2>(d) / 3.0, "net modulus, [DIN743] part 2 section 5.2.3");
}

/// Moduli of the net section.
template <class Tracer>
Area net_area(const Din743Section& s, Tracer& trace) {
  if (s.notch == Notch::cross_hole) return net_area_at_hole("Z", s.d, s.r, trace);
  return NAMED_STEP("Z", pi * (pow<2>(s.d) - pow<2>(s.d_bore)) / 4.0, "area of the section");
}

template <class Tracer>
SectionModulus net_modulus(const Din743Section& s, Stressing kind, Tracer& trace) {
  const double c = kind == Stressing::torsion ? 16.0 : 32.0;
  if (s.notch == Notch::cross_hole) return net_modulus_at_hole("Z", c, s.d, s.r, trace);
  const double c_W = trace.value("c_W", c, "bending 32, torsion 16");
  return NAMED_STEP("Z", pi * (pow<4>(s.d) - pow<4>(s.d_bore)) / (c_W * s.d), "modulus of the section");
}

template <class Quantity>
Quantity or_zero(Quantity q) {
  return is_set(q) ? q : 0.0 * q.from_value(1.0);
}

/// The maximum stress, if given.
template <class Tracer>
void largest(Stress stated, double f, Din743Stress& k, Tracer& trace) {
  if (is_set(stated)) {
    k.sigma_max = trace.value("sigma_max", abs(stated), "maximum stress, as given");
  } else if (is_set(f)) {
    const double f_max = f;
    const Stress sigma_m = k.sigma_m, sigma_a = k.sigma_a;
    STEP_TO(k, sigma_max, f_max * (abs(sigma_m) + sigma_a), "peak load / maximum of each cycle");
  }
}

/// Nominal stresses: L, a force or a moment, over Z, the area or the modulus of the net section.
template <class Quantity, class Modulus, class Tracer>
void from_action(const Din743Action<Quantity>& action, const Modulus& Z, double f, bool signless, Din743Stress& k,
                 Tracer& trace) {
  const auto L_m = trace.value("L_m", or_zero(action.mean), "mean force or moment");
  const auto L_a = trace.value("L_a", or_zero(action.amplitude), "its amplitude");
  k.sigma_m = signless ? NAMED_STEP("sigma_m", abs(L_m) / Z, "mean stress: there is a fibre of either sign")
                       : NAMED_STEP("sigma_m", L_m / Z, "mean stress, tension positive");
  STEP_TO(k, sigma_a, L_a / Z, "amplitude of the nominal stress");
  if (is_set(action.largest)) {
    const auto L_max = trace.value("L_max", action.largest, "maximum force or moment");
    STEP_TO(k, sigma_max, abs(L_max) / Z, "maximum nominal stress");
  } else {
    largest(unset<Stress>, f, k, trace);
  }
}

template <class Tracer>
void from_stresses(const Din743Action<Stress>& action, double f, bool signless, Din743Stress& k, Tracer& trace) {
  const Stress mean = or_zero(action.mean);
  k.sigma_m = trace.value("sigma_m", signless ? abs(mean) : mean, "mean stress, as given");
  k.sigma_a = trace.value("sigma_a", or_zero(action.amplitude), "amplitude, as given");
  largest(action.largest, f, k, trace);
}

/// A kind of stress that acts.
struct Din743Acting {
  Stressing kind;
  Name name;
};
inline List<Din743Acting, 3> acting(const Din743Loads& loads) {
  List<Din743Acting, 3> all;
  if (loads.F_zd.acts() || loads.sigma_zd.acts()) all.push_back({Stressing::tension, "tension"});
  if (loads.M_b.acts() || loads.sigma_b.acts()) all.push_back({Stressing::bending, "bending"});
  if (loads.M_t.acts() || loads.tau_t.acts()) all.push_back({Stressing::torsion, "torsion"});
  return all;
}

template <class Tracer>
void nominal_stresses(const Din743Section& s, const Din743Loads& loads, Stressing kind, Din743Stress& k,
                      Tracer& trace) {
  const double f = loads.f_max;
  if (kind == Stressing::tension) {
    if (loads.sigma_zd.acts()) return from_stresses(loads.sigma_zd, f, false, k, trace);
    return from_action(loads.F_zd, net_area(s, trace), f, false, k, trace);
  }
  const bool bending = kind == Stressing::bending;
  const auto& stress = bending ? loads.sigma_b : loads.tau_t;
  if (stress.acts()) return from_stresses(stress, f, true, k, trace);
  from_action(bending ? loads.M_b : loads.M_t, net_modulus(s, kind, trace), f, true, k, trace);
}

}  // namespace loadpath::fatigue
