#include "calculators/machine/motion/motion.hpp"

#include "calculators/machine/motion/run.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

namespace {

using End = MachineRun::End;

template <class Tracer>
double breakdown_slip(const Motion::Input& in, Tracer& trace) {
  if (!is_set(in.M_K)) return unset<double>;
  if (is_set(in.s_K)) return in.s_K;
  STEP(s_n, 1.0 - in.n_n / in.n_0, "rated slip");
  STEP(s_K, s_n * (in.M_K / in.M_n + sqrt(pow<2>(in.M_K / in.M_n) - 1.0)), "Kloss at the rated point, [FOSSEE-1994]");
  return s_K;
}

template <class Tracer>
void take_inertias(const DrivenMachine& machine, Motion::Result& r, Tracer& trace) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0, sum = 0.0;
  for (const PeriodCell& cell : machine.cells) {
    least = std::min({least, cell.J.v_0, cell.J.v_1});
    most = std::max({most, cell.J.v_0, cell.J.v_1});
    sum += cell.width * cell.J.integral();
  }
  r.J_min = trace.value("J_min", least * kg_m2, "minimum of J_red + J_F + J_M i^2, [B37]");
  r.J_max = trace.value("J_max", most * kg_m2, "maximum of J_red + J_F + J_M i^2, [B37]");
  r.J_m = trace.value("J_m", sum / machine.period * kg_m2, "mean over the period");
}

template <class Tracer>
void take_start(const DrivenMachine& machine, Motion::Result& r, Tracer& trace) {
  r.M_0 = trace.value("M_0", machine.cells.front().M.v_0 * N_m, "load at phi_0");
  r.M_start = trace.value("M_start", machine.drive(0.0) * N_m, "torque at standstill times i and eta");
  if (!(in_si(r.M_start) > 0.0)) return;
  STEP_TO(r, u_A, max(r.M_0, 0.0 * N_m) / r.M_start, "load over the starting torque");
}

template <class Tracer>
void take_run_up(const Motion::Input& in, const MachineRun& run, Motion::Result& r, Tracer& trace) {
  r.t_E = trace.value("t_E", run.t * sec, "integral of dphi/omega up to 0.5 % below the steady cycle");
  r.turns = trace.value("turns", run.angle / (2.0 * pi), "crank angle meanwhile, a turn is 2 pi");
  if (is_set(in.n_0)) r.Q_E = trace.value("Q_E", run.heat * J, "integral of the torque times the slip speed");
  if (!is_set(in.t_adm)) return;
  STEP_TO(r, u_t, r.t_E / in.t_adm, "time of the run-up over the permissible one");
}

/// Extremes over the cycle; of the energy among the borders of the cells, which lie close.
struct Extremes {
  double omega_max = 0.0, omega_min = std::numeric_limits<double>::infinity(), phi_max = 0.0, phi_min = 0.0;
  double M_max = -std::numeric_limits<double>::infinity(), M_min = -M_max;
  double E_max = 0.0, E_min = omega_min;
};

double inertia_at_border(const DrivenMachine& machine, std::size_t k) {
  return k == 0 ? machine.cells.front().J.v_0 : machine.cells[k - 1].J.v_1;
}

/// The speed across a cell, by its values and slopes at both ends.
CellCubic speed_across(const DrivenMachine& machine, const MachineRun& run, std::size_t k) {
  const PeriodCell& cell = machine.cells[k];
  const auto change = [&](double u, double omega) {
    const double inertia = 0.5 * cell.J.slope(u) * omega * omega;
    return (cell.width * (machine.drive(omega) - cell.M.at(u)) - inertia) / (cell.J.at(u) * omega);
  };
  const double from = speed_of(run.cycle[k].E, cell.J.v_0), to = speed_of(run.cycle[k + 1].E, cell.J.v_1);
  return {from, to, change(0.0, from), change(1.0, to)};
}

