// Motion of a point along a known path: the path is a curve of a parameter q, the motion the law S(t) of the arc
// length.
//
// S counts along the path from the place of q_0, positive in the direction of increasing q. The place is where the arc
// length is S(t): a root of the integral of the curve's derivative. Sign: v_tau and a_tau are positive in the direction
// of increasing q. Source: [B26], [B28]. Not covered: paths with corners or cusps up to the place, laws with kinks or
// jumps.
#pragma once

#include "calculators/motion/laws.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

inline constexpr Law::Variable path_parameter{"q", ratio.dimension()};
using CurveLaw = LawOf<m, path_parameter>;

struct AlongPath {
  static constexpr auto id = "motion.along_path";
  static constexpr auto title = "Motion along a known path";
  static constexpr auto scope =
      "Position, velocity and acceleration with tangential and normal components of a point that moves along a smooth "
      "plane or spatial curve x(q), y(q), z(q) with the distance travelled S(t) given.";
  static constexpr auto source = "[B26], [B28]";
  static constexpr auto headline = "v = {v}, a = {a}";
  static constexpr auto synonyms =
      "natural coordinates, intrinsic coordinates, path coordinates, arc length, law of motion along a path, normal "
      "and tangential acceleration, natürliche Koordinaten, Bahnkoordinate, Bogenlänge, естественный способ задания "
      "движения, закон движения по траектории, естественные координаты";
  static constexpr auto example = R"toml([project]
title = "A car on a parabolic road"

[car]
calculator = "motion.along_path"
x = "100 m*q"
y = "50 m*q*q"
S = "20 m/s*t - 1 m/s^2*t*t"
t = "4 s"
)toml";

  struct Input {
    CurveLaw x, y, z;
    double q_0 = 0.0;
    LengthLaw S;
    Time t = unset<Time>;
  };
  static constexpr Fields inputs{
      FormulaField{&Input::x, "x", "coordinate of the path as a formula of the parameter q: \"3 m*cos(q)\""},
      FormulaField{&Input::y, "y", "coordinate as a formula of q; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::z, "z", "coordinate as a formula of q; omitted: 0"}.may_be_missing(),
      Field{&Input::q_0, "q_0", ratio, "parameter at S = 0"},
      FormulaField{&Input::S, "S", "distance along the path as a formula of the time t: \"2 m/s^2*t^2\""},
      Field{&Input::t, "t", sec, "time at which the state is calculated"}};

  struct Result {
    Speed v_tau = unset<Speed>, v = unset<Speed>;
    Acceleration a_tau = unset<Acceleration>, a_n = unset<Acceleration>, a = unset<Acceleration>;
    Length rho = unset<Length>;
    Twist kappa = unset<Twist>;
    Length S_t = unset<Length>;
    double q_t = unset<double>;
    Length x_M = unset<Length>, y_M = unset<Length>, z_M = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>, v_z = unset<Speed>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>, a_z = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::v, "v", m_per_s, "speed"},
      Field{&Result::a_tau, "a_tau", m_per_s2, "tangential acceleration, positive in the direction of increasing q"},
      Field{&Result::a_n, "a_n", m_per_s2, "normal acceleration, towards the centre of curvature"},
      Field{&Result::a, "a", m_per_s2, "acceleration"},
      Field{&Result::rho, "rho", m, "radius of curvature; none where the path is straight"},
      Field{&Result::kappa, "kappa", per_m, "curvature of the path"},
      Field{&Result::v_tau, "v_tau", m_per_s, "velocity along the path, positive in the direction of increasing q"},
      Field{&Result::S_t, "S_t", m, "distance along the path at the time t"},
      Field{&Result::q_t, "q_t", ratio, "path parameter at time t"},
      Field{&Result::x_M, "x_M", m, "coordinate x at the time t"},
      Field{&Result::y_M, "y_M", m, "coordinate y at the time t"},
      Field{&Result::z_M, "z_M", m, "coordinate z at the time t"},
      Field{&Result::v_x, "v_x", m_per_s, "velocity along x"},
      Field{&Result::v_y, "v_y", m_per_s, "velocity along y"},
      Field{&Result::v_z, "v_z", m_per_s, "velocity along z"},
      Field{&Result::a_x, "a_x", m_per_s2, "acceleration along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "acceleration along y"},
      Field{&Result::a_z, "a_z", m_per_s2, "acceleration along z"}};

  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool is_on_path(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&laws_read, "x, y, z, S", "x, y, z must be lengths as formulas of q, S a length as a formula of t",
                  &law_fault},
      Rule<Input>{&is_on_path, "x, y, z, S, q_0, t", "the path must reach as far as S(t), without corners", &gap}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::motion
