// The pulleys of a V-belt drive, room for its adjustment, its life, and the limits of its basis.
#pragma once

#include "calculators/belt/v/types.hpp"

namespace loadpath::belt {

/// 0 at the lower end of a range, 1 at the upper one. `zero` is a value that rounding moved next to an end.
template <class Quantity>
double place_in(Quantity value, Quantity low, Quantity high) {
  const double x = (in_si(value) - in_si(low)) / (in_si(high) - in_si(low));
  if (std::abs(x) < 1e-9) return 0.0;
  return std::abs(x - 1.0) < 1e-9 ? 1.0 : x;
}

/// The validity of the rating.
template <class Tracer>
void limit_rating(const VSection& section, Length d_k, AngularSpeed n_k, VTypes::Result& r, Tracer& trace) {
  const VRow& row = section.row;
  const bool iso = section.basis == Basis::iso;
  r.x_dmin = trace.value("x_dmin", row.d_low / d_k, "minimum diameter of the section / smaller pulley");
  r.x_d = trace.value("x_d", place_in(d_k, row.d_low, row.d_high), "position of the smaller pulley in the rated range");
  r.x_n = trace.value("x_n", place_in(n_k, row.n_low, row.n_high), "position of its speed in the rated range");
  if (!section.lengths.empty()) r.x_L = place_in(r.L, section.lengths.front().L, section.lengths.back().L);
  trace.value("x_L", r.x_L, "position of the length in the list");
  const double alpha_least =
      trace.value("alpha_least", iso ? pi / 2.0 : least_optibelt_wrap(),
                  iso ? "minimum wrap, [GOST1284.3] 3.3.5" : "minimum wrap of the table, [Optibelt-V] 16");
  STEP_TO(r, x_alpha, r.alpha / alpha_least, "smaller wrap angle / minimum wrap angle");
  const auto v_max = trace.value("v_max", row.v_max, "maximum speed of the section");
  STEP_TO(r, x_v, r.v / v_max, "speed / maximum speed");
}

/// Whether pulleys and belts are those of a list, and as many as share a load.
template <class Tracer>
void buy(const VSection& section, const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  r.off_d = trace.value("off_d", (is_sold_pulley(in.d_1) ? 0.0 : 1.0) + (is_sold_pulley(in.d_2) ? 0.0 : 1.0),
                        "number of non-standard pulleys");
  if (is_set(in.L)) r.off_L = trace.value("off_L", is_sold_belt(section, in.L) ? 0.0 : 1.0, "1: no list has this belt");
  if (r.z == 0) return;
  STEP_TO(r, x_z, r.z / 16.0,
          "more belts hardly share the load, and such pulleys are not in stock; not checked against a source");
}

/// The factor of the mean life for the kind of load, [GOST1284.2] annex 3.
inline double life_factor(VTypes::Duty duty) {
  switch (duty) {
    case VTypes::Duty::light:
      return 2.5;
    case VTypes::Duty::medium:
      return 1.0;
    case VTypes::Duty::heavy:
      return 0.5;
    case VTypes::Duty::very_heavy:
      return 0.25;
    default:
      return unset<double>;
  }
}

/// Only what the basis states.
template <class Tracer>
void live(const VSection& section, const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  if (section.basis == Basis::optibelt) {
    r.L_h = trace.value("L_h", section.row.L_h, "life for which the ratings are stated, [Optibelt-V]");
    return;
  }
  if (in.duty == VTypes::Duty::unstated) return;
  STEP(L_medium, in.belt_class == VTypes::BeltClass::IV ? 3700.0 * hour : 2700.0 * hour,
       "mean life under a medium load, [GOST1284.2] annex 3");
  const double K_1 = trace.value("K_1", life_factor(in.duty), "for the kind of load, [GOST1284.2] annex 3");
  STEP_TO(r, L_h, K_1 * L_medium, "mean life, temperate climate");
}

template <class Tracer>
void turn_rims(const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  STEP_TO(r, v_rim, max(in.n_1 * r.d_a1, r.n_2 * r.d_a2) / 2.0, "larger rim speed of the two pulleys");
  STEP_TO(r, u_rim, v_rim / in.v_rim_adm, "rim condition");
}

/// Sizes of the pulleys, as far as they do not depend on the number of belts, and the room for adjustment.
template <class Tracer>
void build_pulleys(const VSection& section, const VTypes::Input& in, VTypes::Result& r, Tracer& trace) {
  const VRow& row = section.row;
  r.phi_1 = in.d_1 <= row.d_phi ? row.phi_1 : row.phi_2;
  r.phi_2 = in.d_2 <= row.d_phi ? row.phi_1 : row.phi_2;
  trace.angle("phi_1", r.phi_1, "groove angle of the driving pulley, [GOST1284.2] annex 5");
  trace.angle("phi_2", r.phi_2, "groove angle of the driven pulley, [GOST1284.2] annex 5");
  trace.value("h_a", row.h_a, "groove above the datum diameter");
  STEP_TO(r, d_a1, in.d_1 + 2.0 * row.h_a, "driving pulley, outside");
  STEP_TO(r, d_a2, in.d_2 + 2.0 * row.h_a, "driven pulley, outside");
  turn_rims(in, r, trace);
  trace.value("w_d", row.w_d, "datum width of the groove");
  STEP_TO(r, Delta_1, 0.020 * r.L, "room for tensioning, [GOST1284.3] (11)");
  STEP_TO(r, Delta_2, 0.009 * r.L + 2.0 * row.w_d, "room for fitting, [GOST1284.3] (12)");
  STEP_TO(r, g_r, r.a - (r.d_a1 + r.d_a2) / 2.0, "between the rims");
  STEP_TO(r, g_f, g_r - Delta_2, "left when the pulleys are moved together for fitting");
  STEP_TO(r, f_B, 2.0 * r.v / r.L, "two bends per belt revolution");
  trace.value("f_B_max", row.f_B_max, "maximum bending frequency of the section");
  STEP_TO(r, u_B, f_B / row.f_B_max, "bending frequency condition");
  live(section, in, r, trace);
  if (r.z == 0) return;
  trace.value("e", row.e, "pitch of the grooves");
  trace.value("f", row.f, "from the last groove to the edge");
  STEP_TO(r, B, (r.z - 1.0) * row.e + 2.0 * row.f, "pulley face width");
}

}  // namespace loadpath::belt
