// A solid ellipse, its axes upright and across. Exact.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"

#include <array>

namespace loadpath::section {

struct Ellipse : ShapeCalculator<Ellipse> {
  static constexpr auto id = "section.ellipse";
  static constexpr auto title = "Elliptical section";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and torsion constant of a solid ellipse; coordinate origin "
      "at the centre.";
  static constexpr auto source = "[Anexa-BMOM]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "ellipse, elliptical bar, section properties, torsion constant, Ellipsenquerschnitt, эллипс, "
      "эллиптическое сечение";
  static constexpr auto example = R"([project]
title = "Oval bar"

[bar]
calculator = "section.ellipse"
b = "40 mm"
h = "20 mm"
)";

  struct Input {
    Length b = unset<Length>, h = unset<Length>;
  };
  static constexpr Fields inputs{Field{&Input::b, "b", mm, "width, the axis across"}.positive().usually(0.1, 1e4),
                                 Field{&Input::h, "h", mm, "height, the upright axis"}.positive().usually(0.1, 1e4)};

  using Result = Properties;
  static constexpr auto results = results_of_properties;

  static constexpr std::array<Rule<Input>, 0> rules{};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
