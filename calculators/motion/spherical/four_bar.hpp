// Spherical four-bar linkage: four links joined by revolute joints whose axes meet in one point.
//
// z is the input axis, the output axis lies in the plane xz at alpha_4 from z towards x. phi_1 turns right-handed about
// the input axis from the arc of the ground, phi_4 right-handed about the output axis from the same arc continued
// beyond that axis, as in a planar four-bar linkage. Sources: [Ruth-McCarthy] (closure, types), [B30] (angular
// velocities and accelerations of a body with a fixed point). Ideal joints: without friction and mass, the power of
// input and output is the same. Not covered: offsets of the axes, forces in the joints, inertia.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct SphericalFourBar {
  static constexpr auto id = "motion.spherical_four_bar";
  static constexpr auto title = "Spherical four-bar linkage";
  static constexpr auto scope =
      "Type, output angle, velocity and acceleration of output and coupler, transmission angle, range of the input, "
      "dead "
      "positions, rocker limits and torque of a spherical four-bar linkage; friction, inertia and joint forces are not "
      "covered.";
  static constexpr auto source = "[Ruth-McCarthy], [B30]";
  static constexpr auto headline = "phi_4 = {phi_4}";
  static constexpr auto synonyms =
      "spherical four-bar linkage, spherical linkage, spherical 4R, spherical crank-rocker, wobble plate, skewed Hooke "
      "joint, intersecting shafts, Grashof, transmission angle, sphärisches Viergelenk, sphärisches Gelenkviereck, "
      "sphärische Kurbelschwinge, Übertragungswinkel, сферический четырёхзвенник, сферический механизм";
  static constexpr auto example = R"toml([project]
title = "A spherical crank-rocker between shafts at 80 degrees"

