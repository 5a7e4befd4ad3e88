// The profile of a cam as a user writes it: by the lift that it gives its follower, or by its shape.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

struct CamProfile {
  enum class Shape { sliding, swinging, flat, swinging_flat, circle, points };
  enum class Law {
    dwell,
    harmonic,
    cycloidal,
    polynomial_345,
    polynomial_4567,
    modified_sine,
    modified_trapezoid,
    constant_velocity
  };
  enum class Sense { counter_clockwise, clockwise };
  enum class Hand { left, right };
  struct Segment {
    Law law = Law::dwell;
    double angle = unset<double>;
    Length lift = unset<Length>;
    double swing = unset<double>;
    static constexpr Fields fields{
        Choice{&Segment::law, "law", "law of motion over the segment"}.may_be_missing(),
        Field{&Segment::angle, "angle", deg, "cam angle of the segment"}.within(0, 360),
        Field{&Segment::lift, "lift", mm, "rise of the follower over the segment; negative: fall"}.may_be_missing(),
        Field{&Segment::swing, "swing", deg, "swinging, swinging_flat: the same of the arm or face, away from the cam"}
            .within(-180, 180)
            .may_be_missing()};
  };
  struct Vertex {
    Length x = unset<Length>, y = unset<Length>;
    static constexpr Fields fields{Field{&Vertex::x, "x", mm, "x coordinate in the axes of the profile"},
                                   Field{&Vertex::y, "y", mm, "y coordinate in the axes of the profile"}};
  };

  Name name;
  Shape shape = Shape::sliding;
  Length base = unset<Length>, roller = 0.0 * m.one, offset = 0.0 * m.one;
  Length pivot = unset<Length>, arm = unset<Length>;
  Hand side = Hand::left;
  Sense sense = Sense::counter_clockwise;
  std::vector<Segment> segments;
  Length r = unset<Length>;
  Vertex centre;
  std::vector<Vertex> points;
  static constexpr Fields fields{
      NameField{&CamProfile::name, "name", "name of the profile"},
      Choice{&CamProfile::shape, "shape", "type of definition"},
      Field{&CamProfile::base, "base", mm, "by lift: radius of the base circle of the cam itself"}
          .positive()
          .may_be_missing(),
      Field{&CamProfile::roller, "roller", mm,
            "sliding, swinging: radius of the roller for which it is made; 0: an edge"}
          .at_least(0),
      Field{&CamProfile::offset, "offset", mm,
            "sliding: of the guide from the cam's axis, to the left as the follower rises; swinging_flat: of the face "
            "from its pivot, towards the cam"},
      Field{&CamProfile::pivot, "pivot", mm, "swinging, swinging_flat: distance of the pivot from the cam's axis"}
          .positive()
          .may_be_missing(),
      Field{&CamProfile::arm, "arm", mm, "swinging: length of the arm, from its pivot to the roller"}
          .positive()
          .may_be_missing(),
      Choice{&CamProfile::side, "side",
             "swinging, swinging_flat: where roller or face is, as seen from the cam's axis to the pivot"}
          .may_be_missing(),
      Choice{&CamProfile::sense, "sense", "by lift: direction in which the cam rotates through the segments"}
          .may_be_missing(),
      ListField{&CamProfile::segments, "segments",
                "by lift: rises, dwells and falls over a revolution; the first begins where the guide, or the line to "
                "the pivot, is the profile's x axis"}
          .may_be_missing(),
      Field{&CamProfile::r, "r", mm, "circle: its radius"}.positive().may_be_missing(),
      Group{&CamProfile::centre, "centre", "circle: its centre, from the cam's axis"}.as_array().may_be_missing(),
      ListField{&CamProfile::points, "points", "points: of the profile, all round, from the cam's axis"}
          .as_arrays()
          .may_be_missing()};
};

/// Whether it is given by the swing of its follower, not by a lift along a guide.
constexpr bool is_by_swing(CamProfile::Shape shape) {
  using enum CamProfile::Shape;
  return shape == swinging || shape == swinging_flat;
}
constexpr bool is_by_lift(CamProfile::Shape shape) {
  using enum CamProfile::Shape;
  return shape == sliding || shape == flat || is_by_swing(shape);
}

constexpr auto choices_of(CamProfile::Shape) {
  using T = CamProfile::Shape;
  return std::array{
      ChoiceName<T>{T::sliding, "sliding", "by the lift of a follower with a roller or an edge on a straight guide"},
      ChoiceName<T>{T::swinging, "swinging", "by the swing of an arm with a roller or an edge"},
      ChoiceName<T>{T::flat, "flat", "by the lift of a flat face on a straight guide square to it"},
      ChoiceName<T>{T::swinging_flat, "swinging_flat", "by the swing of a flat face about a pivot"},
      ChoiceName<T>{T::circle, "circle", "a circle, as of an eccentric"},
      ChoiceName<T>{T::points, "points", "smooth through points, with a continuous curvature"}};
}
constexpr auto choices_of(CamProfile::Law) {
  using T = CamProfile::Law;
  return std::array{
      ChoiceName<T>{T::dwell, "dwell", "the follower rests"},
      ChoiceName<T>{T::harmonic, "harmonic", "simple harmonic; the acceleration jumps at a dwell"},
      ChoiceName<T>{T::cycloidal, "cycloidal", "sinusoidal acceleration (cycloidal); no jump at a dwell"},
      ChoiceName<T>{T::polynomial_345, "3-4-5", "polynomial, no acceleration at the ends"},
      ChoiceName<T>{T::polynomial_4567, "4-5-6-7", "polynomial, neither acceleration nor jerk at the ends"},
      ChoiceName<T>{T::modified_sine, "modified_sine", "sines of the acceleration, low peaks of velocity and torque"},
      ChoiceName<T>{T::modified_trapezoid, "modified_trapezoid", "the minimum peak of acceleration of these laws"},
      ChoiceName<T>{T::constant_velocity, "constant_velocity", "refused: its acceleration at the ends is infinite"}};
}
constexpr auto choices_of(CamProfile::Sense) {
  using T = CamProfile::Sense;
  return std::array{ChoiceName<T>{T::counter_clockwise, "counter_clockwise", "counter-clockwise"},
                    ChoiceName<T>{T::clockwise, "clockwise", "clockwise"}};
}
constexpr auto choices_of(CamProfile::Hand) {
  using T = CamProfile::Hand;
  return std::array{ChoiceName<T>{T::left, "left", "on the left"}, ChoiceName<T>{T::right, "right", "on the right"}};
}

}  // namespace loadpath::planar
