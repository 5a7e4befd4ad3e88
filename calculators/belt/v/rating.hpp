// Power rating of one V-belt on its basis, and the required number of belts.
#pragma once

#include "calculators/belt/v/types.hpp"

#include <cmath>

namespace loadpath::belt {

/// The increments of a row at the four ratios that the basis lists, kW per 1000/min.
struct Increments {
  double k_1, k_2, k_3, k_4;
};

template <class Tracer>
Increments increments(const VRow& row, double x_d_k, Tracer& trace) {
  STEP(lg_d, log(x_d_k) / log(10.0), "decimal logarithm of the diameter in mm");
  return {row.a_1 + row.b_1 * lg_d, row.a_2 + row.b_2 * lg_d, row.a_3 + row.b_3 * lg_d, row.a_4 + row.b_4 * lg_d};
}

/// ISO 5292 as in [GOST1284.3] 3.5.2: linear between the ratios 1, 1.05, 1.20, 1.50 and 3.00.
inline double iso_increment(const Increments& k, double i_g) {
  if (i_g <= 1.05) return k.k_1 * (i_g - 1.0) / 0.05;
  if (i_g <= 1.2) return k.k_1 + (k.k_2 - k.k_1) * (i_g - 1.05) / 0.15;
  if (i_g <= 1.5) return k.k_2 + (k.k_3 - k.k_2) * (i_g - 1.2) / 0.3;
  return i_g < 3.0 ? k.k_3 + (k.k_4 - k.k_3) * (i_g - 1.5) / 1.5 : k.k_4;
}

/// [Optibelt-V]: steps at the ratios 1.01, 1.06, 1.27 and above 1.57.
inline double optibelt_increment(const Increments& k, double i_g) {
  if (i_g > 1.57) return k.k_4;
  if (i_g >= 1.27) return k.k_3;
  if (i_g >= 1.06) return k.k_2;
  return i_g >= 1.01 ? k.k_1 : 0.0;
}

/// Rated power of one belt on the smaller pulley d_k at its speed n_k, with the increment for the ratio i_g >= 1.
template <class Tracer>
void rate(const VSection& section, Length d_k, AngularSpeed n_k, double i_g, VTypes::Result& r, Tracer& trace) {
  const bool iso = section.basis == Basis::iso;
  const char* const fitted = iso ? "fitted to [GOST1284.3] 12 to 17" : "fitted to the power tables of [Optibelt-V]";
  const double C_1 = trace.value("C_1", section.row.C_1, fitted);
  const double C_2 = trace.value("C_2", section.row.C_2, fitted);
  const double C_3 = trace.value("C_3", section.row.C_3, fitted);
  const double C_4 = trace.value("C_4", section.row.C_4, fitted);
  STEP(x_d_k, d_k / mm, "smaller pulley in mm");
  STEP(r_n, n_k / (1000.0 * rpm), "its speed in 1000/min");
  STEP_TO(
      r, P_0,
      1000.0 * W * r_n * x_d_k * (C_1 - C_2 / x_d_k - C_3 * pow<2>(r_n * x_d_k) - C_4 * log(r_n * x_d_k) / log(10.0)),
      "rated power, closed form of the tables of the basis");
  const Increments k = increments(section.row, x_d_k, trace);
  const double k_i =
      trace.value("k_i", iso ? iso_increment(k, i_g) : optibelt_increment(k, i_g),
                  iso ? "increment for the ratio, linear between 1, 1.05, 1.20, 1.50, 3.00, [GOST1284.3] 3.5.2"
                      : "increment for the ratio, in steps, [Optibelt-V]");
  STEP_TO(r, dP, 1000.0 * W * k_i * r_n, "increment for the speed ratio: less bending around the larger pulley");
  STEP_TO(r, P_N, P_0 + dP, "rated power of one belt");
}

/// The arc-of-contact factor of the basis at the smaller wrap.
template <class Tracer>
double wrap_factor(Basis basis, double alpha, Tracer& trace) {
  if (basis == Basis::iso)
    return NAMED_STEP("c_alpha", 1.25 * (1.0 - exp(-alpha / pi * log(5.0))),
                      "arc-of-contact factor: closed form of [GOST1284.3] 18");
  return trace.value("c_alpha", optibelt_wrap_factor(alpha),
                     "arc-of-contact factor, interpolated from [Optibelt-V] 16");
}

/// The least number of belts whose shares carry z_0 belts' rating; 0 where no number up to 100 does.
inline Whole belts_needed(Basis basis, double z_0, bool high_end) {
  for (int z = 1; z <= 100; ++z) {
    const double share = basis == Basis::iso ? v_count_factor(z, high_end) : 1.0;
    if (z * share >= z_0 * (1.0 - 1e-9)) return z;
  }
  return 0;
}

template <class Tracer>
void count(const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  if (!(r.P_N > from_si<Power>(0.0)) || !is_set(r.c_alpha) || !is_set(r.c_L)) return;
  STEP_TO(r, z_0, r.P_B / (r.P_N * r.c_alpha * r.c_L), "number of belts before the belt-number factor");
  const bool iso = in.basis == Basis::iso, high_end = in.C_K_end == VTypes::End::high;
  r.z = in.z > 0 ? in.z : belts_needed(in.basis, z_0, high_end);
  if (r.z == 0) return;
  trace.value("z", r.z, in.z > 0 ? "as given" : "smallest number of belts that transmits the design power");
  r.C_K = trace.value(
      "C_K", iso ? v_count_factor(r.z, high_end) : 1.0,
      iso ? "belts share unevenly, [GOST1284.3] 20" : "no factor for the number of belts in this method, [Optibelt-V]");
  STEP_TO(r, P_all, r.z * r.C_K * r.P_N * r.c_alpha * r.c_L, "power rating of the belts");
  STEP_TO(r, u_P, r.P_B / P_all, "power condition");
}

}  // namespace loadpath::belt
