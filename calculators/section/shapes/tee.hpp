// A T with parallel faces and fillets. Exact; torsion of thin open walls.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"
#include "calculators/section/shapes/flanged.hpp"
#include "calculators/section/shapes/torsion.hpp"

#include <array>

namespace loadpath::section {

struct Tee : ShapeCalculator<Tee> {
  static constexpr auto id = "section.T";
  static constexpr auto title = "T-section";
  static constexpr auto scope =
      "Area, centroid, second moments of area, section moduli and thin-wall torsion constant (sum of b t^3/3) "
      "of a T-section, flange on top; coordinate origin at mid-flange of the top face; warping torsion, shear "
      "centre and tapered flanges are not covered.";
  static constexpr auto source = "[Garrison], [Oasys]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms = "T-section, tee, section properties, T-Profil, тавр, тавровое сечение";
  static constexpr auto example = R"([project]
title = "Half an IPE 200"

[tee]
calculator = "section.T"
h = "100 mm"
b = "100 mm"
t_w = "5.6 mm"
t_f = "8.5 mm"
r = "12 mm"
)";

  using Input = Flanged;
  static constexpr auto inputs =
      flanged_inputs("depth with the flange", "width of the flange", "thickness of the flange");

  using Result = OpenWalls;
  static constexpr auto results = results_of_open_walls;

  static constexpr std::array rules{Rule<Input>{[](const Input& in) { return in.t_f + in.r < in.h; }, "t_f, r, h",
                                                "h is too small for flange and fillet"},
                                    Rule<Input>{[](const Input& in) { return in.t_w + 2.0 * in.r <= in.b; },
                                                "t_w, r, b", "b is too small for web and fillets"}};
  static constexpr std::array modes{torsion_mode<Input>("w")};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
