// The utilisation of one section of a shaft or rod in fatigue and under the largest load, by FKM, factor by factor.
//
// Decides, after [FKM] chapters 1 and 2, nominal stresses of tension, bending and torsion, what size, anisotropy,
// notch with its support, roughness and surface treatment leave of the fatigue limit, how the mean stress counts in
// the four fields and four overload types, what a finite life adds (k = 5, in torsion 8, knee 1e6), and the plastic
// support of the section. Steel, not welded, up to 100 degC (fine grain 60), stresses in phase, one amplitude.
// Tension is positive; in bending and torsion the sign has no effect. Not covered: spectra, local stresses, castings,
// coatings, shear due to transverse forces, the crack of a hard layer. Guideline not read: numbers are those of
// programs and pages that quote it; recalled are size constants of the yield strength, one mean stress for all, both
// supports in bending, slopes and knee of finite life, q, plastic support by strain, 250 mm, 1050 MPa.
#pragma once

#include "calculators/fatigue/din743/bounds.hpp"
#include "calculators/fatigue/fkm/fields.hpp"
#include "calculators/fatigue/fkm/rules.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/steel.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::fatigue {

struct Fkm {
  static constexpr auto id = "fatigue.fkm";
  static constexpr auto title = "Shaft or rod section to FKM";
  static constexpr auto scope =
      "Static and fatigue utilisation of one non-welded steel shaft or rod section by the FKM guideline with "
      "nominal stresses, overload cases F1 to F4 and finite life, for a smooth section, shoulder, groove, "
      "keyway, press fit, cross hole or given factors; load spectra, local stresses, castings, welds, elevated "
      "temperature, transverse shear and cracking of hardened layers are not covered.";
  static constexpr auto source = "[FKM], [PragTic], [4ming], [DIN743]";
  static constexpr auto headline = "S_D = {S_D}";
  static constexpr auto subject = "fatigue and yielding";
  static constexpr auto synonyms =
      "FKM, FKM guideline, nominal stress, static strength assessment, fatigue strength assessment, "
      "degree of utilisation, FKM-Richtlinie, Auslastungsgrad, Nennspannung, Festigkeitsnachweis, запас прочности, "
      "выносливость";
  static constexpr auto example = R"([project]
title = "Shoulder of a gear shaft"

[shoulder]
calculator = "fatigue.fkm"
steel = "quenched-tempered"
R_mN = "1100 MPa"
R_eN = "900 MPa"
d_h = "60 mm"
notch = "shoulder"
d = "42 mm"
D = "50 mm"
r = "2.5 mm"
R_z = "6.3 um"
overload = "F2"
M_ba = "800 N*m"
M_tm = "900 N*m"
M_ta = "150 N*m"
f_max = 1.8
)";

  struct Input : FkmSteel, Din743Section, SectionActions, FkmService {
    Stress E = unset<Stress>;
  };
  static constexpr Fields inputs = join(fkm_steel<Input>(), Fields{modulus_of_material<Input>(&Input::E)},
                                        din743_section<Input>(), section_actions<Input>(), fkm_service<Input>());

  struct Result : FkmSafety {
    double x_E = unset<double>;
  };
  static constexpr Fields results = join(fkm_results<Result>(), Fields{modulus_over_steel<Result>(&Result::x_E)});

  static constexpr auto rules = fkm_rules<Input>();
  static constexpr std::array meanings{Meaning{"sigma_W", specimen_in_tension}, Meaning{"tau_W", specimen_in_torsion},
                                       Meaning{"sigma_bm, sigma_zdm, M_bm", steady_part},
                                       Meaning{"M_tm, tau_tm, F_zdm", paired_middle},
                                       Meaning{"M_ta, tau_ta, F_zda", paired_amplitude}};
  static constexpr auto bounds = notch_bounds<Input>();
  static constexpr std::array modes{
      Mode<Input>{"fatigue", "fatigue strength, constant amplitude", &any_varies<Input>}.judged_by(
          "u_D, x_eff, x_G, x_Rz, x_N, x_small, x_r, x_D, x_alpha, x_t, x_hole, x_bore, x_E"),
      Mode<Input>{"yield", "static strength at peak load", &always<Input>}.judged_by("u_S, x_E").wanting("f_max"),
      Mode<Input>{"layer", "cracking of the hardened layer",
                  [](const Input& in) { return where(in.layer == Layer::hard); }},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"shear", "transverse shear and buckling", &unseen<Input>}.special(),
      Mode<Input>{"surroundings", "corrosion, fretting, temperature and welds", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::fatigue
