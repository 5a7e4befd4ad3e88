// An angle, equal or unequal, with root fillet and rounded toes. Exact; torsion of thin open walls.
// The moduli about y and z are those of tables; an angle that is free to bend does so about its principal axes.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"
#include "calculators/section/shapes/torsion.hpp"

#include <array>

namespace loadpath::section {

struct Angle : ShapeCalculator<Angle> {
  static constexpr auto id = "section.angle";
  static constexpr auto title = "Angle section";
  static constexpr auto scope =
      "Area, centroid, second moments of area, principal axes, section moduli and torsion constant of an angle "
      "with leg h upwards and leg b to the right; coordinate origin at the outer corner; thin-leg torsion "
      "constant, up to 1.7 % below the Prandtl solution without fillet; warping torsion and shear centre are "
      "not covered.";
  static constexpr auto source = "[Garrison], [Roark]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "angle, L-section, equal angle, unequal angle, principal axes, section properties, Winkelprofil, L-Profil, "
      "уголок, угловой профиль";
  static constexpr auto example = R"([project]
title = "L 100x100x10 from its dimensions"

[angle]
calculator = "section.angle"
h = "100 mm"
b = "100 mm"
t = "10 mm"
r = "12 mm"
r_2 = "6 mm"
)";

  struct Input {
    Length h = unset<Length>;
    Length b = unset<Length>;
    Length t = unset<Length>;
    Length r = from_si<Length>(0.0);
    Length r_2 = from_si<Length>(0.0);
  };
  static constexpr Fields inputs{
      Field{&Input::h, "h", mm, "height of the upright leg"}.positive().usually(0.1, 1e4),
      Field{&Input::b, "b", mm, "width of the other leg"}.positive().usually(0.1, 1e4),
      Field{&Input::t, "t", mm, "thickness of both legs"}.positive(),
      Field{&Input::r, "r", mm, "radius of the root fillet; omitted: none"}.at_least(0).may_be_missing(),
      Field{&Input::r_2, "r_2", mm, "radius of the inner edges of the toes; omitted: sharp"}
          .at_least(0)
          .may_be_missing()};

  using Result = OpenWalls;
  static constexpr auto results = results_of_open_walls;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.t + in.r + in.r_2 <= min(in.h, in.b); }, "t, r, r_2, h, b",
                  "the legs are too short for thickness and radii"},
      Rule<Input>{[](const Input& in) { return in.r_2 <= in.t; }, "r_2, t", "the toe radius must not exceed t"}};
  static constexpr std::array modes{torsion_mode<Input>("w")};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
