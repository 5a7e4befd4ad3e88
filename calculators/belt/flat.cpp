#include "calculators/belt/flat.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/initial_tension.hpp"
#include "calculators/belt/quarter_turn.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <cmath>

namespace loadpath::belt {

namespace {

using Tensioning = Flat::Tensioning;

/// Standard diameters of flat pulleys, which are preferred numbers.
std::span<const Length> flat_pulleys() {
  static const auto pulleys = [] {
    std::vector<Length> all;
    if (const auto series = table::find_series("R20")) {
      for (const double d : table::members_in_si(**series)) all.push_back(from_si<Length>(d));
    }
    return all;
  }();
  return pulleys;
}

Pulleys pulleys_of(const Flat::Input& in) {
  return {in.d_1, with_driven_pulley(in, flat_pulleys()).d_2, in.a, in.L, in.arrangement};
}

template <class Tracer>
void move(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.d_2 / in.d_1 / (1.0 - in.epsilon), "transmission ratio with slip, [B40]");
  STEP_TO(r, n_2, in.n_1 / i, "speed of the driven pulley");
  STEP_TO(r, v, in.n_1 * in.d_1 / 2.0, "belt speed");
}

template <class Tracer>
void pull(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  if (is_set(in.T_1)) {
    STEP_TO(r, F_t, 2.0 * in.K_A * in.T_1 / in.d_1, "force that the belt carries over");
  } else {
    STEP_TO(r, F_t, in.K_A * in.P / r.v, "force that the belt carries over");
  }
  STEP_TO(r, m_e, exp(in.mu * min(r.alpha_1, r.alpha_2)),
          "Euler's condition at the smaller wrap, [B40]; tight over slack");
}

/// The stress that is left for pulling, and the least width.
template <class Tracer>
void size(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP_TO(r, sigma_b, is_set(in.E_b) ? in.E_b * in.delta / min(in.d_1, in.d_2) : 0.0 * MPa,
          is_set(in.E_b) ? "bending around the smaller pulley" : "the allowable stress applies to the given pulleys");
  STEP_TO(r, sigma_c, in.rho * r.v * r.v, "centrifugal stress");
  STEP_TO(r, sigma_N, in.sigma_adm - sigma_b - sigma_c, "left for pulling");
  if (is_set(in.E_b)) {
    STEP_TO(r, u_b, sigma_b / in.sigma_adm, "bending only");
  }
  if (!(sigma_N > from_si<Stress>(0.0))) return;
  STEP_TO(r, v_opt, sqrt((in.sigma_adm - sigma_b) / (3.0 * in.rho)), "maximum power where F_t v has its maximum");
  STEP_TO(r, b_min, r.F_t / (in.delta * sigma_N * (1.0 - 1.0 / r.m_e)),
          "stress and friction both at their limit, [Shigley-17]");
}

/// Lever arms of the spans about the pivot of the motor base. Reversed rotation exchanges the spans, and so the arms.
template <class Tracer>
void lever_arms(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP(s_P, in.h_P / abs(in.h_P), "side of the pivot: 1 with the tight span, -1 with the slack span");
  STEP(x_P, is_set(in.x_P) ? in.x_P : 0.0 * mm, is_set(in.x_P) ? "as given" : "below or above the motor axis");
  STEP(e_P, in.d_1 / 2.0 + x_P * (in.arrangement == Arrangement::crossed ? -sin(r.gamma) : sin(r.gamma)),
       "half the difference of the lever arms");
  STEP_TO(r, a_1, abs(in.h_P) * cos(r.gamma) - s_P * e_P, "distance of the tight span from the pivot");
  STEP_TO(r, a_2, abs(in.h_P) * cos(r.gamma) + s_P * e_P, "distance of the slack span from the pivot");
  STEP_TO(r, k_S, (a_2 - a_1) / (a_1 + a_2), "positive: the reaction torque tensions the belt");
}

/// Tensions on a pivoted base: (S_1 - F_c) a_1 + (S_2 - F_c) a_2 = m_m g a_G, [Hibbeler-8-104].
template <class Tracer>
void balance_moments(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP(g, 9.81 * m_per_s2, "gravity");
  STEP_TO(r, S_0_min, max(0.0 * N, r.F_t / (r.m_e - 1.0) * (r.m_e * r.a_1 + r.a_2) / (r.a_1 + r.a_2)),
          "moments about the pivot at the friction limit");
  STEP_TO(r, S_0, in.m_m * g * in.a_G / (r.a_1 + r.a_2), "moments about the pivot at standstill, [Hibbeler-8-104]");
  STEP_TO(r, m_min, in.m_m * S_0_min / S_0, "mass at the friction limit");
  STEP_TO(r, S_1, S_0 + r.F_c + r.F_t * r.a_2 / (r.a_1 + r.a_2), "tight span, by moments about the pivot");
  STEP_TO(r, S_2, S_1 - r.F_t, "slack span");
  STEP_TO(r, u_S, S_0_min / S_0, "friction condition");
  if (in.rotation != Flat::Rotation::both) return;
  STEP_TO(r, S_0r, max(0.0 * N, r.F_t / (r.m_e - 1.0) * (r.m_e * r.a_2 + r.a_1) / (r.a_1 + r.a_2)),
          "at the friction limit, the lever arms exchanged");
  STEP_TO(r, S_1r, S_0 + r.F_c + r.F_t * r.a_1 / (r.a_1 + r.a_2), "tight span, the lever arms exchanged");
  STEP_TO(r, u_Sr, S_0r / S_0, "friction condition, reversed rotation");
}

/// The tensions in operation, and the friction that they use.
template <class Tracer>
void tighten(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP_TO(r, x_b, r.b / min(in.d_1, in.d_2), "no belt is much wider than its smaller pulley");
  STEP_TO(r, F_c, in.rho * r.b * in.delta * r.v * r.v, "centrifugal tension; it does not load the pulleys");
  if (Flat::on_pivot(in)) {
    lever_arms(in, r, trace);
    balance_moments(in, r, trace);
  } else {
    tension_spans(r.F_t, in.S_0, in.tensioning == Tensioning::fixed, r, trace);
  }
  if (r.S_2 > F_c) {
    STEP_TO(r, mu_req, log((r.S_1 - F_c) / (r.S_2 - F_c)) / min(r.alpha_1, r.alpha_2),
            "friction that is used, [Shigley-17]");
  }
}

template <class Tracer>
Force tight_side(const Flat::Result& r, Tracer& trace) {
  if (!is_set(r.S_1r)) return NAMED_STEP("N_1", r.S_1 - r.F_c, "tight side tension less centrifugal tension");
  return NAMED_STEP("N_1", max(r.S_1, r.S_1r) - r.F_c,
                    "tight side tension less centrifugal tension, larger of both directions");
}

/// Shaft loads of the spans, in the direction of rotation with the larger tensions.
template <class Tracer>
void load(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const Force N_1 = tight_side(r, trace);
  STEP(N_2, N_1 - r.F_t, "slack side tension less centrifugal tension");
  const Moment T_1 = r.F_t * in.d_1 / 2.0, T_2 = r.F_t * in.d_2 / 2.0;
  if (in.arrangement == Arrangement::quarter_turn) {
    load_crossed_shafts(N_1, N_2, r, trace);
    return hand_over_crossed(T_1, T_2, N_1, N_2, in.d_1, in.d_2, in.n_1, r);
  }
  STEP_TO(r, R_0, 2.0 * r.S_0 * r.l_s / r.a, "two spans at standstill, along the line of centres");
  load_shaft(N_1, N_2, in.arrangement == Arrangement::crossed ? -r.gamma : r.gamma, r, trace);
  hand_over(T_1, T_2, largest_pull(r, r.R_0), in.d_1, in.d_2, in.n_1, r);
}

template <class Tracer>
void judge(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  if (is_set(r.S_1r)) {
    STEP_TO(r, sigma_max, max(r.S_1, r.S_1r) / (r.b * in.delta) + r.sigma_b, "tight span, larger of both directions");
  } else {
    STEP_TO(r, sigma_max, r.S_1 / (r.b * in.delta) + r.sigma_b, "tight span at the smaller pulley");
  }
  STEP_TO(r, u_sigma, r.sigma_max / in.sigma_adm, "strength condition");
  load(in, r, trace);
  constexpr double widest_face = 1.28;  // times the belt width: pulleys of DIN 111, recalled
  r.shaft_1.b_r = r.shaft_2.b_r = widest_face * r.b;
  STEP_TO(r, f_B, 2.0 * r.v / r.L, "two bends per belt revolution");
}

/// The life by the S-N curve of the belt. Each pulley bends it once a revolution; both bends count with the stress of
/// the smaller one.
template <class Tracer>
void belt_life(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  if (!is_set(in.sigma_f)) return;
  STEP_TO(r, N_B, in.N_f * pow(in.sigma_f / r.sigma_max, in.m_f), "S-N curve of the belt, [Shigley-17-3]");
  STEP_TO(r, L_h, N_B / r.f_B, "two bends per belt revolution, both with the maximum stress");
  if (!is_set(in.L_req)) return;
  STEP_TO(r, u_L, in.L_req / L_h, "life condition");
}

/// Room between the pulleys, and for the spans of a crossed belt, two of which pass there.
template <class Tracer>
void leave_room(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  STEP_TO(r, g_x, r.a - (in.d_1 + in.d_2) / 2.0 - 2.0 * in.delta, "gap of the pulleys less two thicknesses");
}
template <class Tracer>
void cross(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  if (in.arrangement == Arrangement::crossed) {
    STEP_TO(r, x_a, 20.0 * r.b / r.a,
            "spans of a crossed belt twist freely from 20 widths on, not checked against the source");
  }
  if (in.arrangement == Arrangement::quarter_turn) {
    STEP_TO(r, x_q, 2.0 * (in.d_1 + in.d_2) / r.a, "minimum centre distance for the delivery angle, [Firgelli]");
    STEP_TO(r, x_t, 8.0 * r.b / r.a, "minimum span for a quarter turn of the belt, [Firgelli]");
  }
}

template <class Tracer>
void limit_speed(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const bool synthetic = in.kind == Flat::Kind::synthetic;
  STEP(v_max, in.kind == Flat::Kind::synthetic ? 100.0 * m_per_s : 30.0 * m_per_s,
       synthetic ? "maximum speed of a synthetic belt, [B40]" : "maximum speed, [B40]");
  STEP_TO(r, x_v, r.v / v_max, "speed / maximum speed");
  r.v_range = r.v;
}

}  // namespace

