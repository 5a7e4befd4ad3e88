// Thickness, backlash and base-tangent length of the teeth of a pair of gears.
#pragma once

#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace teeth {

/// The symbols in the formulas of one gear.
struct Symbols {
  const char *s_n, *s_an, *k_W, *W;
};
inline constexpr Symbols first{"s_n1", "s_an1", "k_W1", "W_1"}, second{"s_n2", "s_an2", "k_W2", "W_2"};

/// One wheel, or ring (g = -1), of the pair.
struct Wheel {
  double z, x;
  Length A_s, d, d_b, d_a;
  double g;
  Whole spanned;
};

template <class Tracer>
Length tip_thickness(const PairInput& in, const PairResult& r, const Wheel& w, Length s_n, const Symbols& name,
                     Tracer& trace) {
  trace.value("d", w.d, "reference circle of the wheel");
  trace.value("d_a", w.d_a, "its tip circle");
  trace.value("d_b", w.d_b, "its base circle");
  trace.value("s_n", s_n, "its thickness");
  trace.value("g", w.g, "-1 for a ring");
  STEP(alpha_a, acos(w.d_b / w.d_a), "pressure angle at the tip");
  STEP(s_at, w.d_a * (s_n / (w.d * cos(in.beta)) + w.g * (tan(r.alpha_t) - r.alpha_t - tan(alpha_a) + alpha_a)),
       "transverse thickness at the tip, [ISO21771]");
  return NAMED_STEP(name.s_an, s_at * cos(atan(tan(in.beta) * w.d_a / w.d)), "normal thickness at the tip");
}

/// Over as many teeth as touch near the circle d + 2 x m_n.
template <class Tracer>
double spanned_teeth(const PairInput& in, const PairResult& r, const Wheel& w, Tracer&) {
  if (w.spanned > 0) return w.spanned;
  const double tan_b = tan(in.beta) * cos(r.alpha_t);  // tangent of the helix angle at the base cylinder
  const double ratio_v = w.d_b / (w.d + 2.0 * w.x * in.m_n);
  const double tan_v = ratio_v < 1.0 ? std::sqrt(1.0 / (ratio_v * ratio_v) - 1.0) : 0.0;
  const double inv_t = tan(r.alpha_t) - r.alpha_t;
  const double k = w.z / pi * (tan_v * (1.0 + tan_b * tan_b) - 2.0 * w.x / w.z * tan(in.alpha_n) - inv_t) + 0.5;
  const double rounded = std::round(k), most = w.z - 1.0;
  return rounded < 2.0 ? 2.0 : (rounded > most ? most : rounded);
}

template <class Tracer>
Length base_tangent(const PairInput& in, const PairResult& r, const Wheel& w, double k_W, const Symbols& name,
                    Tracer& trace) {
  trace.value(name.k_W, k_W, w.spanned > 0 ? "teeth spanned, as given" : "teeth spanned, contact near d + 2 x m_n");
  trace.value("k_W", k_W, "teeth spanned");
  trace.value("z", w.z, "teeth of the wheel");
  trace.value("x", w.x, "its profile shift");
  trace.value("A_s", w.A_s, "its allowance");
  return NAMED_STEP(name.W,
                    in.m_n * cos(in.alpha_n) * (pi * (k_W - 0.5) + w.z * (tan(r.alpha_t) - r.alpha_t)) +
                        2.0 * w.x * in.m_n * sin(in.alpha_n) + w.A_s * cos(in.alpha_n),
                    "base-tangent length, [ISO21771]");
}

/// Whether the jaws of a gauge find both flanks: the base tangent of a helical tooth leans along the helix, by the
/// angle that the helix has at the base cylinder.
inline bool is_wide_enough(const PairInput& in, const PairResult& r, Length W) {
  return !is_set(r.b) || r.b > W * (sin(in.beta) * cos(in.alpha_n));
}

/// Base-tangent length and the teeth that it spans; none where the face is too narrow to measure it.
struct Span {
  double k_W = unset<double>;
  Length W = unset<Length>;
};

template <class Tracer>
Span span(const PairInput& in, const PairResult& r, const Wheel& w, const Symbols& name, Tracer& trace) {
  NoTrace quiet;
  const double k = spanned_teeth(in, r, w, trace);
  if (!is_wide_enough(in, r, base_tangent(in, r, w, k, name, quiet))) return {};
  return {k, base_tangent(in, r, w, k, name, trace)};
}

}  // namespace teeth

/// Thickness at the reference circle and at the tip, backlash, base-tangent length.
template <class Tracer>
void measure_teeth(const PairInput& in, PairResult& r, Tracer& trace) {
  using namespace teeth;
  const bool both_shifts_given = is_set(in.a_w) && (is_set(in.x_2) || in.mesh == Mesh::rack);
  STEP_TO(r, s_n1, in.m_n * (pi / 2.0 + 2.0 * in.x_1 * tan(in.alpha_n)) + in.A_s1,
          "normal thickness at the reference circle");
  const Wheel one{in.z_1, in.x_1, in.A_s1, r.d_1, r.d_b1, r.d_a1, 1.0, in.k_W1};
  const Length s_an1 = r.s_an1 = tip_thickness(in, r, one, s_n1, first, trace);
  const Span over_one = span(in, r, one, first, trace);
  r.k_W1 = over_one.k_W, r.W_1 = over_one.W;
  if (in.mesh == Mesh::rack) {
    STEP_TO(r, s_an2, in.m_n * (pi / 2.0 - 2.0 * in.h_aP * tan(in.alpha_n)), "tip of the rack");
    STEP_TO(r, s_a, min(s_an1, s_an2) / in.m_n, "the thinner tip, in modules");
  } else {
    STEP_TO(r, s_n2, in.m_n * (pi / 2.0 + 2.0 * r.x_2 * tan(in.alpha_n)) + in.A_s2,
            "normal thickness at the reference circle");
    const Wheel two{in.z_2, r.x_2, in.A_s2, r.d_2, r.d_b2, r.d_a2, sign_of(in.mesh), in.k_W2};
    const Length s_an2 = r.s_an2 = tip_thickness(in, r, two, s_n2, second, trace);
    STEP_TO(r, s_a, min(s_an1, s_an2) / in.m_n, "the thinner tip, in modules");
    if (in.mesh == Mesh::external) {
      const Span over_two = span(in, r, two, second, trace);
      r.k_W2 = over_two.k_W, r.W_2 = over_two.W;
    }
  }
  if (!both_shifts_given) {
    STEP_TO(r, j_bn, -cos(in.alpha_n) * (in.A_s1 + in.A_s2), "backlash from the allowances only");
    return;
  }
  STEP(x_sum, in.mesh == Mesh::rack ? in.x_1 : in.x_1 + r.x_2, "sum of the profile shifts");
  STEP_TO(r, j_bn, 2.0 * in.m_n * sin(in.alpha_n) * (r.x_0 - x_sum) - cos(in.alpha_n) * (in.A_s1 + in.A_s2),
          "backlash along the normal: from the centre distance and the allowances");
}

}  // namespace loadpath::gear
