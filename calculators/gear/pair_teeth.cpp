// Thickness, backlash and base-tangent length of the teeth of a pair of gears.
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace {

/// The symbols under which the formulas of one wheel are told.
struct Symbols {
  const char *s_n, *s_an, *k_W, *W;
};
constexpr Symbols first{"s_n1", "s_an1", "k_W1", "W_1"}, second{"s_n2", "s_an2", "k_W2", "W_2"};

/// One wheel, or ring (g = -1), of the pair.
struct Wheel {
  double z, x;
  Length A_s, d, d_b, d_a;
  double g;
  Whole spanned;
};

template <class Tracer>
Length tip_thickness(const Pair::Input& in, const PairResult& r, const Wheel& w, Length s_n, const Symbols& name,
                     Tracer& trace) {
  const double beta = in.beta, alpha_t = r.alpha_t, g = w.g;
  const auto d = w.d, d_a = w.d_a, d_b = w.d_b;
  trace.value("d", d, "reference circle of the wheel");
  trace.value("d_a", d_a, "its tip circle");
  trace.value("d_b", d_b, "its base circle");
  trace.value("s_n", s_n, "its thickness");
  trace.value("g", g, "-1 for a ring");
  STEP(alpha_a, acos(d_b / d_a), "pressure angle at the tip");
  STEP(s_at, d_a * (s_n / (d * cos(beta)) + g * (tan(alpha_t) - alpha_t - tan(alpha_a) + alpha_a)),
       "transverse thickness at the tip, [ISO21771]");
  return NAMED_STEP(name.s_an, s_at * cos(atan(tan(beta) * d_a / d)), "normal thickness at the tip");
}

/// Over as many teeth as touch near the circle d + 2 x m_n.
template <class Tracer>
double spanned_teeth(const Pair::Input& in, const PairResult& r, const Wheel& w, Tracer&) {
  if (w.spanned > 0) return w.spanned;
  const double tan_b = std::tan(in.beta) * std::cos(r.alpha_t);  // of the helix at the base cylinder
  const double ratio_v = w.d_b / (w.d + 2.0 * w.x * in.m_n);
  const double tan_v = ratio_v < 1.0 ? std::sqrt(1.0 / (ratio_v * ratio_v) - 1.0) : 0.0;
  const double inv_t = std::tan(r.alpha_t) - r.alpha_t;
  const double k = w.z / pi * (tan_v * (1.0 + tan_b * tan_b) - 2.0 * w.x / w.z * std::tan(in.alpha_n) - inv_t) + 0.5;
  return std::clamp(std::round(k), 2.0, std::max(2.0, w.z - 1.0));
}

template <class Tracer>
Length base_tangent(const Pair::Input& in, const PairResult& r, const Wheel& w, double k_W, const Symbols& name,
                    Tracer& trace) {
  const auto m_n = in.m_n;
  const auto A_s = w.A_s;
  const double alpha_n = in.alpha_n, alpha_t = r.alpha_t, z = w.z, x = w.x;
  trace.value(name.k_W, k_W, w.spanned > 0 ? "teeth spanned, as given" : "teeth spanned, contact near d + 2 x m_n");
  trace.value("k_W", k_W, "teeth spanned");
  trace.value("z", z, "teeth of the wheel");
  trace.value("x", x, "its profile shift");
  trace.value("A_s", A_s, "its allowance");
  return NAMED_STEP(name.W,
                    m_n * cos(alpha_n) * (pi * (k_W - 0.5) + z * (tan(alpha_t) - alpha_t)) +
                        2.0 * x * m_n * sin(alpha_n) + A_s * cos(alpha_n),
                    "base-tangent length, [ISO21771]");
}

}  // namespace

template <class Tracer>
void measure_teeth(const Pair::Input& in, PairResult& r, Tracer& trace) {
  const auto m_n = in.m_n, A_s1 = in.A_s1, A_s2 = in.A_s2;
  const double alpha_n = in.alpha_n, x_1 = in.x_1, x_2 = r.x_2, x_0 = r.x_0, h_aP = in.h_aP;
  const bool both_shifts_given = is_set(in.a_w) && (is_set(in.x_2) || in.mesh == Mesh::rack);
  STEP(s_n1, m_n * (pi / 2.0 + 2.0 * x_1 * tan(alpha_n)) + A_s1, "normal thickness at the reference circle");
  const Wheel one{in.z_1, x_1, A_s1, r.d_1, r.d_b1, r.d_a1, 1.0, in.k_W1};
  const Length s_an1 = r.s_an1 = tip_thickness(in, r, one, s_n1, first, trace);
  r.k_W1 = spanned_teeth(in, r, one, trace);
  r.W_1 = base_tangent(in, r, one, r.k_W1, first, trace);
  r.s_n1 = s_n1;
  if (in.mesh == Mesh::rack) {
    STEP(s_an2, m_n * (pi / 2.0 - 2.0 * h_aP * tan(alpha_n)), "tip of the rack");
    STEP(s_a, min(s_an1, s_an2) / m_n, "the thinner tip, in modules");
    r.s_an2 = s_an2, r.s_a = s_a;
  } else {
    STEP(s_n2, m_n * (pi / 2.0 + 2.0 * x_2 * tan(alpha_n)) + A_s2, "normal thickness at the reference circle");
    const Wheel two{in.z_2, x_2, A_s2, r.d_2, r.d_b2, r.d_a2, sign_of(in.mesh), in.k_W2};
    const Length s_an2 = r.s_an2 = tip_thickness(in, r, two, s_n2, second, trace);
    STEP(s_a, min(s_an1, s_an2) / m_n, "the thinner tip, in modules");
    r.s_n2 = s_n2, r.s_a = s_a;
    if (in.mesh == Mesh::external) {
      r.k_W2 = spanned_teeth(in, r, two, trace);
      r.W_2 = base_tangent(in, r, two, r.k_W2, second, trace);
    }
  }
  if (!both_shifts_given) {
    STEP(j_bn, -cos(alpha_n) * (A_s1 + A_s2), "backlash from the allowances alone");
    r.j_bn = j_bn;
    return;
  }
  const double x_sum = in.mesh == Mesh::rack ? x_1 : x_1 + x_2;
  trace.value("x_sum", x_sum, "sum of the profile shifts");
  STEP(j_bn, 2.0 * m_n * sin(alpha_n) * (x_0 - x_sum) - cos(alpha_n) * (A_s1 + A_s2),
       "backlash along the normal: from the centre distance and the allowances");
  r.j_bn = j_bn;
}

template void measure_teeth(const Pair::Input&, PairResult&, NoTrace&);
template void measure_teeth(const Pair::Input&, PairResult&, Trace&);

}  // namespace loadpath::gear
