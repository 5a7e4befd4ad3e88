// Common vessel data: pressure, wall, seams and strength as inputs, stresses and thicknesses as results, and the
// rules between them. The Inputs and Results of the shapes derive from these; every field is declared here once.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::vessel {

using Density = decltype(Mass() / SectionModulus());
inline constexpr Unit<Density> kg_per_m3{"kg/m^3", from_si<Density>(1.0)};

enum class Measured { mean, inner, outer };
enum class Hypothesis { tresca, mises, membrane };

struct WallInput {
  Stress p = unset<Stress>;
  Length delta = unset<Length>;
  Length c = from_si<Length>(0.0), c_t = from_si<Length>(0.0);
  double f_t = 0.0, z_l = 1.0, z_c = 1.0;
  Stress sigma_adm = unset<Stress>, R_e = unset<Stress>;
  double S = unset<double>;
  Measured measured = Measured::mean;
  Hypothesis hypothesis = Hypothesis::tresca;
};

/// A liquid in addition to the gas: its surface lies h_l above the lowest point of the shell.
struct Liquid {
  Density rho = unset<Density>;
  Length h_l = unset<Length>;
};

/// Whether a wall that is given leaves room inside of a radius, to the surface that `measured` says.
inline bool leaves_room(const WallInput& in, Length radius) {
  if (!is_set(in.delta) || in.measured == Measured::inner) return true;
  return radius > (in.measured == Measured::outer ? 1.0 : 0.5) * in.delta;
}

struct WallResult {
  Stress sigma_all = unset<Stress>;
  Length delta_min = unset<Length>, delta = unset<Length>, delta_c = unset<Length>;
  Stress p_i = unset<Stress>, sigma_o = unset<Stress>, sigma_M = unset<Stress>, sigma_v = unset<Stress>;
  Stress p_max = unset<Stress>;
  double t_R = unset<double>, u_v = unset<double>;
};

/// The pressures of a vessel that a head without a liquid of its own belongs to: nothing says that it is the upper one.
inline constexpr auto pressure_below = "p, p_i";

/// A cylinder at its ends, input record of vessel.end: shell = "=tank.shell". Set for a cylinder with ends only. The
/// pressure is that at the lowest place: gas and liquid.
struct ShellOfEnds {
  Stress p = unset<Stress>;
  Length D_i = unset<Length>, c = unset<Length>;

  static constexpr Fields fields{Field{&ShellOfEnds::p, "p", MPa, "pressure on the lower end"}.load(),
                                 Field{&ShellOfEnds::D_i, "D_i", mm, "inside diameter of the new shell"},
                                 Field{&ShellOfEnds::c, "c", mm, "corrosion allowance on the inside"}};
};

/// The wall of a cylinder with all its allowances, input record of vessel.external: wall = "=tank.wall".
struct WallOutside {
  Length D_a = unset<Length>, delta = unset<Length>, c = unset<Length>, c_t = unset<Length>;
  double f_t = unset<double>;

  static constexpr Fields fields{Field{&WallOutside::D_a, "D_a", mm, "outside diameter"},
                                 Field{&WallOutside::delta, "delta", mm, "nominal wall thickness"},
                                 Field{&WallOutside::c, "c", mm, "corrosion allowance on the inside"},
                                 Field{&WallOutside::c_t, "c_t", mm, "mill under-tolerance of the plate"},
                                 Field{&WallOutside::f_t, "f_t", ratio, "mill under-tolerance as a share of delta"}};
};

