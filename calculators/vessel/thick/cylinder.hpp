// A thick-walled cylinder under internal and external pressure: Lamé's stresses through the wall.
//
// Decides the equivalent stress at both surfaces, the safety factor against first yield, the pressure difference at
// which the whole wall is plastic, and the radial displacements. Stresses of [Lame], of a wall that corrosion has left;
// tension is positive. With open ends there is no axial stress, with restrained ends no axial strain. Not covered:
// ends, end junctions, nozzles, temperature gradients, liquid, fatigue, buckling under external pressure.
#pragma once

#include "calculators/vessel/growth.hpp"
#include "calculators/vessel/lame.hpp"
#include "calculators/vessel/modes.hpp"
#include "calculators/vessel/thick/thick_wall.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Thick {
  static constexpr auto id = "vessel.thick";
  static constexpr auto title = "Thick-walled cylinder";
  static constexpr auto scope =
      "Elastic stresses and displacements of a cylinder of any wall thickness under internal and external pressure, "
      "with closed, open or restrained ends, first yield and full plasticity; ends, nozzles, temperature gradients, "
      "buckling and fatigue are not covered.";
  static constexpr auto source = "[Lame], [Mises], [Plastic-cylinder]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "stresses of the wall";
  static constexpr auto synonyms =
      "thick-walled cylinder, thick cylinder, Lamé equations, high-pressure vessel, hydraulic cylinder, gun barrel, "
      "burst pressure, plastic limit pressure, dickwandiger Zylinder, dickwandiges Rohr, Hochdruckbehälter, "
      "толстостенный цилиндр, задача Ламе, толстостенная труба";
  static constexpr auto example = R"([project]
title = "Barrel of a press"

[barrel]
calculator = "vessel.thick"
p = "40 MPa"
R = "80 mm"
measured = "inner"
R_e = "355 MPa"
S = 1.5
E = "210 GPa"
)";

  enum class Ends { closed, open, restrained };

  struct Input : WallInput {
    Length R = unset<Length>;
    Stress p_e = from_si<Stress>(0.0);
    Ends ends = Ends::closed;
    Stress E = unset<Stress>;
    double nu = 0.3;
    Length r = unset<Length>;
  };
  static constexpr Fields inputs = join(
      Fields{Field<Input, Length>{&Input::R, "R", mm, "radius of the cylinder, to the surface given by measured"}
                 .one_of_body("radius")
                 .positive()
                 .usually(2, 5000)},
      wall_inputs<Input>(),
      Fields{
          Field<Input, Stress>{&Input::p_e, "p_e", MPa, "external gauge pressure"}.load().at_least(0).usually(0, 1000),
          Choice<Input, Ends>{&Input::ends, "ends", "end condition: closed, open or restrained ends"}.may_be_missing()},
      elastic_inputs<Input>("modulus of elasticity, for the displacements"),
      Fields{Field<Input, Length>{&Input::r, "r", mm, "radius at which the stresses are shown too"}
                 .positive()
                 .may_be_missing()});

  struct Result {
    Stress sigma_all = unset<Stress>;
    Length delta_min = unset<Length>, delta = unset<Length>, delta_c = unset<Length>;
    Length R_i = unset<Length>, R_a = unset<Length>;
    Stress sigma_ti = unset<Stress>, sigma_ta = unset<Stress>, sigma_z = unset<Stress>;
    Stress sigma_tr = unset<Stress>, sigma_rr = unset<Stress>;
    Stress sigma_vi = unset<Stress>, sigma_va = unset<Stress>, sigma_v = unset<Stress>;
    Length w_i = unset<Length>, w_a = unset<Length>;
    double S_F = unset<double>;
    Stress p_pl = unset<Stress>;
    double S_pl = unset<double>;
    double u_v = unset<double>;
  };
  static constexpr Fields results =
      join(Fields{Field{&Result::sigma_all, "sigma_all", MPa, "allowable stress"},
                  Field{&Result::delta_min, "delta_min", mm, "minimum nominal thickness, allowances included"},
                  Field{&Result::delta, "delta", mm, "nominal wall thickness"},
                  Field{&Result::delta_c, "delta_c", mm, "analysis thickness: corroded, under-tolerance deducted"},
                  Field{&Result::R_i, "R_i", mm, "inside radius of the carrying wall"},
                  Field{&Result::R_a, "R_a", mm, "outside radius of the carrying wall"},
                  Field{&Result::sigma_ti, "sigma_ti", MPa, "hoop stress at the inner surface"},
                  Field{&Result::sigma_ta, "sigma_ta", MPa, "hoop stress at the outer surface"},
                  Field{&Result::sigma_z, "sigma_z", MPa, "axial stress, the same through the wall"},
                  Field{&Result::sigma_tr, "sigma_tr", MPa, "hoop stress at the radius r"}},
           thick_wall_results<Result>());

  static constexpr std::array rules = thick_wall_rules<Input>();

  static constexpr Applies has_ends(const Input& in) { return in.ends == Ends::closed ? Applies::unseen : Applies::no; }
  static constexpr std::array meanings = wall_meanings;
  static constexpr std::array modes =
      modes_of_wall<Input>(Mode<Input>{"strength", "yielding of the wall", &always<Input>}.judged_by("u_v"),
                           Mode<Input>{"ends", "strength of the ends", &has_ends}.of_service());

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Thick::Ends) {
  using Ends = Thick::Ends;
  return std::array{
      ChoiceName<Ends>{Ends::closed, "closed", "closed ends, which pull at the wall"},
      ChoiceName<Ends>{Ends::open, "open", "open: no axial force, as of a barrel with a piston at each end"},
      ChoiceName<Ends>{Ends::restrained, "restrained", "held at a fixed distance: no axial strain"}};
}

}  // namespace loadpath::vessel
