// A column without its section: load, length and ends, material, and the governing method. Inputs common to
// column.buckling and column.lightest; their Inputs derive from it, and every field is declared here once.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "calculators/column/member/stability.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"

#include <array>

namespace loadpath::column {

struct Member {
  struct Support {
    Length x = unset<Length>;
    static constexpr Fields fields{Field{&Support::x, "x", mm, "position from the start of the bar"}.positive()};
  };
  using Supports = List<Support, most_supports>;

  Force N = unset<Force>, P = unset<Force>;
  Length l = unset<Length>;
  Ends ends = Ends::unsaid, ends_y = Ends::unsaid, ends_z = Ends::unsaid;
  Basis beta_basis = Basis::exact;
  double beta_y = unset<double>, beta_z = unset<double>;
  Supports supports_y, supports_z;
  Stress E = unset<Stress>, R_e = unset<Stress>, sigma_P = unset<Stress>;
  Stress a_T = unset<Stress>, b_T = unset<Stress>, c_T = unset<Stress>, E_T = unset<Stress>;
  double lambda_0 = unset<double>, lambda_1 = unset<double>;
  Transition transition = Transition::computed;
  Stress sigma_c = unset<Stress>;
  double a_R = unset<double>;
  Length e_y = unset<Length>, e_z = unset<Length>, e_0y = unset<Length>, e_0z = unset<Length>;
  Grade grade = Grade::to_S420;
  Method method = Method::unsaid;
  double n_st = unset<double>, n_t = unset<double>, gamma_M1 = unset<double>, gamma_F = unset<double>, Omega_c = 1.67;
  Class material_class = Class::unsaid;
  double lambda_max = 200.0;
};

/// Whether the load is eccentric, or the bar has an initial bow.
inline bool is_offset_about_y(const Member& in) { return in.e_y > 0.0 * mm.one || in.e_0y > 0.0 * mm.one; }
inline bool is_offset_about_z(const Member& in) { return in.e_z > 0.0 * mm.one || in.e_0z > 0.0 * mm.one; }
/// Whether the input says so of either axis, if only that it does not.
inline bool offset_is_given(const Member& in) {
  return is_set(in.e_y) || is_set(in.e_z) || is_set(in.e_0y) || is_set(in.e_0z);
}

/// The load, and how the bar is held.
template <class Input>
constexpr auto held_inputs() {
  return Fields{RecordField<Input>{"load", "loads of a mechanism link: load = \"=press.links.rod\""},
                Field<Input, Force>{&Input::N, "N", kN, "axial force, positive in tension"}
                    .load()
                    .one_of_body("compression")
                    .keeps_sign()
                    .may_be_missing(),
                Field<Input, Force>{&Input::P, "P", kN, "compressive force, replaces N"}
                    .load()
                    .one_of_body("compression")
                    .at_least(0)
                    .may_be_missing(),
                Field<Input, Length>{&Input::l, "l", mm, "length between the ends"}
                    .of_body()
                    .one_of_body("length")
                    .positive()
                    .usually(10, 1e5)
                    .most(),
                Choice<Input, Ends>{&Input::ends, "ends", "end conditions, about both axes"}
                    .one_of_body("ends_y, ends_z")
                    .may_be_missing(),
                Choice<Input, Ends>{&Input::ends_y, "ends_y", "end conditions for bending about y, replaces ends"}
                    .one_of_body("ends_y")
                    .may_be_missing(),
                Choice<Input, Ends>{&Input::ends_z, "ends_z", "end conditions for bending about z, replaces ends"}
                    .one_of_body("ends_z")
                    .may_be_missing(),
                Choice<Input, Basis>{&Input::beta_basis, "beta_basis",
                                     "basis of the effective length factors: exact or design values"}
                    .may_be_missing(),
                Field<Input, double>{&Input::beta_y, "beta_y", ratio,
                                     "effective length factor about y, replaces the end conditions"}
                    .positive()
                    .one_of_body("ends_y")
                    .made_for_same("l, E, I_y: I")
                    .usually(0.5, 5)
                    .may_be_missing(),
                Field<Input, double>{&Input::beta_z, "beta_z", ratio,
                                     "effective length factor about z, replaces the end conditions"}
                    .positive()
                    .one_of_body("ends_z")
                    .made_for_same("l, E, I_z: I")
                    .usually(0.5, 5)
                    .may_be_missing(),
                ListField<Input, List<Member::Support, most_supports>>{
                    &Input::supports_y, "supports_y", "rigid intermediate supports against bending about y"}
                    .as_arrays()
                    .may_be_missing(),
                ListField<Input, List<Member::Support, most_supports>>{
                    &Input::supports_z, "supports_z", "rigid intermediate supports against bending about z"}
                    .as_arrays()
                    .may_be_missing()};
}

/// Material data of every method.
template <class Input>
constexpr auto strength_inputs() {
  return Fields{
      Field<Input, Stress>{&Input::E, "E", GPa, "modulus of elasticity"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E"),
      Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength"}
          .positive()
          .usually(10, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "t")
          .where_it_has(),
      Field<Input, Stress>{&Input::sigma_P, "sigma_P", MPa, "proportional limit, upper limit of Euler's formula"}
          .positive()
          .usually(5, 2000)
          .may_be_missing()};
}

/// The set of Tetmajer-Yasinsky.
template <class Input>
constexpr auto tetmajer_inputs() {
  return Fields{
      Field<Input, Stress>{&Input::a_T, "a_T", MPa, "constant of Tetmajer-Yasinsky, a_T - b_T lambda + c_T lambda^2"}
          .positive()
          .usually(15, 1500)
          .from("tetmajer", "a_T"),
      Field<Input, Stress>{&Input::b_T, "b_T", MPa, "constant of Tetmajer-Yasinsky"}.positive().usually(0.05, 20).from(
          "tetmajer", "b_T"),
      Field<Input, Stress>{&Input::c_T, "c_T", MPa, "constant of Tetmajer-Yasinsky, 0 for a line"}.at_least(0).from(
          "tetmajer", "c_T"),
      Field<Input, Stress>{&Input::E_T, "E_T", GPa, "modulus of elasticity of the Tetmajer-Yasinsky constants"}
          .positive()
          .usually(5, 240)
          .from("tetmajer", "E_T"),
      Field<Input, double>{&Input::lambda_0, "lambda_0", ratio,
                           "lower slenderness limit of the Tetmajer-Yasinsky constants"}
          .at_least(0)
          .usually(5, 120)
          .from("tetmajer", "lambda_0"),
      Field<Input, double>{&Input::lambda_1, "lambda_1", ratio, "limiting slenderness published with the constants"}
          .positive()
          .usually(40, 200)
          .from("tetmajer", "lambda_1"),
      Choice<Input, Transition>{&Input::transition, "transition",
                                "transition from Tetmajer's formula to Euler's hyperbola"}
          .may_be_missing()};
}

/// Rankine's constants, and the eccentricities and bows of the secant formula.
template <class Input>
constexpr auto rankine_and_secant_inputs() {
  return Fields{
      Field<Input, Stress>{&Input::sigma_c, "sigma_c", MPa,
                           "crushing stress of Rankine's formula; omitted: yield strength"}
          .positive()
          .usually(10, 1500)
          .may_be_missing(),
      Field<Input, double>{&Input::a_R, "a_R", ratio, "constant of Rankine's formula; omitted: sigma_c/(pi^2 E)"}
          .positive()
          .usually(5e-5, 5e-3)
          .may_be_missing(),
      Field<Input, Length>{&Input::e_y, "e_y", mm, "eccentricity causing bending about y"}.at_least(0).may_be_missing(),
      Field<Input, Length>{&Input::e_z, "e_z", mm, "eccentricity causing bending about z"}.at_least(0).may_be_missing(),
      Field<Input, Length>{&Input::e_0y, "e_0y", mm, "initial bow (half sine wave) causing bending about y"}
          .at_least(0)
          .may_be_missing(),
      Field<Input, Length>{&Input::e_0z, "e_0z", mm, "initial bow (half sine wave) causing bending about z"}
          .at_least(0)
          .may_be_missing()};
}

/// Fields with bounds from a material, and factors of the mode in which a column buckles.
inline constexpr std::array member_meanings{Meaning{"sigma_c", crushing_stress},
                                            Meaning{"beta_y, beta_z", factor_of_first_mode}};

/// Material of the bar, and its eccentricities.
template <class Input>
constexpr auto material_inputs() {
  return join(strength_inputs<Input>(), tetmajer_inputs<Input>(), rankine_and_secant_inputs<Input>());
}

/// The method, and its safety.
template <class Input>
constexpr auto method_choice() {
  return Fields{Choice<Input, Grade>{&Input::grade, "grade", "steel grade, for the buckling curve"}.may_be_missing(),
                Choice<Input, Method>{&Input::method, "method", "governing method"}.may_be_missing(),
                Field<Input, double>{&Input::n_st, "n_st", ratio,
                                     "required buckling safety factor (euler, tetmajer, johnson, rankine, secant)"}
                    .at_least(1)
                    .usually(1.5, 10)
                    .customarily_at_least(1.5)
                    .may_be_missing()
                    .factor()};
}

template <class Input>
constexpr auto tension_inputs() {
  return Fields{
      Field<Input, double>{&Input::n_t, "n_t", ratio,
                           "required safety factor of a bar in tension against yielding (ec3: gamma_M0, gamma_F "
                           "applied in addition)"}
          .at_least(1)
          .usually(1, 6)
          .may_be_missing()
          .factor()};
}

/// The factors of the codes, and what goes with every method.
template <class Input>
constexpr auto code_inputs() {
  return Fields{
      Field<Input, double>{&Input::gamma_M1, "gamma_M1", ratio, "partial factor of EN 1993-1-1 and its national annex"}
          .at_least(1)
          .usually(1, 1.2)
          .may_be_missing()
          .factor(),
      Field<Input, double>{&Input::gamma_F, "gamma_F", ratio,
                           "partial factor of actions (ec3); 1 if the force is a design force"}
          .at_least(1)
          .usually(1, 1.6)
          .may_be_missing()
          .factor(),
      Field<Input, double>{&Input::Omega_c, "Omega_c", ratio, "safety factor of AISC 360, E1"}
          .at_least(1)
          .usually(1.5, 2)
          .customarily_at_least(1.5)
          .factor(),
      Choice<Input, Class>{&Input::material_class, "material_class", "material class, for the customary n_st"}
          .may_be_missing(),
      Field<Input, double>{&Input::lambda_max, "lambda_max", ratio, "allowable slenderness"}
          .positive()
          .usually(50, 400)
          .customarily_at_most(250)};
}

/// How it is judged.
template <class Input>
constexpr auto method_inputs() {
  return join(method_choice<Input>(), tension_inputs<Input>(), code_inputs<Input>());
}

}  // namespace loadpath::column
