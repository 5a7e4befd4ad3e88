// Actions on a planar mechanism: loads, springs and dampers.
#pragma once

#include "calculators/mechanism/input/parts.hpp"
#include "lib/calculator/field.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

enum class Axes { fixed, link };
enum class Useful { no, yes };
struct Share {
  double angle = unset<double>, share = unset<double>;
  static constexpr Fields fields{Field{&Share::angle, "angle", deg, "crank angle"}.within(-3600, 3600),
                                 Field{&Share::share, "share", ratio, "share of F and M at this position"}};
};
struct Load {
  Name name, link, at;
  Force F = unset<Force>;
  double direction = unset<double>;
  Force F_x = unset<Force>, F_y = unset<Force>;
  Moment M = unset<Moment>;
  Axes axes = Axes::fixed;
  std::vector<Share> over;
  Name course;
  Useful useful = Useful::no;
  static constexpr Fields fields{
      NameField{&Load::name, "name", "name of the load"}.may_be_missing(),
      NameField{&Load::link, "link", "link on which the load acts"},
      NameField{&Load::at, "at", "point at which the force acts"}.may_be_missing(),
      Field{&Load::F, "F", N, "force, with its direction"}.load().may_be_missing(),
      Field{&Load::direction, "direction", deg, "direction of the force, from the x axis"}.may_be_missing(),
      Field{&Load::F_x, "F_x", N, "force along x, in place of F and direction"}.load().may_be_missing(),
      Field{&Load::F_y, "F_y", N, "force along y"}.load().may_be_missing(),
      Field{&Load::M, "M", N_m, "couple, counter-clockwise positive"}.load().may_be_missing(),
      Choice{&Load::axes, "axes", "axes of direction, F_x and F_y"}.may_be_missing(),
      ListField{&Load::over, "over",
                "shares of F and M over the crank angle, rising, straight from each to the next and round to the first"}
          .as_arrays()
          .may_be_missing(),
      NameField{&Load::course, "course", "load curve of F and M, one of the courses, in place of 'over'"}
          .may_be_missing(),
      Choice{&Load::useful, "useful", "useful load (counted as output in the efficiency)"}.may_be_missing()};
};

struct Spring {
  Name name;
  Pair links, points;
  Stiffness k = 0.0 * N_per_mm.one;
  Length free = unset<Length>;
  Damping c = 0.0 * N_s_per_m.one;
  Moment k_turn = 0.0 * N_m_per_rad.one;
  double free_angle = unset<double>;
  TurningDamping c_turn = 0.0 * N_m_s.one;
  static constexpr Fields fields{
      NameField{&Spring::name, "name", "name of the spring or damper"},
      Group{&Spring::links, "links", "the two links; the ground is called ground"}.as_array(),
      Group{&Spring::points, "points", "its ends, on the first and on the second link"}.as_array().may_be_missing(),
      Field{&Spring::k, "k", N_per_mm, "rate"}.at_least(0),
      Field{&Spring::free, "free", mm, "free length"}.at_least(0).may_be_missing(),
      Field{&Spring::c, "c", N_s_per_m, "damping"}.at_least(0),
      Field{&Spring::k_turn, "k_turn", N_m_per_rad, "rate of a turning spring, in place of k"}.at_least(0),
      Field{&Spring::free_angle, "free_angle", deg,
            "turning: angle of the first link against the second without moment"}
          .may_be_missing(),
      Field{&Spring::c_turn, "c_turn", N_m_s, "damping of the turning, in place of c"}.at_least(0)};
};

constexpr auto choices_of(Axes) {
  using T = Axes;
  return std::array{ChoiceName<T>{T::fixed, "fixed", "the force keeps its direction"},
                    ChoiceName<T>{T::link, "link", "the force turns with the link"}};
}
constexpr auto choices_of(Useful) {
  using T = Useful;
  return std::array{ChoiceName<T>{T::no, "no", "not counted as useful"}, ChoiceName<T>{T::yes, "yes", "useful load"}};
}

}  // namespace loadpath::planar
