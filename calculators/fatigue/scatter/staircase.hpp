// A fatigue limit by a staircase test: its mean and scatter by Dixon and Mood, the strength at a survival probability.
//
// Decides the mean and the standard deviation of the fatigue strength at the cycles of the run-outs from bars that
// were tested one after the other, a step lower after a failure and a step higher after a run-out [DixonMood]: of the
// rarer of both outcomes, of failures less half a step, of run-outs more. Steps are equal in stress or in its
// logarithm, and the strength is normal, or log-normal. The formula of the standard deviation holds from D = 0.3 on,
// which few tests and wide steps do not reach: then it is not reported. S is the stress level of the test, amplitude or
// largest. Not covered: the confidence of a small sample, maximum likelihood, survivals of the tail.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <limits>
#include <vector>

namespace loadpath::fatigue {

struct Staircase {
  static constexpr auto id = "fatigue.staircase";
  static constexpr auto title = "Staircase test evaluation (Dixon-Mood)";
  static constexpr auto scope =
      "Mean and standard deviation of a fatigue limit from a staircase test by Dixon and Mood, scatter T_S, "
      "and the strength at a survival probability; the confidence of a small sample and maximum likelihood are "
      "not covered.";
  static constexpr auto source = "[DixonMood], [ISO12107]";
  static constexpr auto headline = "S_50 = {S_50}";
  static constexpr auto synonyms =
      "staircase method, up-and-down method, Dixon-Mood, fatigue limit test, scatter, survival probability, "
      "Treppenstufenverfahren, Dauerfestigkeitsversuch, метод лестницы";
  static constexpr auto example = R"([project]
title = "Staircase of twenty bars"

[bars]
calculator = "fatigue.staircase"
tests = [
  ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"],
  ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "failure"], ["270 MPa", "runout"],
  ["280 MPa", "runout"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"],
  ["300 MPa", "runout"], ["310 MPa", "failure"], ["300 MPa", "failure"], ["290 MPa", "runout"],
  ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "failure"],
]
P_s = 0.9
)";

  enum class End { failure, runout };
  /// Scale of equal steps.
  enum class Steps { linear, logarithmic };
  static constexpr std::size_t most_tests = 128;

  struct Test {
    Stress S = unset<Stress>;
    End end = End::failure;
    static constexpr Fields fields{Field{&Test::S, "S", MPa, "stress level of the test"}.positive(),
                                   Choice{&Test::end, "end", "result of the test"}};
  };

  struct Input {
    List<Test, most_tests> tests;
    Steps steps = Steps::linear;
    double P_s = 0.9;
  };
  static bool has_both(const Input& in);
  static bool goes_up_and_down(const Input& in);
  static constexpr Fields inputs{
      ListField{&Input::tests, "tests", "tests in their order: stress, \"failure\" or \"runout\""}.as_arrays(),
      Choice{&Input::steps, "steps", "equal steps in stress or in its logarithm"}.may_be_missing(),
      Field{&Input::P_s, "P_s", ratio, "probability of survival of the strength for design, with 50 % confidence"}
          .within(0.5, 0.999)
          .usually(0.9, 0.999)
          .customarily_at_least(0.9)};

  struct Result {
    double n = unset<double>, N = unset<double>;
    double A = unset<double>, B = unset<double>, D = unset<double>;
    Stress d = unset<Stress>, S_50 = unset<Stress>, s = unset<Stress>, S_P = unset<Stress>;
    double q = unset<double>, s_lg = unset<double>, T_S = unset<double>;
    double x_s = unset<double>, x_n = unset<double>, P_f = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::n, "n", ratio, "tests"},
      Field{&Result::N, "N", ratio, "tests with the rarer outcome, which are counted"},
      Field{&Result::A, "A", ratio, "sum of their steps above the lowest of them"},
      Field{&Result::B, "B", ratio, "sum of the squares of these steps"},
      Field{&Result::D, "D", ratio, "(N B - A^2)/N^2: their scatter, in steps squared"},
      Field{&Result::d, "d", MPa, "step in stress"},
      Field{&Result::q, "q", ratio, "step as a ratio of stresses"},
      Field{&Result::S_50, "S_50", MPa, "mean fatigue strength, 50 % survival"},
      Field{&Result::s, "s", MPa, "standard deviation of the strength"},
      Field{&Result::s_lg, "s_lg", ratio, "standard deviation of lg S"},
      Field{&Result::T_S, "T_S", ratio, "scatter: S at 10 % over S at 90 % survival, above 1"},
      Field{&Result::S_P, "S_P", MPa, "strength with survival probability P_s at 50 % confidence; none below 0"},
      Field{&Result::x_s, "x_s", ratio, "D; the formula of the standard deviation applies from 0.3"}.limit(
          0.3 - 1e-9, std::numeric_limits<double>::infinity()),
      Field{&Result::x_n, "x_n", ratio, "number of tests, at least 15 for a scatter"}.limit(15, most_tests),
      Field{&Result::P_f, "P_f", ratio,
            "failure probability of the design strength: below 5 % few tests give no information"}
          .limit(0.05 - 1e-12, 1)};

  static constexpr std::array rules{
      Rule<Input>{&has_both, "tests", "a staircase needs failures and run-outs"},
      Rule<Input>{&goes_up_and_down, "tests, steps",
                  "each test is one step lower after a failure, one higher after a run-out, steps equal in stress, or "
                  "with steps = \"log\" in ratio"}};

  static constexpr std::array meanings{Meaning{"S_50", mean_strength}};
  static constexpr std::array modes{
      Mode<Input>{"scatter", "sample size and step size", &always<Input>}.judged_by("x_s, x_n").of_shape(),
      Mode<Input>{"survival", "survival probability supported by the sample", &always<Input>}
          .judged_by("P_f")
          .of_shape()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Staircase::End) {
  using End = Staircase::End;
  return std::array{ChoiceName<End>{End::failure, "failure", "the specimen failed"},
                    ChoiceName<End>{End::runout, "runout", "run-out"}};
}
constexpr auto choices_of(Staircase::Steps) {
  using S = Staircase::Steps;
  return std::array{ChoiceName<S>{S::linear, "linear", "stress: the strength is normal"},
                    ChoiceName<S>{S::logarithmic, "log", "its logarithm: the strength is log-normal"}};
}

}  // namespace loadpath::fatigue
