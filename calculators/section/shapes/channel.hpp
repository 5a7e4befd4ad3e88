// A channel with parallel flanges and fillets. Exact; torsion of thin open walls.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"
#include "calculators/section/shapes/flanged.hpp"
#include "calculators/section/shapes/torsion.hpp"

#include <array>

namespace loadpath::section {

struct Channel : ShapeCalculator<Channel> {
  static constexpr auto id = "section.channel";
  static constexpr auto title = "Channel section";
  static constexpr auto scope =
      "Area, centroid, second moments of area, section moduli and thin-wall torsion constant (sum of b t^3/3) "
      "of a channel with parallel flanges; coordinate origin at mid-back of the web; torsion constants of "
      "rolled channels are up to 17 % larger; warping torsion, shear centre and tapered flanges are not "
      "covered.";
  static constexpr auto source = "[Garrison], [Oasys]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms = "channel, U-section, UPE, UPN, C-section, section properties, U-Profil, швеллер";
  static constexpr auto example = R"([project]
title = "UPE 200 from its dimensions"

[channel]
calculator = "section.channel"
h = "200 mm"
b = "80 mm"
t_w = "6 mm"
t_f = "11 mm"
r = "13 mm"
)";

  using Input = Flanged;
  static constexpr auto inputs =
      flanged_inputs("depth over both flanges", "width of the flanges, with the web", "thickness of a flange");

  using Result = OpenWalls;
  static constexpr auto results = results_of_open_walls;

  static constexpr std::array rules{Rule<Input>{[](const Input& in) { return 2.0 * (in.t_f + in.r) <= in.h; },
                                                "t_f, r, h", "h is too small for flanges and fillets"},
                                    Rule<Input>{[](const Input& in) { return in.t_w + in.r <= in.b; }, "t_w, r, b",
                                                "b is too small for web and fillet"}};
  static constexpr std::array modes{torsion_mode<Input>("w")};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
