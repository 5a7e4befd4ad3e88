// Work, power and kinetic energy of a body that slides along a straight path: weight, friction, a driving force, a
// spring.
//
// Theorem of kinetic energy over the path s. Sign: forwards along the path; alpha is positive where the path rises;
// the spring acts along the path, z is its deformation at the start and at the end. Source: [B34]. The work of the
// spring is -c (z_2^2 - z_1^2)/2; -c (z_2 - z_1)^2/2 holds from the unloaded spring only.
#pragma once

#include "calculators/dynamics/gravity.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::dynamics {

struct WorkAndEnergy {
  static constexpr auto id = "dynamics.work";
  static constexpr auto title = "Work and energy of a sliding body";
  static constexpr auto scope =
      "Work of weight, dry friction, a constant force and a spring over a straight path, the final speed, time "
      "and power, and the attainable distance; dry friction with a constant coefficient.";
  static constexpr auto source = "[B34]";
  static constexpr auto headline = "v_2 = {v_2}|A = {A}";
  static constexpr auto synonyms =
      "work, energy, work-energy theorem, kinetic energy, power, sliding friction, spring, inclined plane, Arbeit, "
      "Arbeitssatz, kinetische Energie, schiefe Ebene, работа, кинетическая энергия, трение скольжения";
  static constexpr auto example = R"toml([project]
title = "A body that slides down"

[body]
calculator = "dynamics.work"
m = "1 kg"
s = "2 m"
alpha = "-30 deg"
mu = 0.1
)toml";

  struct Input {
    Mass mass = unset<Mass>;
    Length s = unset<Length>;
    double alpha = 0.0, mu = 0.0;
    Force F = 0.0 * N;
    Speed v_1 = 0.0 * m_per_s;
    Stiffness c = unset<Stiffness>;
    Length z_1 = unset<Length>, z_2 = unset<Length>;
    Acceleration g = unset<Acceleration>;
    double latitude = unset<double>;
    Length altitude = unset<Length>;
  };
  static constexpr auto inputs =
      join(Fields{Field{&Input::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e6),
                  Field{&Input::s, "s", m, "length of the path"}.positive().usually(1e-6, 1e6),
                  Field{&Input::alpha, "alpha", deg, "slope of the path, positive where it rises"}.within(-90, 90),
                  Field{&Input::mu, "mu", ratio, "coefficient of sliding friction"}.at_least(0).usually(0, 1),
                  Field{&Input::F, "F", N, "constant force along the path, positive forwards"}.load(),
                  Field{&Input::v_1, "v_1", m_per_s, "speed at the start"}.at_least(0),
                  Field{&Input::c, "c", N_per_mm, "stiffness of a spring along the path"}.positive().may_be_missing(),
                  Field{&Input::z_1, "z_1", mm, "deformation of the spring at the start"}.may_be_missing(),
                  Field{&Input::z_2, "z_2", mm, "deformation of the spring at the end"}.may_be_missing()},
           gravity_fields<Input>());

  struct Result {
    Force R = unset<Force>, T = unset<Force>;
    Moment A_G = unset<Moment>, A_T = unset<Moment>, A_F = unset<Moment>, A_c = unset<Moment>, A = unset<Moment>;
    Moment E_1 = unset<Moment>, E_2 = unset<Moment>;
    Speed v_2 = unset<Speed>;
    Time t = unset<Time>;
    Power P_m = unset<Power>, P_2 = unset<Power>;
    Length s_stop = unset<Length>;
    double u_s = unset<double>;
    Acceleration g = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::R, "R", N, "force of the plane on the body"}.load(),
      Field{&Result::T, "T", N, "friction"},
      Field{&Result::A_G, "A_G", J, "work of the weight"},
      Field{&Result::A_T, "A_T", J, "work of the friction"},
      Field{&Result::A_F, "A_F", J, "work of the force F"},
      Field{&Result::A_c, "A_c", J, "work of the spring"},
      Field{&Result::A, "A", J, "work of all forces"},
      Field{&Result::E_1, "E_1", J, "kinetic energy at the start"},
      Field{&Result::E_2, "E_2", J, "kinetic energy at the end"},
      Field{&Result::v_2, "v_2", m_per_s, "speed at the end"},
      Field{&Result::t, "t", sec, "time for the path; without a spring"},
      Field{&Result::P_m, "P_m", W, "mean power of the force F; without a spring"},
      Field{&Result::P_2, "P_2", W, "power of the force F at the end"},
      Field{&Result::s_stop, "s_stop", m,
            "path to a standstill under these forces; none where they drive, or with a "
            "spring"},
      Field{&Result::u_s, "u_s", ratio, "reach: work against the motion / available energy"}.check(),
      Field{&Result::g, "g", m_per_s2, "weight per mass of the calculation"}};

  static constexpr std::array rules =
      join(std::array{Rule<Input>{[](const Input& in) { return is_set(in.c) == (is_set(in.z_1) && is_set(in.z_2)); },
                                  "c, z_1, z_2", "a spring needs c, z_1 and z_2: give all three or none"},
                      Rule<Input>{[](const Input& in) { return is_set(in.c) || !(is_set(in.z_1) || is_set(in.z_2)); },
                                  "z_1, z_2, c", "a deformation needs the stiffness c of the spring"}},
           gravity_rules<Input>());

  static constexpr std::array modes{Mode<Input>{"reach", "travel to the path end", &always<Input>}.judged_by("u_s")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::dynamics
