// Part 2 of DIN 743: the notch factor beta of a section, by its shape factor alpha and the support of the stress
// gradient, or as it was measured on bars of d_BK. Two keyways count 1.15 times one in bending; that they do in torsion
// as well is how the program does it that was seen, and recalled of no text.
#pragma once

#include "calculators/fatigue/din743/section.hpp"
#include "calculators/fatigue/size_and_surface.hpp"

#include <array>

namespace loadpath::fatigue {

/// Arguments of the notch functions in addition to the section.
struct Din743Root {
  Length t = unset<Length>;  // depth
  double phi = unset<double>;
  Stress sigma_Bd = unset<Stress>, sigma_Sd = unset<Stress>;
  double K_F = unset<double>, K_FB = unset<double>;  // roughness of the part, and of the bars that beta is of
};

/// alpha = 1 + 1/sqrt(A r/t + 2 B (r/d)(1 + 2 r/d)^2 + C (r/t)^z d/D).
struct ShapeLaw {
  double A, B, C, z;
};

/// By kind of stress, tables 2 and 3 of part 2.
constexpr ShapeLaw shape_law(Notch notch, Stressing kind) {
  constexpr std::array<ShapeLaw, 3> shoulder{{{0.62, 3.5, 0.0, 0.0}, {0.62, 5.8, 0.2, 3.0}, {3.4, 19.0, 1.0, 2.0}}};
  constexpr std::array<ShapeLaw, 3> groove{{{0.22, 1.37, 0.0, 0.0}, {0.2, 2.75, 0.0, 0.0}, {0.7, 10.3, 0.0, 0.0}}};
  return (notch == Notch::shoulder ? shoulder : groove)[static_cast<std::size_t>(kind)];
}

template <class Tracer>
double shape_factor(const Din743Section& s, Stressing kind, Length depth, Tracer& trace) {
  using loadpath::pow;
  using std::pow;
  const ShapeLaw law = shape_law(s.notch, kind);
  const Length t = depth;
  const double A = trace.value("A", law.A, "of shape and load, [DIN743] part 2 tables 2, 3");
  const double B = trace.value("B", law.B, "of shape and load, [DIN743] part 2 tables 2, 3");
  if (law.C == 0.0)
    return NAMED_STEP("alpha", 1.0 + 1.0 / sqrt(A * s.r / t + 2.0 * B * s.r / s.d * pow<2>(1.0 + 2.0 * s.r / s.d)),
                      "shape factor on the net section, [DIN743] part 2 tables 2, 3");
  const double C = trace.value("C", law.C, "of shape and load, [DIN743] part 2 tables 2, 3");
  const double z = trace.value("z", law.z, "of shape and load, [DIN743] part 2 tables 2, 3");
  return NAMED_STEP("alpha",
                    1.0 + 1.0 / sqrt(A * s.r / t + 2.0 * B * s.r / s.d * pow<2>(1.0 + 2.0 * s.r / s.d) +
                                     C * pow(s.r / t, z) * s.d / s.D),
                    "shape factor on the net section, [DIN743] part 2 tables 2, 3");
}

/// A hole across: its factors belong to the net section.
template <class Tracer>
double hole_factor(const Din743Section& s, Stressing kind, Tracer& trace) {
  STEP(q, 2.0 * s.r / s.d, "hole over shaft");
  if (kind == Stressing::tension) return NAMED_STEP("alpha", 3.0 - q, "net section, [DIN743] part 2 section 5.2.3");
  if (kind == Stressing::bending)
    return NAMED_STEP("alpha", 3.0 + 1.4 * q - 2.8 * sqrt(q), "net section, [DIN743] part 2 section 5.2.3");
  return NAMED_STEP("alpha", 2.023 - 1.125 * sqrt(q), "net section, [DIN743] part 2 section 5.2.3");
}

/// The related stress gradient, tables 2 and 3 of part 2.
template <class Tracer>
Twist gradient(const Din743Section& s, Stressing kind, double phi, Tracer& trace) {
  if (s.notch == Notch::cross_hole) {
    if (kind == Stressing::tension) return NAMED_STEP("G", 2.3 / s.r, "stress gradient, [DIN743] part 2 tables 2, 3");
    if (kind == Stressing::bending)
      return NAMED_STEP("G", 2.3 / s.r + 2.0 / s.d, "stress gradient, [DIN743] part 2 tables 2, 3");
    return NAMED_STEP("G", 1.15 / s.r + 2.0 / s.d, "stress gradient, [DIN743] part 2 tables 2, 3");
  }
  const double own = s.notch == Notch::shoulder ? 1.15 : 1.0;
  if (kind == Stressing::torsion) {
    const double c_G = trace.value("c_G", own, "of the shape, [DIN743] part 2 tables 2, 3");
    return NAMED_STEP("G", c_G / s.r, "stress gradient in torsion, [DIN743] part 2 tables 2, 3");
  }
  const double c_G = trace.value("c_G", 2.0 * own, "of the shape, [DIN743] part 2 tables 2, 3");
  return NAMED_STEP("G", c_G * (1.0 + phi) / s.r, "stress gradient, [DIN743] part 2 tables 2, 3");
}

/// alpha over the support that its gradient gives.
template <class Tracer>
void by_shape(const Din743Section& s, const Din743Root& root, Stressing kind, Din743Stress& k, Tracer& trace) {
  using std::pow;
  k.alpha = s.notch == Notch::cross_hole ? hole_factor(s, kind, trace) : shape_factor(s, kind, root.t, trace);
  const Twist G = gradient(s, kind, root.phi, trace);
  const double alpha = k.alpha;
  const Stress sigma_Sd = root.sigma_Sd;
  const double e_n = s.layer == Layer::hard
                         ? trace.value("e_n", 0.7, "hard surface layer, [DIN743] part 2 section 4.3")
                         : NAMED_STEP("e_n", 0.33 + sigma_Sd / (712.0 * MPa), "[DIN743] part 2 section 4.3");
  STEP(n_G, 1.0 + sqrt(G * (1.0 * mm)) * pow(10.0, -e_n),
       "support of the gradient, G in 1/mm, [DIN743] part 2 section 4.3");
  STEP_TO(k, n, min(n_G, alpha), "a notch does not strengthen: beta is 1 or more");
  STEP_TO(k, beta, alpha / n, "notch factor, [DIN743] part 2 section 4.3");
}

/// K_3 of a diameter, with the notch factor that was measured at d_BK.
template <class Tracer>
double size_of_notch(const char* symbol, Length d_n, double beta_n, Tracer& trace) {
  const Length d_K = trace.value("d_K", d_n, "diameter that K_3 is of");
  const double beta_BK = beta_n;
  if (d_K >= 150.0 * mm)
    return NAMED_STEP(symbol, 1.0 - 0.2 * log(beta_BK) / log(10.0), "150 mm and more, [DIN743] part 2 (17)");
  return NAMED_STEP(symbol, 1.0 - 0.2 * log(beta_BK) / log(10.0) * log(d_K / (7.5 * mm)) / log(20.0),
                    "size of a notch, [DIN743] part 2 (17)");
}

template <class Tracer>
double measured_with_hub(const Din743Section& s, Stressing kind, Stress sigma_Bd, Tracer& trace) {
  using std::pow;
  if (s.notch == Notch::press_fit) {
    STEP(beta_1, 2.7 * pow(sigma_Bd / (1000.0 * MPa), 0.43), "press fit in bending, 40 mm, [DIN743] part 2 table 1");
    if (kind != Stressing::torsion) return NAMED_STEP("beta_BK", beta_1, "tension and bending alike");
    return NAMED_STEP("beta_BK", 0.65 * beta_1, "press fit in torsion, [DIN743] part 2 table 1");
  }
  STEP(beta_1, 3.0 * pow(sigma_Bd / (1000.0 * MPa), 0.38), "one keyway in bending, 40 mm, [DIN743] part 2 table 1");
  const double k_2 = trace.value("k_2", s.notch == Notch::two_keyways ? 1.15 : 1.0,
                                 "1.15 for two keyways, [DIN743] part 2 table 1; torsion not checked");
  if (kind == Stressing::torsion)
    return NAMED_STEP("beta_BK", k_2 * (0.56 * beta_1 + 0.1), "keyway in torsion, [DIN743] part 2 table 1");
  return NAMED_STEP("beta_BK", k_2 * beta_1, "keyway, [DIN743] part 2 table 1");
}

template <class Tracer>
double measured_v_groove(Stressing kind, Stress sigma_Bd, Tracer& trace) {
  if (kind == Stressing::tension)
    return NAMED_STEP("beta_BK", 0.109 * sigma_Bd / (100.0 * MPa) + 1.074, "15 mm, [DIN743] part 2 section 4.2.3");
  STEP(beta_1, 0.0923 * sigma_Bd / (100.0 * MPa) + 0.985, "in bending, 15 mm, [DIN743] part 2 section 4.2.3");
  if (kind == Stressing::bending) return NAMED_STEP("beta_BK", beta_1, "bending");
  return NAMED_STEP("beta_BK", 0.8 * beta_1, "V-groove in torsion, [DIN743] part 2 section 4.2.3");
}

template <class Tracer>
double measured_rectangular_groove(const Din743Section& s, Stressing kind, const Din743Root& root, Tracer& trace) {
  using std::pow;
  const Length t = root.t;
  const Stress sigma_Sd = root.sigma_Sd;
  const bool torsion = kind == Stressing::torsion;
  STEP(rho, pow(10.0, -(0.514 + 0.00152 * sigma_Sd / (1.0 * MPa))) * mm, "radius of structure, [DIN743] part 2 4.2.4");
  const double k_rho = trace.value("k_rho", torsion ? 1.0 : 2.9, "of the load, [DIN743] part 2 section 4.2.4");
  STEP(r_f, s.r + k_rho * rho, "effective radius, [DIN743] part 2 section 4.2.4");
  const double beta_1 =
      torsion ? NAMED_STEP("beta_1", 1.48 + 0.45 * sqrt(t / r_f), "torsion, [DIN743] part 2 section 4.2.4")
      : kind == Stressing::bending
          ? NAMED_STEP("beta_1", 0.9 * (1.14 + 1.08 * sqrt(t / r_f)), "bending, [DIN743] part 2 section 4.2.4")
          : NAMED_STEP("beta_1", 0.9 * (1.27 + 1.17 * sqrt(t / r_f)), "tension, [DIN743] part 2 section 4.2.4");
  STEP(k_w, s.w >= 1.4 * t ? 1.0 : 1.08 * pow(s.w / t, -0.2), "a narrow groove, [DIN743] part 2 section 4.2.4");
  const double beta_top = trace.value("beta_top", torsion ? 2.5 : 4.0, "no more was measured, 30 mm");
  return NAMED_STEP("beta_BK", min(k_w * beta_1, beta_top), "rectangular groove, [DIN743] part 2 section 4.2.4");
}

/// The diameter of the bars that the notch factors of tests belong to.
inline Length diameter_of_tests(const Din743Section& s) {
  switch (s.notch) {
    case Notch::v_groove:
      return 15.0 * mm;
    case Notch::rectangular_groove:
      return 30.0 * mm;
    case Notch::beta:
      return s.d_BK;
    default:
      return 40.0 * mm;
  }
}

/// As measured on bars of d_BK, at the diameter of the section.
template <class Tracer>
void by_tests(const Din743Section& s, const Din743Root& root, Stressing kind, Din743Stress& k, Tracer& trace) {
  const bool of_hub = is_keyed(s.notch) || s.notch == Notch::press_fit;
  const double beta_BK = of_hub                       ? measured_with_hub(s, kind, root.sigma_Bd, trace)
                         : s.notch == Notch::v_groove ? measured_v_groove(kind, root.sigma_Bd, trace)
                         : s.notch == Notch::beta
                             ? trace.value("beta_BK", typed_of(kind, s.beta_zd, s.beta_b, s.beta_t), "as given")
                             : measured_rectangular_groove(s, kind, root, trace);
  const Length tested = diameter_of_tests(s);
  if (!is_set(tested)) {
    STEP_TO(k, beta, beta_BK, "of a bar of this diameter");
    return;
  }
  const double K_3B = size_of_notch("K_3B", tested, beta_BK, trace);
  const double K_3 = size_of_notch("K_3", s.d, beta_BK, trace);
  STEP_TO(k, beta, beta_BK * K_3B / K_3, "from the bars of the tests to this diameter, [DIN743] part 2 (3)");
}

template <class Tracer>
void notch_factor(const Din743Section& s, const Din743Root& root, Stressing kind, Din743Stress& k, Tracer& trace) {
  if (s.notch == Notch::untold) return;
  if (s.notch == Notch::smooth) {
    k.beta = trace.value("beta", 1.0, "no notch");
  } else if (s.notch == Notch::alpha) {
    k.alpha = trace.value("alpha", typed_of(kind, s.alpha_zd, s.alpha_b, s.alpha_t), "as given");
    k.beta = trace.value("beta", k.alpha, "alpha, without the support of a gradient: on the safe side");
  } else if (has_shape_factors(s.notch) || s.notch == Notch::cross_hole) {
    by_shape(s, root, kind, k, trace);
  } else {
    by_tests(s, root, kind, k, trace);
  }
}

}  // namespace loadpath::fatigue
