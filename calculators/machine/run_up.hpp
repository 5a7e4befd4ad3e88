// Time in which a machine runs up, or is braked, along the moment lines of its motor and its load.
//
// Both lines are given by points over the speed and are straight between them; J is reduced to the motor shaft. Time,
// turns and work follow in closed form, piece by piece. Braking is a run from the higher to the lower speed, with the
// moment of the brake, negative, as that of the motor. Source: [B36], J epsilon = M.
// Not covered: lines that also depend on the angle or on time; elastic shafts. Near the speed where the motor only just
// holds the load the time grows without limit.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::machine {

struct RunUp {
  static constexpr auto id = "machine.run_up";
  static constexpr auto title = "Run-up and braking of a machine";
  static constexpr auto scope =
      "Time, revolutions and energies of a change of speed along the torque curves of motor or brake and load, "
      "and whether the target speed is reached; rigid shafts, torques dependent on speed only.";
  static constexpr auto source = "[B36], [B37]";
  static constexpr auto headline = "t = {t}";
  static constexpr auto subject = "run-up";
  static constexpr auto synonyms =
      "run-up, start-up, starting time, acceleration time, braking time, torque-speed curve, motor start, stalling, "
      "Anlauf, Hochlauf, Hochlaufzeit, Bremszeit, Drehmomentkennlinie, разгон, торможение, время пуска, "
      "механическая характеристика";
  static constexpr auto example = R"toml([project]
title = "A fan that runs up"

[fan]
calculator = "machine.run_up"
parts = [{ name = "rotor", J = "0.05 kg*m^2" }, { name = "fan", J = "3.6 kg*m^2", u = 0.5 }]
motor = [["0 rpm", "45 N*m"], ["1000 rpm", "60 N*m"], ["1400 rpm", "40 N*m"]]
load = [["0 rpm", "2 N*m"], ["700 rpm", "8 N*m"], ["1400 rpm", "26 N*m"]]
n_2 = "1400 rpm"
)toml";

  struct Part {
    Name name;
    MassMoment inertia = unset<MassMoment>;
    double u = 1.0;
    static constexpr Fields fields{
        NameField{&Part::name, "name", "name of the part"}.may_be_missing(),
        Field{&Part::inertia, called("J"), kg_m2, "moment of inertia about its own axis"}.positive(),
        Field{&Part::u, "u", ratio, "speed of the part / motor speed"}};
  };
  struct Point {
    AngularSpeed n = unset<AngularSpeed>;
    Moment M = unset<Moment>;
    static constexpr Fields fields{Field{&Point::n, "n", rpm, "speed, rising from one to the next"},
                                   Field{&Point::M, "M", N_m, "torque at the motor shaft"}};
  };
  static constexpr std::size_t most_parts = 16, most_points = 48;
  using Points = List<Point, most_points>;

  struct Input {
    List<Part, most_parts> parts;
    Points motor, load;
    AngularSpeed n_1 = 0.0 * rad_per_s, n_2 = unset<AngularSpeed>;
    Time t_adm = unset<Time>;
  };
  static constexpr Fields inputs{
      ListField{&Input::parts, "parts", "accelerated inertias, with their speed ratios to the motor"},
      ListField{&Input::motor, "motor", "torque of the motor over the speed (negative of a brake): [[n, M], ...]"}
          .as_arrays(),
      ListField{&Input::load, "load", "load torque over speed: [[n, M], ...]; omitted: none"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed at the start"}.at_least(0),
      Field{&Input::n_2, "n_2", rpm, "speed at the end"}.at_least(0),
      Field{&Input::t_adm, "t_adm", sec, "permissible time of run-up or braking"}.positive().may_be_missing()};

  struct Result {
    MassMoment J_red = unset<MassMoment>;
    Moment M_least = unset<Moment>, M_start = unset<Moment>, M_end = unset<Moment>;
    AngularAcceleration epsilon_1 = unset<AngularAcceleration>;
    Time t = unset<Time>;
    double turns = unset<double>;
    Moment Delta_E = unset<Moment>, A_M = unset<Moment>, A_L = unset<Moment>;
    double u_M = unset<double>, u_t = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::J_red, "J_red", kg_m2, "moment of inertia reduced to the motor shaft"},
      Field{&Result::M_start, "M_start", N_m, "accelerating moment at the start, signed"},
      Field{&Result::M_end, "M_end", N_m, "accelerating moment at the end, signed"},
      Field{&Result::M_least, "M_least", N_m, "minimum accelerating moment up to the final speed"},
      Field{&Result::epsilon_1, "epsilon_1", rad_per_s2, "angular acceleration at the start"},
      Field{&Result::t, "t", sec, "time of the run"},
      Field{&Result::turns, "turns", ratio, "revolutions of the motor during the change"},
      Field{&Result::Delta_E, "Delta_E", J, "change of the kinetic energy"},
      Field{&Result::A_M, "A_M", J, "work of the motor; of a brake negative, its heat"},
      Field{&Result::A_L, "A_L", J, "work done on the load"},
      Field{&Result::u_M, "u_M", ratio, "run: moment against it over the moment for it, where they are closest"}
          .check(),
      Field{&Result::u_t, "u_t", ratio, "time of the run over the allowed one"}.check("t_adm")};

  static double reduced_inertia(const Input& in);
  static bool lines_rise(const Input& in);
  static bool lines_reach(const Input& in);
  static FieldFault short_line(const Input& in);
  static bool signs_agree(const Input& in);
  static FieldFault wrong_sign(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.parts.empty(); }, "parts", "give at least one rotating part"},
      Rule<Input>{[](const Input& in) { return reduced_inertia(in) > 0.0 || in.parts.empty(); }, "parts",
                  "at least one part must rotate with the motor: u is 0 for all"},
      Rule<Input>{[](const Input& in) { return in.n_1 != in.n_2; }, "n_1, n_2", "initial and final speed must differ"},
      Rule<Input>{[](const Input& in) { return !in.motor.empty(); }, "motor", "give the moment of the motor or brake"},
      Rule<Input>{&lines_rise, "motor, load", "the speeds of a line must increase"},
      Rule<Input>{&lines_reach, "motor, load, n_1, n_2", "a line of two points or more must reach from n_1 to n_2",
                  &short_line},
      Rule<Input>{&signs_agree, "motor, load, n_1, n_2",
                  "the motor torque must be negative for n_2 < n_1 (braking) unless the load torque exceeds it, and "
                  "positive for n_2 > n_1 unless the load drives",
                  &wrong_sign}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"parts.u", ratio_of_speeds}, Meaning{"n_1, n_2", speed_of_run},
                                       Meaning{"motor.M", moment_of_motor}};
  static constexpr std::array modes{
      Mode<Input>{"stall", "accelerating torque", &always<Input>}.judged_by("u_M"),
      Mode<Input>{"time", "run-up or braking time", &always<Input>}.of_service().judged_by("u_t"),
      Mode<Input>{"heat", "thermal load, motor and brake", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::machine