[wiper]
calculator = "motion.spherical_four_bar"
alpha_1 = "30 deg"
alpha_2 = "70 deg"
alpha_3 = "60 deg"
alpha_4 = "80 deg"
phi_1 = "50 deg"
n_1 = "300 rpm"
mu_req = "45 deg"
M_4 = "10 N*m"
)toml";

  enum class Assembly { left, right };
  enum class Type { crank_rocker, double_crank, rocker_crank, double_rocker, triple_rocker, change_point };

  struct Input {
    double alpha_1 = unset<double>, alpha_2 = unset<double>, alpha_3 = unset<double>, alpha_4 = unset<double>;
    double phi_1 = unset<double>;
    Assembly assembly = Assembly::left;
    AngularSpeed n_1 = unset<AngularSpeed>;
    AngularAcceleration epsilon_1 = 0.0 * rad_per_s2;
    double phi_a = unset<double>, phi_b = unset<double>, mu_req = unset<double>;
    Moment M_4 = unset<Moment>;
  };
  static constexpr Fields inputs{
      Field{&Input::alpha_1, "alpha_1", deg, "arc of the input: angle between its two axes"}.within(0.1, 179.9),
      Field{&Input::alpha_2, "alpha_2", deg, "arc of the coupler"}.within(0.1, 179.9),
      Field{&Input::alpha_3, "alpha_3", deg, "arc of the output"}.within(0.1, 179.9),
      Field{&Input::alpha_4, "alpha_4", deg, "arc of the ground: angle between input and output axis"}.within(0.1,
                                                                                                              179.9),
      Field{&Input::phi_1, "phi_1", deg, "input angle from the arc of the ground"},
      Choice{&Input::assembly, "assembly",
             "side of the joint of coupler and output: left or right of the arc from the joint of input and coupler to "
             "the output axis, seen from outside"}
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the input"}.positive(),
      Field{&Input::epsilon_1, "epsilon_1", rad_per_s2, "angular acceleration of the input"},
      Field{&Input::phi_a, "phi_a", deg,
            "start of the input range in use; omitted: the revolution of a crank, else phi_1 only"}
          .may_be_missing(),
      Field{&Input::phi_b, "phi_b", deg, "end of the input range in use"}.may_be_missing(),
      Field{&Input::mu_req, "mu_req", deg, "required minimum transmission angle, acute"}
          .at_least(0)
          .below(90)
          .may_be_missing(),
      Field{&Input::M_4, "M_4", N_m, "load torque on the output, constant"}.load().may_be_missing()};

  struct Result {
    Type type = Type::crank_rocker;
    double T_min = unset<double>, phi_4 = unset<double>, phi_4o = unset<double>, mu = unset<double>;
    double i = unset<double>, i_phi = unset<double>;
    AngularSpeed omega_4 = unset<AngularSpeed>;
    AngularAcceleration epsilon_4 = unset<AngularAcceleration>;
    AngularSpeed omega_x = unset<AngularSpeed>, omega_y = unset<AngularSpeed>, omega_z = unset<AngularSpeed>,
                 omega_2 = unset<AngularSpeed>;
    AngularAcceleration epsilon_x = unset<AngularAcceleration>, epsilon_y = unset<AngularAcceleration>,
                        epsilon_z = unset<AngularAcceleration>, epsilon_2 = unset<AngularAcceleration>;
    double phi_1min = unset<double>, phi_1max = unset<double>, phi_4min = unset<double>, phi_4max = unset<double>;
    double theta_4 = unset<double>, Q = unset<double>;
    double phi_1s = unset<double>, phi_4s = unset<double>, phi_1f = unset<double>, phi_4f = unset<double>;
    double mu_min = unset<double>, phi_mu = unset<double>, u_c = unset<double>, u_mu = unset<double>;
    double i_min = unset<double>, i_max = unset<double>;
    Moment M_1 = unset<Moment>, M_1max = unset<Moment>;
  };
  static constexpr Fields results{
      Choice{&Result::type, "type", "type of linkage, by the links that make full revolutions"},
      Field{
          &Result::T_min, "T_min", deg,
          "distance from the change point: least difference of arcs with which the linkage folds into one great circle"}
          .limit(1e-6, 180)
          .criterion(),
      Field{&Result::phi_4, "phi_4", deg, "output angle, from the arc of the ground continued beyond the output axis"},
      Field{&Result::phi_4o, "phi_4o", deg, "output angle in the other assembly"},
      Field{&Result::mu, "mu", deg, "transmission angle between coupler and output"},
      Field{&Result::i, "i", ratio, "velocity ratio: angular velocity of the output over that of the input"},
      Field{&Result::i_phi, "i_phi", ratio, "derivative of the velocity ratio with respect to phi_1"},
      Field{&Result::omega_4, "omega_4", rad_per_s, "angular velocity of the output"},
      Field{&Result::epsilon_4, "epsilon_4", rad_per_s2, "angular acceleration of the output"},
      Field{&Result::omega_x, "omega_x", rad_per_s, "angular velocity of the coupler along x"},
      Field{&Result::omega_y, "omega_y", rad_per_s, "angular velocity of the coupler along y"},
      Field{&Result::omega_z, "omega_z", rad_per_s, "angular velocity of the coupler along z, the input axis"},
      Field{&Result::omega_2, "omega_2", rad_per_s, "angular velocity of the coupler"},
      Field{&Result::epsilon_x, "epsilon_x", rad_per_s2, "angular acceleration of the coupler along x"},
      Field{&Result::epsilon_y, "epsilon_y", rad_per_s2, "angular acceleration of the coupler along y"},
      Field{&Result::epsilon_z, "epsilon_z", rad_per_s2, "angular acceleration of the coupler along z"},
      Field{&Result::epsilon_2, "epsilon_2", rad_per_s2, "angular acceleration of the coupler"},
      Field{&Result::phi_1min, "phi_1min", deg, "minimum input angle at which the linkage closes; also -phi_1min"},
      Field{&Result::phi_1max, "phi_1max", deg, "maximum input angle at which the linkage closes; also -phi_1max"},
      Field{&Result::phi_4min, "phi_4min", deg, "minimum output angle in magnitude"},
      Field{&Result::phi_4max, "phi_4max", deg, "maximum output angle in magnitude"},
      Field{&Result::theta_4, "theta_4", deg, "swing angle of the output between its limits"},
      Field{&Result::Q, "Q", ratio, "time ratio of the two strokes at constant input speed, 1 or more"},
      Field{&Result::phi_1s, "phi_1s", deg, "input angle of the stretched position: input and coupler in line"},
      Field{&Result::phi_4s, "phi_4s", deg, "output angle of the stretched position"},
      Field{&Result::phi_1f, "phi_1f", deg, "input angle of the folded position: input and coupler overlap"},
      Field{&Result::phi_4f, "phi_4f", deg, "output angle of the folded position"},
      Field{&Result::mu_min, "mu_min", deg, "minimum transmission angle over the input range, acute"},
      Field{&Result::phi_mu, "phi_mu", deg, "input angle at the minimum transmission angle"},
      Field{&Result::u_c, "u_c", ratio, "closure: maximum of |cos(mu)| over the input range / 1"}.check(),
      Field{&Result::u_mu, "u_mu", ratio, "transmission angle: maximum deviation from 90° / 90° - mu_req"}.check(
          "mu_req"),
      Field{&Result::i_min, "i_min", ratio, "minimum velocity ratio over the input range"},
      Field{&Result::i_max, "i_max", ratio, "maximum velocity ratio over the input range"},
      Field{&Result::M_1, "M_1", N_m, "torque on the input at phi_1, from M_4"}.load(),
      Field{&Result::M_1max, "M_1max", N_m, "maximum torque on the input over the range, from M_4"}.load()};

  static bool arcs_close(const Input& in);
  static bool closes_at_phi(const Input& in);
  static FieldFault open_at_phi(const Input& in);
  static bool position_is_in_use(const Input& in);
  static FieldFault position_out_of_use(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{
          &arcs_close, "alpha_1, alpha_2, alpha_3, alpha_4",
          "the arcs must close: the largest must be less than the sum of the other three, and all four together "
          "less than 360°"},
      Rule<Input>{&closes_at_phi, "phi_1, alpha_1, alpha_2, alpha_3, alpha_4",
                  "the linkage must close at phi_1, away from a dead position", &open_at_phi},
      Rule<Input>{[](const Input& in) { return is_set(in.phi_a) == is_set(in.phi_b); }, "phi_a, phi_b",
                  "give both phi_a and phi_b, or neither"},
      Rule<Input>{[](const Input& in) { return !(in.phi_a >= in.phi_b); }, "phi_b, phi_a",
                  "the range must end after its start"},
      Rule<Input>{[](const Input& in) { return !(in.phi_b - in.phi_a > 6.2832); }, "phi_b, phi_a",
                  "the range must not exceed a revolution"},
      Rule<Input>{&position_is_in_use, "phi_1, phi_a, phi_b", "the range in use should include phi_1",
                  &position_out_of_use, true}};

  static constexpr std::array modes{
      Mode<Input>{"closure", "closure over the input range", &always<Input>}.judged_by("u_c").of_shape(),
      Mode<Input>{"change_point", "change point", &always<Input>}.judged_by("T_min").of_shape(),
      Mode<Input>{"transmission", "transmission angle", &always<Input>}.judged_by("u_mu").of_service()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(SphericalFourBar::Assembly) {
  using A = SphericalFourBar::Assembly;
  return std::array{ChoiceName<A>{A::left, "left", "as an open planar linkage with its coupler above the ground"},
                    ChoiceName<A>{A::right, "right", "the mirrored assembly"}};
}

constexpr auto choices_of(SphericalFourBar::Type) {
  using T = SphericalFourBar::Type;
  return std::array{ChoiceName<T>{T::crank_rocker, "crank-rocker", "the input revolves, the output swings"},
                    ChoiceName<T>{T::double_crank, "double-crank", "input and output revolve"},
                    ChoiceName<T>{T::rocker_crank, "rocker-crank", "the input swings, the output revolves"},
                    ChoiceName<T>{T::double_rocker, "double-rocker", "input and output swing, the coupler revolves"},
                    ChoiceName<T>{T::triple_rocker, "triple-rocker", "no link revolves: Grashof's criterion not met"},
                    ChoiceName<T>{T::change_point, "change-point", "folds into one great circle"}};
}

}  // namespace loadpath::motion
