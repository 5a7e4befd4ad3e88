// A thick-walled sphere under internal and external pressure: Lamé's stresses through the wall.
//
// Decides the equivalent stress at both surfaces, the safety factor against first yield, the pressure difference at
// which the whole wall is plastic, and the radial displacements. Stresses of [Lame], of a wall that corrosion has left;
// tension is positive. Both stresses in the wall are alike, so Tresca and von Mises agree in a seamless wall. Not
// covered: supports, nozzles, temperature gradients, liquid, fatigue, buckling under external pressure.
#pragma once

#include "calculators/vessel/growth.hpp"
#include "calculators/vessel/lame.hpp"
#include "calculators/vessel/modes.hpp"
#include "calculators/vessel/thick/thick_wall.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct ThickWalledSphere {
  static constexpr auto id = "vessel.thick_sphere";
  static constexpr auto title = "Thick-walled sphere";
  static constexpr auto scope =
      "Elastic stresses and displacements of a sphere of any wall thickness under internal and external pressure, "
      "first "
      "yield and full plasticity; supports, nozzles, temperature gradients, buckling and fatigue are not covered.";
  static constexpr auto source = "[Lame], [Mises], [Plastic-cylinder]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "stresses of the wall";
  static constexpr auto synonyms =
      "thick-walled sphere, thick sphere, spherical pressure vessel, high-pressure sphere, Lamé equations, plastic "
      "limit "
      "pressure, burst pressure, dickwandige Kugel, Hochdruckkugel, толстостенная сфера, толстостенный шар";
  static constexpr auto example = R"([project]
title = "High-pressure sphere"

[ball]
calculator = "vessel.thick_sphere"
p = "90 MPa"
R = "100 mm"
measured = "inner"
R_e = "355 MPa"
S = 1.5
E = "210 GPa"
)";

  struct Input : WallInput {
    Length R = unset<Length>;
    Stress p_e = from_si<Stress>(0.0);
    Stress E = unset<Stress>;
    double nu = 0.3;
    Length r = unset<Length>;
  };
  static constexpr Fields inputs =
      join(Fields{Field<Input, Length>{&Input::R, "R", mm, "radius of the sphere, to the surface given by measured"}
                      .one_of_body("radius")
                      .positive()
                      .usually(2, 5000)},
           wall_inputs<Input>(),
           Fields{Field<Input, Stress>{&Input::p_e, "p_e", MPa, "external gauge pressure"}.load().at_least(0).usually(
               0, 1000)},
           elastic_inputs<Input>("modulus of elasticity, for the displacements"),
           Fields{Field<Input, Length>{&Input::r, "r", mm, "radius at which the stresses are shown too"}
                      .positive()
                      .may_be_missing()});

  struct Result {
    Stress sigma_all = unset<Stress>;
    Length delta_min = unset<Length>, delta = unset<Length>, delta_c = unset<Length>;
    Length R_i = unset<Length>, R_a = unset<Length>;
    Stress sigma_ti = unset<Stress>, sigma_ta = unset<Stress>, sigma_tr = unset<Stress>, sigma_rr = unset<Stress>;
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
                  Field{&Result::sigma_ti, "sigma_ti", MPa, "stress in the wall at the inner surface"},
                  Field{&Result::sigma_ta, "sigma_ta", MPa, "stress in the wall at the outer surface"},
                  Field{&Result::sigma_tr, "sigma_tr", MPa, "stress in the wall at the radius r"}},
           thick_wall_results<Result>());

  static constexpr std::array rules = thick_wall_rules<Input>();

  static constexpr std::array meanings = wall_meanings;
  static constexpr std::array modes =
      modes_of_wall<Input>(Mode<Input>{"strength", "yielding of the wall", &always<Input>}.judged_by("u_v"));

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::vessel
