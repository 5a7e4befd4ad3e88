// A compound cylinder: a tube shrunk on another one, under internal pressure.
//
// Decides the contact pressure from the interference by [Lame], or the interference from the contact pressure; the
// stresses of both tubes at rest and under internal pressure by superposition, and their yielding. All states count:
// largest and smallest interference, cold and warm, without and with the pressure; between them an equivalent stress is
// smaller, because it is convex in the loads. Tube 1 is the inner one. Interferences are of the diameter, tension is
// positive. At rest the tubes are free to slide; closed ends pull both alike when the pressure comes. Not covered:
// slip, the ends, seams, corrosion, external pressure, temperature gradients within a tube, yielding fits.
#pragma once

#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/fit_units.hpp"

#include <vector>

namespace loadpath::vessel {

struct Compound {
  static constexpr auto id = "vessel.compound";
  static constexpr auto title = "Compound cylinder (two tubes shrunk together)";
  static constexpr auto scope =
      "Contact pressure, stresses at rest and under internal pressure, yielding and loss of contact due to heating of "
      "two "
      "elastic tubes shrunk together, optimum contact pressure and diameter; slip, ends, nozzles, external pressure "
      "and "
      "fatigue are not covered.";
  static constexpr auto source = "[Lame], [Mises], [Bhandari-22]";
  static constexpr auto headline = "d_i = {d_i}, d = {d}, D = {D}";
  static constexpr auto subject = "compound cylinder";
  static constexpr auto synonyms =
      "compound cylinder, composite cylinder, shrunk tubes, shrink-fitted cylinders, jacketed cylinder, liner, "
      "prestressed cylinder, hooped gun barrel, extrusion container, die reinforcement, shrink ring, contact pressure, "
      "interference, Schrumpfring, Mehrlagenzylinder, Verbundzylinder, vorgespannter Hohlzylinder, Armierung, "
      "составной цилиндр, автоскрепление, натяг труб";
  static constexpr auto example = R"([project]
title = "Container of an extrusion press"

[container]
calculator = "vessel.compound"
p = "250 MPa"
d_i = "100 mm"
d = "200 mm"
D = "400 mm"
U_min = "240 um"
U_max = "280 um"
ends = "open"
material = "42CrMo4"
R_e_1 = "650 MPa"
R_e_2 = "650 MPa"
S = 1.5
)";

  enum class Ends { closed, open };

