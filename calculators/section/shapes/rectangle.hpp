// A solid rectangle. Exact, torsion by the series of Saint-Venant.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"

#include <array>

namespace loadpath::section {

struct Rectangle : ShapeCalculator<Rectangle> {
  static constexpr auto id = "section.rectangle";
  static constexpr auto title = "Rectangular section";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and torsion constant (Saint-Venant series) of a rectangle "
      "of width b and height h; coordinate origin at the centre.";
  static constexpr auto source = "[Garrison], [Oasys]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "rectangle, flat bar, square, plate strip, section properties, torsion of a rectangle, Rechteck, "
      "Rechteckquerschnitt, Flachstahl, прямоугольник, прямоугольное сечение, полоса";
  static constexpr auto example = R"([project]
title = "Flat bar"

[bar]
calculator = "section.rectangle"
b = "20 mm"
h = "60 mm"
)";

  struct Input {
    Length b = unset<Length>;
    Length h = unset<Length>;
  };
  static constexpr Fields inputs{Field{&Input::b, "b", mm, "width, along y"}.positive().usually(0.1, 1e4),
                                 Field{&Input::h, "h", mm, "height, along z"}.positive().usually(0.1, 1e4)};

  using Result = Properties;
  static constexpr auto results = results_of_properties;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return max(in.b, in.h) <= 1e4 * min(in.b, in.h); }, "b, h",
                  "one side must not exceed 10000 times the other"}};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
