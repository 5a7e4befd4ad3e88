// Motion of a point whose coordinates are laws of time: path, velocity, acceleration and its parts along the path.
//
// Decides nothing: it gives the state at one time with its derivation, a table of states at given times or evenly
// over a range, and over the range the path length, the displacement, the extremes of speed, and the equation of the
// path without the time, which holds between the given limits of the coordinates. Derivatives are exact. Sign: a_tau is
// positive where the speed grows; a_n and kappa are magnitudes. Source: [B26], [B28]. Not covered: laws with kinks or
// jumps; where the point rests there is no tangent, hence no a_tau, a_n and rho.
#pragma once

#include "calculators/motion/elimination/equation_text.hpp"
#include "calculators/motion/laws.hpp"
#include "calculators/motion/range.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/list.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct Point {
  static constexpr auto id = "motion.point";
  static constexpr auto title = "Kinematics of a point";
  static constexpr auto scope =
      "Path and its equation, velocity, acceleration with tangential and normal components, radius of curvature and "
      "distance travelled of a point from smooth laws of motion x(t), y(t), z(t).";
  static constexpr auto source = "[B26], [B28]";
  static constexpr auto headline = "v_max = {v_max}|v = {v}";
  static constexpr auto synonyms =
      "kinematics, particle, velocity, acceleration, trajectory, equation of the path, eliminate the time, tangential "
      "acceleration, normal acceleration, "
      "radius of curvature, Kinematik des Punktes, Bahnkurve, Normalbeschleunigung, кинематика точки, траектория, "
      "ускорение";
  static constexpr auto example = R"toml([project]
title = "A point on an ellipse"

