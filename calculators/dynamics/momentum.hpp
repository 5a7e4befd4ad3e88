// Momentum of bodies along one line, before and after they act on each other: recoil, separation, coupling, impact.
//
// The bodies whose velocity after is not given move on together; with the coefficient of restitution e two bodies
// part again. All velocities are absolute, signed along the line. Source: [B35]. Not covered: oblique impact.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::dynamics {

struct SystemMomentum {
  static constexpr auto id = "dynamics.momentum";
  static constexpr auto title = "Momentum and direct impact of bodies";
  static constexpr auto scope =
      "Velocities from conservation of momentum of bodies on one line: recoil, separation, coupling, and "
      "direct impact of two bodies with a coefficient of restitution, with the energy lost or released.";
  static constexpr auto source = "[B35]";
  static constexpr auto headline = "V_1 = {V_1}";
  static constexpr auto synonyms =
      "momentum, conservation of momentum, collision, impact, coefficient of restitution, recoil, Impulserhaltung, "
      "Stoß, Stoßzahl, количество движения, удар, коэффициент восстановления";
  static constexpr auto example = R"toml([project]
title = "A cart and a ball"

[cart]
calculator = "dynamics.momentum"
bodies = [
  { name = "cart", m = "5 kg", v_1 = "4 m/s" },
  { name = "ball", m = "1 kg", v_1 = "4 m/s", v_2 = "30 m/s" },
]
)toml";

  struct Body {
    Name name;
    Mass mass = unset<Mass>;
    Speed v_1 = 0.0 * m_per_s, v_2 = unset<Speed>;
    static constexpr Fields fields{
        NameField{&Body::name, "name", "name of the body"}.may_be_missing(),
        Field{&Body::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e7),
        Field{&Body::v_1, "v_1", m_per_s, "velocity before"},
        Field{&Body::v_2, "v_2", m_per_s, "velocity after; omitted: to be found"}.may_be_missing()};
  };
  static constexpr std::size_t most_bodies = 16;

  struct Input {
    List<Body, most_bodies> bodies;
    Momentum S = 0.0 * N_s;
    double e = unset<double>;
  };
  static constexpr Fields inputs{
      ListField{&Input::bodies, "bodies", "the bodies of the system; those without v_2 move on together"},
      Field{&Input::S, "S", N_s, "impulse of the external forces along the line (braking, ground)"},
      Field{&Input::e, "e", ratio, "coefficient of restitution of the impact of two bodies: 0 plastic, 1 elastic"}
          .within(0, 1)
          .may_be_missing()};

  struct After {
    Name name;
    Speed v_2 = unset<Speed>;
    Momentum I = unset<Momentum>;
    static constexpr Fields fields{NameField{&After::name, "name", "name of the body"},
                                   Field{&After::v_2, "v_2", m_per_s, "velocity after"},
                                   Field{&After::I, "I", N_s, "impulse on the body"}};
  };

  struct Result {
    Momentum Q_1 = unset<Momentum>, Q_2 = unset<Momentum>;
    Mass M = unset<Mass>, m_k = unset<Mass>;
    Momentum q_k = unset<Momentum>;
    Speed V_1 = unset<Speed>, V_k = unset<Speed>;
    Moment E_1 = unset<Moment>, E_2 = unset<Moment>, Delta_E = unset<Moment>;
    List<After, most_bodies> after;
  };
  static constexpr Fields results{
      Field{&Result::M, "M", kg, "mass of the system"},
      Field{&Result::Q_1, "Q_1", kg_m_per_s, "momentum before"},
      Field{&Result::Q_2, "Q_2", kg_m_per_s, "momentum after"},
      Field{&Result::V_1, "V_1", m_per_s, "velocity of the centre of mass before"},
      Field{&Result::q_k, "q_k", kg_m_per_s, "momentum after of the bodies whose velocity is given"},
      Field{&Result::m_k, "m_k", kg, "mass of the bodies whose velocity is to be found"},
      Field{&Result::V_k, "V_k", m_per_s,
            "velocity after of the bodies that move on together; of their centre of mass "
            "in an impact"},
      Field{&Result::E_1, "E_1", J, "kinetic energy before"},
      Field{&Result::E_2, "E_2", J, "kinetic energy after"},
      Field{&Result::Delta_E, "Delta_E", J,
            "change of the kinetic energy: positive from inside (a spring), negative "
            "lost"},
      ListField{&Result::after, "after", "the bodies after"}};

  static bool some_are_open(const Input& in);
  static bool impact_is_of_two(const Input& in);
  static bool bodies_meet(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&some_are_open, "bodies", "omit v_2 of one body, which is calculated"},
      Rule<Input>{&impact_is_of_two, "e, bodies", "e needs an impact of two bodies without v_2"},
      Rule<Input>{&bodies_meet, "e, bodies", "two bodies with the same velocity do not collide"}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::dynamics
