// A Woehler curve from test points: the finite-life line, its scatter, the knee, lives at a survival probability.
//
// Decides the line lg N = A + B lg S by least squares with the life as the dependent variable, over the failures above
// the highest level that has a run-out; the standard deviation of lg N; the slope with its confidence interval; the
// fatigue limit as asymptote, or the conventional strength at N_0 cycles. S is the stress level of the test, amplitude
// or largest, and the answers are of the same. Survival lines lie z s off the mean line: they describe the scatter of
// the population with a confidence of 50 %, without the tolerance factor of a small sample.
// Not covered: run-outs in the regression (maximum likelihood), staircase statistics, lack of fit, lives not tested.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <vector>

namespace loadpath::fatigue {

struct Wohler {
  static constexpr auto id = "fatigue.wohler";
  static constexpr auto title = "S-N (Wöhler) curve from tests";
  static constexpr auto scope =
      "Finite-life line through fatigue test results with its scatter and confidence interval, survival lines, "
      "knee, and fatigue limit or conventional fatigue strength; staircase statistics and extrapolation beyond "
      "the tests are not covered.";
  static constexpr auto source = "[B20], [E739], [ISO12107]";
  static constexpr auto headline = "k = {k}, S_D = {S_D}";
  static constexpr auto synonyms =
      "S-N curve, Wöhler curve, SN curve, Basquin, fatigue tests, regression, scatter, run-out, "
      "survival probability, Wöhlerlinie, Wöhlerversuch, Zeitfestigkeit, Durchläufer, кривая усталости, "
      "кривая Вёлера";
  static constexpr auto example = R"([project]
title = "Rotating bending of smooth bars"

[bars]
calculator = "fatigue.wohler"
tests = [
  ["420 MPa", 38000], ["420 MPa", 52000], ["380 MPa", 91000], ["380 MPa", 127000], ["340 MPa", 262000],
  ["340 MPa", 365000], ["310 MPa", 720000], ["310 MPa", 980000],
  ["290 MPa", 10000000, "runout"], ["280 MPa", 10000000, "runout"],
]
P_s = 0.9
S = "350 MPa"
)";

  enum class End { failure, runout };
  static constexpr std::size_t most_tests = 128;

  struct Test {
    Stress S = unset<Stress>;
    double N = unset<double>;
    End end = End::failure;
    static constexpr Fields fields{
        Field{&Test::S, "S", MPa, "stress level of the test"}.positive(),
        Field{&Test::N, "N", ratio, "cycles to failure, or to the end of the test"}.at_least(1).usually(1, 1e11),
        Choice{&Test::end, "end", "result of the test"}.may_be_missing()};
  };

  struct Input {
    List<Test, most_tests> tests;
    double P_s = 0.9, C = 0.95;
    Stress S = unset<Stress>, S_D = unset<Stress>;
    double N_0 = unset<double>;
  };
  static bool enough(const Input& in);
  static bool spread(const Input& in);
  static bool limit_is_below(const Input& in);
  static Applies has_knee(const Input& in);
  static constexpr Fields inputs{
      ListField{&Input::tests, "tests", "test points: stress, cycles, \"failure\" or \"runout\""}.as_arrays(),
      Field{&Input::P_s, "P_s", ratio, "probability of survival of the line for design, with 50 % confidence"}.within(
          0.5, 0.999),
      Field{&Input::C, "C", ratio, "confidence of the interval of the slope"}.within(0.5, 0.999),
      Field{&Input::S, "S", MPa, "stress at which the life is required"}.load().positive().may_be_missing(),
      Field{&Input::S_D, "S_D", MPa, "fatigue limit, if known from other tests"}.positive().may_be_missing(),
      Field{&Input::N_0, "N_0", ratio, "cycles of the conventional fatigue limit: of non-ferrous metals 1e8"}
          .at_least(1)
          .may_be_missing()};