/// `pressures`: of a vessel that the wall belongs to. A bottom with a liquid has that of the vessel above it on top.
template <class Input>
constexpr auto wall_inputs(const char* pressures = "p") {
  return Fields{
      Field<Input, Stress>{&Input::p, "p", MPa, "internal gauge pressure of the gas"}
          .load()
          .at_least_that_of_source(pressures)
          .one_of_body("pressure")
          .at_least(0)
          .usually(0, 100),
      Field<Input, Length>{&Input::delta, "delta", mm, "nominal wall thickness"}
          .positive()
          .usually(0.5, 400)
          .searched("plate")
          .may_be_missing(),
      Field<Input, Length>{&Input::c, "c", mm, "corrosion allowance on the inside"}
          .at_least_that_of_source("c")
          .one_of_body("allowance")
          .at_least(0)
          .usually(0, 10),
      Field<Input, Length>{&Input::c_t, "c_t", mm, "mill under-tolerance of the plate"}.at_least(0).usually(0, 3),
      Field<Input, double>{&Input::f_t, "f_t", ratio, "mill under-tolerance as a share of delta; 0.125 for pipes"}
          .at_least(0)
          .below(0.5),
      Field<Input, double>{&Input::z_l, "z_l", ratio, "joint efficiency of longitudinal seams (hoop stress)"}
          .within(0.3, 1)
          .factor(),
      Field<Input, double>{&Input::z_c, "z_c", ratio, "joint efficiency of circumferential seams (meridional stress)"}
          .within(0.3, 1)
          .factor(),
      Field<Input, Stress>{&Input::sigma_adm, "sigma_adm", MPa, "allowable stress (safety factor included)"}
          .positive()
          .usually(10, 1000)
          .customarily_at_most(400)
          .may_be_missing(),
      Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength, with S in place of sigma_adm"}
          .positive()
          .usually(50, 1100)
          .customarily_at_most(960)
          .from("material", "R_e", "delta", "sigma_adm"),
      Field<Input, double>{&Input::S, "S", ratio, "safety factor against yielding, with R_e"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.5)
          .may_be_missing()
          .factor(),
      Choice<Input, Measured>{&Input::measured, "measured", "reference surface of the radii"}.may_be_missing(),
      Choice<Input, Hypothesis>{&Input::hypothesis, "hypothesis", "failure theory of the equivalent stress"}
          .may_be_missing()};
}

/// Fields with bounds from a material.
inline constexpr std::array wall_meanings{Meaning{"sigma_adm", allowable_in_normal}};
/// The radius of a head is that of a shell with closed ends.
inline constexpr auto radius_when_closed = "the radius of a shell with closed ends";
inline constexpr auto radius_when_open = "the radius of an open pipe";

template <class Input>
constexpr auto liquid_inputs(const char* level) {
  return Fields{Field<Input, Density>{&Input::rho, "rho", kg_per_m3, "density of the liquid, with h_l"}
                    .load()
                    .positive()
                    .usually(500, 14000)
                    .customarily_at_least(400)
                    .may_be_missing(),
                Field<Input, Length>{&Input::h_l, "h_l", mm, level}.at_least(0).may_be_missing()};
}

/// `thinnest`: the largest thickness of a thin wall, over the mean radius of curvature.
template <class Result>
constexpr auto wall_results(double thinnest = 0.05) {
  return Fields{
      Field<Result, Stress>{&Result::sigma_all, "sigma_all", MPa, "allowable stress"},
      Field<Result, Length>{&Result::delta_min, "delta_min", mm, "minimum nominal thickness, allowances included"},
      Field<Result, Length>{&Result::delta, "delta", mm, "nominal wall thickness"},
      Field<Result, Length>{&Result::delta_c, "delta_c", mm, "analysis thickness: corroded, under-tolerance deducted"},
      Field<Result, Stress>{&Result::p_i, "p_i", MPa, "pressure at the governing location"},
      Field<Result, Stress>{&Result::sigma_o, "sigma_o", MPa, "hoop stress at the governing location"},
      Field<Result, Stress>{&Result::sigma_M, "sigma_M", MPa, "meridional stress at the governing location"},
      Field<Result, Stress>{&Result::sigma_v, "sigma_v", MPa,
                            "equivalent stress at the governing location, seams included"},
      Field<Result, Stress>{&Result::p_max, "p_max", MPa, "allowable gas pressure at the thickness"},
      Field<Result, double>{&Result::t_R, "t_R", ratio, "thin wall: thickness / mean radius of curvature"}.limit(
          0, thinnest * (1 + 1e-12)),
      Field<Result, double>{&Result::u_v, "u_v", ratio, "strength: equivalent stress / allowable stress"}.check()};
}

/// Up to 1/10 the membrane stresses at the mean radius with the pressure at the inside are those of [Lame] within 0.3 %
/// for Tresca and von Mises; without that pressure they are 10 % too low.
inline constexpr double round_and_thin = 0.1;
template <class Result>
constexpr auto thin_by_membrane() {
  return Field<Result, double>{&Result::t_M, "t_M", ratio,
                               "thin wall by membrane stresses only: thickness / mean radius of curvature"}
      .limit(0, 0.05 * (1 + 1e-12))
      .where_it_applies();
}

/// Shallowness, for results with x_s.
template <class Result>
constexpr auto shallowness() {
  return Field<Result, double>{
      &Result::x_s, "x_s", ratio,
      "shallowness: widest radius over the root of curvature radius and thickness; a flat dish "
      "carries by bending"}
      .limit(4 * (1 - 1e-9), 1e6);
}

