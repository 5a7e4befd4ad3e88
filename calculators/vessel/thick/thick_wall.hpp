// What thick-walled cylinders and spheres have in common: rules of their input, and results of yielding and
// displacement.
#pragma once

#include "calculators/vessel/wall.hpp"
#include "lib/calculator/fields.hpp"

#include <array>

namespace loadpath::vessel {

template <class Input>
constexpr auto thick_wall_rules() {
  return join(wall_rules<Input>(),
              std::array{Rule<Input>{[](const Input& in) { return in.p > 0.0 * MPa || in.p_e > 0.0 * MPa; }, "p, p_e",
                                     "give an internal pressure p or an external pressure p_e"},
                         Rule<Input>{[](const Input& in) { return in.hypothesis != Hypothesis::membrane; },
                                     "hypothesis", radial_stress_needed},
                         Rule<Input>{[](const Input& in) { return leaves_room(in, in.R); }, "R, delta",
                                     "the wall must be thinner than the radius"}});
}

template <class Result>
constexpr auto thick_wall_results() {
  return Fields{
      Field<Result, Stress>{&Result::sigma_rr, "sigma_rr", MPa, "radial stress at the radius r"},
      Field<Result, Stress>{&Result::sigma_vi, "sigma_vi", MPa,
                            "equivalent stress at the inner surface, seams included"},
      Field<Result, Stress>{&Result::sigma_va, "sigma_va", MPa,
                            "equivalent stress at the outer surface, seams included"},
      Field<Result, Stress>{&Result::sigma_v, "sigma_v", MPa,
                            "equivalent stress at the governing surface, seams included"},
      Field<Result, Length>{&Result::w_i, "w_i", mm, "radial displacement of the inner surface, outward positive"},
      Field<Result, Length>{&Result::w_a, "w_a", mm, "radial displacement of the outer surface, outward positive"},
      Field<Result, double>{&Result::S_F, "S_F", ratio, "safety factor against first yield"},
      Field<Result, Stress>{&Result::p_pl, "p_pl", MPa,
                            "pressure difference at which all of a seamless wall is plastic"},
      Field<Result, double>{&Result::S_pl, "S_pl", ratio, "fully plastic pressure difference / pressure difference"},
      Field<Result, double>{&Result::u_v, "u_v", ratio, "strength: equivalent stress / allowable stress"}.check()};
}

}  // namespace loadpath::vessel
