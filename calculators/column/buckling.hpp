// A compressed bar against buckling, by every method that its inputs allow, side by side.
//
// Decides the critical stress and the allowable load about both axes, by Euler, Tetmajer-Yasinsky, Johnson, Rankine,
// the secant formula, EN 1993-1-1 6.3.1 and AISC 360 E3; one of them is chosen for the check. Critical stresses hold no
// safety; each allowable load holds the safety of its own method. Uniform straight bar, central load (but for the
// secant formula), flexural buckling about the principal axes y and z.
// Sign: N is positive in tension, as mechanisms give it; P is positive in compression. Both may be series.
// Not covered: torsional and flexural-torsional buckling (open sections of one symmetry or none), sections of class 4,
// built-up and tapered bars, transverse loads, biaxial eccentricity.
#pragma once

#include "calculators/column/choices.hpp"
#include "calculators/column/stability.hpp"
#include "lib/draw/figure.hpp"
#include "lib/field.hpp"
#include "lib/issue.hpp"
#include "lib/trace.hpp"

#include <array>
#include <vector>

namespace loadpath {

struct Buckling {
  static constexpr auto id = "column.buckling";
  static constexpr auto title = "Compressed bar";
  static constexpr auto scope =
      "Slenderness of a uniform bar about both axes, its critical stress by Euler, Tetmajer-Yasinsky, Johnson, "
      "Rankine, "
      "the secant formula, EN 1993-1-1 and AISC 360 side by side, the allowable load of each with its own safety. "
      "Flexural buckling; torsional buckling, thin-walled sections of class 4 and transverse loads are not covered.";
  static constexpr auto source = "[B25], [Johnson], [Rankine], [Gere], [EN1993-1-1-buckling], [AISC360]";
  static constexpr auto example = R"([project]
title = "Piston rod"

[rod]
calculator = "column.buckling"
P = "40 kN"
l = "900 mm"
d = "45 mm"
ends = "fixed_free"
E = "210 GPa"
R_e = "340 MPa"
sigma_P = "270 MPa"
method = "euler"
n_st = 3
)";

  using Ends = column::Ends;
  using Method = column::Method;

  struct Support {
    Length x = unset<Length>;
    static constexpr std::tuple fields{Field{&Support::x, "x", mm, "place from the start of the bar"}.positive()};
  };
  using Supports = List<Support, column::most_supports>;

