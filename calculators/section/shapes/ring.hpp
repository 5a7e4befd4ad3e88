// A concentric ring: a tube. Exact.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"

#include <array>

namespace loadpath::section {

struct Ring : ShapeCalculator<Ring> {
  static constexpr auto id = "section.ring";
  static constexpr auto title = "Annular section (tube)";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and torsion constant of an annulus given by its bore or "
      "its wall thickness; coordinate origin at the centre; local buckling of thin walls is not covered.";
  static constexpr auto source = "[B19]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "annulus, ring, tube, pipe, circular hollow section, CHS, hollow shaft, section properties, Kreisring, Rohr, "
      "Rohrquerschnitt, кольцо, труба, кольцевое сечение";
  static constexpr auto example = R"([project]
title = "Tube"

[tube]
calculator = "section.ring"
d = "60 mm"
t = "5 mm"
)";

  struct Input {
    Length d = unset<Length>;
    Length d_i = unset<Length>;
    Length t = unset<Length>;
    Forming fabrication = Forming::unsaid;
  };
  static constexpr Fields inputs{
      Field{&Input::d, "d", mm, "outer diameter"}.positive().usually(0.1, 1e4),
      Field{&Input::d_i, "d_i", mm, "inner diameter"}.at_least(0).may_be_missing(),
      Field{&Input::t, "t", mm, "wall, in place of d_i"}.positive().may_be_missing(),
      Choice{&Input::fabrication, "fabrication", "manufacture, for its buckling curve"}.may_be_missing()};

  using Result = Properties;
  static constexpr auto results = results_of_properties;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.d_i) != is_set(in.t); }, "d_i, t", "give either d_i or t"},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_i) || in.d_i < in.d; }, "d_i, d",
                  "the bore must be smaller than the ring"},
      Rule<Input>{[](const Input& in) { return !is_set(in.t) || 2.0 * in.t <= in.d; }, "t, d",
                  "the wall thickness must not exceed half the diameter"}};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
