// The motion of a point mass under given forces: the second problem of dynamics.
//
// The forces are functions of time, position and velocity; m a = F is integrated from the given start to t_2, or to the
// first zero of `until`, by steps of controlled error (Dormand and Prince, order 5). Kinetic energy and work are
// calculated separately, and both are shown with the estimated error of the solution. Sign: along the axes.
// Source: [B32], [B34]. Not covered: impacts and constraints that start or end on the way. Two zeros of `until` closer
// than 1/500 of t_2 may be missed; forces that jump are followed as far as steps can be shortened.
#pragma once

#include "calculators/dynamics/free_motion.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::dynamics {

struct Motion {
  static constexpr auto id = "dynamics.motion";
  static constexpr auto title = "Motion under given forces (forward dynamics)";
  static constexpr auto scope =
      "Position, velocity, path and work of a point mass under forces that depend on time, position and velocity: "
      "air resistance, springs, friction; impacts are not covered.";
  static constexpr auto source = "[B32], [B34]";
  static constexpr auto headline = "v_E = {v_E}";
  static constexpr auto synonyms =
      "forward dynamics, equation of motion, differential equation, air resistance, drag, terminal velocity, free "
      "fall, "
      "oscillation, spring, damping, braking distance, projectile with drag, Luftwiderstand, Bewegungsgleichung, "
      "freier Fall, Bremsweg, Schwingung, сопротивление воздуха, дифференциальное уравнение движения, колебания";
  static constexpr auto example = R"toml([project]
title = "A ball thrown against the resistance of the air"

[ball]
calculator = "dynamics.motion"
m = "0.145 kg"
v_x0 = "30 m/s"
v_y0 = "20 m/s"
F_x = "-1.3e-3 N*s^2/m^2*v*v_x"
F_y = "-g*0.145 kg - 1.3e-3 N*s^2/m^2*v*v_y"
until = "y"
t_2 = "10 s"
)toml";

  enum class End { time, until };
  static constexpr std::size_t most_states = 61;
  using ForceOf = RelationOf<N, motion_variables>;

  struct Input {
    Mass mass = unset<Mass>;
    ForceOf F_x, F_y, F_z;
    Length x_0 = 0.0 * m, y_0 = 0.0 * m, z_0 = 0.0 * m;
    Speed v_x0 = 0.0 * m_per_s, v_y0 = 0.0 * m_per_s, v_z0 = 0.0 * m_per_s;
    Time t_2 = unset<Time>;
    AnyRelationOf<motion_variables> until;
    Whole rows = 13;
  };
  static constexpr Fields inputs{
      Field{&Input::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e6),
      FormulaField{
          &Input::F_x, "F_x",
          "sum of the forces along x as a formula, e.g. \"-20 N/m*x\"; variables: x, y, z, v_x, v_y, v_z, v, t"},
      FormulaField{&Input::F_y, "F_y", "sum of the forces along y; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::F_z, "F_z", "sum of the forces along z; omitted: 0"}.may_be_missing(),
      Field{&Input::x_0, "x_0", m, "coordinate x at the start"},
      Field{&Input::y_0, "y_0", m, "coordinate y at the start"},
      Field{&Input::z_0, "z_0", m, "coordinate z at the start"},
      Field{&Input::v_x0, "v_x0", m_per_s, "velocity along x at the start"},
      Field{&Input::v_y0, "v_y0", m_per_s, "velocity along y at the start"},
      Field{&Input::v_z0, "v_z0", m_per_s, "velocity along z at the start"},
      Field{&Input::t_2, "t_2", sec, "time at which the calculation ends, from the start at 0"}.positive(),
      FormulaField{&Input::until, "until",
                   "formula whose first zero after the start ends the motion: \"y\", \"v_x - 2 m/s\""}
          .may_be_missing(),
      Count{&Input::rows, "rows", 2, static_cast<int>(most_states), "states in the table, ends included"}
          .may_be_missing()};

  struct State {
    Time t = unset<Time>;
    Length x = unset<Length>, y = unset<Length>, z = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>, v_z = unset<Speed>, v = unset<Speed>;
    Force F = unset<Force>;
    static constexpr Fields fields{Field{&State::t, "t", sec, "time"},
                                   Field{&State::x, "x", m, "coordinate x"},
                                   Field{&State::y, "y", m, "coordinate y"},
                                   Field{&State::z, "z", m, "coordinate z"},
                                   Field{&State::v_x, "v_x", m_per_s, "velocity along x"},
                                   Field{&State::v_y, "v_y", m_per_s, "velocity along y"},
                                   Field{&State::v_z, "v_z", m_per_s, "velocity along z"},
                                   Field{&State::v, "v", m_per_s, "speed"},
                                   Field{&State::F, "F", N, "resultant of the forces"}};
  };

  struct Result {
    Time t_E = unset<Time>;
    End end = End::time;
    Length x_E = unset<Length>, y_E = unset<Length>, z_E = unset<Length>;
    Speed v_xE = unset<Speed>, v_yE = unset<Speed>, v_zE = unset<Speed>, v_E = unset<Speed>;
    Acceleration a_E = unset<Acceleration>;
    Length L = unset<Length>;
    Length x_min = unset<Length>, x_max = unset<Length>, y_min = unset<Length>, y_max = unset<Length>;
    Length z_min = unset<Length>, z_max = unset<Length>;
    Speed v_max = unset<Speed>;
    Force F_max = unset<Force>;
    Moment E_1 = unset<Moment>, E_2 = unset<Moment>, A = unset<Moment>;
    double delta = unset<double>;
    List<State, most_states> states;
  };
  static constexpr Fields results{
      Field{&Result::t_E, "t_E", sec, "time at the end of the motion"},
      Choice{&Result::end, "end", "reason for the end"},
      Field{&Result::x_E, "x_E", m, "coordinate x at the end"},
      Field{&Result::y_E, "y_E", m, "coordinate y at the end"},
      Field{&Result::z_E, "z_E", m, "coordinate z at the end"},
      Field{&Result::v_xE, "v_xE", m_per_s, "velocity along x at the end"},
      Field{&Result::v_yE, "v_yE", m_per_s, "velocity along y at the end"},
      Field{&Result::v_zE, "v_zE", m_per_s, "velocity along z at the end"},
      Field{&Result::v_E, "v_E", m_per_s, "speed at the end"},
      Field{&Result::a_E, "a_E", m_per_s2, "acceleration at the end"},
      Field{&Result::L, "L", m, "distance travelled"},
      Field{&Result::x_min, "x_min", m, "minimum of the coordinate x"},
      Field{&Result::x_max, "x_max", m, "maximum of the coordinate x"},
      Field{&Result::y_min, "y_min", m, "minimum of the coordinate y"},
      Field{&Result::y_max, "y_max", m, "maximum of the coordinate y"},
      Field{&Result::z_min, "z_min", m, "minimum of the coordinate z"},
      Field{&Result::z_max, "z_max", m, "maximum of the coordinate z"},
      Field{&Result::v_max, "v_max", m_per_s, "maximum speed"},
      Field{&Result::F_max, "F_max", N, "maximum of the resultant, at the steps of the solution"},
      Field{&Result::E_1, "E_1", J, "kinetic energy at the start"},
      Field{&Result::E_2, "E_2", J, "kinetic energy at the end"},
      Field{&Result::A, "A", J, "work of the forces, by integration of their power"},
      Field{&Result::delta, "delta", ratio,
            "estimated error of the state at the end, relative to the largest values of the motion"},
      ListField{&Result::states, "states", "states evenly over the time"}};

  static bool forces_read(const Input& in);
  static FieldFault force_fault(const Input& in);
  static bool is_solved(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&forces_read, "F_x, F_y, F_z, until", "the forces must be formulas of the motion", &force_fault},
      Rule<Input>{&is_solved, "F_x, F_y, F_z, t_2", "the forces must have values along the motion", &gap}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Motion::End) {
  using E = Motion::End;
  return std::array{ChoiceName<E>{E::time, "time", "the time t_2"},
                    ChoiceName<E>{E::until, "until", "the zero of `until`"}};
}

}  // namespace loadpath::dynamics
