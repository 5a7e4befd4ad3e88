// A section bounded by straight lines, with holes: by Green's theorem, exact.
//
// Not covered: torsion (see section.solid_torsion), warping, the shear centre. Curves are followed
// by points: the area of a circle of n points is too small by (2 pi / n)^2 / 6.
#pragma once

#include "calculators/section/properties/outline.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::section {

struct Polygon {
  static constexpr auto id = "section.polygon";
  static constexpr auto title = "Polygonal section with holes";
  static constexpr auto scope =
      "Area, centroid, second moments of area, principal axes and section moduli of a polygon with up to 64 "
      "corners and 8 holes; moduli about y and z apply only where these are principal axes; torsion constant: "
      "section.solid_torsion.";
  static constexpr auto source = "[Garrison], [ME102]";
  static constexpr auto headline = "A = {A}, I = {I_max}";
  static constexpr auto synonyms =
      "polygon, arbitrary section, section with holes, section properties, principal axes, product of inertia, "
      "Polygonquerschnitt, beliebiger Querschnitt, многоугольник, произвольное сечение";
  static constexpr auto example = R"([project]
title = "Frame with a window"

[frame]
calculator = "section.polygon"
points = [["0 mm", "0 mm"], ["80 mm", "0 mm"], ["80 mm", "20 mm"], ["20 mm", "60 mm"], ["0 mm", "60 mm"]]
holes = [{ points = [["10 mm", "10 mm"], ["40 mm", "10 mm"], ["10 mm", "40 mm"]] }]
)";

  struct Corner {
    Length y = unset<Length>, z = unset<Length>;
    static constexpr Fields fields{Field{&Corner::y, "y", mm, "to the right"}.within(-1e6, 1e6),
                                   Field{&Corner::z, "z", mm, "upwards"}.within(-1e6, 1e6)};
  };
  struct Hole {
    List<Corner, 32> points;
    static constexpr Fields fields{
        ListField{&Hole::points, "points", "corners of the hole, in order around the edge"}.as_arrays()};
  };
  struct Input {
    List<Corner, 64> points;
    List<Hole, 8> holes;
  };
  static bool has_corners(const Input& in);
  static bool is_simple(const Input& in);
  static FieldFault crossing(const Input& in);
  static bool holes_are_inside(const Input& in);
  static FieldFault hole_outside(const Input& in);
  static constexpr Fields inputs{
      ListField{&Input::points, "points", "corners of the contour, in order around the edge"}.as_arrays(),
      ListField{&Input::holes, "holes", "holes"}.may_be_missing()};

  using Result = Properties;
  static constexpr auto results = results_of_properties;
  static constexpr std::array rules{
      Rule<Input>{&has_corners, "points, holes", "a contour and each hole need at least three corners"},
      Rule<Input>{&is_simple, "points, holes", "the sides of a contour must not touch or cross each other", &crossing},
      Rule<Input>{&holes_are_inside, "holes, points", "every hole must lie inside the contour and clear of other holes",
                  &hole_outside}};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::section
