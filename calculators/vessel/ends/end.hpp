// A dished end of a cylindrical vessel under internal pressure: torispherical, ellipsoidal or hemispherical.
//
// Decides the thickness by [EN13445-3], 7.5: membrane stress of the crown, yielding and plastic buckling of the
// knuckle; an ellipsoid counts as the torisphere of the same height. The allowable stress is the lesser of R_e/1.5 and
// R_m/2.4, or sigma_adm. A test loads the new end up to R_e/1.05. Sizes are those of the corroded end; the radii of
// Klöpper and Korbbogen ends follow from the outside diameter. Not covered: external pressure, openings, ends of
// cold-spun austenitic steel, fatigue.
#pragma once

#include "calculators/vessel/ends/end_input.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct End {
  static constexpr auto id = "vessel.end";
  static constexpr auto title = "Dished end of a cylindrical vessel";
  static constexpr auto scope =
      "Thickness of torispherical, ellipsoidal and hemispherical ends under internal pressure by EN 13445-3: crown, "
      "knuckle, straight flange; external pressure, openings, temperature and fatigue are not covered.";
  static constexpr auto source = "[EN13445-3]";
  static constexpr auto headline = "end {delta}";
  static constexpr auto subject = "end under internal pressure";
  static constexpr auto synonyms =
      "dished end, dished head, torispherical head, Klöpper head, Korbbogen head, semi-ellipsoidal head, "
      "hemispherical head, vessel head, knuckle, crown, straight flange, Klöpperboden, Korbbogenboden, gewölbter "
      "Boden, "
      "Krempe, днище, торосферическое днище, эллиптическое днище";
  static constexpr auto example = R"([project]
title = "Klöpper end"