  struct Input {
    Stress p = unset<Stress>;
    Length d_i = unset<Length>, d = unset<Length>, D = unset<Length>;
    Length U_min = unset<Length>, U_max = unset<Length>;
    Stress p_c = unset<Stress>;
    Ends ends = Ends::closed;
    Stress E_1 = unset<Stress>, E_2 = unset<Stress>;
    double nu_1 = unset<double>, nu_2 = unset<double>;
    Expansion alpha_1 = unset<Expansion>, alpha_2 = unset<Expansion>;
    Heating dT_1 = unset<Heating>, dT_2 = unset<Heating>;
    Stress R_e_1 = unset<Stress>, R_e_2 = unset<Stress>;
    double S = unset<double>;
    Hypothesis hypothesis = Hypothesis::tresca;
  };
  static constexpr Fields inputs{
      Field{&Input::p, "p", MPa, "internal gauge pressure in service; 0: at rest only"}.load().at_least(0).usually(
          0, 1000),
      Field{&Input::d_i, "d_i", mm, "bore diameter of the inner tube"}.positive().usually(2, 3000),
      Field{&Input::d, "d", mm, "contact diameter"}.positive().usually(3, 4000),
      Field{&Input::D, "D", mm, "outer diameter of the outer tube"}.positive().usually(4, 6000),
      Field{&Input::U_min, "U_min", um, "minimum diametral interference, effective (smoothing deducted)"}
          .positive()
          .usually(1, 10000)
          .may_be_missing(),
      Field{&Input::U_max, "U_max", um, "maximum diametral interference, effective (smoothing deducted)"}
          .positive()
          .usually(1, 10000)
          .may_be_missing(),
      Field{&Input::p_c, "p_c", MPa, "contact pressure of the cold tubes at rest, in place of the interference"}
          .positive()
          .usually(0.1, 1000)
          .may_be_missing(),
      Choice{&Input::ends, "ends", "end condition: closed, with an axial force on both tubes, or open"}
          .may_be_missing(),
      Field{&Input::E_1, "E_1", GPa, "modulus of elasticity of the inner tube"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E"),
      Field{&Input::E_2, "E_2", GPa, "modulus of elasticity of the outer tube"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E"),
      Field{&Input::nu_1, "nu_1", ratio, "Poisson's ratio of the inner tube"}.at_least(0).below(0.5).from("material",
                                                                                                          "nu"),
      Field{&Input::nu_2, "nu_2", ratio, "Poisson's ratio of the outer tube"}.at_least(0).below(0.5).from("material",
                                                                                                          "nu"),
      Field{&Input::alpha_1, "alpha_1", per_kelvin, "coefficient of thermal expansion of the inner tube"}
          .positive()
          .customarily_at_least(4e-6)
          .from("material", "alpha")
          .where_it_has(),
      Field{&Input::alpha_2, "alpha_2", per_kelvin, "coefficient of thermal expansion of the outer tube"}
          .positive()
          .customarily_at_least(4e-6)
          .from("material", "alpha")
          .where_it_has(),
      Field{&Input::dT_1, "dT_1", kelvin, "temperature rise of the inner tube in service"}
          .usually(-200, 600)
          .may_be_missing(),
      Field{&Input::dT_2, "dT_2", kelvin, "temperature rise of the outer tube in service"}
          .usually(-200, 600)
          .may_be_missing(),
      Field{&Input::R_e_1, "R_e_1", MPa, "yield strength of the inner tube; brittle tubes are not covered"}
          .positive()
          .at_most_that_of_source("R_e")
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .may_be_missing(),
      Field{&Input::R_e_2, "R_e_2", MPa, "yield strength of the outer tube; brittle tubes are not covered"}
          .positive()
          .at_most_that_of_source("R_e")
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .may_be_missing(),
      Field{&Input::S, "S", ratio, "required safety factor against yielding"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.5)
          .may_be_missing()
          .factor(),
      Choice{&Input::hypothesis, "hypothesis", "failure theory of the equivalent stress: Tresca or von Mises"}
          .may_be_missing()};

  /// Stresses of both tubes with one interference, with or without the internal pressure.
  struct State {
    Name name;
    Length U = unset<Length>;
    Stress p_i = unset<Stress>, p_k = unset<Stress>;
    Stress sigma_1i = unset<Stress>, sigma_1a = unset<Stress>, sigma_2i = unset<Stress>, sigma_2a = unset<Stress>;
    Stress sigma_z1 = unset<Stress>, sigma_z2 = unset<Stress>, sigma_v1 = unset<Stress>, sigma_v2 = unset<Stress>;
    static constexpr Fields fields{
        NameField{&State::name, "name", "state"},
        Field{&State::U, "U", um, "diametral interference"},
        Field{&State::p_i, "p_i", MPa, "internal pressure"},
        Field{&State::p_k, "p_k", MPa, "contact pressure"},
        Field{&State::sigma_1i, "sigma_1i", MPa, "hoop stress of the inner tube, inside"},
        Field{&State::sigma_1a, "sigma_1a", MPa, "hoop stress of the inner tube, at the contact"},
        Field{&State::sigma_2i, "sigma_2i", MPa, "hoop stress of the outer tube, at the contact"},
        Field{&State::sigma_2a, "sigma_2a", MPa, "hoop stress of the outer tube, outside"},
        Field{&State::sigma_z1, "sigma_z1", MPa, "axial stress of the inner tube"},
        Field{&State::sigma_z2, "sigma_z2", MPa, "axial stress of the outer tube"},
        Field{&State::sigma_v1, "sigma_v1", MPa, "equivalent stress of the inner tube, at its governing surface"},
        Field{&State::sigma_v2, "sigma_v2", MPa, "equivalent stress of the outer tube, at its governing surface"}};
  };

  struct Result {
    double Q_1 = unset<double>, Q_2 = unset<double>;
    Length U_T = unset<Length>, U_w_min = unset<Length>, U_w_max = unset<Length>;
    Stress p_min = unset<Stress>, p_max = unset<Stress>;
    double q_p = unset<double>;
    List<State, 4> states;
    Stress sigma_v1 = unset<Stress>, sigma_v2 = unset<Stress>;
    Stress p_opt = unset<Stress>, p_F = unset<Stress>;
    Length U_opt = unset<Length>, d_opt = unset<Length>;
    double u_1 = unset<double>, u_2 = unset<double>, u_U = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::Q_1, "Q_1", ratio, "diameter ratio of the inner tube: bore / contact"},
      Field{&Result::Q_2, "Q_2", ratio, "diameter ratio of the outer tube: contact / outside"},
      Field{&Result::U_T, "U_T", um, "interference lost by heating; negative: gained"},
      Field{&Result::U_w_min, "U_w_min", um, "minimum effective interference, cold or warm"},
      Field{&Result::U_w_max, "U_w_max", um, "maximum effective interference, cold or warm"},
      Field{&Result::p_min, "p_min", MPa, "minimum contact pressure at rest"},
      Field{&Result::p_max, "p_max", MPa, "maximum contact pressure at rest"},
      Field{&Result::q_p, "q_p", ratio, "increase of the contact pressure / internal pressure"},
      ListField{&Result::states, "states", "stresses of both tubes in all states"},
      Field{&Result::sigma_v1, "sigma_v1", MPa, "equivalent stress of the inner tube in the governing state"},
      Field{&Result::sigma_v2, "sigma_v2", MPa, "equivalent stress of the outer tube in the governing state"},
      Field{&Result::p_opt, "p_opt", MPa, "contact pressure at rest for equal utilisation of both bores (Tresca)"},
      Field{&Result::U_opt, "U_opt", um, "interference for the contact pressure"},
      Field{&Result::p_F, "p_F", MPa, "internal pressure at first yield with the contact pressure (Tresca)"},
      Field{&Result::d_opt, "d_opt", mm, "contact diameter of the highest such internal pressure"},
      Field{&Result::u_1, "u_1", ratio, "inner tube: S x equivalent stress / yield strength"}.check("S"),
      Field{&Result::u_2, "u_2", ratio, "outer tube: S x equivalent stress / yield strength"}.check("S"),
      Field{&Result::u_U, "u_U", ratio, "contact: interference lost by heating / minimum interference"}.check("dT_2")};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.d_i < in.d && in.d < in.D; }, "d_i, d, D",
                  "the contact diameter must be between the bore and the outer diameter"},
      Rule<Input>{[](const Input& in) { return is_set(in.U_min) == is_set(in.U_max); }, "U_min, U_max",
                  "give both U_min and U_max; equal ones for a single interference"},
      Rule<Input>{[](const Input& in) { return is_set(in.p_c) != is_set(in.U_max); }, "p_c, U_min, U_max",
                  "give the interference U_min and U_max, or the contact pressure p_c, not both"},
      Rule<Input>{[](const Input& in) { return !(in.U_min > in.U_max); }, "U_min, U_max",
                  "U_min must not exceed U_max"},
      Rule<Input>{
          [](const Input& in) { return is_set(in.E_1) && is_set(in.E_2) && is_set(in.nu_1) && is_set(in.nu_2); },
          "E_1, E_2, nu_1, nu_2", "give E and nu of both tubes, or a material of both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S) || (is_set(in.R_e_1) && is_set(in.R_e_2)); },
                  "S, R_e_1, R_e_2", "the safety factor against yielding needs the yield strengths R_e_1 and R_e_2"},
      Rule<Input>{[](const Input& in) { return is_set(in.dT_1) == is_set(in.dT_2); }, "dT_1, dT_2",
                  "give the temperature rise of both tubes; 0 for a cold one"},
      Rule<Input>{[](const Input& in) { return !is_set(in.dT_1) || (is_set(in.alpha_1) && is_set(in.alpha_2)); },
                  "dT_1, dT_2, alpha_1, alpha_2",
                  "a heating needs the thermal expansion alpha of both tubes, or a material"},
      Rule<Input>{[](const Input& in) { return in.hypothesis != Hypothesis::membrane; }, "hypothesis",
                  radial_stress_needed}};

  static constexpr Applies has_ends(const Input& in) { return in.ends == Ends::closed ? Applies::unseen : Applies::no; }
  static Applies heated(const Input& in) { return shown_by(is_set(in.dT_1)); }
  static constexpr std::array meanings{Meaning{"R_e_1, R_e_2", yield_strength}};
  static constexpr std::array modes =
      modes_of_wall<Input>(Mode<Input>{"inner", "yielding of the inner tube", &always<Input>}.judged_by("u_1"),
                           Mode<Input>{"outer", "yielding of the outer tube", &always<Input>}.judged_by("u_2"),
                           Mode<Input>{"contact", "loss of contact due to heating", &heated}.judged_by("u_U").special(),
                           Mode<Input>{"slip", "slip between the tubes", &unseen<Input>}.special(),
                           Mode<Input>{"ends", "strength of the ends", &has_ends}.of_service());

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Compound::Ends) {
  using Ends = Compound::Ends;
  return std::array{
      ChoiceName<Ends>{Ends::closed, "closed", "closed ends: both tubes are stretched by the same amount"},
      ChoiceName<Ends>{Ends::open, "open", "open: no axial force, as with a ram at each end"}};
}

}  // namespace loadpath::vessel
