// Autofrettage of a thick cylinder: overstrained once by internal pressure, it keeps compressive stresses at the bore.
//
// Decides the plastic radius from the autofrettage pressure or the reverse, the residual stresses, the stresses in
// service, the pressure at which it yields again, and reverse yielding at the bore. Ideally plastic material, [Hill],
// as restated by [Hearn-2]: elastic unloading; the axial stress is the middle one, for von Mises the mean of hoop and
// radial stress. Tension is positive. In service the wall yields again at the autofrettage pressure; strength is judged
// by the pressures, because the stresses are not proportional to the pressure. Not covered: hardening, a Bauschinger
// effect that grows with the strain, machining after autofrettage, relaxation by heat, ends, openings, fatigue.
#pragma once

#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Autofrettage {
  static constexpr auto id = "vessel.autofrettage";
  static constexpr auto title = "Autofrettage of a thick-walled cylinder";
  static constexpr auto scope =
      "Plastic radius, residual stresses, reverse yielding and elastic pressure of a cylinder after autofrettage, "
      "ideally "
      "plastic, by Tresca or von Mises; hardening, machining after autofrettage, heat, openings and fatigue are not "
      "covered.";
  static constexpr auto source = "[Hill], [Hearn-2], [Lame], [Mises]";
  static constexpr auto headline = "p_A = {p_A}, r_p = {r_p}";
  static constexpr auto subject = "autofrettage";
  static constexpr auto synonyms =
      "autofrettage, overstrain, elastic-plastic cylinder, residual stresses, prestressed cylinder, self-hooping, gun "
      "barrel, high-pressure tube, injection line, Bauschinger effect, reverse yielding, shakedown, "
      "Autofrettage, Kaltreckung, Eigenspannungen, автофреттаж, автоскрепление, остаточные напряжения";
  static constexpr auto example = R"([project]
title = "Intensifier cylinder"

