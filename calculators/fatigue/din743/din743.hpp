// The safety of one section of a shaft against fatigue and against yielding, by DIN 743.
//
// Decides, after [DIN743] parts 1 to 3, nominal stresses of tension, bending and torsion, what notch, size, roughness
// and surface treatment leave of the fatigue limit, how much the mean stress takes off it, and both safeties. Steel,
// not welded, -40 to 150 degC, stresses in phase, loads with their service factors in, 1e7 cycles and more. Tension
// is positive; in bending and torsion the sign is of no account, for a round section has a fibre of either sign.
// Not covered: part 4 (finite life, spectra), shear due to transverse forces, splines and undercuts (type their beta),
// notch factors of hollow shafts (type them), the cracking of a hard surface layer under the largest load. Recalled:
// that two keyways count 1.15 in torsion as they do in bending.
#pragma once

#include "calculators/fatigue/din743/bounds.hpp"
#include "calculators/fatigue/din743/fields.hpp"
#include "calculators/fatigue/din743/rules.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/steel.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"

#include <array>

namespace loadpath::fatigue {

struct Din743 {
  static constexpr auto id = "fatigue.din743";
  static constexpr auto title = "Shaft section to DIN 743";
  static constexpr auto scope =
      "Safety factors of one steel shaft section against fatigue fracture and yielding by DIN 743 parts 1 to "
      "3, from -40 to 150 °C, for a smooth section, shoulder, groove, keyway, press fit, cross hole or given "
      "notch factors; finite life and load spectra (part 4), transverse shear, welds, notch factors of hollow "
      "shafts and cracking of hardened layers are not covered.";
  static constexpr auto source = "[DIN743]";
  static constexpr auto headline = "S_D = {S_D}, S_F = {S_F}";
  static constexpr auto subject = "fatigue and yielding";
  static constexpr auto synonyms =
      "DIN 743, shaft fatigue, safety factor, notch factor, keyway, shoulder, groove, press fit, "
      "Tragfähigkeit von Wellen, Sicherheitsnachweis, Dauerfestigkeit, Kerbwirkungszahl, Welle, "
      "расчёт вала на выносливость, запас прочности";
  static constexpr auto example = R"([project]
title = "Shoulder of a gear shaft"

[shoulder]
calculator = "fatigue.din743"
group = "quenched-tempered"
sigma_B = "1100 MPa"
sigma_S = "900 MPa"
d_h = "60 mm"
notch = "shoulder"
d = "42 mm"
D = "50 mm"
r = "2.5 mm"
R_z = "6.3 um"
mean = "proportional"
M_ba = "800 N*m"
M_tm = "900 N*m"
M_ta = "150 N*m"
f_max = 1.8
)";

  struct Input : Din743Steel, Din743Section, SectionActions {
    Stress E = unset<Stress>;
    double S_min = 1.2;
    MeanStress mean = MeanStress::proportional;
  };
  static constexpr Fields loads{
      Choice<Input, MeanStress>{&Input::mean, "mean",
                                "overload case: constant mean stress (case 1) or constant ratio (case 2)"},
      Field<Input, double>{&Input::S_min, "S_min", ratio,
                           "required safety, 1.2 by the standard, more where loads or "
                           "consequences are not known"}
          .at_least(1.2)
          .usually(1.2, 5)
          .customarily_at_least(1.2)
          .factor()};
  static constexpr Fields inputs = join(din743_steel<Input>(), Fields{modulus_of_material<Input>(&Input::E)},
                                        din743_section<Input>(), section_actions<Input>(), loads);

  struct Result : Din743Safety {
    double x_E = unset<double>;
  };
  static constexpr Fields results = join(din743_results<Result>(), Fields{modulus_over_steel<Result>(&Result::x_E)});

  static constexpr auto rules = din743_rules<Input>();
  static constexpr std::array meanings{
      Meaning{"sigma_bW", specimen_in_bending},      Meaning{"sigma_zdW", specimen_in_tension},
      Meaning{"tau_tW", specimen_in_torsion},        Meaning{"sigma_bm, sigma_zdm, M_bm", steady_part},
      Meaning{"M_tm, tau_tm, F_zdm", paired_middle}, Meaning{"M_ta, tau_ta, F_zda", paired_amplitude}};
  static constexpr auto bounds = notch_bounds<Input>();
  static constexpr std::array modes{
      Mode<Input>{"fatigue", "fatigue fracture, constant amplitude", &any_varies<Input>}.judged_by(
          "u_D, x_m, x_small, x_eff, x_Rz, x_r, x_D, x_alpha, x_t, x_hole, x_bore, x_E"),
      Mode<Input>{"yield", "static strength at peak load", &always<Input>}.judged_by("u_F, x_E").wanting("f_max"),
      Mode<Input>{"layer", "cracking of the hardened layer",
                  [](const Input& in) { return where(in.layer == Layer::hard); }},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"shear", "transverse shear and buckling", &unseen<Input>}.special(),
      Mode<Input>{"surroundings", "corrosion, fretting, temperature and welds", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::fatigue