[point]
calculator = "motion.point"
x = "3 m*sin(pi*t/(1 s))"
y = "5 m*cos(pi*t/(1 s))"
t = "0.25 s"
t_1 = "0 s"
t_2 = "2 s"
)toml";

  enum class Change { at_rest, steady, faster, slower };

  struct Instant {
    Time t = unset<Time>;
    static constexpr Fields fields{Field{&Instant::t, "t", sec, "a time"}};
  };
  static constexpr std::size_t most_states = 61;

  struct Input {
    LengthLaw x, y, z;
    Time t = unset<Time>;
    Time t_1 = unset<Time>, t_2 = unset<Time>;
    Whole rows = 13;
    List<Instant, most_states> times;
  };
  static constexpr Fields inputs{
      FormulaField{&Input::x, "x", "coordinate as a formula of the time t: \"3 m*sin(pi*t/(1 s))\""},
      FormulaField{&Input::y, "y", "coordinate as a formula of the time t; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::z, "z", "coordinate as a formula of the time t; omitted: 0"}.may_be_missing(),
      Field{&Input::t, "t", sec, "time at which the state is calculated"},
      Field{&Input::t_1, "t_1", sec, "start of the time range for path and distance, with t_2"}.may_be_missing(),
      Field{&Input::t_2, "t_2", sec, "end of the range, after t_1"}.may_be_missing(),
      Count{&Input::rows, "rows", 2, static_cast<int>(most_states), "states of the range in the table, ends included"}
          .may_be_missing(),
      ListField{&Input::times, "times", "times of the states in the table, in place of rows"}
          .as_arrays()
          .may_be_missing()};

  struct State {
    Time t = unset<Time>;
    Length x = unset<Length>, y = unset<Length>, z = unset<Length>;
    Speed v = unset<Speed>;
    Acceleration a_tau = unset<Acceleration>, a_n = unset<Acceleration>, a = unset<Acceleration>;
    Length rho = unset<Length>;
    static constexpr Fields fields{Field{&State::t, "t", sec, "time"},
                                   Field{&State::x, "x", m, "coordinate x"},
                                   Field{&State::y, "y", m, "coordinate y"},
                                   Field{&State::z, "z", m, "coordinate z"},
                                   Field{&State::v, "v", m_per_s, "speed"},
                                   Field{&State::a_tau, "a_tau", m_per_s2, "tangential acceleration"},
                                   Field{&State::a_n, "a_n", m_per_s2, "normal acceleration"},
                                   Field{&State::a, "a", m_per_s2, "acceleration"},
                                   Field{&State::rho, "rho", m, "radius of curvature"}};
  };

  struct Result {
    Length x_M = unset<Length>, y_M = unset<Length>, z_M = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>, v_z = unset<Speed>, v = unset<Speed>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>, a_z = unset<Acceleration>;
    Acceleration a = unset<Acceleration>, a_tau = unset<Acceleration>, a_n = unset<Acceleration>;
    Twist kappa = unset<Twist>;
    Length rho = unset<Length>;
    double gamma = unset<double>, cos_x = unset<double>, cos_y = unset<double>, cos_z = unset<double>;
    Change change = Change::at_rest;
    Length L = unset<Length>, Delta_r = unset<Length>;
    Speed v_m = unset<Speed>, v_L = unset<Speed>, v_max = unset<Speed>;
    Acceleration a_max = unset<Acceleration>;
    ShortText<255> path, path_z;
    PathForm form = PathForm::no_range;
    double e_path = unset<double>;
    Length x_min = unset<Length>, x_max = unset<Length>, y_min = unset<Length>, y_max = unset<Length>;
    Length z_min = unset<Length>, z_max = unset<Length>;
    List<State, most_states> states;
  };
  static constexpr Fields results{
      Field{&Result::x_M, "x_M", m, "coordinate x at the time t"},
      Field{&Result::y_M, "y_M", m, "coordinate y at the time t"},
      Field{&Result::z_M, "z_M", m, "coordinate z at the time t"},
      Field{&Result::v_x, "v_x", m_per_s, "velocity along x"},
      Field{&Result::v_y, "v_y", m_per_s, "velocity along y"},
      Field{&Result::v_z, "v_z", m_per_s, "velocity along z"},
      Field{&Result::v, "v", m_per_s, "speed"},
      Field{&Result::a_x, "a_x", m_per_s2, "acceleration along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "acceleration along y"},
      Field{&Result::a_z, "a_z", m_per_s2, "acceleration along z"},
      Field{&Result::a, "a", m_per_s2, "acceleration"},
      Field{&Result::a_tau, "a_tau", m_per_s2, "tangential acceleration, positive where the speed grows"},
      Field{&Result::a_n, "a_n", m_per_s2, "normal acceleration, towards the centre of curvature"},
      Field{&Result::kappa, "kappa", per_m, "curvature of the path"},
      Field{&Result::rho, "rho", m, "radius of curvature; none where the path is straight"},
      Field{&Result::gamma, "gamma", deg, "direction of the velocity in the plane xy, from x"},
      Field{&Result::cos_x, "cos_x", ratio, "direction cosine of the velocity: of its angle to x"},
      Field{&Result::cos_y, "cos_y", ratio, "direction cosine of the velocity: of its angle to y"},
      Field{&Result::cos_z, "cos_z", ratio, "direction cosine of the velocity: of its angle to z"},
      Choice{&Result::change, "change", "the point accelerates or decelerates"},
      Field{&Result::L, "L", m, "distance travelled from t_1 to t_2"},
      Field{&Result::Delta_r, "Delta_r", m, "displacement from t_1 to t_2, end from start"},
      Field{&Result::v_m, "v_m", m_per_s, "mean velocity from t_1 to t_2, the displacement over the time"},
      Field{&Result::v_L, "v_L", m_per_s, "mean speed from t_1 to t_2, distance / time"},
      Field{&Result::v_max, "v_max", m_per_s, "maximum speed from t_1 to t_2, at 257 times"},
      Field{&Result::a_max, "a_max", m_per_s2, "maximum acceleration from t_1 to t_2, at 257 times"},
      FormulaField{&Result::path, "path", "equation of the path in the plane xy, x and y in m"},
      FormulaField{&Result::path_z, "path_z", "second equation of a path in space, coordinates in m"},
      Choice{&Result::form, "form", "form of the path in the plane xy"},
      Field{&Result::e_path, "e_path", ratio,
            "deviation of 257 points of the path from its equations, relative to the extent of the path"},
      Field{&Result::x_min, "x_min", m, "minimum x from t_1 to t_2"},
      Field{&Result::x_max, "x_max", m, "maximum x from t_1 to t_2"},
      Field{&Result::y_min, "y_min", m, "minimum y from t_1 to t_2"},
      Field{&Result::y_max, "y_max", m, "maximum y from t_1 to t_2"},
      Field{&Result::z_min, "z_min", m, "minimum z from t_1 to t_2"},
      Field{&Result::z_max, "z_max", m, "maximum z from t_1 to t_2"},
      ListField{&Result::states, "states", "states at the given times, or evenly over the range"}};

  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool laws_are_smooth(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr std::array rules =
      join(std::array{Rule<Input>{&laws_read, "x, y, z", "x, y and z must be lengths as formulas of t", &law_fault}},
           range_rules<Input>(),
           std::array{Rule<Input>{&laws_are_smooth, "x, y, z, t, t_1, t_2, times",
                                  "the laws must have values at these times", &gap}});

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Point::Change) {
  using C = Point::Change;
  return std::array{ChoiceName<C>{C::at_rest, "at_rest", "the point rests at this time"},
                    ChoiceName<C>{C::steady, "steady", "the speed does not change at this time"},
                    ChoiceName<C>{C::faster, "faster", "accelerated"}, ChoiceName<C>{C::slower, "slower", "retarded"}};
}
constexpr auto choices_of(PathForm) {
  using F = PathForm;
  return std::array{ChoiceName<F>{F::no_range, "no_range", "t_1 and t_2 are not given"},
                    ChoiceName<F>{F::no_equation, "no_equation", "no closed equation without the time was found"},
                    ChoiceName<F>{F::point, "point", "the point rests from t_1 to t_2"},
                    ChoiceName<F>{F::line, "line", "straight line"},
                    ChoiceName<F>{F::circle, "circle", "circle"},
                    ChoiceName<F>{F::ellipse, "ellipse", "ellipse"},
                    ChoiceName<F>{F::parabola, "parabola", "parabola"},
                    ChoiceName<F>{F::hyperbola, "hyperbola", "hyperbola"},
                    ChoiceName<F>{F::other, "other_curve", "another curve, by its equation"}};
}

}  // namespace loadpath::motion