bool Flat::clear_of_each_other(const Input& in) {
  const bool open = !is_set(in.d_2) && !is_set(in.n_2_set) && !is_set(in.i_set);
  return open || is_set(in.a) == is_set(in.L) || stand_clear(pulleys_of(in));  // other rules speak of d_2, a and L
}
bool Flat::is_thin(const Input& in) {
  const Length d_2 = pulleys_of(in).d_2;
  return in.delta < 0.5 * (is_set(d_2) ? min(in.d_1, d_2) : in.d_1);
}
/// The fatigue strength at 1e7 bends is of the order of the allowable stress; on the S-N curve of m_f at N_f.
double Flat::most_fatigue_strength(const Input& in) {
  constexpr double at_best = 2.0, bends = 1e7;
  return at_best * in_si(in.sigma_adm) * std::pow(bends / in.N_f, 1.0 / in.m_f);
}
FieldFault Flat::touching(const Input& in) { return overlap(pulleys_of(in)); }

namespace {

/// Results of a drive whose pulleys are known.
template <class Tracer>
Flat::Result drive(const Flat::Input& in, Tracer& trace) {
  Flat::Result r;
  r.d_2 = in.d_2;
  move(in, r, trace);
  if (in.arrangement == Arrangement::quarter_turn) {
    lay_quarter_turn(pulleys_of(in), r, trace);
  } else {
    lay(pulleys_of(in), r, trace);
  }
  limit_speed(in, r, trace);
  leave_room(in, r, trace);
  pull(in, r, trace);
  size(in, r, trace);
  r.b = is_set(in.b) ? in.b : r.b_min;
  cross(in, r, trace);
  tighten(in, r, trace);
  judge(in, r, trace);
  belt_life(in, r, trace);
  return r;
}

}  // namespace

template <class Tracer>
Flat::Result Flat::evaluate(const Input& in, Tracer& trace) {
  if (is_set(in.d_2)) return drive(in, trace);
  const Input whole = with_driven_pulley(in, flat_pulleys(), trace);
  Result r = drive(whole, trace);
  compare_ratio(in, r, trace);
  return r;
}

template Flat::Result Flat::evaluate(const Input&, NoTrace&);
template Flat::Result Flat::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Flat::figures(const Input& in, const Result& r) {
  if (in.arrangement == Arrangement::quarter_turn) return {};  // its pulleys lie in two planes
  TwoWheels w;
  w.d_1 = in_si(in.d_1), w.d_2 = in_si(r.d_2), w.a = in_si(r.a);
  w.crossed = in.arrangement == Arrangement::crossed;
  w.alpha_1 = r.alpha_1, w.alpha_2 = r.alpha_2;
  w.n_1 = in_si(in.n_1), w.n_2 = in_si(r.n_2);
  Pulls pulls;
  pulls.tight = in_si(r.S_1), pulls.slack = in_si(r.S_2);
  pulls.R = in_si(r.R), pulls.R_x = in_si(r.R_x), pulls.R_y = in_si(r.R_y);
  return {drive_figure(w, pulls)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Flat>();