  struct Input {
    Force N = unset<Force>, P = unset<Force>;
    Length l = unset<Length>;
    Ends ends = Ends::unsaid, ends_y = Ends::unsaid, ends_z = Ends::unsaid;
    column::Basis beta_basis = column::Basis::exact;
    double beta_y = unset<double>, beta_z = unset<double>;
    Supports supports_y, supports_z;
    Length d = unset<Length>, d_bore = unset<Length>, h = unset<Length>, b = unset<Length>;
    Area A = unset<Area>;
    SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_min = unset<SecondMoment>;
    Length i_y = unset<Length>, i_z = unset<Length>;
    column::Profile kind = column::Profile::unsaid;
    Length t_f = unset<Length>, t_w = unset<Length>, r = unset<Length>;
    Stress E = unset<Stress>, R_e = unset<Stress>, sigma_P = unset<Stress>;
    Stress a_T = unset<Stress>, b_T = unset<Stress>, c_T = unset<Stress>, E_T = unset<Stress>;
    double lambda_0 = unset<double>, lambda_1 = unset<double>;
    column::Transition transition = column::Transition::computed;
    Stress sigma_c = unset<Stress>;
    double a_R = unset<double>;
    Length e_y = unset<Length>, e_z = unset<Length>, c_y = unset<Length>, c_z = unset<Length>;
    column::Curve curve_y = column::Curve::by_kind, curve_z = column::Curve::by_kind;
    column::Grade grade = column::Grade::to_S420;
    Method method = Method::tetmajer;
    double n_st = unset<double>, gamma_M1 = unset<double>, gamma_F = unset<double>, Omega_c = 1.67;
    column::Class material_class = column::Class::unsaid;
    double lambda_max = 200.0;
  };
  static constexpr std::tuple inputs{
      Field{&Input::N, "N", kN, "normal force, positive in tension"}.may_be_missing(),
      Field{&Input::P, "P", kN, "compressive force, in place of N"}.at_least(0).may_be_missing(),
      Field{&Input::l, "l", mm, "length between the ends"}.positive().usually(10, 1e5),
      Choice{&Input::ends, "ends", "how the ends are held, about both axes"}.may_be_missing(),
      Choice{&Input::ends_y, "ends_y", "how the ends are held where the bar bends about y, in place of ends"}
          .may_be_missing(),
      Choice{&Input::ends_z, "ends_z", "how the ends are held where the bar bends about z, in place of ends"}
          .may_be_missing(),
      Choice{&Input::beta_basis, "beta_basis", "where the effective length factors of the ends come from"}
          .may_be_missing(),
      Field{&Input::beta_y, "beta_y", ratio, "effective length factor about y, in place of the ends"}
          .positive()
          .usually(0.3, 5)
          .may_be_missing(),
      Field{&Input::beta_z, "beta_z", ratio, "effective length factor about z, in place of the ends"}
          .positive()
          .usually(0.3, 5)
          .may_be_missing(),
      ListField{&Input::supports_y, "supports_y", "rigid supports between the ends that hinder bending about y"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Input::supports_z, "supports_z", "rigid supports between the ends that hinder bending about z"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of a round bar"}.positive().usually(1, 2000).may_be_missing(),
      Field{&Input::d_bore, "d_bore", mm, "bore of a round bar"}.at_least(0).may_be_missing(),
      Field{&Input::h, "h", mm, "height of the section, along z"}
          .positive()
          .usually(1, 5000)
          .from("section", "h")
          .where_it_has(),
      Field{&Input::b, "b", mm, "width of the section, along y"}
          .positive()
          .usually(1, 5000)
          .from("section", "b")
          .where_it_has(),
      Field{&Input::A, "A", mm2, "area; without it a round bar d or a rectangle b h is meant"}.positive().from(
          "section", "A"),
      Field{&Input::I_y, "I_y", mm4, "second moment of area about y"}.positive().from("section", "I_y").where_it_has(),
      Field{&Input::I_z, "I_z", mm4, "second moment of area about z"}.positive().from("section", "I_z").where_it_has(),
      Field{&Input::I_min, "I_min", mm4, "least second moment of a section whose principal axes are not y, z: an angle"}
          .positive()
          .from("section", "I_min")
          .where_it_has(),
      Field{&Input::i_y, "i_y", mm, "radius of gyration about y, in place of I_y"}.positive().may_be_missing(),
      Field{&Input::i_z, "i_z", mm, "radius of gyration about z, in place of I_z"}.positive().may_be_missing(),
      Choice{&Input::kind, "kind", "kind of section, for the curves of EN 1993-1-1 and local buckling"}
          .may_be_missing(),
      Field{&Input::t_f, "t_f", mm, "thickness of the flange"}.positive().from("section", "t_f").where_it_has(),
      Field{&Input::t_w, "t_w", mm, "thickness of the web or wall"}.positive().from("section", "t_w").where_it_has(),
      Field{&Input::r, "r", mm, "root radius"}.at_least(0).from("section", "r").where_it_has(),
      Field{&Input::E, "E", GPa, "modulus of elasticity"}.positive().usually(1, 500).from("material", "E"),
      Field{&Input::R_e, "R_e", MPa, "yield strength"}
          .positive()
          .usually(10, 2500)
          .from("material", "R_e", "t")
          .where_it_has(),
      Field{&Input::sigma_P, "sigma_P", MPa, "proportional limit, below which Euler's formula holds"}
          .positive()
          .usually(5, 2000)
          .may_be_missing(),
      Field{&Input::a_T, "a_T", MPa, "constant of Tetmajer-Yasinsky, a_T - b_T lambda + c_T lambda^2"}.positive().from(
          "tetmajer", "a_T"),
      Field{&Input::b_T, "b_T", MPa, "constant of Tetmajer-Yasinsky"}.positive().from("tetmajer", "b_T"),
      Field{&Input::c_T, "c_T", MPa, "constant of Tetmajer-Yasinsky, 0 for a line"}.at_least(0).from("tetmajer", "c_T"),
      Field{&Input::E_T, "E_T", GPa, "modulus that the set of Tetmajer-Yasinsky was given with"}.positive().from(
          "tetmajer", "E_T"),
      Field{&Input::lambda_0, "lambda_0", ratio, "slenderness from which the set of Tetmajer-Yasinsky holds"}
          .at_least(0)
          .from("tetmajer", "lambda_0"),
      Field{&Input::lambda_1, "lambda_1", ratio, "limit slenderness that was published with the set"}.positive().from(
          "tetmajer", "lambda_1"),
      Choice{&Input::transition, "transition", "where Euler's hyperbola takes over from Tetmajer's formula"}
          .may_be_missing(),
      Field{&Input::sigma_c, "sigma_c", MPa, "crushing stress of Rankine's formula; the yield strength where missing"}
          .positive()
          .may_be_missing(),
      Field{&Input::a_R, "a_R", ratio, "constant of Rankine's formula; sigma_c/(pi^2 E) where missing"}
          .positive()
          .usually(1e-5, 1e-2)
          .may_be_missing(),
      Field{&Input::e_y, "e_y", mm, "eccentricity that bends the bar about y"}.at_least(0).may_be_missing(),
      Field{&Input::e_z, "e_z", mm, "eccentricity that bends the bar about z"}.at_least(0).may_be_missing(),
      Field{&Input::c_y, "c_y", mm, "distance of the extreme fibre from y; half the height where missing"}
          .positive()
          .may_be_missing(),
      Field{&Input::c_z, "c_z", mm, "distance of the extreme fibre from z; half the width where missing"}
          .positive()
          .may_be_missing(),
      Choice{&Input::curve_y, "curve_y", "buckling curve of EN 1993-1-1 about y"}.may_be_missing(),
      Choice{&Input::curve_z, "curve_z", "buckling curve of EN 1993-1-1 about z"}.may_be_missing(),
      Choice{&Input::grade, "grade", "steel grade, for the buckling curve"}.may_be_missing(),
      Choice{&Input::method, "method", "method that the check goes by"}.may_be_missing(),
      Field{&Input::n_st, "n_st", ratio, "safety against buckling of euler, tetmajer, johnson, rankine and secant"}
          .at_least(1)
          .usually(1.5, 10)
          .may_be_missing()
          .factor(),
      Field{&Input::gamma_M1, "gamma_M1", ratio, "partial factor of EN 1993-1-1 and its national annex"}
          .at_least(1)
          .usually(1, 1.2)
          .may_be_missing()
          .factor(),
      Field{&Input::gamma_F, "gamma_F", ratio, "from the force to the design load of ec3; 1 where it is one already"}
          .at_least(1)
          .usually(1, 1.6)
          .may_be_missing()
          .factor(),
      Field{&Input::Omega_c, "Omega_c", ratio, "safety factor of AISC 360, E1"}.at_least(1).usually(1.5, 2).factor(),
      Choice{&Input::material_class, "material_class", "class of material, for the custom of n_st"}.may_be_missing(),
      Field{&Input::lambda_max, "lambda_max", ratio, "largest slenderness that is allowed"}.positive().usually(50,
                                                                                                               400)};

  struct Axis {
    Name name;
    Length i = unset<Length>;
    double beta = unset<double>;
    Length s = unset<Length>;
    double lambda = unset<double>;
    Force N_cr = unset<Force>;
    double alpha = unset<double>, lambda_bar = unset<double>, chi = unset<double>;
    double eta = unset<double>;
    Stress sigma_s = unset<Stress>;
    static constexpr std::tuple fields{
        NameField{&Axis::name, "name", "axis that the bar bends about"}.as(Role::result),
        Field{&Axis::i, "i", mm, "radius of gyration"}.as(Role::result),
        Field{&Axis::beta, "beta", ratio, "effective length factor"}.as(Role::result),
        Field{&Axis::s, "s", mm, "effective length"}.as(Role::result),
        Field{&Axis::lambda, "lambda", ratio, "slenderness"}.as(Role::result),
        Field{&Axis::N_cr, "N_cr", kN, "critical force of the elastic bar"}.as(Role::result),
        Field{&Axis::alpha, "alpha", ratio, "imperfection factor of EN 1993-1-1"}.as(Role::result),
        Field{&Axis::lambda_bar, "lambda_bar", ratio, "slenderness of EN 1993-1-1"}.as(Role::result),
        Field{&Axis::chi, "chi", ratio, "reduction factor of EN 1993-1-1"}.as(Role::result),
        Field{&Axis::eta, "eta", ratio, "eccentricity ratio e c/i^2"}.as(Role::result),
        Field{&Axis::sigma_s, "sigma_s", MPa, "mean stress at which the extreme fibre yields"}.as(Role::result)};
  };

  struct ByMethod {
    Name name;
    Stress sigma_cr = unset<Stress>;
    Force P_cr = unset<Force>;
    double n = unset<double>;
    Force P_all = unset<Force>;
    double u = unset<double>;
    static constexpr std::tuple fields{
        NameField{&ByMethod::name, "name", "method"}.as(Role::result),
        Field{&ByMethod::sigma_cr, "sigma_cr", MPa, "critical stress, without safety"}.as(Role::result),
        Field{&ByMethod::P_cr, "P_cr", kN, "critical force, without safety"}.as(Role::result),
        Field{&ByMethod::n, "n", ratio, "safety of the method"}.as(Role::result),
        Field{&ByMethod::P_all, "P_all", kN, "allowable force"}.as(Role::result),
        Field{&ByMethod::u, "u", ratio, "force over the allowable one"}.as(Role::result)};
  };

  struct Result {
    column::Loading loading = column::Loading::none;
    Force F = unset<Force>;
    Area A = unset<Area>;
    Length t = unset<Length>;
    column::AxisName axis = column::AxisName::y;
    double lambda = unset<double>;
    Force N_cr = unset<Force>;
    Stress sigma_E = unset<Stress>;
    double lambda_T = unset<double>, gap = unset<double>, lambda_lim = unset<double>;
    Stress sigma_cr = unset<Stress>;
    Force P_all = unset<Force>;
    double spread = unset<double>;
    double u = unset<double>;
    double r_lambda = unset<double>, r_1 = unset<double>, r_0 = unset<double>, r_class = unset<double>;
    List<Axis, 2> axes;
    List<ByMethod, 7> methods;
  };
  static constexpr std::tuple results{
      Choice{&Result::loading, "loading", "what the force does to the bar"}.as(Role::result),
      Field{&Result::F, "F", kN, "compressive force"}.as(Role::result),
      Field{&Result::A, "A", mm2, "area"}.as(Role::result),
      Field{&Result::t, "t", mm, "thickness that the strength depends on; the least of the table where unknown"}.as(
          Role::result),
      Choice{&Result::axis, "axis", "axis of the largest slenderness"}.as(Role::result),
      Field{&Result::lambda, "lambda", ratio, "largest slenderness"}.as(Role::result),
      Field{&Result::N_cr, "N_cr", kN, "least critical force of the elastic bar, however short it is"}.as(Role::result),
      Field{&Result::sigma_E, "sigma_E", MPa, "stress at that force, however short the bar is"}.as(Role::result),
      Field{&Result::lambda_T, "lambda_T", ratio, "slenderness at which Tetmajer's formula ends"}.as(Role::result),
      Field{&Result::gap, "gap", ratio, "at the published lambda_1, Tetmajer over Euler less 1"}.as(Role::result),
      Field{&Result::lambda_lim, "lambda_lim", ratio, "limit slenderness of Euler's formula"}.as(Role::result),
      Field{&Result::sigma_cr, "sigma_cr", MPa, "critical stress of the method that decides"}.as(Role::result),
      Field{&Result::P_all, "P_all", kN, "allowable force of the method that decides"}.as(Role::result),
      Field{&Result::spread, "spread", ratio, "largest critical stress of the methods over the least, less 1"}.as(
          Role::result),
      Field{&Result::u, "u", ratio, "buckling: force over the allowable one"}.check("N, P"),
      Field{&Result::r_lambda, "r_lambda", ratio, "slenderness over the largest that is allowed"}.limit(0, 1),
      Field{&Result::r_1, "r_1", ratio, "Euler: limit slenderness over the slenderness"}.limit(0, 1).where_it_applies(),
      Field{&Result::r_0, "r_0", ratio, "Tetmajer without a yield strength: lambda_0 over the slenderness"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::r_class, "r_class", ratio, "local buckling: thinness of the parts over the limit of class 3"}
          .limit(0, 1)
          .where_it_applies(),
      ListField{&Result::axes, "axes", "bending about y and about z"}.as(Role::result),
      ListField{&Result::methods, "methods", "the methods side by side"}.as(Role::result)};

  static bool section_given(const Input& in);
  static bool radii_fit(const Input& in);
  static bool supports_inside(const Input& in);
  static bool supports_need_ends(const Input& in);
  static bool needs_of_method(const Input& in);
  static bool extreme_fibre_known(const Input& in);
  static bool set_meets_euler(const Input& in);
  static bool set_near_euler(const Input& in);
  static bool set_fits_modulus(const Input& in);
  static bool usual_safety(const Input& in);
  static FieldFault section_missing(const Input& in);
  static FieldFault support_outside(const Input& in);
  static FieldFault missing_for_method(const Input& in);
  static FieldFault gap_of_set(const Input& in);
  static FieldFault modulus_of_set(const Input& in);
  static FieldFault unusual_safety(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !(is_set(in.N) && is_set(in.P)); }, "N, P",
                  "give the force as N, positive in tension, or as P, positive in compression, never both"},
      Rule<Input>{[](const Input& in) { return is_set(in.E); }, "E", "give the modulus E, or a material"},
      Rule<Input>{&section_given, "A, I_y, i_y, I_z, i_z, d, d_bore, h, b", "give the section", &section_missing},
      Rule<Input>{&radii_fit, "A, I_y, I_z, i_y, i_z", "I and i of an axis do not fit: I is A i^2; give one of them"},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_bore) || (is_set(in.d) && in.d_bore < in.d); }, "d_bore, d",
                  "a bore goes with d, and is smaller"},
      Rule<Input>{[](const Input& in) {
                    const bool y = is_set(in.beta_y) || in.ends_y != Ends::unsaid || in.ends != Ends::unsaid;
                    const bool z = is_set(in.beta_z) || in.ends_z != Ends::unsaid || in.ends != Ends::unsaid;
                    return y && z;
                  },
                  "ends, ends_y, ends_z, beta_y, beta_z",
                  "say how the ends are held: ends, or ends_y and ends_z, or the factors beta_y and beta_z"},
      Rule<Input>{[](const Input& in) {
                    return !(is_set(in.beta_y) && in.ends_y != Ends::unsaid) &&
                           !(is_set(in.beta_z) && in.ends_z != Ends::unsaid);
                  },
                  "ends_y, ends_z, beta_y, beta_z", "give the ends of an axis or its factor beta, never both"},
      Rule<Input>{&supports_inside, "supports_y, supports_z, l",
                  "supports stand between the ends, in order along the bar", &support_outside},
      Rule<Input>{
          &supports_need_ends, "supports_y, supports_z, beta_y, beta_z, beta_basis",
          "supports are computed from the ends exactly: leave out beta of that axis, and beta_basis = \"exact\""},
      Rule<Input>{[](const Input& in) { return is_set(in.a_T) == is_set(in.b_T); }, "a_T, b_T",
                  "a_T and b_T belong together"},
      Rule<Input>{[](const Input& in) { return in.transition == column::Transition::computed || is_set(in.lambda_1); },
                  "transition, lambda_1", "the published transition is the lambda_1 of the set: give it"},
      Rule<Input>{&needs_of_method,
                  "method, R_e, sigma_P, a_T, sigma_c, e_y, e_z, n_st, gamma_M1, gamma_F, kind, "
                  "curve_y, curve_z, h, b, t_f",
                  "something is missing that the method needs", &missing_for_method},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_P) || !is_set(in.R_e) || in.sigma_P <= in.R_e; },
                  "sigma_P, R_e", "the proportional limit is not above the yield strength"},
      Rule<Input>{&extreme_fibre_known, "e_y, e_z, c_y, c_z, h, b, d",
                  "an eccentricity needs the distance of the extreme fibre: c_y (or h) with e_y, c_z (or b) with e_z"},
      Rule<Input>{[](const Input& in) { return !(in.e_y > 0.0 * mm && in.e_z > 0.0 * mm); }, "e_y, e_z",
                  "the secant formula takes an eccentricity about one axis"},
      Rule<Input>{&set_meets_euler, "a_T, b_T, c_T, E, transition",
                  "with this modulus the set of Tetmajer-Yasinsky never meets Euler's hyperbola"},
      Rule<Input>{&set_near_euler, "a_T, b_T, c_T, E, lambda_1", "the set misses Euler at its lambda_1", &gap_of_set,
                  true},
      Rule<Input>{&set_fits_modulus, "E_T, E", "the set was given with another modulus", &modulus_of_set, true},
      Rule<Input>{&usual_safety, "n_st, material_class", "the safety factor is unusual", &unusual_safety, true}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

extern template Buckling::Result Buckling::evaluate(const Input&, NoTrace&);
extern template Buckling::Result Buckling::evaluate(const Input&, Trace&);

}  // namespace loadpath
