#include "calculators/belt/synchronous.hpp"

#include "calculators/belt/figures.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>

namespace loadpath::belt {

namespace {

constexpr double last_bits = 1e-9;

Length pitch_diameter(Whole z, Length p_b) { return z * p_b / pi; }

/// The pulleys of a belt of z_B teeth, or with the centre distance a.
Pulleys toothed_pulleys(const Synchronous::Input& in, double z_B) {
  return {pitch_diameter(in.z_1, in.p_b), pitch_diameter(in.z_2, in.p_b), is_set(in.a) ? in.a : unset<Length>,
          z_B > 0.0 ? z_B * in.p_b : unset<Length>};
}

/// The centre distance at which the pitch circles touch.
Length least_centre(const Synchronous::Input& in) {
  return (pitch_diameter(in.z_1, in.p_b) + pitch_diameter(in.z_2, in.p_b)) / 2.0;
}

/// Belt teeth at a centre distance, not rounded: two spans and the arcs.
double teeth_at(const Synchronous::Input& in, Length a) {
  NoTrace quiet;
  Synchronous::Result r;
  Pulleys pulleys = toothed_pulleys(in, 0.0);
  pulleys.a = a;
  lay(pulleys, r, quiet);
  return in_si(r.L) / in_si(in.p_b);
}

/// The minimum number of belt teeth with which the pulleys have clearance.
double least_teeth(const Synchronous::Input& in) {
  return std::floor(teeth_at(in, least_centre(in)) + last_bits) + 1.0;
}

template <class Tracer>
void turn_pulleys(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "ratio of the teeth, without slip");
  STEP_TO(r, n_2, in.n_1 / i, "speed of the driven pulley");
  STEP_TO(r, d_1, in.z_1 * in.p_b / pi, "pitch diameter, [Tsubaki-belts]");
  STEP_TO(r, d_2, in.z_2 * in.p_b / pi, "pitch diameter, [Tsubaki-belts]");
  STEP_TO(r, v, in.n_1 * d_1 / 2.0, "belt speed");
  STEP_TO(r, n_k, max(in.n_1, n_2), "the smaller pulley is the faster one");
}

template <class Tracer>
void lay_teeth(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  if (in.z_B > 0) {
    r.z_B = trace.value("z_B", in.z_B, "as given");
  } else {
    r.z_0 = trace.value("z_0", teeth_at(in, in.a), "two spans and the arcs at the required centre distance, exact");
    r.z_B = trace.value("z_B", std::max(std::round(r.z_0), least_teeth(in)), "the nearest integer");
  }
  STEP_TO(r, L, r.z_B * in.p_b, "pitch length of the belt");
  Pulleys pulleys = toothed_pulleys(in, r.z_B);
  pulleys.a = unset<Length>;
  lay(pulleys, r, trace);
  STEP_TO(r, g_x, r.a - (r.d_1 + r.d_2) / 2.0, "gap of the pitch circles");
  STEP_TO(r, g_f, g_x - in.p_b / 2.0, "two flanges, a quarter of the pitch beyond the pitch circle each, from memory");
  STEP_TO(r, f_B, 2.0 * r.v / L, "two bends per belt revolution");
}

/// Complete teeth in mesh, and the factor of the rating.
template <class Tracer>
void mesh(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  STEP(z_k, min(in.z_1, in.z_2), "teeth of the smaller pulley");
  STEP(alpha_k, min(r.alpha_1, r.alpha_2), "wrap of the smaller pulley");
  const double z_w = NAMED_STEP("z_w", z_k * alpha_k / (2.0 * pi), "teeth on this wrap, [Tsubaki-belts]");
  r.z_m = trace.value("z_m", std::floor(z_w + last_bits), "complete teeth in mesh");
  r.x_m = r.z_m;
  STEP_TO(r, k_z, r.z_m < 6.0 ? max(1.0 - 0.2 * (6.0 - r.z_m), 0.0) : 1.0,
          "full rating from six teeth in mesh, a fifth less for each tooth below, [RMA-IP24]");
}

/// Speed-up drives load the belt more: [Inventor-belts], by the ratio of the speeds.
double speed_up_addition(double n_2_n_1) {
  if (n_2_n_1 < 1.25) return 0.0;
  if (n_2_n_1 < 1.75) return 0.1;
  if (n_2_n_1 < 2.5) return 0.2;
  return n_2_n_1 < 3.5 ? 0.3 : 0.4;
}

template <class Tracer>
Power power_of(const Synchronous::Input& in, Tracer& trace) {
  if (is_set(in.P)) return in.P;
  return NAMED_STEP("P", in.T_1 * in.n_1, "power of the torque");
}

template <class Tracer>
void rate_teeth(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  r.c_i = trace.value("c_i", speed_up_addition(in.z_1 / in.z_2), "for the speed-up ratio n_2/n_1, [Inventor-belts]");
  STEP_TO(r, K_B, in.K_A + r.c_i, "total service factor");
  const Power P = power_of(in, trace);
  STEP_TO(r, P_B, K_B * P, "design power");
  STEP_TO(r, k_w, pow(in.b / in.b_0, 1.14), "wider belts carry more per width, [ISO5295]");
  STEP_TO(r, F_c, in.m_0 * in.b / in.b_0 * r.v * r.v, "centrifugal tension");
  STEP_TO(r, P_R, (r.k_z * k_w * in.F_a - F_c) * r.v, "power rating, [ISO5295]");
  if (P_R > from_si<Power>(0.0)) {
    STEP_TO(r, u_P, P_B / P_R, "power condition");
  }
}

template <class Tracer>
void toothed_tensions(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  STEP_TO(r, F_t, r.P_B / r.v, "force that the belt transmits");
  STEP_TO(r, S_1, in.k_1 * F_t + r.F_c, "tight span, with the tension factor, [Inventor-belts]");
  STEP_TO(r, S_2, S_1 - F_t, "slack span");
  STEP_TO(r, F_0, (S_1 + S_2) / 2.0, "on fixed centres the mean of the spans remains that of standstill");
  STEP_TO(r, R_0, 2.0 * F_0 * r.l_s / r.a, "two spans at standstill, along the line of centres");
  STEP(N_1, S_1 - r.F_c, "tight side tension less centrifugal tension");
  STEP(N_2, S_2 - r.F_c, "slack side tension less centrifugal tension");
  load_shaft(N_1, N_2, r.gamma, r, trace);
  hand_over(F_t * r.d_1 / 2.0, F_t * r.d_2 / 2.0, largest_pull(r, R_0), r.d_1, r.d_2, in.n_1, r);
}

/// The minimum number of teeth at a speed; above the speeds of the table its last value.
double least_pulley(const Synchronous::Input& in, AngularSpeed n_k) {
  if (n_k <= 900.0 * rpm) return in.z_900;
  if (n_k <= 1200.0 * rpm) return in.z_1200;
  return n_k <= 1800.0 * rpm ? in.z_1800 : in.z_3600;
}

/// Standard widths of a section begin here, from memory of ISO 5296; of inch pitches, by which sections are known.
Length least_standard_width(Length p_b) {
  struct Section {
    double p_b, b;  // mm
  };
  constexpr std::array sections{Section{5.08, 6.4}, Section{9.525, 12.7}, Section{12.7, 19.1}, Section{22.225, 50.8},
                                Section{31.75, 50.8}};
  for (const Section& section : sections) {
    if (std::abs(in_si(p_b) - section.p_b * 1e-3) < 1e-6) return section.b * mm;
  }
  return unset<Length>;
}

template <class Tracer>
void limit_width(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  const Length least = least_standard_width(in.p_b);
  if (!is_set(least)) return;
  r.b_s = trace.value("b_s", least, "smallest standard width of the section, ISO 5296, from memory");
  STEP_TO(r, x_w, r.b_s / in.b, "smallest standard / actual width");
}

template <class Tracer>
void limit_teeth(const Synchronous::Input& in, Synchronous::Result& r, Tracer& trace) {
  STEP_TO(r, x_b, in.b / in.b_0, "width / base width");
  limit_width(in, r, trace);
  if (is_set(in.v_max)) {
    STEP_TO(r, x_v, r.v / in.v_max, "speed / maximum speed");
  }
  if (is_set(in.n_max)) {
    STEP_TO(r, x_n, r.n_k / in.n_max, "speed of the smaller pulley / maximum of the table");
  }
  const double least = least_pulley(in, r.n_k);
  if (!is_set(least)) return;
  r.z_min = trace.value("z_min", least, "minimum number of teeth at the speed of the smaller pulley");
  STEP_TO(r, x_z, r.z_min / min(in.z_1, in.z_2), "minimum / actual number of teeth");
}

}  // namespace

