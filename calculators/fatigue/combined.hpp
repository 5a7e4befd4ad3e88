// Safety of a section where normal and shear stresses vary together, by Serensen, von Mises or Gough and Pollard.
//
// Decides the load factor for infinite life: Serensen's n = n_sigma n_tau/sqrt(n_sigma^2 + n_tau^2) with psi (GOST
// 25.504, the school of [B20]); von Mises stresses of amplitudes and of means by Goodman, Soderberg, Gerber or the
// ellipse of ASME [Shigley6]; the ellipse of Gough and Pollard with Goodman's line in each stress; and yielding at
// the first cycle. All are listed next to each other. Normal and shear stresses rise and fall together, of ductile
// metals; stresses are nominal, as sigma_D and tau_D are. Not covered: stresses out of phase, brittle metals, finite
// life, two normal stresses. Not checked against the source: psi from R_m.
#pragma once

#include "calculators/fatigue/mean_stress.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::fatigue {

struct Combined {
  static constexpr auto id = "fatigue.combined";
  static constexpr auto title = "Fatigue under proportional normal and shear stress";
  static constexpr auto scope =
      "Infinite-life safety factor for in-phase normal and shear stresses by Serensen, von Mises with four "
      "mean stress rules, and Gough-Pollard, with first-cycle yielding; out-of-phase stresses, brittle metals "
      "and finite life are not covered.";
  static constexpr auto source = "[GOST25504], [Gough], [Shigley6]";
  static constexpr auto headline = "n = {n}";
  static constexpr auto subject = "fatigue";
  static constexpr auto synonyms =
      "combined stress, multiaxial fatigue, proportional, in phase, bending and torsion fatigue, Gough-Pollard, "
      "von Mises, Serensen, zusammengesetzte Beanspruchung, Biegung und Torsion, сложное напряжённое состояние, "
      "Гаф-Поллард, запас прочности";
  static constexpr auto example = R"([project]
title = "Shoulder of a shaft that turns and drives"

[shoulder]
calculator = "fatigue.combined"
sigma_m = "20 MPa"
sigma_a = "60 MPa"
tau_m = "40 MPa"
tau_a = "10 MPa"
sigma_D = "180 MPa"
tau_D = "110 MPa"
K_sigma = 1.7
K_tau = 1.5
R_m = "690 MPa"
R_e = "490 MPa"
S_D = 1.8
S_F = 1.5
)";

  enum class Criterion { serensen, goodman, soderberg, gerber, elliptic, gough };

  struct Input {
    Stress sigma_m = unset<Stress>, sigma_a = unset<Stress>, tau_m = unset<Stress>, tau_a = unset<Stress>;
    Stress sigma_D = unset<Stress>, tau_D = unset<Stress>;
    double K_sigma = 1.0, K_tau = 1.0, psi_sigma = unset<double>, psi_tau = unset<double>;
    Stress R_m = unset<Stress>, R_e = unset<Stress>, E = unset<Stress>;
    Density rho = unset<Density>;
    Length d_h = unset<Length>;
    Criterion rule = Criterion::serensen;
    double S_D = unset<double>, S_F = unset<double>, N = unset<double>, N_D = unset<double>;
  };
  static bool varies(const Input& in) { return in.sigma_a > 0.0 * MPa || in.tau_a > 0.0 * MPa; }
  static constexpr Fields inputs = join(
      Fields{Field{&Input::sigma_m, "sigma_m", MPa, "mean normal stress, signed; compression is not credited"}.load(),
             Field{&Input::sigma_a, "sigma_a", MPa, "amplitude of the normal stress"}.load().at_least(0),
             Field{&Input::tau_m, "tau_m", MPa, "mean shear stress"}.load(),
             Field{&Input::tau_a, "tau_a", MPa, "amplitude of the shear stress"}.load().at_least(0),
             Field{&Input::sigma_D, "sigma_D", MPa,
                   "fatigue limit of the part in normal stresses, r = −1: of fatigue.endurance"}
                 .positive()
                 .usually(5, 1500),
             Field{&Input::tau_D, "tau_D", MPa, "the same in shear: of fatigue.endurance with loading = \"torsion\""}
                 .positive()
                 .usually(3, 1000)
                 .may_be_missing(),
             Field{&Input::K_sigma, "K_sigma", ratio,
                   "K_D of sigma_D, not applied to the mean stress; 1 is on the safe side"}
                 .within(1, 50)
                 .usually(1, 6),
             Field{&Input::K_tau, "K_tau", ratio, "K_D of tau_D"}.within(1, 50).usually(1, 6),
             Field{&Input::psi_sigma, "psi_sigma", ratio, "sensitivity to mean normal stress, else by R_m of steels"}
                 .within(0, 1)
                 .usually(0.02, 0.6)
                 .may_be_missing(),
             Field{&Input::psi_tau, "psi_tau", ratio, "the same in shear, else half of it"}
                 .within(0, 1)
                 .usually(0.01, 0.4)
                 .may_be_missing(),
             Field{&Input::R_m, "R_m", MPa, "tensile strength"}
                 .positive()
                 .usually(80, 2500)
                 .customarily_at_most(most_tensile_strength)
                 .from("material", "R_m", "d_h"),
             Field{&Input::R_e, "R_e", MPa, "yield strength"}
                 .positive()
                 .usually(50, 2500)
                 .customarily_at_most(most_yield_strength)
                 .from("material", "R_e", "d_h"),
             modulus_of_material<Input>(&Input::E), density_of_material<Input>(&Input::rho),
             diameter_at_heat_treatment(&Input::d_h).at_least_that_of_source("d_s, t, d_h"),
             Choice{&Input::rule, "rule", "governing rule"}.may_be_missing(),
             Field{&Input::S_D, "S_D", ratio, "required fatigue safety factor, on the load"}
                 .at_least(1)
                 .usually(1.2, 6)
                 .customarily_at_least(1.2)
                 .factor(),
             Field{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
                 .at_least(1)
                 .usually(1, 6)
                 .customarily_at_least(1.2)
                 .may_be_missing()
                 .factor()},
      cycles_of_metal<Input>());

  struct Result {
    double n_sigma = unset<double>, n_tau = unset<double>, n_Serensen = unset<double>;
    Stress sigma_va = unset<Stress>, sigma_vm = unset<Stress>;
    double n_Goodman = unset<double>, n_Soderberg = unset<double>, n_Gerber = unset<double>, n_elliptic = unset<double>;
    double n_Gough = unset<double>, n = unset<double>, n_y = unset<double>;
    double u_D = unset<double>, x_v = unset<double>, x_B = unset<double>, u_y = unset<double>, u_F = unset<double>;
    double x_E = unset<double>, x_N = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::n_sigma, "n_sigma", ratio, "Serensen's safety in normal stresses; none without them"},
      Field{&Result::n_tau, "n_tau", ratio, "Serensen's safety in shear; none without it"},
      Field{&Result::n_Serensen, "n_Serensen", ratio, "safety by Serensen"},
      Field{&Result::sigma_va, "sigma_va", MPa, "von Mises stress of the amplitudes"},
      Field{&Result::sigma_vm, "sigma_vm", MPa, "von Mises stress of the means"},
      Field{&Result::n_Goodman, "n_Goodman", ratio, "safety by von Mises and Goodman"},
      Field{&Result::n_Soderberg, "n_Soderberg", ratio, "safety by von Mises and Soderberg"},
      Field{&Result::n_Gerber, "n_Gerber", ratio, "safety by von Mises and Gerber"},
      Field{&Result::n_elliptic, "n_elliptic", ratio, "safety by von Mises and the ellipse of ASME"},
      Field{&Result::n_Gough, "n_Gough", ratio, "safety by Gough and Pollard, with Goodman in each stress"},
      Field{&Result::n, "n", ratio, "safety factor by the governing rule"},
      Field{&Result::n_y, "n_y", ratio, "safety against yielding at the first cycle"},
      Field{&Result::u_D, "u_D", ratio, "fatigue: required / calculated safety factor"}.check().where_it_applies(),
      Field{&Result::x_v, "x_v", ratio, "limit in shear by von Mises over tau_D: above 1 shear is not covered by it"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Result::x_B, "x_B", ratio, "maximum von Mises stress / tensile strength (static fracture)"}
          .limit(0, 1, "R_m")
          .criterion(),
      Field{&Result::u_y, "u_y", ratio, "yielding: maximum von Mises stress / yield strength"}.check("R_e"),
      Field{&Result::u_F, "u_F", ratio, "yielding: required / calculated safety factor"}.check("S_F"),
      modulus_over_steel<Result>(&Result::x_E),
      cycles_over_told<Result>(&Result::x_N)};

  static bool rule_has_all(const Input& in);
  static FieldFault lacking(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&rule_has_all, "rule, R_m, R_e, tau_D, psi_sigma, psi_tau",
                  "an input of the mean stress rule is missing", &lacking},
      lasts_below_tensile<&Input::sigma_D, Input>("sigma_D, R_m"),
      Rule<Input>{[](const Input& in) { return !(in.tau_D > in.sigma_D); }, "tau_D, sigma_D",
                  "the fatigue limit in shear must not exceed that in normal stress"},
      yields_before_it_breaks<Input>(), safety_has_its_yield<Input>()};

  /// Specimens have 0.577 of it by von Mises, and up to 0.7 in tests of ductile metals [Gough].
  static double most_limit_in_shear(const Input& in) { return 0.7 * in_si(in.sigma_D) * in.K_sigma / in.K_tau; }
  static constexpr std::array bounds{
      Bound<Input>{"tau_D", "0.7 sigma_D K_sigma / K_tau", &most_limit_in_shear}.sparing_results()};

  static constexpr std::array meanings{Meaning{"sigma_D", limit_in_normal},    Meaning{"tau_D", limit_in_shear},
                                       Meaning{"K_sigma", factor_in_normal},   Meaning{"K_tau", factor_in_shear},
                                       Meaning{"sigma_a, tau_a", "amplitude"}, Meaning{"sigma_m, tau_m", steady_part}};

  static constexpr std::array modes{
      Mode<Input>{"yield", "first-cycle yielding", &always<Input>}.judged_by("u_y, u_F"),
      Mode<Input>{"fatigue", "infinite-life fatigue, proportional stresses",
                  [](const Input& in) { return where(varies(in)); }}
          .judged_by("u_D, x_v, x_B, x_E"),
      fatigue_of_metal<&varies, Input>(),
      Mode<Input>{"phase", "non-proportional and variable-amplitude stresses", &unseen<Input>},
      Mode<Input>{"notch", "local yielding at the notch root", &unseen<Input>},
      Mode<Input>{"surroundings", "corrosion, heat and fretting", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Combined::Criterion) {
  using R = Combined::Criterion;
  return std::array{ChoiceName<R>{R::serensen, "serensen", "Serensen: safeties of each stress, together by squares"},
                    ChoiceName<R>{R::goodman, "goodman", "von Mises stresses, a line to the tensile strength"},
                    ChoiceName<R>{R::soderberg, "soderberg", "von Mises stresses, a line to the yield strength"},
                    ChoiceName<R>{R::gerber, "gerber", "von Mises stresses, a parabola to the tensile strength"},
                    ChoiceName<R>{R::elliptic, "elliptic", "von Mises stresses, an ellipse to the yield strength"},
                    ChoiceName<R>{R::gough, "gough", "ellipse of Gough and Pollard, Goodman in each stress"}};
}

}  // namespace loadpath::fatigue
