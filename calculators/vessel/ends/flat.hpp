// A flat end of a cylindrical vessel under internal pressure: a round plate without openings, welded, forged or bolted.
//
// Decides the thickness by [UG-34], with the factor C of the attachment; the allowable stress is the lesser of R_m/3.5
// and R_e/1.5 of that code, or sigma_adm. The new end is assessed at its test pressure by the same formula, up to
// R_e/1.05, which the fully plastic plate exceeds by far. Sizes are those of the corroded end. Not covered: bolts and
// gaskets that bend the end, openings, stays, external pressure, fatigue, the junction with the shell.
#pragma once

#include "calculators/vessel/ends/end_input.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct FlatEnd {
  static constexpr auto id = "vessel.flat_end";
  static constexpr auto title = "Flat end of a cylindrical vessel";
  static constexpr auto scope =
      "Thickness of round flat ends without openings under internal pressure by ASME VIII-1, UG-34, and at test "
      "pressure; "
      "bolts that bend the end, openings, external pressure and fatigue are not covered.";
  static constexpr auto source = "[UG-34]";
  static constexpr auto headline = "end {delta}";
  static constexpr auto subject = "flat end under internal pressure";
  static constexpr auto synonyms =
      "flat end, flat head, unstayed flat head, blind plate, cover, circular plate, UG-34, ebener Boden, Flachboden, "
      "Deckel, Blinddeckel, плоское днище, плоская крышка";
  static constexpr auto example = R"([project]
title = "Flat cover"

[cover]
calculator = "vessel.flat_end"
p = "1 MPa"
D_i = "600 mm"
c = "1 mm"
R_e = "265 MPa"
R_m = "410 MPa"
)";

  enum class Attachment { welded, integral, bolted };

  struct Input : TestInput {
    Stress p = unset<Stress>;
    Length D_i = unset<Length>, delta = unset<Length>;
    Attachment attachment = Attachment::welded;
    double m_r = unset<double>, C = unset<double>;
    Length c = from_si<Length>(0.0), c_t = from_si<Length>(0.0);
    double z = 1.0;
    Stress sigma_adm = unset<Stress>, R_e = unset<Stress>, R_m = unset<Stress>;
  };
  static constexpr Fields inputs = join(
      pressure_on_end<Input>(),
      Fields{Field{&Input::D_i, "D_i", mm, "inside diameter of the shell, or diameter of the seal"}.positive().usually(
                 50, 20000),
             Choice{&Input::attachment, "attachment", "attachment to the shell"}.may_be_missing(),
             Field{&Input::m_r, "m_r", ratio, "required / actual thickness of the shell, of a welded end; 1 if omitted"}
                 .within(0, 1)
                 .positive()
                 .may_be_missing(),
             Field{&Input::C, "C", ratio, "factor of the attachment by the sketch of the code, in place of attachment"}
                 .within(0.1, 0.5)
                 .usually(0.17, 0.5)
                 .may_be_missing(),
             Field{&Input::delta, "delta", mm, "nominal thickness"}
                 .positive()
                 .usually(0.5, 400)
                 .searched("plate")
                 .may_be_missing(),
             Field{&Input::c, "c", mm, "corrosion allowance on the inside"}
                 .at_least_that_of_source("c")
                 .at_least(0)
                 .usually(0, 10),
             Field{&Input::c_t, "c_t", mm, "under-tolerance of the plate"}.at_least(0).usually(0, 5),
             Field{&Input::z, "z", ratio, "efficiency of welds in the end"}.within(0.3, 1).factor()},
      strength_of_end<Input>(), test_inputs<Input>());

  struct Result : TestResult {
    Stress f = unset<Stress>;
    double C_e = unset<double>;
    Length delta_min = unset<Length>, delta = unset<Length>, e = unset<Length>, D_c = unset<Length>;
    Stress p_max = unset<Stress>;
    double u_e = unset<double>, x_e = unset<double>;
  };
  static constexpr Fields results =
      join(Fields{Field{&Result::f, "f", MPa, "allowable stress"},
                  Field{&Result::C_e, "C_e", ratio, "factor of the attachment"},
                  Field{&Result::delta_min, "delta_min", mm, "minimum nominal thickness, allowances included"},
                  Field{&Result::delta, "delta", mm, "nominal thickness"},
                  Field{&Result::e, "e", mm, "analysis thickness: corroded, under-tolerance deducted"},
                  Field{&Result::D_c, "D_c", mm, "inside diameter, corroded"},
                  Field{&Result::p_max, "p_max", MPa, "allowable pressure of the end"},
                  Field{&Result::u_e, "u_e", ratio, "bending: pressure / allowable pressure"}.check(),
                  Field{&Result::x_e, "x_e", ratio, "thickness / diameter (plate theory)"}.limit(0.01, 0.5)},
           test_results<Result>());

  static constexpr std::array rules = join(
      std::array{Rule<Input>{[](const Input& in) { return !is_set(in.m_r) || in.attachment == Attachment::welded; },
                             "m_r, attachment", "m_r is the ratio of the shell at attachment = \"welded\""},
                 Rule<Input>{[](const Input& in) { return !is_set(in.C) || !is_set(in.m_r); }, "C, m_r",
                             "C includes the ratio m_r: give one of them"},
                 Rule<Input>{[](const Input& in) { return is_set(in.sigma_adm) || (is_set(in.R_e) && is_set(in.R_m)); },
                             "sigma_adm, R_e, R_m", "give sigma_adm, or R_e and R_m (or a material)"},
                 Rule<Input>{[](const Input& in) { return !is_set(in.delta) || in.delta > in.c + in.c_t; },
                             "delta, c, c_t", "the end must be thicker than its allowances"}},
      test_rules<Input>());

  static constexpr std::array meanings = wall_meanings;
  static Applies is_bolted(const Input& in) { return shown_by(in.attachment == Attachment::bolted); }
  static constexpr std::array modes = modes_of_tested_wall<Input>(
      Mode<Input>{"strength", "bending of the end", &always<Input>}.judged_by("u_e, x_e"), test_mode<Input>(),
      test_level_mode<Input>(), Mode<Input>{"bolts", "bolts, and their bending of the end", &is_bolted}.special());

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(FlatEnd::Attachment) {
  using Attachment = FlatEnd::Attachment;
  return std::array{
      ChoiceName<Attachment>{Attachment::welded, "welded", "welded to the shell: C = 0.33 m_r, at least 0.2"},
      ChoiceName<Attachment>{Attachment::integral, "integral", "forged with the shell, or flanged: C = 0.17"},
      ChoiceName<Attachment>{Attachment::bolted, "bolted", "bolted with a full-face gasket: C = 0.25"}};
}

}  // namespace loadpath::vessel
