// Work of a force along a prescribed plane or spatial curve.
//
// The curve is given by x, y, z as laws of t, its time or any parameter; the force along each axis by position,
// velocity and t. Work is the integral of F_x dx + F_y dy + F_z dz, by Gauss's rule of eight points with intervals
// halved until their halves agree; the sum of the differences that are left is the estimated error. Sign: positive
// where the force acts along the motion. Source: [B34]. Not covered: constraint forces, which do no work if
// the guide is smooth.
#pragma once

#include "calculators/dynamics/free_motion.hpp"
#include "calculators/motion/laws.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::dynamics {

struct PathWork {
  static constexpr auto id = "dynamics.path_work";
  static constexpr auto title = "Work of a force along a curve";
  static constexpr auto scope =
      "Work, mean force and power of a force that depends on position, velocity and time along a prescribed plane or "
      "spatial curve x(t), y(t), z(t); constraint forces are not covered.";
  static constexpr auto source = "[B34]";
  static constexpr auto headline = "A = {A}";
  static constexpr auto synonyms =
      "work along a path, work of a variable force, line integral, curvilinear integral, force field, conservative "
      "force, Arbeit längs einer Bahn, Wegintegral, Linienintegral, Kraftfeld, работа силы на криволинейном пути, "
      "криволинейный интеграл, силовое поле";
  static constexpr auto example = R"toml([project]
title = "A body on a helix, drawn to the axis and lifted"

[body]
calculator = "dynamics.path_work"
x = "1 m*cos(t/(1 s))"
y = "1 m*sin(t/(1 s))"
z = "1 m/s*t"
t_2 = "9.424777961 s"
F_x = "-0.5 N/m*x"
F_y = "-0.5 N/m*y"
F_z = "0.25 N"
)toml";

  using ForceOf = RelationOf<N, motion_variables>;

  struct Input {
    motion::LengthLaw x, y, z;
    Time t_1 = 0.0 * sec, t_2 = unset<Time>;
    ForceOf F_x, F_y, F_z;
  };
  static constexpr Fields inputs{
      FormulaField{&Input::x, "x", "coordinate of the curve as a formula of t: \"3 m*sin(pi*t/(1 s))\""},
      FormulaField{&Input::y, "y", "coordinate as a formula of t; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::z, "z", "coordinate as a formula of t; omitted: 0"}.may_be_missing(),
      Field{&Input::t_1, "t_1", sec, "time at the start of the path"},
      Field{&Input::t_2, "t_2", sec, "time at the end of the path (> t_1)"},
      FormulaField{&Input::F_x, "F_x",
                   "force along x as a formula, e.g. \"-20 N/m*x\"; variables: x, y, z, v_x, v_y, v_z, v, t"},
      FormulaField{&Input::F_y, "F_y", "force along y; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::F_z, "F_z", "force along z; omitted: 0"}.may_be_missing()};

  struct Result {
    Moment A_x = unset<Moment>, A_y = unset<Moment>, A_z = unset<Moment>, A = unset<Moment>;
    Length L = unset<Length>;
    Force F_m = unset<Force>;
    Power P_m = unset<Power>, P_max = unset<Power>, P_min = unset<Power>;
    double delta = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::A, "A", J, "work of the force"},
      Field{&Result::A_x, "A_x", J, "work done by F_x"},
      Field{&Result::A_y, "A_y", J, "work done by F_y"},
      Field{&Result::A_z, "A_z", J, "work done by F_z"},
      Field{&Result::L, "L", m, "length of the path"},
      Field{&Result::F_m, "F_m", N, "mean of the force along the path: work over length"},
      Field{&Result::P_m, "P_m", W, "mean power; t is the time"},
      Field{&Result::P_max, "P_max", W, "maximum power, at 257 times"},
      Field{&Result::P_min, "P_min", W, "minimum power, negative where the force is against the motion; at 257 times"},
      Field{&Result::delta, "delta", ratio,
            "estimated error of A, relative to the integral of the magnitude of the power"}};

  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool is_integrated(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&laws_read, "x, y, z, F_x, F_y, F_z",
                  "x, y and z must be lengths as formulas of t, the forces formulas of the motion", &law_fault},
      Rule<Input>{[](const Input& in) { return !(in.t_1 >= in.t_2); }, "t_2, t_1", "the path must end after its start"},
      Rule<Input>{&is_integrated, "x, y, z, F_x, F_y, F_z, t_1, t_2",
                  "the laws and the forces must have values along the path", &gap}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::dynamics
