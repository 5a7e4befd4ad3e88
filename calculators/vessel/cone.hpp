// A thin-walled cone under internal pressure of gas, or hanging point down with a liquid in it.
//
// Decides the least thickness, the equivalent stress at the governing place and the allowable gas pressure. Membrane
// stresses of [B24] (9) with the balance of the tip beyond a section, held at the large end. Tension is positive. Radii
// lie in the plane of the section; the middle of the wall lies on the same normal.
// Not covered: bending at the junction with a cylinder, knuckles, weight of the wall, external pressure, fatigue.
#pragma once

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Cone {
  static constexpr auto id = "vessel.cone";
  static constexpr auto title = "Thin-walled conical vessel";
  static constexpr auto scope =
      "Static membrane stresses and wall thickness of a cone under internal gas pressure, or hanging apex down "
      "and filled with liquid; bending at the junction with a cylinder, knuckles, self-weight, external "
      "pressure and fatigue are not covered.";
  static constexpr auto source = "[B24], [ExpertsMind-cone], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "pressure vessel, cone, hopper, conical shell, reducer, Kegel, Trichter, Kegelschale, коническая оболочка, "
      "конический сосуд, воронка";
  static constexpr auto example = R"([project]
title = "Hopper bottom"

[hopper]
calculator = "vessel.cone"
p = "0.1 MPa"
R = "1.2 m"
alpha = "30 deg"
rho = "1000 kg/m^3"
h_l = "2 m"
sigma_adm = "120 MPa"
)";

  struct Input : WallInput, Liquid {
    Length R = unset<Length>;
    double alpha = unset<double>;
  };
  static constexpr Fields inputs = join(
      Fields{Field<Input, Length>{&Input::R, "R", mm, "radius of the large end, to the surface given by measured"}
                 .at_least_that_of_source("R")
                 .one_of_body("radius")
                 .positive()
                 .usually(5, 50000),
             Field<Input, double>{&Input::alpha, "alpha", deg, "half the angle of the point"}.within(1, 75).usually(
                 5, 60)},
      wall_inputs<Input>("p, p_i"), liquid_inputs<Input>("height of the liquid's surface above the point"));

  struct Result : WallResult {
    Length R_m = unset<Length>, r = unset<Length>;
    double x_s = unset<double>;
  };
  static constexpr Fields results =
      join(wall_results<Result>(),
           Fields{Field{&Result::R_m, "R_m", mm, "mean radius at the analysis thickness at the large end"},
                  Field{&Result::r, "r", mm, "mean radius at the governing location"}, shallowness<Result>()});

  static constexpr std::array rules = join(
      wall_rules<Input>(), liquid_rules<Input>(),
      std::array{Rule<Input>{[](const Input& in) { return !is_set(in.h_l) || in.h_l <= in.R / std::tan(in.alpha); },
                             "h_l, R, alpha", "the liquid level is above the large end of the cone"},
                 Rule<Input>{[](const Input& in) { return leaves_room(in, in.R); }, "R, delta",
                             "the wall must be thinner than the radius"}});

  static constexpr std::array meanings = join(wall_meanings, std::array{Meaning{"R", radius_when_closed}});
  static constexpr std::array modes = wall_modes<Input>("u_v, t_R, x_s");

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::vessel
