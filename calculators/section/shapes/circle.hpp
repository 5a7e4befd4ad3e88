// A solid circle. Exact.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"

#include <array>

namespace loadpath::section {

struct Circle : ShapeCalculator<Circle> {
  static constexpr auto id = "section.circle";
  static constexpr auto title = "Circular section";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and torsion constant of a solid circle; coordinate origin "
      "at the centre.";
  static constexpr auto source = "[B19]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "circle, round bar, rod, section properties, second moment of area, moment of inertia of area, "
      "section modulus, torsion constant, polar moment, Kreisquerschnitt, Flächenträgheitsmoment, "
      "Widerstandsmoment, круг, круглое сечение, момент инерции сечения, момент сопротивления";
  static constexpr auto example = R"([project]
title = "Solid round bar"

[bar]
calculator = "section.circle"
d = "40 mm"
)";

  struct Input {
    Length d = unset<Length>;
  };
  static constexpr Fields inputs{Field{&Input::d, "d", mm, "diameter"}.positive().usually(0.1, 1e4)};

  using Result = Properties;
  static constexpr auto results = results_of_properties;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.d); }, "d", "give the diameter"}};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