/// A wider belt runs unevenly on pulleys that are not parallel; bound set by loadpath.
double Synchronous::most_width(const Input& in) { return in_si(pitch_diameter(std::min(in.z_1, in.z_2), in.p_b)); }

/// Sections by inch pitches are made in the widths of ISO 5296, as [Optibelt-ZR] lists them.
double Synchronous::standard_width(const Input& in) {
  constexpr std::array widths{6.4, 7.9, 9.5, 12.7, 19.1, 25.4, 38.1, 50.8, 76.2, 101.6, 127.0};  // mm
  constexpr double rounding = 1.005, mm_si = 1e-3;
  const double b = in_si(in.b);
  if (!is_set(least_standard_width(in.p_b)) || std::isnan(b)) return std::nan("");
  const auto next = std::ranges::upper_bound(widths, rounding * b / mm_si);
  if (next == widths.begin()) return std::nan("");  // narrower than all of them: x_w
  const double width = *std::prev(next) * mm_si;
  return b <= rounding * width ? b : width;
}

/// The sections of the table have 1.0 to 2.2 N/mm^2, other profiles up to some 4 N/mm^2, from memory.
double Synchronous::most_pull(const Input& in) { return in_si(5.0 * MPa * in.p_b * in.b_0); }

/// Pitches of curvilinear profiles only, which the rating does not cover: the next smaller trapezoidal pitch.
double Synchronous::trapezoidal_pitch(const Input& in) {
  struct Pitch {
    double curvilinear, trapezoidal;  // mm
  };
  for (const Pitch& pitch : {Pitch{3.0, 2.5}, Pitch{8.0, 5.08}, Pitch{14.0, 12.7}}) {
    if (std::abs(in_si(in.p_b) - pitch.curvilinear * 1e-3) < 1e-6) return pitch.trapezoidal * 1e-3;
  }
  return unset<double>;
}

