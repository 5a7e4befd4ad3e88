// A thin-walled torus, or a pipe bend, under internal gas pressure.
//
// Decides the least thickness, the equivalent stress and the allowable pressure. The hoop stress of the ring is
// pr/2delta everywhere; the stress around the tube is largest at the inside of the ring, which governs. Membrane
// stresses of [B24] (9) with the balance of a part that is cut off at the crown. Tension is positive. Not covered:
// ovality of a bend, bending at the crown, liquid, weight of the wall, external pressure, fatigue.
#pragma once

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Torus {
  static constexpr auto id = "vessel.torus";
  static constexpr auto title = "Thin-walled toroidal vessel";
  static constexpr auto scope =
      "Static membrane stresses and wall thickness of a torus of circular section, or a smooth pipe bend, "
      "under internal gas pressure; ovality, bending at the crown, external pressure and fatigue are not "
      "covered.";
  static constexpr auto source = "[B24], [Timoshenko], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "torus, toroidal shell, pipe bend, elbow, membrane stress, Rohrbogen, Torusschale, тор, "
      "тороидальная оболочка, отвод";
  static constexpr auto example = R"([project]
title = "Ring main"

[ring]
calculator = "vessel.torus"
p = "2.5 MPa"
R_0 = "1 m"
r = "200 mm"
sigma_adm = "140 MPa"
)";

  struct Input : WallInput {
    Length R_0 = unset<Length>, r = unset<Length>;
  };
  static constexpr Fields inputs = join(
      Fields{Field<Input, Length>{&Input::R_0, "R_0", mm, "radius of the ring: from its axis to the middle of the tube"}
                 .positive()
                 .usually(10, 50000),
             Field<Input, Length>{&Input::r, "r", mm, "radius of the tube, to the surface given by measured"}
                 .positive()
                 .usually(5, 10000)},
      wall_inputs<Input>(pressure_below));

  struct Result : WallResult {
    Length r_m = unset<Length>;
  };
  static constexpr Fields results =
      join(wall_results<Result>(), Fields{Field{&Result::r_m, "r_m", mm, "mean radius of the tube"}});

  static constexpr std::array rules =
      join(wall_rules<Input>(), gas_rules<Input>(),
           std::array{
               Rule<Input>{[](const Input& in) { return in.R_0 > 1.02 * in.r; }, "R_0, r", "R_0 must be larger than r"},
               Rule<Input>{[](const Input& in) { return leaves_room(in, in.r); }, "r, delta",
                           "the wall must be thinner than the radius"},
               Rule<Input>{[](const Input& in) { return !is_set(in.delta) || in.R_0 > in.r + in.delta; },
                           "R_0, r, delta", "R_0 must be larger: the wall closes the ring"}});

  static constexpr std::array meanings = wall_meanings;
  static constexpr std::array modes = wall_modes<Input>("u_v, t_R");

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::vessel