Extremes extremes_of(const DrivenMachine& machine, const MachineRun& run) {
  constexpr int places = 16;  // in a cell
  Extremes e;
  for (std::size_t k = 0; k < machine.cells.size(); ++k) {
    const CellCubic speed = speed_across(machine, run, k);
    for (int n = 0; n < places; ++n) {
      const double u = static_cast<double>(n) / places, omega = speed.at(u), M = machine.motor_at(omega);
      const double phi = machine.cells[k].from + u * machine.cells[k].width;
      if (omega > e.omega_max) e.omega_max = omega, e.phi_max = phi;
      if (omega < e.omega_min) e.omega_min = omega, e.phi_min = phi;
      e.M_max = std::max(e.M_max, M), e.M_min = std::min(e.M_min, M);
    }
    e.E_max = std::max(e.E_max, run.cycle[k].E), e.E_min = std::min(e.E_min, run.cycle[k].E);
  }
  return e;
}

double turned(double phi, double period) { return phi - period * std::floor(phi / period); }

template <class Tracer>
void take_speeds(const Motion::Input& in, const DrivenMachine& machine, const Extremes& e, Motion::Result& r,
                 Tracer& trace) {
  r.n_max = trace.value("n_max", e.omega_max * rad_per_s, "sqrt(2 E/J), its maximum over the cycle");
  r.n_min = trace.value("n_min", e.omega_min * rad_per_s, "sqrt(2 E/J), its minimum over the cycle");
  r.phi_fast = turned(in.phi_0 + e.phi_max, machine.period);
  r.phi_slow = turned(in.phi_0 + e.phi_min, machine.period);
  trace.value("period", machine.period, "angle of a cycle");
  r.n_m = trace.value("n_m", machine.period / in_si(r.t_c) * rad_per_s, "angle of a cycle over its duration");
  STEP_TO(r, delta, (r.n_max - r.n_min) / r.n_m, "coefficient of speed fluctuation, [Khurmi-16]");
  const AngularSpeed n_b =
      trace.value("n_b", machine.motor.breakdown_speed() * rad_per_s, "speed of the motor at its maximum torque");
  STEP_TO(r, u_K, n_b / (in.i * r.n_min), "below that speed the torque falls with the speed");
  if (machine.motor.kind == MotorCurve::Kind::points) {
    const AngularSpeed n_l = trace.value("n_l", machine.motor.last_speed() * rad_per_s, "last point of the motor");
    STEP_TO(r, x_n, in.i * r.n_max / n_l, "beyond its last point the motor curve is unknown");
  }
  if (!is_set(in.delta_adm)) return;
  STEP_TO(r, u_delta, r.delta / in.delta_adm, "speed fluctuation: calculated / permissible");
}

template <class Tracer>
void take_torques(const Motion::Input& in, const RunState& end, const Extremes& e, Motion::Result& r, Tracer& trace) {
  r.M_max = trace.value("M_max", e.M_max * N_m, "maximum over the cycle");
  r.M_min = trace.value("M_min", e.M_min * N_m, "minimum over the cycle");
  r.M_rms = trace.value("M_rms", std::sqrt(end.square / end.t) * N_m, "root of the mean square over the time");
  if (!is_set(in.M_n)) return;
  STEP_TO(r, u_M, r.M_rms / in.M_n, "heat grows with the square of the torque");
}

/// Work of the motor at the crank, from that at its shaft by the efficiency, cell by cell.
double work_at_crank(const DrivenMachine& machine, const MachineRun& run) {
  double sum = 0.0;
  for (std::size_t k = 0; k < machine.cells.size(); ++k) {
    const double work = run.cycle[k + 1].A_shaft - run.cycle[k].A_shaft;
    sum += work >= 0.0 ? work * machine.eta : work / machine.eta;
  }
  return sum;
}