/// The spans are inclined by 30 deg where the difference of the diameters is the centre distance.
double Synchronous::least_centre_distance(const Input& in) {
  return std::abs(in_si(pitch_diameter(in.z_2, in.p_b) - pitch_diameter(in.z_1, in.p_b)));
}
double Synchronous::least_belt_teeth(const Input& in) {
  const double a = in.z_B > 0 ? least_centre_distance(in) : unset<double>;
  return a > in_si(least_centre(in)) ? std::ceil(teeth_at(in, from_si<Length>(a)) - last_bits) : unset<double>;
}

bool Synchronous::pulleys_apart(const Input& in) { return !is_set(in.a) || !is_set(in.p_b) || in.a > least_centre(in); }
FieldFault Synchronous::pulleys_touch(const Input& in) { return overlap(toothed_pulleys(in, 0.0)); }

bool Synchronous::belt_reaches(const Input& in) { return in.z_B == 0 || !is_set(in.p_b) || in.z_B >= least_teeth(in); }
FieldFault Synchronous::too_few_teeth(const Input& in) {
  return {"z_B", say("{1} belt teeth are too few for these pulleys", std::to_string(static_cast<int>(in.z_B))),
          say("give at least {1}", std::to_string(static_cast<int>(least_teeth(in))))};
}

template <class Tracer>
Synchronous::Result Synchronous::evaluate(const Input& in, Tracer& trace) {
  Result r;
  turn_pulleys(in, r, trace);
  lay_teeth(in, r, trace);
  mesh(in, r, trace);
  if (!is_set(in.b)) return r;  // a search finds it
  rate_teeth(in, r, trace);
  toothed_tensions(in, r, trace);
  limit_teeth(in, r, trace);
  return r;
}

template Synchronous::Result Synchronous::evaluate(const Input&, NoTrace&);
template Synchronous::Result Synchronous::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Synchronous::figures(const Input& in, const Result& r) {
  if (!is_set(r.a)) return {};
  TwoWheels w;
  w.d_1 = in_si(r.d_1), w.d_2 = in_si(r.d_2), w.a = in_si(r.a);
  w.alpha_1 = r.alpha_1, w.alpha_2 = r.alpha_2;
  w.n_1 = in_si(in.n_1), w.n_2 = in_si(r.n_2);
  Pulls pulls;
  pulls.tight = in_si(r.S_1), pulls.slack = in_si(r.S_2);
  pulls.R = in_si(r.R), pulls.R_x = in_si(r.R_x), pulls.R_y = in_si(r.R_y);
  return {drive_figure(w, pulls)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Synchronous>();
