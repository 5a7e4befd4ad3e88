// A section put together from parts: plain shapes and rolled sections of the tables, each at its place and angle.
//
// Second moments by Steiner, exact. Sign: an angle turns a part counter-clockwise about its own origin, which is then
// put to y, z. The parts act as one: their connection is not checked. Parts that overlap are refused, for what both
// cover would count twice; a separate one is reported. Not covered: torsion of closed cells that parts form, warping,
// the shear centre. Each part has the origin of its own calculator: a channel the middle of its back, an angle its
// corner, a T the middle of its upper face, the others their centre.
#pragma once

#include "calculators/section/built_up_types.hpp"
#include "calculators/section/properties/outline.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::section {

struct BuiltUp : BuiltUpTypes {
  static constexpr auto id = "section.built_up";
  static constexpr auto title = "Built-up section";
  static constexpr auto scope =
      "Area, centroid, second moments of area, principal axes and section moduli of a section assembled from, "
      "or cut out of, up to 20 shapes or tabulated sections acting compositely; the torsion constant is the "
      "lower-bound sum of the parts; connection between parts and warping are not covered.";
  static constexpr auto source = "[Garrison], [ME102]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "built-up section, composite section, compound section, plate girder, welded section, parallel axis theorem, "
      "Steiner, zusammengesetzter Querschnitt, Steinerscher Satz, составное сечение, теорема Штейнера";
  static constexpr auto example = R"([project]
title = "Two channels, toes outwards, with a plate below"

[girder]
calculator = "section.built_up"
parts = [
  { name = "right", section = "UPN 200", y = "10 mm" },
  { name = "left", section = "UPN 200", y = "-10 mm", angle = "180 deg" },
  { name = "plate", shape = "rectangle", b = "200 mm", h = "12 mm", z = "-106 mm" },
]
)";

  static bool parts_are_whole(const Input& in);
  static FieldFault incomplete(const Input& in);
  static bool is_full(const Input& in);
  static bool none_overlap(const Input& in);
  static FieldFault overlapping(const Input& in);
  static bool all_touch(const Input& in);
  static FieldFault apart(const Input& in);
  static constexpr Fields inputs{ListField{&Input::parts, "parts", "parts of the section"}};

  static constexpr auto results =
      join(property_fields<Result>(), Fields{ListField{&Result::parts, "parts", "the parts at their places"}});
  static constexpr std::array rules{
      Rule<Input>{&parts_are_whole, "parts", "a dimension of the shape of a part is missing", &incomplete},
      Rule<Input>{&is_full, "parts",
                  "the holes leave no section: they remove more than the material, or lie outside of it"},
      Rule<Input>{&none_overlap, "parts", "parts must not overlap: the common area would be included twice",
                  &overlapping},
      Rule<Input>{&all_touch, "parts", "each part must be connected to the others", &apart, true}};

  static constexpr std::array modes{Mode<Input>{"joined", "shear connection of the parts", [](const Input& in) {
                                                  return in.parts.size() < 2 ? Applies::no : shown_by(!all_touch(in));
                                                }}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::section
