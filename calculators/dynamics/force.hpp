// The force that produces a known motion of a point: the first problem of dynamics.
//
// Resultant, inertia force of d'Alembert, and what is left for the unknown force when known ones (weight, a load) are
// given. Sign: along the axes. Source: [B32]. Not covered: laws with kinks or jumps (they cause impacts).
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

namespace loadpath::dynamics {

struct ForceOfMotion {
  static constexpr auto id = "dynamics.force";
  static constexpr auto title = "Force from a prescribed motion (inverse dynamics)";
  static constexpr auto scope =
      "Resultant force on a mass with smooth laws of motion x(t), y(t), z(t), its components along the path, "
      "the inertia force, and the unknown force in addition to known ones.";
  static constexpr auto source = "[B32]";
  static constexpr auto headline = "R_max = {R_max}|R = {R}";
  static constexpr auto synonyms =
      "inverse dynamics, Newton second law, inertia force, D'Alembert, force from motion, equation of motion, "
      "Newtonsches Grundgesetz, Trägheitskraft, сила инерции, второй закон Ньютона, принцип Даламбера";
  static constexpr auto example = R"toml([project]
title = "A point on an ellipse"

[point]
calculator = "dynamics.force"
m = "2 kg"
x = "3 m*sin(pi*t/(1 s))"
y = "5 m*cos(pi*t/(1 s))"
t = "0.25 s"
t_1 = "0.1 s"
t_2 = "1.9 s"
)toml";

  struct Input {
    Mass mass = unset<Mass>;
    motion::LengthLaw x, y, z;
    Time t = unset<Time>;
    Force F_x = 0.0 * N, F_y = 0.0 * N, F_z = 0.0 * N;
    Time t_1 = unset<Time>, t_2 = unset<Time>;
  };
  static constexpr Fields inputs{
      Field{&Input::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e6),
      FormulaField{&Input::x, "x", "coordinate as a formula of the time t: \"3 m*sin(pi*t/(1 s))\""},
      FormulaField{&Input::y, "y", "coordinate as a formula of the time t; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::z, "z", "coordinate as a formula of the time t; omitted: 0"}.may_be_missing(),
      Field{&Input::t, "t", sec, "time at which the force is calculated"},
      Field{&Input::F_x, "F_x", N, "known forces along x: weight, loads"}.load(),
      Field{&Input::F_y, "F_y", N, "known forces along y"}.load(),
      Field{&Input::F_z, "F_z", N, "known forces along z"}.load(),
      Field{&Input::t_1, "t_1", sec, "start of the time range of the maximum force, with t_2"}.may_be_missing(),
      Field{&Input::t_2, "t_2", sec, "end of the range, after t_1"}.may_be_missing()};

  struct Result {
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>, a_z = unset<Acceleration>;
    Force P_x = unset<Force>, P_y = unset<Force>, P_z = unset<Force>, P = unset<Force>;
    Force P_tau = unset<Force>, P_n = unset<Force>;
    Force Phi_x = unset<Force>, Phi_y = unset<Force>, Phi_z = unset<Force>;
    Force R_x = unset<Force>, R_y = unset<Force>, R_z = unset<Force>, R = unset<Force>;
    Power N_R = unset<Power>;
    Force R_max = unset<Force>;
    Time t_max = unset<Time>;
  };
  static constexpr Fields results{
      Field{&Result::a_x, "a_x", m_per_s2, "acceleration along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "acceleration along y"},
      Field{&Result::a_z, "a_z", m_per_s2, "acceleration along z"},
      Field{&Result::P_x, "P_x", N, "resultant of all forces along x"},
      Field{&Result::P_y, "P_y", N, "resultant of all forces along y"},
      Field{&Result::P_z, "P_z", N, "resultant of all forces along z"},
      Field{&Result::P, "P", N, "resultant of all forces"},
      Field{&Result::P_tau, "P_tau", N, "part of the resultant along the path, positive forwards"},
      Field{&Result::P_n, "P_n", N, "part of the resultant towards the centre of curvature"},
      Field{&Result::Phi_x, "Phi_x", N, "inertia force along x"},
      Field{&Result::Phi_y, "Phi_y", N, "inertia force along y"},
      Field{&Result::Phi_z, "Phi_z", N, "inertia force along z"},
      Field{&Result::R_x, "R_x", N, "missing force along x: the resultant less the known forces"}.load().with(
          "R_y, R_z"),
      Field{&Result::R_y, "R_y", N, "missing force along y"}.load().with("R_x, R_z"),
      Field{&Result::R_z, "R_z", N, "missing force along z"}.load().with("R_x, R_y"),
      Field{&Result::R, "R", N, "missing force: drive, guide, rope"}.load(),
      Field{&Result::N_R, "N_R", W, "power of the missing force"},
      Field{&Result::R_max, "R_max", N, "maximum missing force from t_1 to t_2, at 257 times"}.load(),
      Field{&Result::t_max, "t_max", sec, "time of the maximum missing force, the first where there are several"}};

  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool laws_are_smooth(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules =
      join(std::array{Rule<Input>{&laws_read, "x, y, z", "x, y and z must be lengths as formulas of t", &law_fault}},
           motion::range_rules<Input>(),
           std::array{Rule<Input>{&laws_are_smooth, "x, y, z, t, t_1, t_2", "the laws must have values at these times",
                                  &gap}});

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::dynamics
