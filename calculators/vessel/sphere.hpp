// A thin-walled sphere under internal pressure of gas and liquid, on a ring.
//
// Decides the minimum thickness, the equivalent stress at the governing place and the allowable gas pressure, and
// Lamé's thick-walled result for comparison. Membrane stresses of [B24]; the liquid by the balance of the cap beyond
// a section: below the ring the lower one, above it the upper one. Tension is positive. Not covered: bending next to
// the ring and at nozzles, weight of the wall, external pressure, fatigue.
#pragma once

#include "calculators/vessel/growth.hpp"
#include "calculators/vessel/lame.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Sphere {
  static constexpr auto id = "vessel.sphere";
  static constexpr auto title = "Thin-walled spherical vessel";
  static constexpr auto scope =
      "Static membrane stresses and wall thickness of a sphere under internal gas pressure and the liquid "
      "pressure of a ring-supported sphere; bending near the ring, nozzles, self-weight, external pressure and "
      "fatigue are not covered.";
  static constexpr auto source = "[B24], [Timoshenko], [Lame], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "pressure vessel, sphere, spherical tank, gas holder, membrane stress, Kugelbehälter, Kugel, Druckbehälter, "
      "сферический резервуар, сферическая оболочка";
  static constexpr auto example = R"([project]
title = "Gas holder"

[holder]
calculator = "vessel.sphere"
p = "0.8 MPa"
R = "5 m"
measured = "inner"
c = "1 mm"
z_l = 0.85
z_c = 0.85
sigma_adm = "160 MPa"
)";

  struct Input : WallInput, Liquid, ElasticInput {
    Length R = unset<Length>;
    double phi_s = pi / 2;
  };
  static constexpr Fields inputs =
      join(Fields{Field<Input, Length>{&Input::R, "R", mm, "radius of the sphere, to the surface given by measured"}
                      .at_least_that_of_source("R")
                      .one_of_body("radius")
                      .positive()
                      .usually(5, 50000)},
           wall_inputs<Input>("p, !rho?p_i"),
           liquid_inputs<Input>("height of the liquid surface above the lowest point of the wall"),
           Fields{Field<Input, double>{&Input::phi_s, "phi_s", deg,
                                       "supporting ring of a sphere with liquid: angle from the top"}
                      .within(20, 160)
                      .may_be_missing()},
           elastic_inputs<Input>("modulus of elasticity, for the growth under pressure"));

  struct Result : WallResult, LameResult, GrowthResult {
    Length R_m = unset<Length>;
    double phi = unset<double>, t_M = unset<double>;
  };
  static constexpr Fields results =
      join(wall_results<Result>(round_and_thin),
           Fields{Field{&Result::R_m, "R_m", mm, "mean radius at the analysis thickness"},
                  Field{&Result::phi, "phi", deg, "governing location, from the top"}, thin_by_membrane<Result>()},
           lame_results<Result>(), growth_of_radius<Result>());

  static constexpr std::array rules =
      join(wall_rules<Input>(), liquid_rules<Input>(),
           std::array{Rule<Input>{[](const Input& in) { return !is_set(in.h_l) || in.h_l <= 2.0 * in.R; }, "h_l, R",
                                  "the liquid level is above the top of the sphere: give the pressure there as p"},
                      Rule<Input>{[](const Input& in) { return leaves_room(in, in.R); }, "R, delta",
                                  "the wall must be thinner than the radius"}});

  static Applies compressed(const Input& in);
  static constexpr std::array meanings = join(wall_meanings, std::array{Meaning{"R", radius_when_closed}});
  static constexpr std::array modes =
      wall_modes<Input>("u_v, t_R, t_M", Mode<Input>{"buckling", "compressive buckling of the wall", &compressed});

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::vessel
