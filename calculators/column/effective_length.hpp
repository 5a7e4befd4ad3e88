// The effective length of a column whose ends are held by springs, with rigid supports between them.
//
// Decides beta = s/l from the smallest root of the characteristic equation of the uniform bar: ends that are hinged,
// built in, guided, free or elastic (against turning, across the bar, or both), or the stiffness ratios G of the
// joints of a frame, braced or free to sway. Elastic, central load, all columns of a frame buckle together (the
// assumption of the alignment charts). A higher mode, `mode`, is shown in addition: a column reaches it only where the
// lower ones are prevented, so that its factor is not that of column.buckling. Not covered: bars of changing section or
// force, elastic supports between the ends.
#pragma once

#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/stability.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::column {

struct EffectiveLength {
  static constexpr auto id = "column.effective_length";
  static constexpr auto title = "Effective length of a column";
  static constexpr auto scope =
      "Effective length factor of a uniform column from end stiffnesses and intermediate supports, as the "
      "smallest root of the characteristic equation, or of braced and sway frames from joint stiffness ratios; "
      "columns of variable section or force are not covered.";
  static constexpr auto source = "[B25], [Wittrick], [AISC-alignment]";
  static constexpr auto headline = "beta = {beta}";
  static constexpr auto synonyms =
      "effective length, effective length factor, buckling length, K factor, alignment chart, braced frame, "
      "sway frame, elastic restraint, Knicklänge, Knicklängenbeiwert, расчётная длина, коэффициент приведения длины";
  static constexpr auto example = R"([project]
title = "Rod in a flexible bracket"

[rod]
calculator = "column.effective_length"
l = "1.2 m"
E = "210 GPa"
I = "83300 mm^4"
end_1 = "elastic"
c_1 = "40 kN*m/rad"
end_2 = "pinned"
)";

  enum class End { unsaid, pinned, fixed, guided, free, elastic };
  enum class Frame { unsaid, braced, sway };

  struct Support {
    Length x = unset<Length>;
    static constexpr Fields fields{Field{&Support::x, "x", mm, "position from the first end"}.positive()};
  };

  struct Input {
    Length l = unset<Length>;
    Stress E = unset<Stress>;
    SecondMoment I = unset<SecondMoment>;
    End end_1 = End::unsaid, end_2 = End::unsaid;
    Moment c_1 = unset<Moment>, c_2 = unset<Moment>;
    Stiffness k_1 = unset<Stiffness>, k_2 = unset<Stiffness>;
    double G_1 = unset<double>, G_2 = unset<double>;
    Frame frame = Frame::unsaid;
    Whole mode = 1;
    List<Support, most_supports> supports;
  };
  static constexpr Fields inputs{
      Field{&Input::l, "l", mm, "length between the ends"}.positive().usually(10, 1e5),
      Field{&Input::E, "E", GPa, "modulus of elasticity, for elastic ends"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E"),
      Field{&Input::I, "I", mm4, "second moment of area about the buckling axis, for elastic ends"}
          .positive()
          .may_be_missing(),
      Choice{&Input::end_1, "end_1", "condition of the first end"}.may_be_missing(),
      Choice{&Input::end_2, "end_2", "condition of the second end"}.may_be_missing(),
      Field{&Input::c_1, "c_1", N_m_per_rad, "rotational stiffness of the first end; omitted: 0"}
          .at_least(0)
          .may_be_missing(),
      Field{&Input::c_2, "c_2", N_m_per_rad, "rotational stiffness of the second end; omitted: 0"}
          .at_least(0)
          .may_be_missing(),
      Field{&Input::k_1, "k_1", N_per_mm, "lateral stiffness of the first end; omitted: rigid"}
          .at_least(0)
          .may_be_missing(),
      Field{&Input::k_2, "k_2", N_per_mm, "lateral stiffness of the second end; omitted: rigid"}
          .at_least(0)
          .may_be_missing(),
      Field{&Input::G_1, "G_1", ratio,
            "stiffness ratio at the first joint of a frame: sum of E I/L of the columns / of the beams"}
          .at_least(0)
          .usually(0.1, 100)
          .may_be_missing(),
      Field{&Input::G_2, "G_2", ratio, "stiffness ratio at the second joint of a frame; hinge: infinite, use 10"}
          .at_least(0)
          .usually(0.1, 100)
          .may_be_missing(),
      Choice{&Input::frame, "frame", "frame type, with G_1 and G_2: braced or sway"}.may_be_missing(),
      Count{&Input::mode, "mode", 1, 20, "buckling mode of u_n, beta_n and N_cr_n; 1: only the first, which governs"}
          .may_be_missing(),
      ListField{&Input::supports, "supports", "rigid intermediate supports"}.as_arrays().may_be_missing()};

  struct Result {
    double kappa_1 = unset<double>, kappa_2 = unset<double>, mu_1 = unset<double>, mu_2 = unset<double>;
    double u = unset<double>, beta = unset<double>;
    Length s = unset<Length>;
    Force N_cr = unset<Force>;
    double u_n = unset<double>, beta_n = unset<double>;
    Force N_cr_n = unset<Force>;
  };
  static constexpr Fields results{
      Field{&Result::kappa_1, "kappa_1", ratio, "relative rotational stiffness of the first end: c_1/(E I/l)"}
          .where_it_applies(),
      Field{&Result::kappa_2, "kappa_2", ratio, "relative rotational stiffness of the second end: c_2/(E I/l)"}
          .where_it_applies(),
      Field{&Result::mu_1, "mu_1", ratio, "relative lateral stiffness of the first end: k_1/(E I/l^3)"}
          .where_it_applies(),
      Field{&Result::mu_2, "mu_2", ratio, "relative lateral stiffness of the second end: k_2/(E I/l^3)"}
          .where_it_applies(),
      Field{&Result::u, "u", ratio, "l sqrt(N_cr/(E I)); none for a kinematically unstable bar"}.limit(1e-3, 1e3),
      Field{&Result::beta, "beta", ratio, "effective length factor"},
      Field{&Result::s, "s", mm, "effective length"},
      Field{&Result::N_cr, "N_cr", kN, "elastic critical force"}.where_it_applies(),
      Field{&Result::u_n, "u_n", ratio, "l sqrt(N_cr_n/(E I)) of the mode"}.where_it_applies(),
      Field{&Result::beta_n, "beta_n", ratio, "effective length factor of the mode"}.where_it_applies(),
      Field{&Result::N_cr_n, "N_cr_n", kN,
            "elastic critical force of the mode, reached if the lower ones are prevented"}
          .where_it_applies()};

  static bool ends_or_frame(const Input& in);
  static bool springs_fit_ends(const Input& in);
  static bool supports_inside(const Input& in);
  static bool is_held(const Input& in);
  static FieldFault loose_end(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{&ends_or_frame, "end_1, end_2, G_1, G_2",
                  "give both end conditions, end_1 and end_2, or G_1 and G_2 of a frame, not both"},
      Rule<Input>{[](const Input& in) { return in.frame != Frame::sway || is_set(in.G_1); }, "frame, G_1, G_2",
                  "a sway frame needs G_1 and G_2"},
      Rule<Input>{[](const Input& in) { return in.frame != Frame::unsaid || !is_set(in.G_1); }, "frame, G_1",
                  "give the frame type: frame = \"braced\" or frame = \"sway\""},
      Rule<Input>{&springs_fit_ends, "end_1, end_2, c_1, c_2, k_1, k_2",
                  "springs c and k belong to an elastic end, which needs at least one"},
      Rule<Input>{[](const Input& in) {
                    const bool elastic = in.end_1 == End::elastic || in.end_2 == End::elastic;
                    return !elastic || (is_set(in.E) && is_set(in.I));
                  },
                  "end_1, end_2, E, I", "springs need E (or a material) and I of the bar"},
      Rule<Input>{&supports_inside, "supports, l", "supports must lie between the ends, in order along the bar"},
      Rule<Input>{&is_held, "end_1, end_2, c_1, c_2, k_1, k_2, supports", "this bar is a mechanism: hold an end",
                  &loose_end}};
  static constexpr std::array meanings{Meaning{"beta", factor_of_first_mode}, Meaning{"beta_n", factor_of_higher_mode}};
  static constexpr std::array modes{
      Mode<Input>{"held", "kinematic stability of the supports", &always<Input>}.judged_by("u").of_shape()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(EffectiveLength::End) {
  using E = EffectiveLength::End;
  return std::array{ChoiceName<E>{E::unsaid, "", "not given"},
                    ChoiceName<E>{E::pinned, "pinned", "pinned (hinged)"},
                    ChoiceName<E>{E::fixed, "fixed", "fixed (built in)"},
                    ChoiceName<E>{E::guided, "guided", "guided: free to translate, fixed against rotation"},
                    ChoiceName<E>{E::free, "free", "free"},
                    ChoiceName<E>{E::elastic, "elastic", "elastic (springs)"}};
}

constexpr auto choices_of(EffectiveLength::Frame) {
  using F = EffectiveLength::Frame;
  return std::array{ChoiceName<F>{F::unsaid, "", "not given"},
                    ChoiceName<F>{F::braced, "braced", "braced against sway"},
                    ChoiceName<F>{F::sway, "sway", "free to sway"}};
}

}  // namespace loadpath::column
