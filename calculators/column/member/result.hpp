// Results common to column.buckling and column.lightest, each declared here once; their Results derive from it.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"

namespace loadpath::column {

/// Range of the modulus of steel, around 210 GPa: the steel codes and their section classes apply within.
inline constexpr Stress steel_modulus = from_si<Stress>(210e9);
inline constexpr double least_steel = 0.85, most_steel = 1.1;

inline constexpr std::size_t most_methods = choices_of(Method{}).size() - 1;  // the last word is none

struct AxisResult {
  Name name;
  Length i = unset<Length>;
  double beta = unset<double>;
  Length s = unset<Length>;
  double lambda = unset<double>;
  Force N_cr = unset<Force>;
  double alpha = unset<double>, lambda_bar = unset<double>, chi = unset<double>;
  double eta = unset<double>, eta_0 = unset<double>;
  Stress sigma_s = unset<Stress>;
  Length w = unset<Length>;
  Stress sigma_max = unset<Stress>;
  static constexpr Fields fields{
      NameField{&AxisResult::name, "name", "buckling axis"},
      Field{&AxisResult::i, "i", mm, "radius of gyration"},
      Field{&AxisResult::beta, "beta", ratio, "effective length factor"},
      Field{&AxisResult::s, "s", mm, "effective length"},
      Field{&AxisResult::lambda, "lambda", ratio, "slenderness"},
      Field{&AxisResult::N_cr, "N_cr", kN, "elastic critical force"},
      Field{&AxisResult::alpha, "alpha", ratio, "imperfection factor of EN 1993-1-1"},
      Field{&AxisResult::lambda_bar, "lambda_bar", ratio, "non-dimensional slenderness of EN 1993-1-1"},
      Field{&AxisResult::chi, "chi", ratio, "reduction factor of EN 1993-1-1"},
      Field{&AxisResult::eta, "eta", ratio, "eccentricity ratio e c/i^2"},
      Field{&AxisResult::eta_0, "eta_0", ratio, "bow ratio e_0 c/i^2"},
      Field{&AxisResult::sigma_s, "sigma_s", MPa, "mean stress at yielding of the extreme fibre"},
      Field{&AxisResult::w, "w", mm, "deflection caused by the force at mid-length of the effective length"},
      Field{&AxisResult::sigma_max, "sigma_max", MPa, "stress of the extreme fibre under the force"}};
};

struct MethodResult {
  Name name;
  Stress sigma_cr = unset<Stress>;
  Force P_cr = unset<Force>;
  double n = unset<double>;
  Force P_all = unset<Force>;
  double u = unset<double>;
  static constexpr Fields fields{
      NameField{&MethodResult::name, "name", "method"},
      Field{&MethodResult::sigma_cr, "sigma_cr", MPa, "critical stress, without safety factor"},
      Field{&MethodResult::P_cr, "P_cr", kN, "critical force, without safety factor"},
      Field{&MethodResult::n, "n", ratio, "safety factor of the method"},
      Field{&MethodResult::P_all, "P_all", kN, "allowable force"},
      Field{&MethodResult::u, "u", ratio, "force / allowable force"}};
};

struct MemberResult {
  Loading loading = Loading::none;
  Force F = unset<Force>;
  Area A = unset<Area>;
  Length t = unset<Length>;
  AxisName axis = AxisName::y;
  double lambda = unset<double>;
  Force N_cr = unset<Force>;
  Stress sigma_E = unset<Stress>;
  double lambda_T = unset<double>, gap = unset<double>, lambda_lim = unset<double>;
  Stress sigma_cr = unset<Stress>;
  Force P_all = unset<Force>;
  double spread = unset<double>;
  Stress sigma_max = unset<Stress>;
  Length w = unset<Length>;
  double n_e = unset<double>;
  Force N_crT = unset<Force>, N_crTF = unset<Force>;
  double lambda_TF = unset<double>, u_TF = unset<double>;
  double u = unset<double>, u_e = unset<double>, u_t = unset<double>, x_t = unset<double>;
  double r_lambda = unset<double>, r_1 = unset<double>, r_0 = unset<double>, r_class = unset<double>,
         x_E = unset<double>;
  List<AxisResult, 2> axes;
  List<MethodResult, most_methods> methods;
};

/// The load, the section and how slender the bar is.
template <class Result>
constexpr auto slenderness_results() {
  return Fields{
      Choice<Result, Loading>{&Result::loading, "loading", "loading: compression or tension"},
      Field<Result, Force>{&Result::F, "F", kN, "compressive force"}.one_of_body("compression"),
      Field<Result, Area>{&Result::A, "A", mm2, "area"},
      Field<Result, Length>{&Result::t, "t", mm,
                            "thickness that selects the material strength; unknown: lowest value of the table"},
      Choice<Result, AxisName>{&Result::axis, "axis", "axis of maximum slenderness"},
      Field<Result, double>{&Result::lambda, "lambda", ratio, "maximum slenderness"},
      Field<Result, Force>{&Result::N_cr, "N_cr", kN, "minimum elastic critical force, without slenderness limit"}};
}

/// Where the formulas end, and what the method that decides allows.
template <class Result>
constexpr auto stress_results() {
  return Fields{
      Field<Result, Stress>{&Result::sigma_E, "sigma_E", MPa,
                            "stress at the elastic critical force, at any slenderness"},
      Field<Result, double>{&Result::lambda_T, "lambda_T", ratio, "upper slenderness limit of Tetmajer's formula"},
      Field<Result, double>{&Result::gap, "gap", ratio,
                            "relative difference of Tetmajer to Euler at the published lambda_1"},
      Field<Result, double>{&Result::lambda_lim, "lambda_lim", ratio, "limiting slenderness of Euler's formula"},
      Field<Result, Stress>{&Result::sigma_cr, "sigma_cr", MPa, "critical stress of the governing method"},
      Field<Result, Force>{&Result::P_all, "P_all", kN, "allowable force of the governing method"},
      Field<Result, double>{&Result::spread, "spread", ratio, "relative spread of the critical stresses of the methods"}
          .informative()};
}

/// The eccentric or bowed bar under its force, by whatever method it is judged.
template <class Result>
constexpr auto eccentric_results() {
  return Fields{
      Field<Result, Stress>{&Result::sigma_max, "sigma_max", MPa,
                            "eccentric or bowed bar: elastic stress of the extreme fibre under the force"}
          .where_it_applies(),
      Field<Result, Length>{&Result::w, "w", mm,
                            "eccentric or bowed bar: deflection caused by the force, at mid-length of the effective "
                            "length (fixed_free: at the free end)"}
          .where_it_applies(),
      Field<Result, double>{&Result::n_e, "n_e", ratio,
                            "eccentric or bowed bar: safety, force at yielding of the extreme fibre / force"}
          .where_it_applies()};
}

/// Buckling by the method that decides.
template <class Result>
constexpr auto buckling_check() {
  return Fields{Field<Result, double>{&Result::u, "u", ratio, "buckling: force / allowable force"}.check("N, P")};
}

template <class Result>
constexpr auto eccentric_check() {
  return Fields{Field<Result, double>{&Result::u_e, "u_e", ratio,
                                      "eccentric load: force / allowable force of the secant formula, if it governs"}
                    .check("N, P")
                    .where_it_applies()};
}

/// Open sections that twist when they buckle.
template <class Result>
constexpr auto twisting_results() {
  return Fields{
      Field<Result, Force>{&Result::N_crT, "N_crT", kN,
                           "elastic critical force of torsional buckling (channel, tee, angle of equal legs)"}
          .where_it_applies(),
      Field<Result, Force>{&Result::N_crTF, "N_crTF", kN, "elastic critical force of torsional-flexural buckling"}
          .where_it_applies(),
      Field<Result, double>{&Result::lambda_TF, "lambda_TF", ratio, "slenderness of torsional-flexural buckling"}
          .where_it_applies(),
      Field<Result, double>{&Result::u_TF, "u_TF", ratio, "torsional-flexural buckling: force / allowable force"}
          .check("N, P")
          .where_it_applies()};
}

template <class Result>
constexpr auto tension_checks() {
  return Fields{
      Field<Result, double>{&Result::u_t, "u_t", ratio, "tension: n_t x stress / yield strength; 0 in compression"}
          .check("n_t")
          .where_it_applies(),
      Field<Result, double>{&Result::x_t, "x_t", ratio, "tension: stress N/A / yield strength; 0 in compression"}
          .limit(0, 1, "N")
          .criterion()};
}

template <class Result>
constexpr auto slenderness_limit() {
  return Fields{
      Field<Result, double>{&Result::r_lambda, "r_lambda", ratio, "slenderness / allowable slenderness; 0 in tension"}
          .check("lambda_max")};
}

/// Slenderness, and where Euler's formula holds.
template <class Result>
constexpr auto slenderness_limits() {
  return join(slenderness_limit<Result>(),
              Fields{Field<Result, double>{&Result::r_1, "r_1", ratio,
                                           "Euler: limiting slenderness / slenderness; 0 in tension"}
                         .limit(0, 1)
                         .where_it_applies()});
}

template <class Result>
constexpr auto tetmajer_limit() {
  return Fields{Field<Result, double>{&Result::r_0, "r_0", ratio,
                                      "Tetmajer without yield strength: lambda_0 / slenderness; 0 in tension"}
                    .limit(0, 1)
                    .where_it_applies()};
}

template <class Result>
constexpr auto class_limit() {
  return Fields{Field<Result, double>{
      &Result::r_class, "r_class", ratio,
      "local buckling: plate slenderness / class 3 limit (aisc: limit of E7); 0 without compression"}
                    .limit(0, 1)
                    .where_it_applies()};
}

template <class Result>
constexpr auto wall_limits() {
  return join(class_limit<Result>(),
              Fields{Field<Result, double>{&Result::x_E, "x_E", ratio,
                                           "modulus / 210 GPa of steel (class 3 limits); 1 without compression"}
                         .limit(least_steel, most_steel)
                         .where_it_applies()});
}

/// The axes, and the methods side by side.
template <class Result>
constexpr auto side_by_side() {
  return Fields{
      ListField<Result, List<AxisResult, 2>>{&Result::axes, "axes", "buckling about y and about z"},
      ListField<Result, List<MethodResult, most_methods>>{&Result::methods, "methods", "all methods in comparison"}
          .informative()};
}

template <class Result>
constexpr auto member_results() {
  return join(slenderness_results<Result>(), stress_results<Result>(), eccentric_results<Result>(),
              buckling_check<Result>(), eccentric_check<Result>(), twisting_results<Result>(), tension_checks<Result>(),
              slenderness_limits<Result>(), tetmajer_limit<Result>(), wall_limits<Result>(), side_by_side<Result>());
}

}  // namespace loadpath::column