[end]
calculator = "vessel.end"
p = "1 MPa"
D_i = "1980 mm"
form = "kloepper"
c = "1 mm"
l_f = "50 mm"
R_e = "265 MPa"
R_m = "410 MPa"
)";

  enum class Form { kloepper, korbbogen, torispherical, ellipsoidal, hemispherical };

  struct Input : TestInput {
    Stress p = unset<Stress>;
    Length D_i = unset<Length>;
    Form form = Form::kloepper;
    Length R = unset<Length>, r = unset<Length>, h_i = unset<Length>, l_f = unset<Length>;
    Length delta = unset<Length>;
    Length c = from_si<Length>(0.0), c_t = from_si<Length>(0.0);
    double f_t = 0.0, z = 1.0;
    Stress sigma_adm = unset<Stress>, R_e = unset<Stress>, R_m = unset<Stress>;
  };
  static constexpr Fields inputs = join(
      pressure_on_end<Input>(),
      Fields{
          Field{&Input::D_i, "D_i", mm, "inside diameter of the shell, uncorroded"}.positive().usually(50, 20000),
          Choice{&Input::form, "form", "form of the end; Klöpper if omitted"},
          Field{&Input::R, "R", mm, "inside radius of the crown, of a torispherical end"}.positive().may_be_missing(),
          Field{&Input::r, "r", mm, "inside radius of the knuckle, of a torispherical end"}.positive().may_be_missing(),
          Field{&Input::h_i, "h_i", mm, "inside height of an ellipsoidal end, without flange; D_i/4 if omitted"}
              .positive()
              .may_be_missing(),
          Field{&Input::l_f, "l_f", mm, "length of the straight flange"}.at_least(0).usually(0, 200).may_be_missing(),
          Field{&Input::delta, "delta", mm, "nominal wall thickness"}
              .positive()
              .usually(0.5, 400)
              .searched("plate")
              .may_be_missing(),
          Field{&Input::c, "c", mm, "corrosion allowance on the inside"}
              .at_least_that_of_source("c")
              .at_least(0)
              .usually(0, 10),
          Field{&Input::c_t, "c_t", mm, "under-tolerance of the plate and thinning in forming"}.at_least(0).usually(0,
                                                                                                                    5),
          Field{&Input::f_t, "f_t", ratio, "under-tolerance and thinning as a share of delta"}.at_least(0).below(0.5),
          Field{&Input::z, "z", ratio, "efficiency of welds in the crown"}.within(0.3, 1).factor()},
      strength_of_end<Input>(), test_inputs<Input>());

  struct Result : TestResult {
    Stress f = unset<Stress>;
    Length delta_min = unset<Length>, delta = unset<Length>, e = unset<Length>;
    Length D_a = unset<Length>, D_c = unset<Length>, R_c = unset<Length>, r_c = unset<Length>;
    double beta = unset<double>;
    Stress p_s = unset<Stress>, p_y = unset<Stress>, p_b = unset<Stress>, p_max = unset<Stress>;
    double u_s = unset<double>, u_y = unset<double>, u_b = unset<double>, u_f = unset<double>;
    double x_r = unset<double>, x_k = unset<double>, x_e = unset<double>, x_R = unset<double>, x_K = unset<double>;
  };
  static constexpr Fields results = join(
      Fields{
          Field{&Result::f, "f", MPa, "allowable stress"},
          Field{&Result::delta_min, "delta_min", mm, "minimum nominal thickness, allowances included"},
          Field{&Result::delta, "delta", mm, "nominal wall thickness"},
          Field{&Result::e, "e", mm, "analysis thickness: corroded, under-tolerance deducted"},
          Field{&Result::D_a, "D_a", mm, "outside diameter"},
          Field{&Result::D_c, "D_c", mm, "inside diameter, corroded"},
          Field{&Result::R_c, "R_c", mm, "inside radius of the crown, corroded"},
          Field{&Result::r_c, "r_c", mm, "inside radius of the knuckle, corroded"},
          Field{&Result::beta, "beta", ratio, "stress factor of the knuckle"},
          Field{&Result::p_s, "p_s", MPa, "allowable pressure of the crown"},
          Field{&Result::p_y, "p_y", MPa, "allowable pressure of the knuckle, yielding"},
          Field{&Result::p_b, "p_b", MPa, "allowable pressure of the knuckle, plastic buckling"},
          Field{&Result::p_max, "p_max", MPa, "allowable pressure of the end, straight flange excluded"},
          Field{&Result::u_s, "u_s", ratio, "crown: pressure / allowable pressure"}.check(),
          Field{&Result::u_y, "u_y", ratio, "knuckle, yielding: pressure / allowable pressure"}
              .check()
              .where_it_applies(),
          Field{&Result::u_b, "u_b", ratio, "knuckle, buckling: pressure / allowable pressure"}
              .check("R_e")
              .where_it_applies(),
          Field{&Result::u_f, "u_f", ratio, "straight flange as a cylinder: pressure / allowable pressure"}.check(
              "l_f"),
          Field{&Result::x_r, "x_r", ratio, "knuckle radius / inside diameter"}
              .limit(0.06 * (1 - 1e-9), 0.2 * (1 + 1e-9))
              .where_it_applies(),
          Field{&Result::x_k, "x_k", ratio, "knuckle radius / thickness"}.limit(2 * (1 - 1e-9), 1e6).where_it_applies(),
          Field{&Result::x_e, "x_e", ratio, "thickness / outside diameter"}.limit(0.001 * (1 - 1e-9),
                                                                                  0.08 * (1 + 1e-9)),
          Field{&Result::x_R, "x_R", ratio, "crown radius of the new end / outside diameter"}.limit(0, 1 + 1e-9),
          Field{&Result::x_K, "x_K", ratio, "inside diameter / height of two semi-ellipsoids"}
              .limit(1.7 * (1 - 1e-9), 2.2 * (1 + 1e-9))
              .where_it_applies()},
      test_results<Result>());

  static constexpr std::array rules = join(
      std::array{
          Rule<Input>{
              [](const Input& in) { return (in.form == Form::torispherical) == (is_set(in.R) && is_set(in.r)); },
              "form, R, r", "the radii R and r are those of form = \"torispherical\", which needs both"},
          Rule<Input>{[](const Input& in) { return is_set(in.R) == is_set(in.r); }, "R, r",
                      "give the radii of crown and knuckle, R and r, both"},
          Rule<Input>{[](const Input& in) { return !is_set(in.R) || (in.R > in.r && 2.0 * in.r < in.D_i); },
                      "R, r, D_i", "the knuckle radius must be smaller than the crown radius and half of D_i"},
          Rule<Input>{[](const Input& in) { return !is_set(in.R) || 2.0 * in.R >= in.D_i; }, "R, D_i",
                      "the crown radius is at least half of D_i"},
          Rule<Input>{[](const Input& in) { return in.form == Form::ellipsoidal || !is_set(in.h_i); }, "h_i, form",
                      "h_i is the height of form = \"ellipsoidal\""},
          Rule<Input>{[](const Input& in) { return is_set(in.sigma_adm) || (is_set(in.R_e) && is_set(in.R_m)); },
                      "sigma_adm, R_e, R_m", "give sigma_adm, or R_e and R_m (or a material)"},
          Rule<Input>{[](const Input& in) { return in.c_t == 0.0 * mm || in.f_t == 0.0; }, "c_t, f_t",
                      "give the under-tolerance as c_t or as f_t, not both"},
          Rule<Input>{[](const Input& in) { return !is_set(in.delta) || in.delta * (1.0 - in.f_t) > in.c + in.c_t; },
                      "delta, c, c_t, f_t", "the wall must be thicker than its allowances"}},
      test_rules<Input>());

  static constexpr Applies has_knuckle(const Input& in) { return where(in.form != Form::hemispherical); }
  static Applies has_flange(const Input& in) { return shown_by(is_set(in.l_f) && in.l_f > 0.0 * mm); }
  static constexpr std::array meanings = wall_meanings;
  static constexpr std::array modes = modes_of_tested_wall<Input>(
      Mode<Input>{"strength", "yielding of crown and knuckle", &always<Input>}.judged_by(
          "u_s, u_y, x_r, x_k, x_e, x_R, x_K"),
      test_mode<Input>(), test_level_mode<Input>(),
      Mode<Input>{"knuckle", "plastic buckling of the knuckle", &has_knuckle}.judged_by("u_b"),
      Mode<Input>{"flange", "yielding of the straight flange", &has_flange}.judged_by("u_f").special());

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(End::Form) {
  using Form = End::Form;
  return std::array{ChoiceName<Form>{Form::kloepper, "kloepper", "Klöpper: R = D_a, r = 0.1 D_a (DIN 28011)"},
                    ChoiceName<Form>{Form::korbbogen, "korbbogen", "Korbbogen: R = 0.8 D_a, r = 0.154 D_a (DIN 28013)"},
                    ChoiceName<Form>{Form::torispherical, "torispherical", "torispherical, of the radii R and r"},
                    ChoiceName<Form>{Form::ellipsoidal, "ellipsoidal", "semi-ellipsoidal, of the height h_i"},
                    ChoiceName<Form>{Form::hemispherical, "hemispherical", "half of a sphere"}};
}

}  // namespace loadpath::vessel
