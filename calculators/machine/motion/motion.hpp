// The motion of a machine under the characteristic of its motor, from rest to the steady cycle.
//
// Rigid links, one degree of freedom: the kinetic energy J(phi) omega^2/2 of mechanism, flywheel and rotor changes by
// the work of the motor less that of the load. The reduced moment of inertia and the load are series of a mechanism's
// cycle ("=press.drive.J_red", "=-press.drive.M_red"), formulas, points or constants. Unlike the flywheel's
// calculation, the torque of the motor falls with the speed and the inertia forces follow it. The run-up ends where the
// speed is within 0.5 % of that of the steady cycle at the same crank angle. Signs: the load is positive against the
// motion. Source: [B37], theorem of kinetic energy. Not covered: backlash, elastic shafts, electrical transients of the
// motor, clutches; a machine that stops in its cycle is reported as stalled.
#pragma once

#include "calculators/machine/energy_of_turning.hpp"
#include "calculators/machine/motion/machine.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/law_text.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::machine {

struct Motion {
  static constexpr auto id = "machine.motion";
  static constexpr auto title = "Motion of a machine under its motor";
  static constexpr auto scope =
      "Run-up time, steady cycle, coefficient of speed fluctuation and motor torque of a rigid machine with variable "
      "reduced moment of inertia under the torque-speed curve of its motor; electrical transients are not covered.";
  static constexpr auto source = "[B36], [B37], [FOSSEE-1994], [Khurmi-16]";
  static constexpr auto headline = "delta = {delta}, t_E = {t_E}";
  static constexpr auto subject = "motion under the motor";
  static constexpr auto synonyms =
      "equation of motion of a machine, reduced moment of inertia, speed fluctuation, run-up, Kloss, breakdown torque, "
      "pull-out torque, slip, induction motor, crank press, motor characteristic, Bewegungsgleichung der starren "
      "Maschine, reduziertes Massenträgheitsmoment, Ungleichförmigkeitsgrad, Hochlaufzeit, Kippmoment, Kippschlupf, "
      "Motorkennlinie, движение машины, приведённый момент инерции, коэффициент неравномерности хода, разгон, "
      "механическая характеристика двигателя";
  static constexpr auto example = R"toml([project]
title = "A crank press under its motor"

[press]
calculator = "machine.motion"
J_of_phi = "0.4 kg*m^2 - 0.3 kg*m^2*cos(2*phi)"
points = [["0 deg", "15 N*m"], ["300 deg", "15 N*m"], ["310 deg", "900 N*m"], ["345 deg", "900 N*m"], ["350 deg", "15 N*m"], ["360 deg", "15 N*m"]]
J_F = "20 kg*m^2"
J_M = "0.01 kg*m^2"
i = 12
eta = 0.92
M_K = "42 N*m"
n_0 = "1500 rpm"
s_K = 0.2
)toml";

  struct Point {
    double phi = unset<double>;
    Moment M = unset<Moment>;
    static constexpr Fields fields{Field{&Point::phi, "phi", deg, "crank angle, not falling from one to the next"},
                                   Field{&Point::M, "M", N_m, "moment of the load; straight to the next point"}.load()};
  };
  struct MotorPoint {
    AngularSpeed n = unset<AngularSpeed>;
    Moment M = unset<Moment>;
    static constexpr Fields fields{Field{&MotorPoint::n, "n", rpm, "speed of the motor, rising from one to the next"},
                                   Field{&MotorPoint::M, "M", N_m, "torque of the motor"}};
  };
  static constexpr std::size_t most_load_points = 72, most_samples = 1440;
  using Samples = List<Sample, most_samples>;

  static constexpr Law::Variable angle{"phi", deg.dimension()};

  struct Input {
    Moment M = unset<Moment>;
    LawOf<N_m, angle> M_of_phi;
    List<Point, most_load_points> points;
    AngularSpeed n_M = unset<AngularSpeed>;
    MassMoment J_red = unset<MassMoment>;
    LawOf<kg_m2, angle> J_of_phi;
    double period = 2.0 * pi;
    double phi_0 = 0.0;
    MassMoment J_F = 0.0 * kg_m2, J_M = 0.0 * kg_m2;
    double i = 1.0, eta = 1.0;
    List<MotorPoint, MotorCurve::most_points> motor;
    Moment M_A = unset<Moment>, M_K = unset<Moment>;
    AngularSpeed n_0 = unset<AngularSpeed>;
    double s_K = unset<double>;
    Moment M_n = unset<Moment>;
    AngularSpeed n_n = unset<AngularSpeed>;
    double delta_adm = unset<double>;
    Time t_adm = unset<Time>;
    Samples load_series, inertia_series;  // filled by the step; not fields
  };
  static constexpr Fields inputs{
      Field{&Input::M, "M", N_m,
            "moment of the load at the crank, positive against the motion: a series, \"=-press.drive.M_red\", or a "
            "constant"}
          .load()
          .may_be_missing(),
      FormulaField{&Input::M_of_phi, "M_of_phi", "moment of the load as a formula of the crank angle phi"}
          .load()
          .may_be_missing(),
      ListField{&Input::points, "points", "moment of the load by points over one period: [[phi, M], ...]"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::n_M, "n_M", rpm,
            "constant speed of the crank at which M includes inertia forces (\"=press.drive.M\"): they are subtracted"}
          .positive()
          .may_be_missing(),
      Field{&Input::J_red, "J_red", kg_m2,
            "moment of inertia of the mechanism reduced to the crank: a series, \"=press.drive.J_red\", or a constant"}
          .at_least(0)
          .may_be_missing(),
      FormulaField{&Input::J_of_phi, "J_of_phi", "reduced moment of inertia as a formula of the angle phi"}
          .may_be_missing(),
      Field{&Input::period, "period", deg, "period of formulas and points"}.positive().usually(10, 1e7),
      Field{&Input::phi_0, "phi_0", deg, "crank angle at the start from rest"}.within(-360e3, 360e3),
      Field{&Input::J_F, "J_F", kg_m2, "moment of inertia of flywheel and crankshaft"}.at_least(0),
      Field{&Input::J_M, "J_M", kg_m2, "moment of inertia of rotor and motor shaft"}.at_least(0),
      Field{&Input::i, "i", ratio, "speed of the motor over that of the crank"}.positive().usually(0.05, 500),
      Field{&Input::eta, "eta", ratio, "efficiency between motor and crank"}.within(0.01, 1),
      ListField{&Input::motor, "motor", "torque of the motor by points over its speed: [[n, M], ...]"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::M_A, "M_A", N_m, "starting torque of a motor whose torque falls straight to zero at n_0"}
          .positive()
          .may_be_missing(),
      Field{&Input::M_K, "M_K", N_m, "breakdown torque of an induction motor, by the formula of Kloss"}
          .positive()
          .may_be_missing(),
      Field{&Input::n_0, "n_0", rpm, "speed of the motor without torque; of an induction motor the synchronous speed"}
          .positive()
          .may_be_missing(),
      Field{&Input::s_K, "s_K", ratio, "breakdown slip; omitted: from M_n and n_n"}
          .positive()
          .usually(0.02, 1)
          .may_be_missing(),
      Field{&Input::M_n, "M_n", N_m, "rated torque of the motor"}.positive().may_be_missing(),
      Field{&Input::n_n, "n_n", rpm, "rated speed of an induction motor"}.positive().may_be_missing(),
      Field{&Input::delta_adm, "delta_adm", ratio, "permissible coefficient of speed fluctuation"}
          .positive()
          .below(2)
          .customarily_at_most(0.3)
          .may_be_missing(),
      Field{&Input::t_adm, "t_adm", sec, "permissible time of the run-up"}.positive().may_be_missing()};

  struct State {
    double phi = unset<double>;
    Time t = unset<Time>;
    AngularSpeed n = unset<AngularSpeed>;
    Moment M_mot = unset<Moment>, M_L = unset<Moment>;
    MassMoment J = unset<MassMoment>;
    static constexpr Fields fields{Field{&State::phi, "phi", deg, "crank angle, over a cycle from phi_0"},
                                   Field{&State::t, "t", sec, "time"},
                                   Field{&State::n, "n", rpm, "speed of the crank"},
                                   Field{&State::M_mot, "M_mot", N_m, "torque of the motor at its shaft"},
                                   Field{&State::M_L, "M_L", N_m, "moment of the load"},
                                   Field{&State::J, called("J"), kg_m2, "total moment of inertia at the crank"}};
  };
  static constexpr std::size_t most_states = 37;

  struct Result {
    MassMoment J_m = unset<MassMoment>, J_min = unset<MassMoment>, J_max = unset<MassMoment>;
    Moment M_0 = unset<Moment>, M_start = unset<Moment>;
    Time t_E = unset<Time>;
    double turns = unset<double>;
    Moment Q_E = unset<Moment>;
    Time t_c = unset<Time>;
    AngularSpeed n_m = unset<AngularSpeed>, n_max = unset<AngularSpeed>, n_min = unset<AngularSpeed>;
    double delta = unset<double>, phi_fast = unset<double>, phi_slow = unset<double>;
    Moment M_max = unset<Moment>, M_min = unset<Moment>, M_rms = unset<Moment>;
    Moment A_L = unset<Moment>, A_M = unset<Moment>, A_V = unset<Moment>, Q = unset<Moment>;
    Power P_M = unset<Power>, P_L = unset<Power>;
    double x_A = unset<double>, x_t = unset<double>, x_n = unset<double>;
    double u_A = unset<double>, u_S = unset<double>, u_K = unset<double>;
    double u_delta = unset<double>, u_t = unset<double>, u_M = unset<double>;
    List<State, most_states> states;
  };
  static constexpr Fields results{
      Field{&Result::J_m, "J_m", kg_m2, "mean total moment of inertia at the crank, with flywheel and rotor"},
      Field{&Result::J_min, "J_min", kg_m2, "minimum total moment of inertia at the crank"},
      Field{&Result::J_max, "J_max", kg_m2, "maximum total moment of inertia at the crank"},
      Field{&Result::M_0, "M_0", N_m, "moment of the load at the start"},
      Field{&Result::M_start, "M_start", N_m, "starting torque of the motor, reduced to the crank"},
      Field{&Result::t_E, "t_E", sec, "time of the run-up, to 0.5 % below the speed of the steady cycle"},
      Field{&Result::turns, "turns", ratio, "revolutions of the crank during the run-up"},
      Field{&Result::Q_E, "Q_E", J, "heat by the slip of the motor in the run-up"}.where_it_applies(),
      Field{&Result::t_c, "t_c", sec, "duration of the steady cycle"},
      Field{&Result::n_m, "n_m", rpm, "mean speed of the crank in the steady cycle"},
      Field{&Result::n_max, "n_max", rpm, "maximum speed of the crank in the steady cycle"},
      Field{&Result::n_min, "n_min", rpm, "minimum speed of the crank in the steady cycle"},
      Field{&Result::delta, "delta", ratio, "coefficient of speed fluctuation (n_max - n_min)/n_m"},
      Field{&Result::phi_fast, "phi_fast", deg, "crank angle of the maximum speed"},
      Field{&Result::phi_slow, "phi_slow", deg, "crank angle of the minimum speed"},
      Field{&Result::M_max, "M_max", N_m, "maximum torque of the motor in the steady cycle"},
      Field{&Result::M_min, "M_min", N_m, "minimum torque of the motor in the steady cycle"},
      Field{&Result::M_rms, "M_rms", N_m, "root mean square torque of the motor over time (thermal load)"},
      Field{&Result::A_L, "A_L", J, "work of the load in a cycle"},
      Field{&Result::A_M, "A_M", J, "work of the motor in a cycle, at its shaft"},
      Field{&Result::A_V, "A_V", J, "loss between motor and crank in a cycle"},
      Field{&Result::Q, "Q", J, "heat by the slip of the motor in a cycle"}.where_it_applies(),
      Field{&Result::P_M, "P_M", W, "mean power of the motor at its shaft"},
      Field{&Result::P_L, "P_L", W, "mean power of the load"},
      Field{&Result::x_A, "x_A", ratio,
            "energy balance of the cycle: difference of the works / work or energy fluctuation, the larger"},
      Field{&Result::x_t, "x_t", ratio, "difference of the steady cycle from its integration over the time"},
      Field{&Result::x_n, "x_n", ratio, "maximum motor speed / last speed of the motor curve"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::u_A, "u_A", ratio, "start: moment of the load over that of the motor at rest"}.check(),
      Field{&Result::u_S, "u_S", ratio,
            "stall: kinetic energy given up within the cycle, of its maximum; above 1 the machine stops"}
          .check(),
      Field{&Result::u_K, "u_K", ratio, "pull-out: speed of the maximum torque over the minimum speed of the motor"}
          .check(),
      Field{&Result::u_delta, "u_delta", ratio, "speed fluctuation: calculated / permissible"}.check("delta_adm"),
      Field{&Result::u_t, "u_t", ratio, "time of the run-up over the permissible one"}.check("t_adm"),
      Field{&Result::u_M, "u_M", ratio, "root mean square torque over the rated one"}.check("M_n"),
      ListField{&Result::states, "states", "steady cycle, evenly over the crank angle"}};

  static bool has_one_load(const Input& in);
  static bool has_one_motor(const Input& in);
  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool points_rise(const Input& in);
  static bool motor_rises(const Input& in);
  static bool has_inertia(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&has_one_load, "M, M_of_phi, points", "give the load once: as M, as M_of_phi, or as points"},
      Rule<Input>{[](const Input& in) { return !is_set(in.J_red) || in.J_of_phi.empty(); }, "J_red, J_of_phi",
                  "give the reduced moment of inertia once: as J_red or as J_of_phi"},
      Rule<Input>{&laws_read, "M_of_phi, J_of_phi, period", "the values of the formulas must be periodic", &law_fault},
      Rule<Input>{&points_rise, "points, period",
                  "points need two or more angles, none below the one before, and all within one period"},
      Rule<Input>{[](const Input& in) { return in_si(in.J_F) > 0.0 || in_si(in.J_M) > 0.0; }, "J_F, J_M",
                  "give the moment of inertia of the flywheel J_F or that of the rotor J_M"},
      Rule<Input>{&has_inertia, "J_of_phi", "the total moment of inertia must be positive at every angle"},
      Rule<Input>{&has_one_motor, "motor, M_A, M_K",
                  "give the motor once: by points, by M_A with n_0, or by M_K with n_0"},
      Rule<Input>{&motor_rises, "motor", "the line of the motor needs two or more points with rising speeds, from 0"},
      Rule<Input>{
          [](const Input& in) { return !is_set(in.M_K) || is_set(in.s_K) || (is_set(in.M_n) && is_set(in.n_n)); },
          "s_K, M_n, n_n", "an induction motor needs its breakdown slip s_K, or its rated values M_n and n_n"},
      Rule<Input>{[](const Input& in) { return !is_set(in.M_K) || is_set(in.s_K) || !(in.n_n >= in.n_0); }, "n_n, n_0",
                  "the rated speed must be below the synchronous speed"},
      Rule<Input>{[](const Input& in) { return !is_set(in.M_K) || is_set(in.s_K) || !(in.M_n > in.M_K); }, "M_n, M_K",
                  "the rated torque must not exceed the breakdown torque"}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"i", ratio_of_speeds}};

  static constexpr std::array modes{
      Mode<Input>{"start", "starting torque", &always<Input>}.judged_by("u_A"),
      Mode<Input>{"stall", "stall under the load of a cycle", &always<Input>}.judged_by("u_S, x_n"),
      Mode<Input>{"pull_out", "pull-out of the motor", &always<Input>}.judged_by("u_K"),
      Mode<Input>{"unevenness", "speed fluctuation", &always<Input>}.of_service().judged_by("u_delta"),
      Mode<Input>{"time", "run-up time", &always<Input>}.of_service().judged_by("u_t"),
      Mode<Input>{"rating", "thermal rating of the motor", &always<Input>}.of_service().judged_by("u_M"),
      Mode<Input>{"start_heat", "heat of the motor by frequent starts", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);

  /// The machine that the input describes. `s_K`: breakdown slip; NaN of a motor that is not given by Kloss.
  static DrivenMachine machine_of(const Input& in, double s_K);
  /// Speed and torque of the motor over the steady cycle, the run-up over the time, and the moments at the crank.
  static std::vector<figure::Figure> drawn(const Input& in, const DrivenMachine& machine);
};

}  // namespace loadpath::machine
