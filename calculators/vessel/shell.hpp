// A thin shell of revolution whose meridian is given by points, under internal pressure of gas and liquid.
//
// Decides stresses along the meridian, the minimum thickness, the governing place and the allowable gas pressure:
// [B24] (9) with radii of curvature from circles through three neighbouring points, and the balance of what lies
// before each point. The points run from the free end of the shell to its support. Tension is positive. Not covered:
// edges of the meridian and jumps of its curvature (limits), weight of the wall, external pressure, fatigue. Where
// the curvature changes, points give the hoop stress to some 5 % while it changes by less than 0.2/rho_o from one to
// the next; a real jump, as from the crown to the knuckle of a torispherical head, they would smooth away. Give finer
// points, or take the parts as vessel.sphere and vessel.torus.
#pragma once

#include "calculators/vessel/assess.hpp"
#include "calculators/vessel/meridian.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Shell {
  static constexpr auto id = "vessel.shell";
  static constexpr auto title = "Thin shell of revolution";
  static constexpr auto scope =
      "Membrane stresses and minimum thickness of a shell of revolution with a point-defined meridian, under "
      "internal gas and liquid pressure; meridian kinks, curvature jumps (knuckle at a crown), self-weight, "
      "external pressure and fatigue are not covered.";
  static constexpr auto source = "[B24], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "shell of revolution, membrane theory, meridian, hoop stress, meridional stress, tank, Rotationsschale, "
      "Membrantheorie, оболочка вращения, безмоментная теория, меридиан";
  static constexpr auto example = R"([project]
title = "Bottom of a kettle"

[kettle]
calculator = "vessel.shell"
p = "0.6 MPa"
points = [
  ["0 mm", "0 mm"], ["130.53 mm", "8.56 mm"], ["258.82 mm", "34.07 mm"], ["382.68 mm", "76.12 mm"],
  ["500 mm", "133.97 mm"], ["608.76 mm", "206.65 mm"], ["707.11 mm", "292.89 mm"],
]
sigma_adm = "120 MPa"
)";

  enum class Start { closed, open };

  struct Point {
    Length r = unset<Length>, z = unset<Length>;
    static constexpr Fields fields{Field{&Point::r, "r", mm, "distance from the axis"}.at_least(0),
                                   Field{&Point::z, "z", mm, "height, upward"}};
  };

  struct Input : WallInput, Liquid {
    Start start = Start::closed;
    List<Point, most_points> points;
  };
  static bool long_enough(const Input& in);
  static bool apart(const Input& in);
  static bool is_loaded(const Input& in);
  static bool held_off_axis(const Input& in);
  static constexpr Fields inputs =
      join(Fields{ListField<Input, List<Point, most_points>>{
                      &Input::points, "points", "meridian, from the free end of the shell to the supported end"}
                      .as_arrays(),
                  Choice<Input, Start>{&Input::start, "start", "end of the shell at a first point off the axis"}
                      .may_be_missing()},
           wall_inputs<Input>(), liquid_inputs<Input>("height z of the liquid's surface"));

  struct Along {
    Length r = unset<Length>, z = unset<Length>, rho_o = unset<Length>, rho_M = unset<Length>;
    Stress sigma_o = unset<Stress>, sigma_M = unset<Stress>, sigma_v = unset<Stress>;
    static constexpr Fields fields{
        Field{&Along::r, "r", mm, "distance from the axis, mid-surface"},
        Field{&Along::z, "z", mm, "height"},
        Field{&Along::rho_o, "rho_o", mm, "radius of curvature across the meridian"},
        Field{&Along::rho_M, "rho_M", mm, "radius of curvature of the meridian; none where it is straight"},
        Field{&Along::sigma_o, "sigma_o", MPa, "hoop stress"},
        Field{&Along::sigma_M, "sigma_M", MPa, "meridional stress"},
        Field{&Along::sigma_v, "sigma_v", MPa, "equivalent stress, seams included"}};
  };

  struct Result : WallResult {
    Length r = unset<Length>, z = unset<Length>;
    double psi_max = unset<double>, s_min = unset<double>, w_kappa = unset<double>, w_b = unset<double>,
           x_s = unset<double>;
    List<Along, most_points> along;
  };
  static constexpr Fields results = join(
      wall_results<Result>(),
      Fields{Field{&Result::r, "r", mm, "governing location: distance from the axis"},
             Field{&Result::z, "z", mm, "governing location: height"},
             Field{&Result::psi_max, "psi_max", deg, "edges: maximum turn of the meridian from one chord to the next"}
                 .limit(0, 15 * (1 + 1e-9)),
             Field{&Result::s_min, "s_min", ratio,
                   "flatness: largest radius / largest radius of curvature rho_o (validity of membrane theory)"}
                 .limit(0.02, 1.0 + 1e-9),
             shallowness<Result>(),
             Field{&Result::w_kappa, "w_kappa", ratio,
                   "jumps: maximum change of the meridian's curvature from point to point, times rho_o; finer points, "
                   "or vessel.sphere and vessel.torus for the parts of a head"}
                 .limit(0, 0.2),
             Field{&Result::w_b, "w_b", ratio, "buckling of a knuckle: 0.002 of the crown radius over the thickness"}
                 .limit(0, 1),
             ListField<Result, List<Along, most_points>>{&Result::along, "along", "stresses along the meridian"}});

  static constexpr std::array rules = join(
      wall_rules<Input>(), liquid_rules<Input>(),
      std::array{Rule<Input>{&long_enough, "points", "a meridian needs at least three points"},
                 Rule<Input>{&apart, "points", "neighbouring points of the meridian must differ"},
                 Rule<Input>{&is_loaded, "h_l, points", "the liquid level is below the wall: no load"},
                 Rule<Input>{&held_off_axis, "points",
                             "only the first point may lie on the axis, and the last must lie higher or lower than it: "
                             "split a shell that is closed at both ends where it is held"}});

  static Applies knuckle_compressed(const Input& in);
  static Applies compressed(const Input& in);
  static constexpr std::array meanings = wall_meanings;
  static constexpr std::array modes =
      wall_modes<Input>("u_v, t_R, psi_max, s_min, x_s, w_kappa",
                        Mode<Input>{"knuckle", "buckling of the knuckle", &knuckle_compressed}.judged_by("w_b"),
                        Mode<Input>{"buckling", "compressive buckling of the wall", &compressed});

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Shell::Start) {
  using Start = Shell::Start;
  return std::array{ChoiceName<Start>{Start::closed, "closed", "closed by a lid"},
                    ChoiceName<Start>{Start::open, "open", "open: no meridional force there"}};
}

}  // namespace loadpath::vessel