template <class Tracer>
void take_works(const Motion::Input& in, const DrivenMachine& machine, const MachineRun& run, const Extremes& e,
                Motion::Result& r, Tracer& trace) {
  double load = 0.0;
  for (const PeriodCell& cell : machine.cells) load += cell.width * cell.M.integral();
  const RunState& end = run.cycle.back();
  r.A_L = trace.value("A_L", load * J, "integral of the load over the period");
  r.A_M = trace.value("A_M", end.A_shaft * J, "integral of the torque of the motor over its angle");
  const Moment A_K = trace.value("A_K", work_at_crank(machine, run) * J, "work of the motor at the crank, with eta");
  STEP_TO(r, A_V, r.A_M - A_K, "loss between motor and crank");
  if (is_set(in.n_0)) r.Q = trace.value("Q", end.slip_heat * J, "integral of the torque times the slip speed");
  STEP_TO(r, P_M, r.A_M / r.t_c, "mean power at the shaft of the motor");
  STEP_TO(r, P_L, r.A_L / r.t_c, "mean power of the load");
  const double scale = std::max({std::abs(end.A_shaft), std::abs(load), e.E_max - e.E_min, 1e-12 * e.E_max});
  r.x_A = trace.value("x_A", std::abs(in_si(A_K) - load) / scale, "theorem of kinetic energy: no change in a cycle");
  r.x_t = trace.value("x_t", run.by_time, "angle and speed over the time, J epsilon + J' omega^2/2 = M, [B36]");
}

void take_states(const DrivenMachine& machine, const MachineRun& run, const Motion::Input& in, Motion::Result& r) {
  const std::size_t cells = machine.cells.size();
  for (std::size_t n = 0; n < Motion::most_states; ++n) {
    const std::size_t k = (n * cells + Motion::most_states / 2) / (Motion::most_states - 1);
    const double inertia = inertia_at_border(machine, k), omega = speed_of(run.cycle[k].E, inertia);
    const bool last = k == cells;
    const double phi = last ? machine.period : machine.cells[k].from;
    const double load = last ? machine.cells.front().M.v_0 : machine.cells[k].M.v_0;
    r.states.push_back({in.phi_0 + phi, run.cycle[k].t * sec, omega * rad_per_s, machine.motor_at(omega) * N_m,
                        load * N_m, inertia * kg_m2});
  }
}

}  // namespace

template <class Tracer>
Motion::Result Motion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const DrivenMachine machine = machine_of(in, breakdown_slip(in, trace));
  take_inertias(machine, r, trace);
  take_start(machine, r, trace);
  if (!(in_si(r.J_min) > 0.0)) return r;
  const MachineRun run = run_up(machine, false);
  if (run.end == End::no_start || run.end == End::stalled)
    r.u_S = trace.value("u_S", run.stall, "standstill: load over the torque of the motor at rest");
  if (run.end == End::runs_away && machine.motor.kind == MotorCurve::Kind::points)
    r.x_n = trace.value("x_n", machine.motor.far_speed() / machine.motor.last_speed(),
                        "the speed rises beyond the last point");
  if (run.end != End::steady) return r;
  const Extremes e = extremes_of(machine, run);
  r.u_S = trace.value("u_S", 1.0 - e.E_min / e.E_max, "1 - E_min/E_max of the kinetic energy over the cycle");
  r.t_c = trace.value("t_c", run.cycle.back().t * sec, "integral of dphi/omega over the steady cycle");
  take_run_up(in, run, r, trace);
  take_speeds(in, machine, e, r, trace);
  take_torques(in, run.cycle.back(), e, r, trace);
  take_works(in, machine, run, e, r, trace);
  take_states(machine, run, in, r);
  return r;
}

template Motion::Result Motion::evaluate(const Input&, NoTrace&);
template Motion::Result Motion::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Motion::figures(const Input& in, const Result& r) {
  if (!is_set(r.t_c)) return {};
  NoTrace trace;
  return drawn(in, machine_of(in, breakdown_slip(in, trace)));
}

}  // namespace loadpath::machine

template const loadpath::Calculator& loadpath::erased<loadpath::machine::Motion>();