template <class Input>
constexpr auto wall_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return is_set(in.sigma_adm) || (is_set(in.R_e) && is_set(in.S)); },
                  "sigma_adm, R_e, S", "give sigma_adm, or S with the yield strength R_e (or a material)"},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_adm) || !(is_set(in.S) || is_set(in.R_e)); },
                  "sigma_adm, R_e, S", "sigma_adm includes the safety factor: give sigma_adm, or R_e with S, not both"},
      Rule<Input>{[](const Input& in) { return in.c_t == 0.0 * mm || in.f_t == 0.0; }, "c_t, f_t",
                  "give the under-tolerance as c_t or as f_t, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.delta) || in.delta * (1.0 - in.f_t) > in.c + in.c_t; },
                  "delta, c, c_t, f_t", "the wall must be thicker than its allowances"}};
}

/// Requirement of thick walls: Tresca or von Mises.
inline constexpr auto radial_stress_needed =
    "a thick wall needs a radial stress: give hypothesis = \"tresca\" or \"mises\"";

/// The hydrostatic test before service.
struct TestInput {
  Stress p_t = unset<Stress>;
  Length h_t = unset<Length>;
  Stress R_e_t = unset<Stress>;
};

template <class Input>
constexpr auto test_inputs() {
  return Fields{
      Field<Input, Stress>{&Input::p_t, "p_t", MPa, "test pressure at the top of the vessel"}
          .positive()
          .usually(0.01, 200)
          .may_be_missing(),
      Field<Input, Length>{&Input::h_t, "h_t", mm,
                           "height of the test water above the lowest point of the part; 0: gas"}
          .at_least(0)
          .usually(0, 50000)
          .may_be_missing(),
      Field<Input, Stress>{&Input::R_e_t, "R_e_t", MPa, "yield strength at the temperature of the test; R_e if omitted"}
          .positive()
          .usually(50, 1100)
          .customarily_at_most(960)
          .may_be_missing()};
}

struct TestResult {
  Stress f_test = unset<Stress>, p_tr = unset<Stress>;
  double u_t = unset<double>, u_tr = unset<double>;
};

template <class Result>
constexpr auto test_results() {
  return Fields{
      Field<Result, Stress>{&Result::f_test, "f_test", MPa, "allowable stress in the test"},
      Field<Result, Stress>{&Result::p_tr, "p_tr", MPa, "required test pressure at the top of the vessel"},
      Field<Result, double>{&Result::u_t, "u_t", ratio, "test: utilisation of the new wall at the test pressure"}.check(
          "p_t"),
      Field<Result, double>{&Result::u_tr, "u_tr", ratio, "test: required / given test pressure"}.check("p_t")};
}

template <class Input>
constexpr auto test_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return !is_set(in.p_t) || is_set(in.R_e_t) || is_set(in.R_e); },
                                "p_t, R_e_t, R_e", "a test needs the yield strength R_e_t, or R_e"},
                    Rule<Input>{[](const Input& in) { return is_set(in.p_t) == is_set(in.h_t); }, "p_t, h_t",
                                "a test needs its pressure p_t and the height h_t of its water, 0 for gas"},
                    Rule<Input>{[](const Input& in) { return !is_set(in.R_e_t) || is_set(in.p_t); }, "R_e_t, p_t",
                                "R_e_t is the yield strength in the test: give its pressure p_t"}};
}

template <class Input>
constexpr auto liquid_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return is_set(in.rho) == is_set(in.h_l); }, "rho, h_l",
                                "a liquid needs both its density rho and the height h_l of its surface"},
                    Rule<Input>{[](const Input& in) { return in.p > 0.0 * MPa || in.h_l > 0.0 * mm; }, "p, rho, h_l",
                                "give a pressure p, or a liquid by rho and h_l"}};
}

template <class Input>
constexpr auto gas_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return in.p > 0.0 * MPa; }, "p", "the pressure must be greater than zero"}};
}

template <class Input>
bool has_liquid(const Input& in) {
  if constexpr (requires { in.rho; }) return is_set(in.rho);
  return false;
}

constexpr auto choices_of(Measured) {
  return std::array{ChoiceName<Measured>{Measured::mean, "mean", "middle of the nominal wall"},
                    ChoiceName<Measured>{Measured::inner, "inner", "inside of the wall, uncorroded"},
                    ChoiceName<Measured>{Measured::outer, "outer", "outside of the wall"}};
}

constexpr auto choices_of(Hypothesis) {
  return std::array{
      ChoiceName<Hypothesis>{Hypothesis::tresca, "tresca", "Tresca, with the radial stress -p at the inside"},
      ChoiceName<Hypothesis>{Hypothesis::mises, "mises", "von Mises, with the radial stress -p at the inside"},
      ChoiceName<Hypothesis>{Hypothesis::membrane, "membrane", "the larger membrane stress only, as in the textbook"}};
}

}  // namespace loadpath::vessel