  struct Result {
    double n = unset<double>, A = unset<double>, B = unset<double>, B_low = unset<double>, B_high = unset<double>;
    double k = unset<double>, s = unset<double>, T_N = unset<double>, T_S = unset<double>, A_P = unset<double>;
    Stress S_D = unset<Stress>;
    double N_D = unset<double>, N_50 = unset<double>, N_P = unset<double>;
    Stress S_0 = unset<Stress>;
    double x_S = unset<double>, x_N = unset<double>, x_0 = unset<double>, x_D = unset<double>, P_f = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::n, "n", ratio, "failures in the regression"},
      Field{&Result::A, "A", ratio, "lg N at S = 1 MPa on the line of 50 % survival"},
      Field{&Result::B, "B", ratio, "slope of lg N over lg S, negative"},
      Field{&Result::B_low, "B_low", ratio, "lower end of the slope's confidence interval"},
      Field{&Result::B_high, "B_high", ratio, "upper end of the slope's confidence interval"},
      Field{&Result::k, "k", ratio, "exponent of the line N S^k = const"},
      Field{&Result::s, "s", ratio, "standard deviation of lg N"},
      Field{&Result::T_N, "T_N", ratio, "scatter of life: N at 10 % over N at 90 % survival, above 1"},
      Field{&Result::T_S, "T_S", ratio, "scatter of strength: S at 10 % over S at 90 % survival, above 1"},
      Field{&Result::A_P, "A_P", ratio, "lg N at S = 1 MPa on the line of survival P_s"},
      Field{&Result::S_D, "S_D", MPa, "fatigue limit: given, or midway between run-outs and failures"},
      Field{&Result::N_D, "N_D", ratio, "cycles of the knee, where the line meets the fatigue limit"},
      Field{&Result::N_50, "N_50", ratio, "life at S, 50 % survival; none at and below the fatigue limit"},
      Field{&Result::N_P, "N_P", ratio, "life at S, survival P_s with 50 % confidence: z s, no tolerance factor"},
      Field{&Result::S_0, "S_0", MPa, "conventional fatigue limit: strength at N_0 cycles, 50 % survival"},
      Field{&Result::x_S, "x_S", ratio, "S within the tested stresses: 0 the lowest, 1 the highest of the regression"}
          .limit(0, 1 + 1e-9, "S"),
      Field{&Result::x_N, "x_N", ratio, "N_0 over the longest life in the regression: no extrapolation"}.limit(
          0, 1 + 1e-9, "N_0"),
      Field{&Result::x_0, "x_0", ratio, "S_0 over the maximum stress in the regression: no extrapolation"}.limit(
          0, 1 + 1e-9, "N_0"),
      Field{&Result::x_D, "x_D", ratio, "cycles of the knee over the longest test: no extrapolation"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Result::P_f, "P_f", ratio,
            "failure probability of the design line: below 5 % few tests give no information"}
          .limit(0.05 - 1e-12, 1)};

  static constexpr std::array rules{
      Rule<Input>{&enough, "tests",
                  "a line with scatter needs at least three failures above the highest stress with a run-out"},
      Rule<Input>{&spread, "tests",
                  "a line needs failures at two stress levels at least, with lives that decrease with stress"},
      Rule<Input>{&limit_is_below, "S_D",
                  "S_D exceeds the lowest stress of the line, where specimens failed; reduce S_D"}};

  static constexpr std::array modes{
      Mode<Input>{"stress", "stress within the tested range", [](const Input& in) { return where(is_set(in.S)); }}
          .judged_by("x_S")
          .of_shape(),
      Mode<Input>{"cycles", "cycles within the tested range", [](const Input& in) { return where(is_set(in.N_0)); }}
          .judged_by("x_N, x_0")
          .of_shape(),
      Mode<Input>{"knee", "knee within the tested range", &has_knee}.judged_by("x_D").of_shape(),
      Mode<Input>{"survival", "survival probability supported by the sample", &always<Input>}
          .judged_by("P_f")
          .of_shape()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Wohler::End) {
  using End = Wohler::End;
  return std::array{ChoiceName<End>{End::failure, "failure", "the specimen failed"},
                    ChoiceName<End>{End::runout, "runout", "run-out"}};
}

}  // namespace loadpath::fatigue
