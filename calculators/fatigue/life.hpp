// Safety and life of a part in one stress cycle that comes again and again, by ten rules for its mean stress.
//
// Decides the load factor for a life of N cycles, or infinite life, by the chosen rule: mean stress and amplitude
// grow together, or the mean stays; the life at this load; the amplitude that is allowed; and yielding at the first
// cycle. All rules are listed next to each other. Stresses are nominal, as sigma_D is, amplitudes, and N is in
// cycles. The finite-life line goes from f R_m at 1e3 cycles to the fatigue limit at N_D [Shigley6], by Basquin
// over reversals 2 N, or with a slope k. Compression gives no benefit. Below 1e3 cycles, of low cycles, nothing is
// said. Safety and life are for the survival probability of sigma_D: 50 %, unless it includes P_s. Not covered:
// histories (only one cycle), shear with normal stresses (fatigue.combined), creep, corrosion. Not checked against the
// source: the fit of f, of gamma, and of psi.
#pragma once

#include "calculators/fatigue/cycle_of.hpp"
#include "calculators/fatigue/endurance.hpp"
#include "calculators/fatigue/mean_stress.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::fatigue {

struct Life {
  static constexpr auto id = "fatigue.life";
  static constexpr auto title = "Constant-amplitude fatigue (safety factor and life)";
  static constexpr auto scope =
      "Safety factor and life under one stress cycle; mean-stress correction by Goodman, Soderberg, Gerber, ASME "
      "ellipse, Morrow, Smith-Watson-Topper, Walker, FKM and Serensen, one of which governs, with first-cycle "
      "yielding and the allowable amplitude; load histories, fewer than 1e3 cycles, combined shear, creep and "
      "corrosion are not covered.";
  static constexpr auto source = "[Dowling9], [FKM], [GOST25504], [Shigley6]";
  static constexpr auto headline = "n = {n}|N_f = {N_f}";
  static constexpr auto subject = "fatigue";
  static constexpr auto synonyms =
      "fatigue life, Goodman, modified Goodman, Soderberg, Gerber, ASME elliptic, Morrow, SWT, Walker, "
      "Haigh diagram, mean stress, S-N curve, Basquin, infinite life, finite life, Haigh-Diagramm, Smith-Diagramm, "
      "Dauerfestigkeit, Zeitfestigkeit, Lebensdauer, запас выносливости, долговечность, диаграмма Хея";
  static constexpr auto example = R"([project]
title = "Rod that is pulled"

[rod]
calculator = "fatigue.life"
sigma_max = "180 MPa"
sigma_min = "-20 MPa"
sigma_D = "190 MPa"
group = "carbon-steel"
R_m = "690 MPa"
R_e = "490 MPa"
S_D = 1.5
S_F = 1.5
)";

  using Group = Endurance::Group;
  enum class Line { shigley, basquin, slope };
  enum class Compression { ignored, counted };

  struct Input : Given {
    Stresses stress = Stresses::normal;
    Stress sigma_D = unset<Stress>;
    Group group = Group::other_non_ferrous;  // infinite life is excluded unless a group is given
    Stress R_m = unset<Stress>, R_e = unset<Stress>;
    Length d_h = unset<Length>;
    double S_D = unset<double>, S_F = unset<double>;
    MeanRule rule = MeanRule::goodman;
    MeanStress mean = MeanStress::proportional;
    Compression compression = Compression::ignored;
    double K_m = unset<double>, K_D = unset<double>;
    Density rho = unset<Density>;
    Stress E = unset<Stress>, sigma_f = unset<Stress>, sigma_fB = unset<Stress>;
    double gamma = unset<double>, M = unset<double>, psi = unset<double>;
    double N = unset<double>;
    Line line = Line::shigley;
    double f = unset<double>, b = unset<double>, k = unset<double>, N_D = unset<double>;
  };
  static bool two_given(const Input& in) { return count(in) == 2; }
  static bool sound(const Input& in) { return *objection(in).reason == '\0'; }
  static FieldFault miscount(const Input& in) { return wrong_count(in, ""); }
  static FieldFault objectionable(const Input& in) { return unsound(in, ""); }
  static bool rule_has_all(const Input& in);
  static FieldFault lacking(const Input& in);
  static bool line_has_all(const Input& in);
  static FieldFault lacking_of_line(const Input& in);
  static Applies varies(const Input& in);
  static bool is_ferrous(const Input& in) { return in.group < Group::wrought_aluminium; }

  template <class Quantity>
  using F = Field<Input, Quantity>;
  static constexpr Fields inputs = join(
      Fields{RecordField<Input>{"cycle", "stress cycle of a fatigue.cycle step: cycle = \"=rod.cycle\""}},
      given_fields<Input>(),
      Fields{
          Choice<Input, Stresses>{&Input::stress, "stress", "stress component: normal or shear"}.may_be_missing(),
          F<Stress>{&Input::sigma_D, "sigma_D", MPa,
                    "fatigue limit of the part, r = −1, as nominal stress, e.g. of fatigue.endurance"}
              .positive()
              .usually(5, 1500)
              .may_be_missing(),
          Choice<Input, Group>{&Input::group, "group", "group of materials"},
          F<Stress>{&Input::R_m, "R_m", MPa, "tensile strength"}
              .positive()
              .usually(80, 2500)
              .customarily_at_most(most_tensile_strength)
              .from("material", "R_m", "d_h"),
          F<Stress>{&Input::R_e, "R_e", MPa, "yield strength"}
              .positive()
              .usually(50, 2500)
              .customarily_at_most(most_yield_strength)
              .from("material", "R_e", "d_h"),
          modulus_of_material(&Input::E),
          density_of_material(&Input::rho),
          diameter_at_heat_treatment(&Input::d_h).at_least_that_of_source("d_s, t, d_h"),
          F<double>{&Input::S_D, "S_D", ratio, "required fatigue safety factor, on the load"}
              .at_least(1)
              .usually(1.2, 6)
              .customarily_at_least(1.2)
              .factor(),
          F<double>{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
              .at_least(1)
              .usually(1, 6)
              .customarily_at_least(1.2)
              .may_be_missing()
              .factor(),
          Choice<Input, MeanRule>{&Input::rule, "rule", "governing mean stress rule"}.may_be_missing(),
          Choice<Input, MeanStress>{&Input::mean, "mean", "overload case: constant mean stress, or constant ratio"}
              .may_be_missing(),
          Choice<Input, Compression>{&Input::compression, "compression", "benefit of compressive mean stress"}
              .may_be_missing(),
          F<double>{&Input::K_m, "K_m", ratio,
                    "notch factor of the mean stress: 1 for ductile metals, K_f for brittle ones"}
              .within(1, 10)
              .usually(1, 5)
              .may_be_missing(),
          F<double>{&Input::K_D, "K_D", ratio, "fatigue limit of specimen / part, e.g. of fatigue.endurance"}
              .within(0.2, 50)
              .usually(0.5, 10)
              .may_be_missing(),
          F<Stress>{&Input::sigma_f, "sigma_f", MPa, "fatigue strength coefficient sigma_f' of Basquin, for Morrow too"}
              .positive()
              .usually(200, 4000)
              .may_be_missing(),
          F<Stress>{&Input::sigma_fB, "sigma_fB", MPa, "true fracture stress, for Morrow in place of sigma_f"}
              .positive()
              .usually(200, 4000)
              .may_be_missing(),
          F<double>{&Input::gamma, "gamma", ratio, "Walker exponent; omitted: by R_m of steels"}
              .within(0.1, 1)
              .usually(0.3, 0.9)
              .customarily_at_most(0.9)
              .may_be_missing(),
          F<double>{&Input::M, "M", ratio, "FKM mean stress sensitivity; omitted: by group and R_m"}
              .at_least(0)
              .below(1)
              .usually(0.01, 0.8)
              .may_be_missing(),
          F<double>{&Input::psi, "psi", ratio, "Serensen's mean stress sensitivity; omitted: by R_m of steels"}
              .within(0, 1)
              .usually(0.02, 0.6)
              .may_be_missing(),
          F<double>{&Input::N, "N", ratio, "required life in cycles; infinite if omitted"}
              .at_least(1)
              .usually(1e3, 1e9)
              .may_be_missing()
              .most(),
          Choice<Input, Line>{&Input::line, "line", "finite-life line"}.may_be_missing(),
          F<double>{&Input::f, "f", ratio, "strength at 1e3 cycles / R_m; omitted: by R_m of steels"}
              .within(0.5, 1)
              .usually(0.7, 0.95)
              .may_be_missing(),
          F<double>{&Input::b, "b", ratio, "Basquin's exponent over reversals, negative"}
              .within(-0.5, -0.02)
              .usually(-0.2, -0.04)
              .may_be_missing(),
          F<double>{&Input::k, "k", ratio, "slope of the line: N S^k is constant"}
              .within(2, 40)
              .usually(3, 20)
              .may_be_missing(),
          F<double>{&Input::N_D, "N_D", ratio, "number of cycles of sigma_D; omitted: 1e6, non-ferrous metals 1e8"}
              .within(1e4, 1e10)
              .usually(5e5, 1e9)
              .may_be_missing()});

  struct Row {
    Name name;
    Stress sigma_m = unset<Stress>, sigma_ar = unset<Stress>, sigma_A = unset<Stress>;
    double n = unset<double>, n_m = unset<double>, N = unset<double>;
    static constexpr Fields fields{
        NameField{&Row::name, "name", "the rule"},
        Field{&Row::sigma_m, "sigma_m", MPa, "mean stress by the rule"},
        Field{&Row::sigma_ar, "sigma_ar", MPa, "fully reversed amplitude of the same damage"},
        Field{&Row::sigma_A, "sigma_A", MPa, "permissible amplitude at the same mean stress"},
        Field{&Row::n, "n", ratio, "safety factor on the total load"},
        Field{&Row::n_m, "n_m", ratio, "safety factor on the amplitude at constant mean stress"},
        Field{&Row::N, "N", ratio, "life in cycles; none below 1e3"}.may_be_infinite()};
  };

  struct Result : Characteristics {
    double u_y = unset<double>, u_F = unset<double>, n_y = unset<double>, u_D = unset<double>;
    Stress S_e = unset<Stress>, sigma_ar = unset<Stress>;
    double n = unset<double>, n_m = unset<double>, N_f = unset<double>, N_S = unset<double>;
    Stress S_req = unset<Stress>, sigma_adm = unset<Stress>;
    double f = unset<double>, b_N = unset<double>;
    Stress a_N = unset<Stress>;
    double x_m = unset<double>, x_B = unset<double>, x_N = unset<double>, x_D = unset<double>, x_f = unset<double>;
    double x_E = unset<double>;
    List<Row, choices_of(MeanRule{}).size()> rules;
  };
  static constexpr Fields results = join(
      cycle_fields<Result>(),
      Fields{
          Field{&Result::u_y, "u_y", ratio, "yielding: maximum stress / yield strength"}.check().where_it_applies(),
          Field{&Result::u_F, "u_F", ratio, "yielding: required / calculated safety factor"}.check("S_F"),
          Field{&Result::n_y, "n_y", ratio, "safety factor against first-cycle yielding (Langer)"},
          Field{&Result::u_D, "u_D", ratio, "fatigue: required / calculated safety factor"}.check().where_it_applies(),
          Field{&Result::S_e, "S_e", MPa, "fully reversed strength for this life"},
          Field{&Result::sigma_ar, "sigma_ar", MPa, "fully reversed amplitude of the same damage, by the rule"},
          Field{&Result::n, "n", ratio, "safety factor by the rule: on the total load"},
          Field{&Result::n_m, "n_m", ratio, "safety factor by the rule: on the amplitude at constant mean stress"},
          Field{&Result::N_f, "N_f", ratio, "life in cycles at this load; none below 1e3, at most N_D"}
              .may_be_infinite(),
          Field{&Result::N_S, "N_S", ratio, "life in cycles at S_D times the load"}.may_be_infinite(),
          Field{&Result::S_req, "S_req", MPa, "fully reversed strength required at S_D times the load"},
          Field{&Result::sigma_adm, "sigma_adm", MPa, "allowable amplitude for this life, safety factor included"},
          Field{&Result::f, "f", ratio, "strength at 1e3 cycles / tensile strength"},
          Field{&Result::a_N, "a_N", MPa, "amplitude at one cycle of the finite-life line a_N N^b_N"},
          Field{&Result::b_N, "b_N", ratio, "exponent of the finite-life line, over cycles"},
          Field{&Result::x_m, "x_m", ratio, "mean stress / mean stress at zero amplitude, by the rule"}
              .limit(0, 1 - 1e-12)
              .criterion()
              .where_it_applies(),
          Field{&Result::x_B, "x_B", ratio, "maximum stress / tensile strength (static fracture)"}
              .limit(0, 1, "R_m")
              .criterion(),
          Field{&Result::x_N, "x_N", ratio, "1e3 cycles / N (below 1e3 cycles strain-life applies)"}.limit(0, 1, "N"),
          Field{&Result::x_D, "x_D", ratio, "N / N_D; the curve is not given beyond N_D"}
              .limit(0, 1 + 1e-9, "N")
              .where_it_applies(),
          Field{&Result::x_f, "x_f", ratio, "R_m / maximum R_m of the fit of f"}.limit(0, 1, "N").where_it_applies(),
          modulus_over_steel<Result>(&Result::x_E),
          ListField<Result, List<Row, choices_of(MeanRule{}).size()>>{&Result::rules, "rules",
                                                                      "all rules whose inputs are given"}});

  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{&two_given, "sigma_max, sigma_min, sigma_m, sigma_a, r",
                  "a cycle needs two of sigma_max, sigma_min, sigma_m, sigma_a and r", &miscount},
      Rule<Input>{&sound, "sigma_max, sigma_min, sigma_m, sigma_a, r", "these two do not define a cycle",
                  &objectionable},
      Rule<Input>{&rule_has_all, "rule, R_m, R_e, sigma_f, sigma_fB, gamma, M, psi",
                  "an input of the mean stress rule is missing", &lacking},
      Rule<Input>{&line_has_all, "line, N, sigma_D, R_m, f, sigma_f, b, k, K_D",
                  "an input of the finite-life line is missing", &lacking_of_line},
      Rule<Input>{[](const Input& in) { return is_set(in.sigma_D) || (in.line == Line::basquin && is_set(in.N)); },
                  "sigma_D",
                  "give the fatigue limit of the part sigma_D; omit it only with a required life N and the finite-life "
                  "line of Basquin, line = \"basquin\""},
      Rule<Input>{
          [](const Input& in) { return is_ferrous(in) || is_set(in.N); }, "group, N",
          "give the group, e.g. group = \"carbon-steel\"; without it the material is taken as non-ferrous, with no "
          "endurance limit, and needs a required life N"},
      group_of_metal<Input>(),
      lasts_below_tensile<&Input::sigma_D, Input>("sigma_D, R_m"),
      yields_before_it_breaks<Input>(),
      Rule<Input>{[](const Input& in) { return in.compression == Compression::ignored || in.rule == MeanRule::fkm; },
                  "compression, rule", "compression is considered only by rule = \"fkm\""},
      Rule<Input>{[](const Input& in) { return in.group != Group::grey_iron || is_set(in.K_m); }, "K_m, group",
                  "grey iron does not yield at a notch: give K_m = K_f, or 1 without a notch"},
      Rule<Input>{[](const Input& in) {
                    return !is_set(in.S_F) || is_set(in.R_e) || (in.group == Group::grey_iron && is_set(in.R_m));
                  },
                  "S_F, R_e", "the safety factor S_F needs the yield strength R_e, or a material"}};

  static constexpr std::array meanings{Meaning{"sigma_D", strength_in_normal, "stress, group",
                                               "normal/wrought-aluminium, normal/cast-aluminium, normal/non-ferrous"},
                                       Meaning{"sigma_D", strength_in_shear, "stress, group",
                                               "shear/wrought-aluminium, shear/cast-aluminium, shear/non-ferrous"},
                                       Meaning{"sigma_D", limit_in_normal, "stress", "normal"},
                                       Meaning{"sigma_D", limit_in_shear, "stress", "shear"},
                                       Meaning{"K_D", factor_in_normal, "stress", "normal"},
                                       Meaning{"K_D", factor_in_shear, "stress", "shear"},
                                       Meaning{"sigma_max", "max"},
                                       Meaning{"sigma_min", "min"},
                                       Meaning{"sigma_a", "amplitude"},
                                       Meaning{"sigma_m", steady_part}};

  static constexpr std::array modes{
      Mode<Input>{"yield", "first-cycle yielding", &always<Input>}.judged_by("u_y, u_F").wanting("R_e, S_F"),
      Mode<Input>{"fatigue", "constant-amplitude fatigue", &varies}.judged_by("u_D, x_m, x_B, x_N, x_D, x_f, x_E"),
      Mode<Input>{"notch", "local yielding at the notch root", &unseen<Input>},
      Mode<Input>{"multiaxial", "combined normal and shear stresses", &unseen<Input>}.assessed_in("fatigue.combined"),
      Mode<Input>{"history", "variable-amplitude loading", &unseen<Input>}.assessed_in("fatigue.history"),
      Mode<Input>{"surroundings", "corrosion, creep and fretting", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Life::Line) {
  using L = Life::Line;
  return std::array{ChoiceName<L>{L::shigley, "shigley", "from f R_m at 1e3 cycles to sigma_D at N_D"},
                    ChoiceName<L>{L::basquin, "basquin", "sigma_f' (2 N)^b of the specimen over K_D; N in cycles"},
                    ChoiceName<L>{L::slope, "slope", "N = N_D (sigma_D/S)^k, as FKM has it"}};
}

constexpr auto choices_of(Life::Compression) {
  using C = Life::Compression;
  return std::array{ChoiceName<C>{C::ignored, "ignored", "not counted"},
                    ChoiceName<C>{C::counted, "counted", "mean stress fields of FKM"}};
}

}  // namespace loadpath::fatigue
