// Rotation of a body about a fixed axis by a law phi(t): speed, acceleration, and a point of the body.
//
// Sign: counter-clockwise positive, as phi. The acceleration of the point is given by its parts along the circle and to
// the axis. Source: [B28]. Not covered: laws with kinks or jumps.
#pragma once

#include "calculators/motion/laws.hpp"
#include "calculators/motion/range.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct Rotation {
  static constexpr auto id = "motion.rotation";
  static constexpr auto title = "Rotation about a fixed axis";
  static constexpr auto scope =
      "Angular velocity and acceleration of a body from a smooth law phi(t), velocity and acceleration of one "
      "of its points, and revolutions over a time range.";
  static constexpr auto source = "[B28]";
  static constexpr auto headline = "omega = {omega}";
  static constexpr auto synonyms =
      "rotation, angular velocity, angular acceleration, revolutions, fixed axis, Drehung um feste Achse, "
      "Winkelgeschwindigkeit, Winkelbeschleunigung, вращение вокруг неподвижной оси, угловая скорость";
  static constexpr auto example = R"toml([project]
title = "A shaft that runs up"

[shaft_end]
calculator = "motion.rotation"
phi = "90 deg*(t/(1 s))^2"
t = "2 s"
R = "150 mm"
t_1 = "0 s"
t_2 = "2 s"
)toml";

  enum class Change { at_rest, steady, faster, slower };

  struct Input {
    AngleLaw phi;
    Time t = unset<Time>;
    Length R = unset<Length>;
    double phi_M = 0.0;
    Time t_1 = unset<Time>, t_2 = unset<Time>;
  };
  static constexpr Fields inputs{
      FormulaField{&Input::phi, "phi", "angle as a formula of the time t: \"90 deg*(t/(1 s))^2\""},
      Field{&Input::t, "t", sec, "time at which the state is calculated"},
      Field{&Input::R, "R", mm, "distance of the point from the axis"}.at_least(0).usually(0.1, 1e5).may_be_missing(),
      Field{&Input::phi_M, "phi_M", deg, "direction from the axis to the point at phi = 0, from x"},
      Field{&Input::t_1, "t_1", sec, "start of the range in which revolutions are counted, with t_2"}.may_be_missing(),
      Field{&Input::t_2, "t_2", sec, "end of the range, after t_1"}.may_be_missing()};

  struct Result {
    double phi_t = unset<double>;
    AngularSpeed omega = unset<AngularSpeed>, n = unset<AngularSpeed>;
    AngularAcceleration epsilon = unset<AngularAcceleration>;
    Change change = Change::at_rest;
    double Delta_phi = unset<double>, turns = unset<double>;
    AngularSpeed omega_m = unset<AngularSpeed>;
    Speed v = unset<Speed>;
    Acceleration a_tau = unset<Acceleration>, a_n = unset<Acceleration>, a = unset<Acceleration>;
    double mu = unset<double>;
    Length x_M = unset<Length>, y_M = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::phi_t, "phi_t", deg, "angle at the time t"},
      Field{&Result::omega, "omega", rad_per_s, "angular velocity, signed"},
      Field{&Result::n, "n", rpm, "angular velocity in revolutions per minute, signed"},
      Field{&Result::epsilon, "epsilon", rad_per_s2, "angular acceleration, signed"},
      Choice{&Result::change, "change", "the body accelerates or decelerates"},
      Field{&Result::Delta_phi, "Delta_phi", deg, "angle turned from t_1 to t_2, signed"},
      Field{&Result::turns, "turns", ratio, "revolutions from t_1 to t_2, signed"},
      Field{&Result::omega_m, "omega_m", rad_per_s, "mean angular velocity from t_1 to t_2"},
      Field{&Result::v, "v", m_per_s, "speed of the point"},
      Field{&Result::a_tau, "a_tau", m_per_s2, "tangential acceleration, positive counter-clockwise"},
      Field{&Result::a_n, "a_n", m_per_s2, "normal acceleration, towards the axis"},
      Field{&Result::a, "a", m_per_s2, "acceleration of the point"},
      Field{&Result::mu, "mu", deg, "angle of the acceleration against the direction to the axis"},
      Field{&Result::x_M, "x_M", mm, "coordinate x of the point, from the axis"},
      Field{&Result::y_M, "y_M", mm, "coordinate y of the point, from the axis"},
      Field{&Result::v_x, "v_x", m_per_s, "velocity of the point along x"},
      Field{&Result::v_y, "v_y", m_per_s, "velocity of the point along y"},
      Field{&Result::a_x, "a_x", m_per_s2, "acceleration of the point along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "acceleration of the point along y"}};

  static bool law_reads(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool law_is_smooth(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules = join(
      std::array{Rule<Input>{&law_reads, "phi", "phi must be an angle as a formula of t", &law_fault}},
      range_rules<Input>(),
      std::array{Rule<Input>{&law_is_smooth, "phi, t, t_1, t_2", "the law must have a value at these times", &gap}});

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Rotation::Change) {
  using C = Rotation::Change;
  return std::array{ChoiceName<C>{C::at_rest, "at_rest", "the body is at rest at this time"},
                    ChoiceName<C>{C::steady, "steady", "the angular velocity does not change at this time"},
                    ChoiceName<C>{C::faster, "faster", "accelerated"}, ChoiceName<C>{C::slower, "slower", "retarded"}};
}

}  // namespace loadpath::motion
