// A section put together from parts: plain shapes and rolled sections of the tables, each at its place and angle.
//
// Second moments by Steiner, exact. Sign: an angle turns a part counter-clockwise about its own origin, which is then
// put to y, z. The parts act as one: their connection is not checked. Parts that overlap are refused, for what both
// cover would count twice; one that stands apart is told. Not covered: torsion of closed cells that parts form,
// warping, the shear centre.
#pragma once

#include "calculators/section/properties/outline.hpp"
#include "lib/calculator/join.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::section {

struct BuiltUp {
  static constexpr auto id = "section.built_up";
  static constexpr auto title = "Section: built up from parts";
  static constexpr auto scope =
      "Area, centroid, second moments, principal axes and moduli of a section that is put together from at most 20 "
      "parts: circles, rings, rectangles, I, channels, angles, T, hollow rectangles, and rows of the section tables; "
      "or "
      "cut from them. Each part has the origin of its own calculator (a channel the middle of its back, an angle its "
      "corner, a T the middle of its upper face, others their centre). The parts act as one. I_t is the sum of the "
      "parts' own, a lower bound: closed cells that the parts form would add to it. Connection is not "
      "checked; warping is not covered.";
  static constexpr auto source = "[Garrison], [ME102]";
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

  enum class Shape { table, circle, ring, rectangle, I, channel, angle, T, hollow };
  enum class As { full, hole };

  struct Part {
    Name name;
    Formula section;
    Shape shape = Shape::table;
    Length h = unset<Length>, b = unset<Length>;
    Length d = unset<Length>, d_i = unset<Length>;
    Length t = unset<Length>, t_w = unset<Length>, t_f = unset<Length>;
    Length r = from_si<Length>(0.0), r_2 = from_si<Length>(0.0);
    Length y = from_si<Length>(0.0), z = from_si<Length>(0.0);
    double angle = 0.0;
    As as = As::full;
    static constexpr Fields fields{
        NameField{&Part::name, "name", "name of the part"}.may_be_missing(),
        FormulaField{&Part::section, "section", "row of the section tables, in place of a shape: IPE 200"}
            .may_be_missing(),
        Choice{&Part::shape, "shape", "shape of the part"}.may_be_missing(),
        Field{&Part::h, "h", mm, "height or depth"}.positive().may_be_missing(),
        Field{&Part::b, "b", mm, "width"}.positive().may_be_missing(),
        Field{&Part::d, "d", mm, "diameter of a circle or ring"}.positive().may_be_missing(),
        Field{&Part::d_i, "d_i", mm, "bore of a ring"}.at_least(0).may_be_missing(),
        Field{&Part::t, "t", mm, "wall of a hollow rectangle, leg of an angle"}.positive().may_be_missing(),
        Field{&Part::t_w, "t_w", mm, "web of an I, channel or T"}.positive().may_be_missing(),
        Field{&Part::t_f, "t_f", mm, "flange of an I, channel or T"}.positive().may_be_missing(),
        Field{&Part::r, "r", mm, "fillet; outer radius of a hollow rectangle"}.at_least(0).may_be_missing(),
        Field{&Part::r_2, "r_2", mm, "toe of an angle; inner radius of a hollow rectangle"}
            .at_least(0)
            .may_be_missing(),
        Field{&Part::y, "y", mm, "place of its origin, to the right"}.within(-1e6, 1e6).may_be_missing(),
        Field{&Part::z, "z", mm, "place of its origin, upwards"}.within(-1e6, 1e6).may_be_missing(),
        Field{&Part::angle, "angle", deg, "turned about its origin, counter-clockwise"}.may_be_missing(),
        Choice{&Part::as, "as", "full, or cut out"}.may_be_missing()};
  };
  struct Input {
    List<Part, 20> parts;
  };
  static bool parts_are_whole(const Input& in);
  static FieldFault incomplete(const Input& in);
  static bool is_full(const Input& in);
  static bool none_overlap(const Input& in);
  static FieldFault overlapping(const Input& in);
  static bool all_touch(const Input& in);
  static FieldFault apart(const Input& in);
  static constexpr Fields inputs{ListField{&Input::parts, "parts", "what the section is put together from"}};

  /// A part at its place: about its own centroid, in the axes of the whole.
  struct Placed {
    Name name;
    Area A = unset<Area>;
    Length y_S = unset<Length>, z_S = unset<Length>;
    SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_yz = unset<SecondMoment>;
    static constexpr Fields fields{NameField{&Placed::name, "name", "name of the part"},
                                   Field{&Placed::A, "A", mm2, "area, negative where cut out"},
                                   Field{&Placed::y_S, "y_S", mm, "centroid, to the right"},
                                   Field{&Placed::z_S, "z_S", mm, "centroid, upwards"},
                                   Field{&Placed::I_y, "I_y", mm4, "second moment about its own centroid"},
                                   Field{&Placed::I_z, "I_z", mm4, "second moment about its own centroid"},
                                   Field{&Placed::I_yz, "I_yz", mm4, "product of area about its own centroid"}};
  };
  struct Result : Properties {
    List<Placed, 20> parts;
  };
  static constexpr auto results =
      join(property_fields<Result>(), Fields{ListField{&Result::parts, "parts", "the parts at their places"}});
  static constexpr std::array rules{
      Rule<Input>{&parts_are_whole, "parts", "a part lacks what its shape needs", &incomplete},
      Rule<Input>{&is_full, "parts",
                  "the holes leave no section: more is cut out than there is, or beside the material"},
      Rule<Input>{&none_overlap, "parts", "parts overlap: what both cover would count twice", &overlapping},
      Rule<Input>{&all_touch, "parts", "a part stands apart from the others", &apart, true}};

  static constexpr std::array modes{
      Mode<Input>{"joined", "parts that are not joined, and do not act as one",
                  [](const Input& in) { return in.parts.size() < 2 ? Applies::no : shown_by(!all_touch(in)); }}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(BuiltUp::Shape) {
  using Shape = BuiltUp::Shape;
  return std::array{ChoiceName<Shape>{Shape::table, "table", "a row of the section tables: `section` names it"},
                    ChoiceName<Shape>{Shape::circle, "circle", "d"},
                    ChoiceName<Shape>{Shape::ring, "ring", "d, d_i"},
                    ChoiceName<Shape>{Shape::rectangle, "rectangle", "b, h"},
                    ChoiceName<Shape>{Shape::I, "I", "h, b, t_w, t_f, r"},
                    ChoiceName<Shape>{Shape::channel, "channel", "h, b, t_w, t_f, r"},
                    ChoiceName<Shape>{Shape::angle, "angle", "h, b, t, r, r_2"},
                    ChoiceName<Shape>{Shape::T, "T", "h, b, t_w, t_f, r"},
                    ChoiceName<Shape>{Shape::hollow, "hollow", "h, b, t, r, r_2"}};
}

constexpr auto choices_of(BuiltUp::As) {
  using As = BuiltUp::As;
  return std::array{ChoiceName<As>{As::full, "full", "material"}, ChoiceName<As>{As::hole, "hole", "cut out"}};
}

}  // namespace loadpath::section
