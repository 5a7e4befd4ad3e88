// A fatigue strength, a life and a knee at another survival probability than they are known at.
//
// Decides how a strength sigma and a life N move from the survival P_0 that they are known at to the survival P: both
// are log-normal, with the scatter T_S of strengths and T_N of lives, each the value at 10 % over that at 90 %
// survival and so above 1; one of them gives the other by the slope of the line, T_N = T_S^k. The knee keeps its
// place on the moved line. P_0 follows from the source of sigma: of single tests 50 %, of FKM 97.5 %. Not covered:
// the uncertainty of T_S from few tests, tails beyond one in a thousand.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"

#include <array>

namespace loadpath::fatigue {

struct Survival {
  static constexpr auto id = "fatigue.survival";
  static constexpr auto title = "Conversion of survival probability";
  static constexpr auto scope =
      "Conversion of a log-normally distributed fatigue strength, life and knee from one survival probability "
      "to another by the scatter T_S or T_N; the confidence of the scatter and tails beyond 0.1 % are not "
      "covered.";
  static constexpr auto source = "[ISO12107], [pylife-tests]";
  static constexpr auto headline = "sigma_P = {sigma_P}|N_P = {N_P}";
  static constexpr auto synonyms =
      "survival probability, failure probability, reliability, scatter, T_S, T_N, log-normal, quantile, "
      "Überlebenswahrscheinlichkeit, Streuung, вероятность неразрушения, рассеяние";
  static constexpr auto example = R"([project]
title = "A fatigue limit of which one in forty fails"

[limit]
calculator = "fatigue.survival"
sigma_0 = "288 MPa"
N_0 = 1e6
T_S = 1.25
k = 5
P = 0.975
)";

  struct Input {
    Stress sigma_0 = unset<Stress>;
    double N_0 = unset<double>, T_S = unset<double>, T_N = unset<double>, k = unset<double>;
    double P_0 = 0.5, P = unset<double>;
  };
  static bool has_one(const Input& in) { return is_set(in.sigma_0) || is_set(in.N_0); }
  static bool has_scatter(const Input& in);
  static constexpr Fields inputs{
      Field{&Input::sigma_0, "sigma_0", MPa, "fatigue strength at the survival P_0"}
          .positive()
          .usually(5, 1500)
          .may_be_missing(),
      Field{&Input::N_0, "N_0", ratio, "life at the survival P_0, at the stress as it is; of the knee its cycles"}
          .at_least(1)
          .usually(1e3, 1e9)
          .may_be_missing(),
      Field{&Input::T_S, "T_S", ratio, "scatter of strengths, S at 10 % over S at 90 % survival"}
          .within(1, 10)
          .usually(1.02, 2)
          .may_be_missing(),
      Field{&Input::T_N, "T_N", ratio, "scatter of lives, N at 10 % over N at 90 % survival"}
          .within(1, 1e4)
          .usually(1.2, 30)
          .may_be_missing(),
      Field{&Input::k, "k", ratio, "slope of the line, N S^k = const"}.within(1, 32).usually(3, 20).may_be_missing(),
      Field{&Input::P_0, "P_0", ratio, "survival probability of the known values"}.within(1e-6, 1 - 1e-6),
      Field{&Input::P, "P", ratio, "required survival probability"}.within(1e-6, 1 - 1e-6).customarily_at_least(0.9)};

  struct Result {
    double T_S = unset<double>, T_N = unset<double>, s_S = unset<double>, s_N = unset<double>, z = unset<double>;
    double f_S = unset<double>, f_N = unset<double>;
    Stress sigma_P = unset<Stress>;
    double N_P = unset<double>, N_D = unset<double>, x_P = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::T_S, "T_S", ratio, "scatter of strengths"},
      Field{&Result::T_N, "T_N", ratio, "scatter of lives"},
      Field{&Result::s_S, "s_S", ratio, "standard deviation of lg S"},
      Field{&Result::s_N, "s_N", ratio, "standard deviation of lg N"},
      Field{&Result::z, "z", ratio, "standard deviations between both survivals"},
      Field{&Result::f_S, "f_S", ratio, "strength at P over that at P_0"},
      Field{&Result::f_N, "f_N", ratio, "life at P over that at P_0"},
      Field{&Result::sigma_P, "sigma_P", MPa, "fatigue strength at the survival P"},
      Field{&Result::N_P, "N_P", ratio, "life at the survival P, at the same stress"},
      Field{&Result::N_D, "N_D", ratio, "knee at the survival P: where the moved line meets the moved strength"},
      Field{&Result::x_P, "x_P", ratio, "the rarer of failure and survival, of both probabilities the smaller"}.limit(
          1e-3 - 1e-12, 0.5)};

  static constexpr std::array rules{
      Rule<Input>{&has_one, "sigma_0, N_0", "a strength or a life is required"},
      Rule<Input>{&has_scatter, "T_S, T_N, k",
                  "a strength needs the scatter T_S, a life T_N; either follows from the other with the slope k"}};

  static constexpr std::array modes{
      Mode<Input>{"tail", "validity: survival probability", &always<Input>}.judged_by("x_P").of_shape()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::fatigue