[cylinder]
calculator = "vessel.autofrettage"
p = "300 MPa"
R_i = "50 mm"
R_a = "100 mm"
r_p = "70 mm"
R_e = "850 MPa"
f_B = 0.7
S = 1.5
)";

  enum class Ends { closed, open };

  struct Input {
    Stress p = unset<Stress>;
    Length R_i = unset<Length>, R_a = unset<Length>;
    Stress p_A = unset<Stress>;
    Length r_p = unset<Length>;
    double w = unset<double>;
    Ends ends = Ends::closed;
    Stress R_e = unset<Stress>;
    double f_B = unset<double>, S = unset<double>;
    Hypothesis hypothesis = Hypothesis::tresca;
  };
  static constexpr Fields inputs{
      Field{&Input::p, "p", MPa, "internal gauge pressure in service"}.load().positive().usually(1, 1500),
      Field{&Input::R_i, "R_i", mm, "inside radius"}.positive().usually(0.5, 2000),
      Field{&Input::R_a, "R_a", mm, "outside radius"}.positive().usually(1, 4000),
      Field{&Input::p_A, "p_A", MPa, "autofrettage pressure"}.positive().usually(10, 3000).may_be_missing(),
      Field{&Input::r_p, "r_p", mm, "radius of the plastic zone at the autofrettage pressure"}
          .positive()
          .usually(0.5, 4000)
          .may_be_missing(),
      Field{&Input::w, "w", ratio, "overstrain: plastic share of the wall thickness"}
          .within(0, 1)
          .positive()
          .may_be_missing(),
      Choice{&Input::ends, "ends", "end condition: closed or open"}.may_be_missing(),
      Field{&Input::R_e, "R_e", MPa, "yield strength; without hardening"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength),
      Field{&Input::f_B, "f_B", ratio, "yield strength after reversal / yield strength (Bauschinger effect)"}
          .within(0.1, 1)
          .usually(0.3, 0.9)
          .may_be_missing(),
      Field{&Input::S, "S", ratio, "required safety factor against yielding in service"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.5)
          .may_be_missing()
          .factor(),
      Choice{&Input::hypothesis, "hypothesis", "yield criterion: Tresca or von Mises"}.may_be_missing()};

  struct Result {
    double k = unset<double>;
    Stress p_y = unset<Stress>, p_pl = unset<Stress>, p_A = unset<Stress>;
    Length r_p = unset<Length>;
    double w = unset<double>;
    Stress sigma_ri = unset<Stress>, sigma_rp = unset<Stress>, sigma_ra = unset<Stress>;
    Stress sigma_ti = unset<Stress>, sigma_tp = unset<Stress>, sigma_ta = unset<Stress>;
    Stress sigma_vr = unset<Stress>, sigma_v = unset<Stress>;
    Length r_opt = unset<Length>;
    double u_p = unset<double>, u_B = unset<double>, x_k = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::k, "k", ratio, "outside radius / inside radius"},
      Field{&Result::p_y, "p_y", MPa, "internal pressure at first yield, without autofrettage"},
      Field{&Result::p_pl, "p_pl", MPa, "internal pressure at which all of the wall is plastic"},
      Field{&Result::p_A, "p_A", MPa, "autofrettage pressure; in service the wall yields again at this pressure"},
      Field{&Result::r_p, "r_p", mm, "radius of the plastic zone"},
      Field{&Result::w, "w", ratio, "overstrain: plastic share of the wall thickness"},
      Field{&Result::sigma_ri, "sigma_ri", MPa, "residual hoop stress at the bore"},
      Field{&Result::sigma_rp, "sigma_rp", MPa, "residual hoop stress at the radius r_p"},
      Field{&Result::sigma_ra, "sigma_ra", MPa, "residual hoop stress at the outside"},
      Field{&Result::sigma_ti, "sigma_ti", MPa, "hoop stress at the bore in service"},
      Field{&Result::sigma_tp, "sigma_tp", MPa, "hoop stress at the radius r_p in service"},
      Field{&Result::sigma_ta, "sigma_ta", MPa, "hoop stress at the outside in service"},
      Field{&Result::sigma_vr, "sigma_vr", MPa, "residual equivalent stress at the bore"},
      Field{&Result::sigma_v, "sigma_v", MPa, "equivalent stress in service, maximum over the wall"},
      Field{&Result::r_opt, "r_opt", mm, "radius of the plastic zone for the minimum equivalent stress in service"},
      Field{&Result::u_p, "u_p", ratio, "yielding in service: S x pressure / autofrettage pressure"}.check("S"),
      Field{&Result::u_B, "u_B", ratio,
            "reverse yielding: residual equivalent stress at the bore / f_B x yield strength"}
          .check("f_B"),
      Field{&Result::x_k, "x_k", ratio, "outside radius / inside radius (axial stress the middle one)"}.limit(1, 5)};

  static bool yields_partly(const Input& in);
  static FieldFault range_of_pressure(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.R_i < in.R_a; }, "R_i, R_a",
                  "the inside radius must be smaller than the outside radius"},
      Rule<Input>{[](const Input& in) { return is_set(in.p_A) + is_set(in.r_p) + is_set(in.w) == 1; }, "p_A, r_p, w",
                  "give one of the autofrettage pressure p_A, the plastic radius r_p, the overstrain w"},
      Rule<Input>{[](const Input& in) { return !is_set(in.r_p) || (in.r_p > in.R_i && in.r_p <= in.R_a); },
                  "r_p, R_i, R_a", "the plastic radius must be greater than R_i, and at most R_a"},
      Rule<Input>{&yields_partly, "p_A, R_i, R_a, R_e",
                  "the autofrettage pressure must be between that of first yield and that of full plasticity",
                  &range_of_pressure},
      Rule<Input>{[](const Input& in) { return in.hypothesis != Hypothesis::membrane; }, "hypothesis",
                  radial_stress_needed},
      Rule<Input>{[](const Input& in) { return in.ends == Ends::closed || in.hypothesis != Hypothesis::mises; },
                  "ends, hypothesis", "von Mises is for closed ends; with open ends give hypothesis = \"tresca\""}};

  static constexpr Applies has_ends(const Input& in) { return in.ends == Ends::closed ? Applies::unseen : Applies::no; }
  static constexpr std::array meanings{Meaning{"R_e", yield_strength}};
  static constexpr std::array modes = modes_of_wall<Input>(
      Mode<Input>{"strength", "yielding of the wall in service", &always<Input>}.judged_by("u_p, x_k"),
      Mode<Input>{"reverse", "reverse yielding at the bore after autofrettage", &always<Input>}.judged_by("u_B"),
      Mode<Input>{"ends", "strength of the ends", &has_ends}.of_service(),
      Mode<Input>{"heat", "relaxation of the residual stresses due to heat", &unseen<Input>}.special());

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Autofrettage::Ends) {
  using Ends = Autofrettage::Ends;
  return std::array{
      ChoiceName<Ends>{Ends::closed, "closed", "closed ends, which pull at the wall"},
      ChoiceName<Ends>{Ends::open, "open", "open: no axial force, as of a barrel with a piston at each end"}};
}

}  // namespace loadpath::vessel
