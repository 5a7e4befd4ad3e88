// Two shafts at an angle connected by a universal joint (Hooke's joint), or three in one plane by two joints.
//
// Angles of the shafts are measured from the position in which the driving fork lies in the plane of the shafts: there
// the driven shaft is fastest. Sign: counter-clockwise, seen along the driving shaft. Without friction, the power is
// the same on both sides. Source: [MechanicalData-2.4.3]. Not covered: joints that are not in one plane, inertia of the
// intermediate shaft, bending moments from the joint on the shafts.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct UniversalJoint {
  static constexpr auto id = "motion.universal_joint";
  static constexpr auto title = "Universal joint (Hooke's joint)";
  static constexpr auto scope =
      "Rotation, speed and angular acceleration of the driven shaft, fluctuation over a revolution and torques, with "
      "one "
      "universal joint or two in one plane; strength of the joint is not covered.";
  static constexpr auto source = "[MechanicalData-2.4.3]";
  static constexpr auto headline = "U = {U}";
  static constexpr auto synonyms =
      "universal joint, Hooke joint, cardan joint, cardan shaft, double joint, constant velocity, spherical linkage, "
      "Kreuzgelenk, Kardangelenk, Kardanwelle, Gelenkwelle, карданный шарнир, шарнир Гука, карданный вал";
  static constexpr auto example = R"toml([project]
title = "A universal joint at 20 degrees"

[joint]
calculator = "motion.universal_joint"
n_1 = "1500 rpm"
beta = "20 deg"
J_2 = "0.12 kg*m^2"
)toml";

  /// How the forks on the intermediate shaft are aligned.
  enum class Forks { aligned, crossed };

  struct Input {
    AngularSpeed n_1 = unset<AngularSpeed>;
    double beta = unset<double>, beta_2 = 0.0;
    Forks forks = Forks::aligned;
    double phi_1 = 0.0;
    AngularAcceleration epsilon_1 = 0.0 * rad_per_s2;
    MassMoment J_2 = unset<MassMoment>;
    Moment M_2 = unset<Moment>;
  };
  static constexpr Fields inputs{
      Field{&Input::n_1, "n_1", rpm, "speed of the driving shaft"}.positive(),
      Field{&Input::beta, "beta", deg, "angle between the shafts at the joint"}.at_least(0).below(90).usually(0, 45),
      Field{&Input::beta_2, "beta_2", deg, "angle at a second joint, in the same plane; 0: there is none"}
          .at_least(0)
          .below(90)
          .usually(0, 45),
      Choice{&Input::forks, "forks", "forks on the intermediate shaft, with a second joint"}.may_be_missing(),
      Field{&Input::phi_1, "phi_1", deg, "angle of the driving shaft at which the state is calculated"},
      Field{&Input::epsilon_1, "epsilon_1", rad_per_s2, "angular acceleration of the driving shaft"},
      Field{&Input::J_2, "J_2", kg_m2, "moment of inertia on the driven shaft"}.positive().may_be_missing(),
      Field{&Input::M_2, "M_2", N_m, "load torque on the driven shaft, constant"}.load().may_be_missing()};

  struct Result {
    double phi_2 = unset<double>, i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    AngularAcceleration epsilon_2 = unset<AngularAcceleration>;
    AngularSpeed n_2min = unset<AngularSpeed>, n_2max = unset<AngularSpeed>;
    double U = unset<double>, phi_equal = unset<double>;
    AngularAcceleration epsilon_max = unset<AngularAcceleration>;
    double phi_max = unset<double>;
    Moment M_J = unset<Moment>, M_1 = unset<Moment>, M_1max = unset<Moment>;
  };
  static constexpr Fields results{
      Field{&Result::phi_2, "phi_2", deg, "angle of the driven shaft"},
      Field{&Result::i, "i", ratio, "speed of the driven over that of the driving shaft"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven shaft"},
      Field{&Result::epsilon_2, "epsilon_2", rad_per_s2, "angular acceleration of the driven shaft"},
      Field{&Result::n_2min, "n_2min", rpm, "minimum speed of the driven shaft over a revolution"},
      Field{&Result::n_2max, "n_2max", rpm, "maximum speed of the driven shaft over a revolution"},
      Field{&Result::U, "U", ratio, "fluctuation: maximum less minimum speed, over the speed of the driving shaft"},
      Field{&Result::phi_equal, "phi_equal", deg, "angle of the driving shaft at which both speeds are equal"},
      Field{&Result::epsilon_max, "epsilon_max", rad_per_s2,
            "maximum angular acceleration of the driven shaft, at a constant speed of the driving one"},
      Field{&Result::phi_max, "phi_max", deg, "angle of the driving shaft at the maximum"},
      Field{&Result::M_J, "M_J", N_m, "maximum inertia torque on the driven shaft, J_2 epsilon_max"},
      Field{&Result::M_1, "M_1", N_m, "torque on the driving shaft at phi_1, from M_2 and J_2"}.load(),
      Field{&Result::M_1max, "M_1max", N_m, "maximum torque on the driving shaft from M_2 without inertia"}.load()};

  static constexpr bool turns = true;
  static constexpr std::array<Rule<Input>, 0> rules{};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(UniversalJoint::Forks) {
  using F = UniversalJoint::Forks;
  return std::array{ChoiceName<F>{F::aligned, "aligned", "in one plane: joints with equal angles compensate"},
                    ChoiceName<F>{F::crossed, "crossed", "at right angles: the fluctuations add up"}};
}

}  // namespace loadpath::motion
