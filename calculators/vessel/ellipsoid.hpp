// A thin-walled ellipsoid of revolution, or a half-ellipsoidal head, under internal gas pressure.
//
// Decides the least thickness, the equivalent stress at the governing place and the allowable pressure. Membrane
// stresses of [B24] (9). Tension is positive; the hoop stress of a flat head is a compression at the equator. Not
// covered: the junction with a cylinder, buckling of the knuckle beyond the limit shown, liquid, external pressure.
#pragma once

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Ellipsoid {
  static constexpr auto id = "vessel.ellipsoid";
  static constexpr auto title = "Thin-walled ellipsoidal vessel or head";
  static constexpr auto scope =
      "Static membrane stresses and wall thickness of an ellipsoid of revolution or a semi-ellipsoidal head "
      "under internal gas pressure; bending at the junction with a cylinder, nozzles, external pressure and "
      "fatigue are not covered.";
  static constexpr auto source = "[B24], [Timoshenko], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "ellipsoidal head, dished end, dished head, vessel head, knuckle, crown, pressure vessel, Ellipsoidboden, "
      "gewölbter Boden, Krempe, эллиптическое днище, днище";
  static constexpr auto example = R"([project]
title = "Two to one head"

[head]
calculator = "vessel.ellipsoid"
p = "0.6 MPa"
a = "600 mm"
b = "300 mm"
measured = "inner"
sigma_adm = "140 MPa"
)";

  struct Input : WallInput {
    Length a = unset<Length>, b = unset<Length>;
  };
  static constexpr Fields inputs =
      join(Fields{Field<Input, Length>{&Input::a, "a", mm, "semi-axis across: radius of the equator"}
                      .at_least_that_of_source("R")
                      .one_of_body("radius")
                      .positive()
                      .usually(5, 50000),
                  Field<Input, Length>{&Input::b, "b", mm, "semi-axis along the axis of revolution: height of a head"}
                      .positive()
                      .usually(5, 50000)},
           wall_inputs<Input>(pressure_below));

  struct Result : WallResult {
    Length a_m = unset<Length>, b_m = unset<Length>, r = unset<Length>;
    Stress sigma_pole = unset<Stress>, sigma_eq = unset<Stress>;
    double w_b = unset<double>, x_s = unset<double>;
  };
  static constexpr Fields results = join(
      wall_results<Result>(),
      Fields{Field{&Result::a_m, "a_m", mm, "mid-surface semi-axis, across"},
             Field{&Result::b_m, "b_m", mm, "mid-surface semi-axis, along"},
             Field{&Result::r, "r", mm, "distance of the governing location from the axis"},
             Field{&Result::sigma_pole, "sigma_pole", MPa, "stress at the pole, equal in all directions"},
             Field{&Result::sigma_eq, "sigma_eq", MPa, "hoop stress at the equator; negative is compression"},
             Field{&Result::w_b, "w_b", ratio, "buckling of the knuckle: 0.002 of the crown radius over the thickness"}
                 .limit(0, 1),
             shallowness<Result>()});

  static constexpr std::array rules =
      join(wall_rules<Input>(), gas_rules<Input>(),
           std::array{Rule<Input>{[](const Input& in) { return in.a <= 5.0 * in.b && in.b <= 5.0 * in.a; }, "a, b",
                                  "a/b must be 1/5 to 5 (range of membrane theory)"},
                      Rule<Input>{[](const Input& in) { return leaves_room(in, min(in.a, in.b)); }, "a, b, delta",
                                  "the wall must be thinner than the semi-axes"}});

  static constexpr Applies flat(const Input& in) { return where(in.a * in.a > 2.0 * in.b * in.b); }
  static constexpr std::array meanings = join(wall_meanings, std::array{Meaning{"a", radius_when_closed}});
  static constexpr std::array modes =
      wall_modes<Input>("u_v, t_R, x_s", Mode<Input>{"knuckle", "buckling of the knuckle", &flat}.judged_by("w_b"));

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::vessel
