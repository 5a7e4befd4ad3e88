// Input and result of section.built_up.
#pragma once

#include "calculators/section/properties/outline.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::section {

struct BuiltUpTypes {
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
        Field{&Part::y, "y", mm, "position of its origin, to the right"}.within(-1e6, 1e6).may_be_missing(),
        Field{&Part::z, "z", mm, "position of its origin, upwards"}.within(-1e6, 1e6).may_be_missing(),
        Field{&Part::angle, "angle", deg, "turned about its origin, counter-clockwise"}.may_be_missing(),
        Choice{&Part::as, "as", "full, or cut out"}.may_be_missing()};
  };
  struct Input {
    List<Part, 20> parts;
  };

  /// A part at its place: about its own centroid, in the axes of the built-up section.
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
};

constexpr auto choices_of(BuiltUpTypes::Shape) {
  using Shape = BuiltUpTypes::Shape;
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

constexpr auto choices_of(BuiltUpTypes::As) {
  using As = BuiltUpTypes::As;
  return std::array{ChoiceName<As>{As::full, "full", "material"}, ChoiceName<As>{As::hole, "hole", "cut out"}};
}

}  // namespace loadpath::section
