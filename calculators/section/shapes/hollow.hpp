// A hollow rectangle of one wall thickness, corners sharp or rounded. Exact; torsion by EN 10210-2.
// Corner radii: hot finished sections of EN 10210-2 have r_o = 1.5 t and r_i = t, cold formed ones of EN 10219-2 up to
// 6 mm wall r_o = 2 t and r_i = t.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"
#include "calculators/section/shapes/torsion.hpp"
#include "lib/calculator/fields.hpp"

#include <array>

namespace loadpath::section {

struct Hollow : ShapeCalculator<Hollow> {
  static constexpr auto id = "section.hollow";
  static constexpr auto title = "Rectangular hollow section";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and thin-wall torsion constant (EN 10210-2) of a "
      "rectangular hollow section with sharp or rounded corners; coordinate origin at the centre; local "
      "buckling of thin walls is not covered.";
  static constexpr auto source = "[Garrison], [EN10210-2]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "rectangular hollow section, RHS, SHS, box section, square tube, EN 10210, EN 10219, Hohlprofil, "
      "Kastenquerschnitt, Vierkantrohr, коробчатое сечение, прямоугольная труба";
  static constexpr auto example = R"([project]
title = "SHS 100x5 from its dimensions"

[post]
calculator = "section.hollow"
h = "100 mm"
b = "100 mm"
t = "5 mm"
r_o = "7.5 mm"
r_i = "5 mm"
)";

  struct Input {
    Length h = unset<Length>;
    Length b = unset<Length>;
    Length t = unset<Length>;
    Length r_o = from_si<Length>(0.0);
    Length r_i = from_si<Length>(0.0);
    Forming fabrication = Forming::unsaid;
  };
  static constexpr Fields inputs{
      Field{&Input::h, "h", mm, "height, along z"}.positive().usually(0.1, 1e4),
      Field{&Input::b, "b", mm, "width, along y"}.positive().usually(0.1, 1e4),
      Field{&Input::t, "t", mm, "wall"}.positive(),
      Field{&Input::r_o, "r_o", mm, "outer radius of the corners; omitted: sharp"}.at_least(0).may_be_missing(),
      Field{&Input::r_i, "r_i", mm, "inner radius of the corners; omitted: sharp"}.at_least(0).may_be_missing(),
      Choice{&Input::fabrication, "fabrication", "manufacture, for its buckling curve"}.may_be_missing()};

  struct Result : Properties {
    double w = unset<double>;
  };
  static constexpr auto results = join(
      property_fields<Result>(),
      Fields{Field{&Result::w, "w", ratio, "wall over the shorter middle line, for the torsion of thin closed walls"}
                 .limit(0, thickest_closed_wall)});

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return 2.0 * in.t < min(in.h, in.b); }, "t, h, b",
                  "the walls must be thinner than half the section"},
      Rule<Input>{[](const Input& in) { return 2.0 * in.r_o <= min(in.h, in.b); }, "r_o, h, b",
                  "the outer radius must not exceed half the shorter side"},
      Rule<Input>{[](const Input& in) { return 2.0 * in.r_i <= min(in.h, in.b) - 2.0 * in.t; }, "r_i, t, h, b",
                  "the inner radius must not exceed half the hollow"},
      Rule<Input>{[](const Input& in) { return in.r_o <= in.r_i + 3.4 * in.t; }, "r_o, r_i, t",
                  "the outer radius leaves no wall at the corner"}};
  static constexpr std::array modes{torsion_mode<Input>("w")};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
