// A doubly symmetric I or H with parallel flanges and fillets. Exact; torsion by the formula of SCI P385.
// SCI P385 counts the T-junctions of web and flanges.
#pragma once

#include "calculators/section/properties/shape_calculator.hpp"
#include "calculators/section/shapes/flanged.hpp"
#include "calculators/section/shapes/torsion.hpp"
#include "lib/calculator/fields.hpp"

#include <array>

namespace loadpath::section {

struct I : ShapeCalculator<I> {
  static constexpr auto id = "section.I";
  static constexpr auto title = "I-section with equal flanges";
  static constexpr auto scope =
      "Area, second moments of area, section moduli and torsion constant of an I- or H-section with two equal "
      "parallel flanges and root fillets; torsion constant to SCI P385 within 4.5 % of the tables of rolled "
      "sections, whose proportions are its range; warping torsion is not covered; unequal flanges are modelled "
      "by section.built_up.";
  static constexpr auto source = "[Garrison], [SCI-P385]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "I-section, I-beam, H-section, double-T, IPE, HEA, HEB, UB, UC, rolled section, section properties, I-Profil, "
      "Doppel-T-Träger, двутавр, двутавровое сечение";
  static constexpr auto example = R"([project]
title = "HEB 200 from its dimensions"

[beam]
calculator = "section.I"
h = "200 mm"
b = "200 mm"
t_w = "9 mm"
t_f = "15 mm"
r = "18 mm"
)";

  struct Input : Flanged {
    Rolling fabrication = Rolling::unsaid;
  };
  static constexpr auto inputs =
      join(flanged_inputs<Input>("depth over both flanges", "width of the flanges", "thickness of a flange"),
           Fields{Choice{&Input::fabrication, "fabrication", "manufacture (rolled or welded), for its buckling curves"}
                      .may_be_missing()});

  struct Result : Properties {
    double w_t = unset<double>, w_r = unset<double>;
  };
  static constexpr auto results =
      join(property_fields<Result>(),
           Fields{Field{&Result::w_t, "w_t", ratio, "web over flange thickness, for the torsion constant"}.limit(
                      ranges_of_I.least_web, ranges_of_I.most_web),
                  Field{&Result::w_r, "w_r", ratio, "fillet over flange thickness, for the torsion constant"}.limit(
                      0, ranges_of_I.most_fillet)});

  static constexpr std::array rules{Rule<Input>{[](const Input& in) { return 2.0 * (in.t_f + in.r) <= in.h; },
                                                "t_f, r, h", "h is too small for flanges and fillets"},
                                    Rule<Input>{[](const Input& in) { return in.t_w + 2.0 * in.r <= in.b; },
                                                "t_w, r, b", "b is too small for web and fillets"}};
  static constexpr std::array modes{torsion_mode<Input>("w_t, w_r")};

  template <class Tracer>
  static Result own(const Input& in, Tracer& trace);
  static Extremes extremes(const Input& in);
  static Contours contours(const Input& in);
  static void describe(const Input& in, SectionRecord& section);
};

}  // namespace loadpath::section
