// The drives of a planar mechanism: a crank and cylinders, at a speed or by a law of motion.
#pragma once

#include "calculators/mechanism/input/parts.hpp"
#include "lib/calculator/field.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

enum class Impending { either, forward, backward };
enum class LawShape { spline, monotone };

struct Crank {
  Name joint, to;
  AngularSpeed speed = 0.0 * rad_per_s.one;
  AngularAcceleration acceleration = 0.0 * rad_per_s2.one;
  double start = 0.0;
  Whole positions = 360, turns = 1;
  struct Place {
    double angle = unset<double>;
    static constexpr Fields fields{Field{&Place::angle, "angle", deg, "crank angle"}.within(-3600, 3600)};
  };
  std::vector<Place> at;
  struct Moment {
    Time t = unset<Time>;
    double angle = unset<double>;
    static constexpr Fields fields{Field{&Moment::t, "t", sec, "time"},
                                   Field{&Moment::angle, "angle", deg, "crank angle then"}.within(-36000, 36000)};
  };
  std::vector<Moment> law;
  LawShape law_shape = LawShape::spline;
  Formula angle_of_t;
  Time duration = unset<Time>;
  Impending impending = Impending::either;
  static constexpr Fields fields{
      NameField{&Crank::joint, "joint", "revolute joint that is driven"},
      NameField{&Crank::to, "to",
                "point of the driven link that the crank angle is measured to; omitted: the link's x axis"}
          .may_be_missing(),
      Field{&Crank::speed, "speed", rad_per_s, "angular velocity, counter-clockwise positive"}.also("n"),
      Field{&Crank::acceleration, "acceleration", rad_per_s2, "angular acceleration at every position"},
      Field{&Crank::start, "start", deg, "crank angle of the first position of a revolution"}.within(-3600, 3600),
      Count{&Crank::positions, "positions", 8, 7200, "positions of a cycle"},
      Count{&Crank::turns, "turns", 1, 100, "revolutions of the crank per cycle of the mechanism"},
      ListField{&Crank::at, "at", "given crank angles, rising or falling, instead of a full revolution"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Crank::law, "law",
                "crank angles over time, replaces a revolution at a given speed; smooth, from rest to rest"}
          .as_arrays()
          .may_be_missing(),
      Choice{&Crank::law_shape, "law_shape", "interpolation of 'law' between its points"}.may_be_missing(),
      FormulaField{&Crank::angle_of_t, "angle_of_t",
                   "crank angle as a formula of the time t, in place of a law by points: 30 deg + 9 deg*sin(t/(1 s))"}
          .may_be_missing(),
      Field{&Crank::duration, "duration", sec, "time for which the formula holds, from t = 0 s"}
          .positive()
          .may_be_missing(),
      Choice{&Crank::impending, "impending", "direction of impending rotation at rest (sets the friction direction)"}
          .may_be_missing()};
};

struct Cylinder {
  Name name, joint;
  Speed speed = 0.0 * m_per_s.one;
  Acceleration acceleration = 0.0 * m_per_s2.one;
  Length from = unset<Length>, to = unset<Length>;
  struct Moment {
    Time t = unset<Time>;
    Length place = unset<Length>;
    static constexpr Fields fields{Field{&Moment::t, "t", sec, "time"},
                                   Field{&Moment::place, "place", mm, "position along the guide then"}};
  };
  std::vector<Moment> law;
  LawShape law_shape = LawShape::spline;
  Formula place_of_t;
  Time duration = unset<Time>;
  Impending impending = Impending::either;
  Pair links, points;
  Force F = unset<Force>;
  Name course;
  static constexpr Fields fields{
      NameField{&Cylinder::name, "name", "name of the drive"},
      NameField{&Cylinder::joint, "joint", "prismatic or slot joint that is driven, of links that are written out"}
          .may_be_missing(),
      Group{&Cylinder::links, "links",
            "in place of joint: the two links that it lies between, itself without mass; the ground is called ground"}
          .as_array()
          .may_be_missing(),
      Group{&Cylinder::points, "points", "its ends, on the first and on the second link; positions are its lengths"}
          .as_array()
          .may_be_missing(),
      Field{&Cylinder::F, "F", N, "between two points: given force in place of a drive, pushing the ends apart"}
          .may_be_missing(),
      NameField{&Cylinder::course, "course", "load curve of F, one of the courses"}.may_be_missing(),
      Field{&Cylinder::speed, "speed", m_per_s, "speed of the first link along the guide"},
      Field{&Cylinder::acceleration, "acceleration", m_per_s2, "acceleration along the guide"},
      Field{&Cylinder::from, "from", mm, "start position; as assembled if omitted"}.may_be_missing(),
      Field{&Cylinder::to, "to", mm, "end position of a stroke"}.may_be_missing(),
      ListField{&Cylinder::law, "law", "places over time, in place of a stroke; smooth, from rest to rest"}
          .as_arrays()
          .may_be_missing(),
      Choice{&Cylinder::law_shape, "law_shape", "interpolation of 'law' between its points"}.may_be_missing(),
      FormulaField{&Cylinder::place_of_t, "place_of_t",
                   "place along the guide as a formula of the time t, in place of a law by points"}
          .may_be_missing(),
      Field{&Cylinder::duration, "duration", sec, "time for which the formula holds, from t = 0 s"}
          .positive()
          .may_be_missing(),
      Choice{&Cylinder::impending, "impending", "direction of impending motion at rest (sets the friction direction)"}
          .may_be_missing()};
};

constexpr auto choices_of(Impending) {
  using T = Impending;
  return std::array{ChoiceName<T>{T::either, "either", "not stated: the effort is a band between both directions"},
                    ChoiceName<T>{T::forward, "forward", "in the positive direction of the drive"},
                    ChoiceName<T>{T::backward, "backward", "in the negative direction of the drive"}};
}
constexpr auto choices_of(LawShape) {
  using T = LawShape;
  return std::array{ChoiceName<T>{T::spline, "spline", "a cubic spline: gentle, but it may swing beyond the points"},
                    ChoiceName<T>{T::monotone, "monotone", "never beyond the points; rests where they turn or dwell"}};
}

}  // namespace loadpath::planar
