// A lift of weights, drums and pulleys on threads that do not stretch: its motion by the theorem of kinetic energy.
//
// Every part moves i times as far (at the radius r of a wheel) as the path s, the coordinate of the lift. A pulley
// whose axis moves is a weight and a wheel. Friction in the bearings and on tracks is against the motion; a lift that
// its weights cannot move is at rest. Sign: i is positive where a weight goes down for growing s, and a wheel turns
// forwards. A thread acts upwards on a hanging part, or one on a slope: else it is slack. Source: [B37]. Not covered:
// slip and weight of the threads, a thread acting down a slope, and whether one along a level track is tight.
#pragma once

#include "calculators/dynamics/gravity.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace loadpath::dynamics {

struct Lift {
  static constexpr auto id = "dynamics.lift";
  static constexpr auto title = "Hoist and rope systems";
  static constexpr auto scope =
      "Acceleration, speed and time over a path of a one-degree-of-freedom system of weights on ropes and "
      "tracks, drums and pulleys with bearing friction and driving moments, with start, direction and "
      "completion of the motion.";
  static constexpr auto source = "[B37]";
  static constexpr auto headline = "a = {a}";
  static constexpr auto synonyms =
      "hoist, lift, elevator, winch, drum, pulley, block and tackle, rope, counterweight, inclined track, "
      "Atwood machine, Hubwerk, Seiltrommel, Winde, Aufzug, Flaschenzug, Seilrolle, лебёдка, подъёмник, барабан, "
      "блок, полиспаст, лифт";
  static constexpr auto example = R"toml([project]
title = "Three bodies and a thread"

[lift]
calculator = "dynamics.lift"
s = "1.2 m"
weights = [{ name = "body_1", m = "8 kg" }, { name = "pulley_2", m = "5 kg" }]
wheels = [
  { name = "pulley_2", J = "0.025 kg*m^2", r = "100 mm", M_f = "0.6 N*m" },
  { name = "drum_3", J = "0.0675 kg*m^2", r = "150 mm", i = 2, M_f = "0.9 N*m" },
]
)toml";

  enum class Moves { forwards, backwards, stands };

  struct Weight {
    Name name;
    Mass mass = unset<Mass>;
    double i = 1.0, alpha = pi / 2.0, mu = 0.0;
    static constexpr Fields fields{
        NameField{&Weight::name, "name", "name of the body"}.may_be_missing(),
        Field{&Weight::mass, called("m"), kg, "mass"}.load().positive().usually(1e-6, 1e7),
        Field{&Weight::i, "i", ratio, "its path over the path s, positive downwards"},
        Field{&Weight::alpha, "alpha", deg, "inclination of its track: 90° suspended, 0° level"}.within(0, 90),
        Field{&Weight::mu, "mu", ratio, "coefficient of friction on its track"}.at_least(0).usually(0, 1)};
  };
  struct Wheel {
    Name name;
    MassMoment J = unset<MassMoment>;
    Length r = unset<Length>;
    double i = 1.0;
    Moment M_f = 0.0 * N_m, M_d = 0.0 * N_m;
    static constexpr Fields fields{
        NameField{&Wheel::name, "name", "name of the wheel"}.may_be_missing(),
        Field{&Wheel::J, "J", kg_m2, "moment of inertia about its axis"}.at_least(0),
        Field{&Wheel::r, "r", mm, "radius of the rope on the wheel"}.positive().usually(1, 1e5),
        Field{&Wheel::i, "i", ratio, "path of the rope relative to the wheel axis, over the path s"},
        Field{&Wheel::M_f, "M_f", N_m, "moment of the bearing friction"}.at_least(0),
        Field{&Wheel::M_d, "M_d", N_m, "driving moment, positive forwards; negative brakes"}.load()};
  };
  static constexpr std::size_t most_parts = 16;

  struct Input {
    Length s = unset<Length>;
    Speed v_0 = 0.0 * m_per_s;
    List<Weight, most_parts> weights;
    List<Wheel, most_parts> wheels;
    Acceleration g = unset<Acceleration>;
    double latitude = unset<double>;
    Length altitude = unset<Length>;
  };
  static constexpr auto inputs =
      join(Fields{Field{&Input::s, "s", m, "travel over which the motion is calculated"}.positive().usually(1e-3, 1e4),
                  Field{&Input::v_0, "v_0", m_per_s, "speed of the coordinate at the start"}.at_least(0),
                  ListField{&Input::weights, "weights", "bodies moving vertically or along tracks"}.may_be_missing(),
                  ListField{&Input::wheels, "wheels", "drums and pulleys"}.may_be_missing()},
           gravity_fields<Input>());

  struct WeightState {
    Name name;
    Speed v = unset<Speed>;
    Moment E = unset<Moment>;
    Force T = unset<Force>;
    static constexpr Fields fields{NameField{&WeightState::name, "name", "name of the body"},
                                   Field{&WeightState::v, "v", m_per_s, "speed at the end, positive downwards"},
                                   Field{&WeightState::E, "E", J, "kinetic energy at the end"},
                                   Field{&WeightState::T, "T", N, "force of the ropes on the body, upwards"}.load()};
  };
  struct WheelState {
    Name name;
    AngularSpeed omega = unset<AngularSpeed>, n = unset<AngularSpeed>;
    Moment E = unset<Moment>;
    Power P = unset<Power>;
    static constexpr Fields fields{NameField{&WheelState::name, "name", "name of the wheel"},
                                   Field{&WheelState::omega, "omega", rad_per_s, "angular velocity at the end"},
                                   Field{&WheelState::n, "n", rpm, "the same in revolutions per minute"},
                                   Field{&WheelState::E, "E", J, "kinetic energy at the end"},
                                   Field{&WheelState::P, "P", W, "power of the driving moment at the end"}};
  };

  struct Result {
    Mass m_red = unset<Mass>;
    Force F_G = unset<Force>, F_d = unset<Force>, F_f = unset<Force>, F = unset<Force>;
    Moves moves = Moves::forwards;
    Acceleration a = unset<Acceleration>;
    Speed v = unset<Speed>;
    Time t = unset<Time>;
    Moment A = unset<Moment>;
    Length s_stop = unset<Length>;
    double u_s = unset<double>;
    Force T_hang = unset<Force>, T_slope = unset<Force>;
    List<WeightState, most_parts> weight_states;
    List<WheelState, most_parts> wheel_states;
    Acceleration g = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::m_red, "m_red", kg, "mass reduced to the path s"},
      Field{&Result::F_G, "F_G", N, "weights reduced to the path s"},
      Field{&Result::F_d, "F_d", N, "driving moments reduced to the path s"},
      Field{&Result::F_f, "F_f", N, "friction reduced to the path s"},
      Field{&Result::F, "F", N, "accelerating force, less friction"},
      Choice{&Result::moves, "moves", "direction of motion of the lift"},
      Field{&Result::a, "a", m_per_s2, "acceleration of the coordinate"},
      Field{&Result::v, "v", m_per_s, "speed of the coordinate at the end, negative backwards"},
      Field{&Result::t, "t", sec, "time for the path"},
      Field{&Result::A, "A", J, "work of all forces over the path"},
      Field{&Result::s_stop, "s_stop", m, "path to a standstill, where the forces brake"},
      Field{&Result::u_s, "u_s", ratio,
            "reach: the path over the one to a standstill; none where it never moves along s"}
          .check(),
      Field{&Result::T_hang, "T_hang", N, "minimum rope force, suspended bodies; below zero the ropes are slack"}
          .limit(0, std::numeric_limits<double>::infinity())
          .criterion()
          .where_it_applies(),
      Field{&Result::T_slope, "T_slope", N,
            "minimum rope force, bodies on inclines; below zero the ropes are slack, or act downwards"}
          .limit(0, std::numeric_limits<double>::infinity())
          .where_it_applies(),
      ListField{&Result::weight_states, "weight_states", "the weights at the end of the path"},
      ListField{&Result::wheel_states, "wheel_states", "the wheels at the end of the path"},
      Field{&Result::g, "g", m_per_s2, "weight per mass of the calculation"}};

  static constexpr bool hangs(const Weight& w) { return w.alpha >= pi / 2.0 * (1.0 - 1e-12); }
  static constexpr bool is_level(const Weight& w) { return w.alpha == 0.0; }
  static constexpr bool slopes(const Weight& w) { return !hangs(w) && !is_level(w); }
  static bool has_track(const Input& in, bool (*track)(const Weight&)) {
    return std::any_of(in.weights.begin(), in.weights.end(), track);
  }
  static Mass reduced_mass(const Input& in);
  static constexpr std::array rules =
      join(std::array{Rule<Input>{[](const Input& in) { return !(in.weights.empty() && in.wheels.empty()); },
                                  "weights, wheels", "give at least one weight or wheel"},
                      Rule<Input>{[](const Input& in) {
                                    return in_si(reduced_mass(in)) > 0.0 || (in.weights.empty() && in.wheels.empty());
                                  },
                                  "weights, wheels", "at least one part with a mass must move with the path s"}},
           gravity_rules<Input>());

  static constexpr bool turns = true;
  static constexpr std::array modes{
      Mode<Input>{"reach", "travel to the path end", &always<Input>}.judged_by("u_s"),
      Mode<Input>{"slack", "rope tension, suspended bodies",
                  [](const Input& in) { return where(has_track(in, &hangs)); }}
          .judged_by("T_hang"),
      Mode<Input>{"slack_slope", "rope tension, bodies on inclines",
                  [](const Input& in) { return where(has_track(in, &slopes)); }}
          .judged_by("T_slope"),
      Mode<Input>{"slack_level", "rope tension, bodies on level tracks",
                  [](const Input& in) { return has_track(in, &is_level) ? Applies::unseen : Applies::no; }},
      Mode<Input>{"threads", "rope strength", &unseen<Input>},
      Mode<Input>{"slip", "rope slip on drums", &unseen<Input>}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Lift::Moves) {
  using M = Lift::Moves;
  return std::array{ChoiceName<M>{M::forwards, "forwards", "positive direction of s"},
                    ChoiceName<M>{M::backwards, "backwards", "negative direction of s, driven by the weights"},
                    ChoiceName<M>{M::stands, "stands", "at rest, held by friction"}};
}

}  // namespace loadpath::dynamics
