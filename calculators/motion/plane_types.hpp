// Input and result of motion.plane.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::motion {

struct PlaneTypes {
  enum class Case { given, meeting, tips, inclined };
  enum class Kind { rotation, translation, rest };

  struct Place {
    Length x = unset<Length>, y = unset<Length>;
    static constexpr Fields fields{Field{&Place::x, "x", m, "coordinate x"}.may_be_missing(),
                                   Field{&Place::y, "y", m, "coordinate y"}.may_be_missing()};
  };
  struct Point {
    Name name;
    Length x = unset<Length>, y = unset<Length>;
    static constexpr Fields fields{NameField{&Point::name, "name", "name of the point"}.may_be_missing(),
                                   Field{&Point::x, "x", m, "coordinate x"}, Field{&Point::y, "y", m, "coordinate y"}};
  };
  static constexpr std::size_t most_points = 16;

  struct Input {
    Place A, B;
    Speed v_A = unset<Speed>;
    double alpha_A = 0.0;
    AngularSpeed omega = unset<AngularSpeed>;
    Speed v_B = unset<Speed>;
    double alpha_B = unset<double>;
    Acceleration a_A = unset<Acceleration>;
    double alpha_aA = 0.0;
    AngularAcceleration epsilon = unset<AngularAcceleration>;
    double alpha_aB = unset<double>;
    List<Point, most_points> points;
  };

  struct PointState {
    Name name;
    Length x = unset<Length>, y = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>, v = unset<Speed>;
    double gamma = unset<double>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>, a = unset<Acceleration>;
    static constexpr Fields fields{NameField{&PointState::name, "name", "name of the point"},
                                   Field{&PointState::x, "x", m, "coordinate x"},
                                   Field{&PointState::y, "y", m, "coordinate y"},
                                   Field{&PointState::v_x, "v_x", m_per_s, "velocity along x"},
                                   Field{&PointState::v_y, "v_y", m_per_s, "velocity along y"},
                                   Field{&PointState::v, "v", m_per_s, "speed"},
                                   Field{&PointState::gamma, "gamma", deg, "direction of the velocity, from x"},
                                   Field{&PointState::a_x, "a_x", m_per_s2, "acceleration along x"},
                                   Field{&PointState::a_y, "a_y", m_per_s2, "acceleration along y"},
                                   Field{&PointState::a, "a", m_per_s2, "acceleration"}};
  };

  struct Result {
    Case found = Case::given;
    Kind kind = Kind::rotation;
    Length AB = unset<Length>;
    double beta = unset<double>;
    Speed v_B = unset<Speed>;
    AngularSpeed omega = unset<AngularSpeed>;
    Length x_P = unset<Length>, y_P = unset<Length>, PA = unset<Length>;
    AngularAcceleration epsilon = unset<AngularAcceleration>;
    Acceleration a_B = unset<Acceleration>;
    Length x_Q = unset<Length>, y_Q = unset<Length>;
    List<PointState, most_points + 2> states;
  };
};

constexpr auto choices_of(PlaneTypes::Case) {
  using C = PlaneTypes::Case;
  return std::array{
      ChoiceName<C>{C::given, "given", "the angular velocity is given"},
      ChoiceName<C>{C::meeting, "meeting", "the perpendiculars to the velocities meet in the pole"},
      ChoiceName<C>{C::tips, "tips", "both velocities are perpendicular to AB: the line through their tips"},
      ChoiceName<C>{C::inclined, "inclined", "parallel velocities, oblique to AB: a translation"}};
}
constexpr auto choices_of(PlaneTypes::Kind) {
  using K = PlaneTypes::Kind;
  return std::array{ChoiceName<K>{K::rotation, "rotation", "turns about the pole of velocities"},
                    ChoiceName<K>{K::translation, "translation", "all points have one velocity; no pole"},
                    ChoiceName<K>{K::rest, "rest", "no point moves"}};
}

}  // namespace loadpath::motion
