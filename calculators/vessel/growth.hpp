// How a thin vessel grows under its pressure, by Hooke's law of the membrane stresses.
#pragma once

#include "calculators/load/steel.hpp"
#include "calculators/vessel/wall.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::vessel {

struct ElasticInput {
  Stress E = unset<Stress>;
  double nu = 0.3;
};

struct GrowthResult {
  Length Delta_R = unset<Length>;
  double eps_l = unset<double>, eps_V = unset<double>;
};

/// `modulus`: what the modulus of elasticity is for.
template <class Input>
constexpr auto elastic_inputs(const char* modulus) {
  return Fields{
      Field<Input, Stress>{&Input::E, "E", GPa, modulus}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E")
          .where_it_has()
          .may_be_missing(),
      Field<Input, double>{&Input::nu, "nu", ratio, "Poisson's ratio"}.at_least(0).below(0.5).usually(0.2, 0.4)};
}

template <class Result>
constexpr auto growth_of_radius() {
  return Fields{Field<Result, Length>{&Result::Delta_R, "Delta_R", mm, "increase of the mean radius under pressure"}
                    .informative(),
                Field<Result, double>{&Result::eps_V, "eps_V", ratio, "relative increase of the volume"}.informative()};
}
template <class Result>
constexpr auto growth_of_cylinder() {
  return join(
      growth_of_radius<Result>(),
      Fields{Field<Result, double>{&Result::eps_l, "eps_l", ratio, "relative increase of the length"}.informative()});
}

/// Of a wall with the same membrane stresses everywhere: gas, and no rings.
template <class Tracer>
void grow_cylinder(const ElasticInput& in, Length R_m, Stress sigma_o, Stress sigma_M, GrowthResult& r, Tracer& trace) {
  if (!is_set(in.E)) return;
  STEP_TO(r, Delta_R, R_m * (sigma_o - in.nu * sigma_M) / in.E, "Hooke's law, hoop strain, [Pytel-8]");
  STEP_TO(r, eps_l, (sigma_M - in.nu * sigma_o) / in.E, "Hooke's law along the axis");
  STEP_TO(r, eps_V, 2.0 * Delta_R / R_m + eps_l, "two hoop strains and one along the axis");
}

template <class Tracer>
void grow_sphere(const ElasticInput& in, Length R_m, Stress sigma_o, GrowthResult& r, Tracer& trace) {
  if (!is_set(in.E)) return;
  STEP_TO(r, Delta_R, R_m * (1.0 - in.nu) * sigma_o / in.E,
          "Hooke's law, equal stresses in both directions, [Pytel-8]");
  STEP_TO(r, eps_V, 3.0 * Delta_R / R_m, "three equal strains");
}

}  // namespace loadpath::vessel
