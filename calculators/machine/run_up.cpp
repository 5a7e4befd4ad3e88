#include "calculators/machine/run_up.hpp"

#include "calculators/machine/moment_line.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

namespace {

using Input = RunUp::Input;
using Result = RunUp::Result;
using MomentLine = List<LinePoint, RunUp::most_points>;
using Speeds = List<double, 2 * RunUp::most_points + 2>;

MomentLine line_of(const RunUp::Points& points) {
  MomentLine line;
  for (const auto& point : points) line.push_back({in_si(point.n), in_si(point.M)});
  return line;
}

/// Motor less load at a speed.
struct Balance {
  MomentLine motor, load;
  explicit Balance(const Input& in) : motor(line_of(in.motor)), load(line_of(in.load)) {}
  [[nodiscard]] double motor_at(double omega) const { return moment_at({motor.data(), motor.size()}, omega); }
  [[nodiscard]] double load_at(double omega) const { return moment_at({load.data(), load.size()}, omega); }
  [[nodiscard]] double at(double omega) const { return motor_at(omega) - load_at(omega); }
};

/// From n_1 to n_2, with the speeds between at which a line bends.
Speeds speeds_of(const Input& in, const Balance& balance) {
  const double from = in_si(in.n_1), to = in_si(in.n_2), low = std::min(from, to), high = std::max(from, to);
  Speeds speeds{from, to};
  for (const MomentLine* const line : {&balance.motor, &balance.load}) {
    for (const LinePoint& point : *line) {
      if (low < point.omega && point.omega < high) speeds.push_back(point.omega);
    }
  }
  if (from < to) {
    std::sort(speeds.begin(), speeds.end());
  } else {
    std::sort(speeds.begin(), speeds.end(), [](double a, double b) { return a > b; });
  }
  return speeds;
}

/// Resistance over driving moment, at one speed: motor and load each on the side of their sign.
double resistance(const Balance& balance, double omega, double sense) {
  const double motor = sense * balance.motor_at(omega), load = -sense * balance.load_at(omega);
  const double with = std::max(motor, 0.0) + std::max(load, 0.0);
  const double against = std::max(-motor, 0.0) + std::max(-load, 0.0);
  return with > 0.0 ? against / with : unset<double>;
}

/// Time, angle and works of the full run; none if it does not reach its end.
void follow(const Input& in, const Balance& balance, const Speeds& speeds, Result& r) {
  const double inertia = in_si(r.J_red), sense = in.n_2 > in.n_1 ? 1.0 : -1.0;
  r.u_M = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double omega : speeds) {
    least = std::min(least, sense * balance.at(omega));
    const double u = resistance(balance, omega, sense);
    if (!(u <= r.u_M)) r.u_M = u;  // an unavailable value stays unavailable
    if (std::isnan(u)) break;
  }
  r.M_least = least * N_m;
  if (!(least > 0.0)) {
    if (r.u_M <= 1.0) r.u_M = unset<double>;  // just balanced: it stays there, or never gets there
    return;
  }
  Stretch whole;
  for (std::size_t i = 0; i + 1 < speeds.size(); ++i) {
    const double a = speeds[i], b = speeds[i + 1];
    if (a == b) continue;
    const auto part = run(inertia, a, balance.at(a), b, balance.at(b), balance.load_at(a), balance.load_at(b));
    whole.time += part.time;
    whole.angle += part.angle;
    whole.taken += part.taken;
  }
  r.t = whole.time * sec;
  r.turns = whole.angle / (2.0 * pi);
  r.A_L = whole.taken * J;
}

template <class Tracer>
void take_energies(const Input& in, Result& r, Tracer& trace) {
  trace.value("t", r.t, "sum over the stretches of J_red times the integral of d omega/M, [B36]");
  trace.value("turns", r.turns, "sum over the stretches of the angle, a turn is 2 pi");
  trace.value("A_L", r.A_L, "integral of the load's moment over the angle");
  STEP_TO(r, Delta_E, 0.5 * r.J_red * (in.n_2 * in.n_2 - in.n_1 * in.n_1), "kinetic energy, [B37]");
  STEP_TO(r, A_M, Delta_E + r.A_L, "theorem of kinetic energy, [B37]");
  if (!is_set(in.t_adm)) return;
  STEP_TO(r, u_t, r.t / in.t_adm, "time over the allowed one");
}

bool rises(const RunUp::Points& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!(points[i].n > points[i - 1].n)) return false;
  }
  return true;
}

bool reaches(const Input& in, const RunUp::Points& points) {
  if (points.size() < 2) return true;
  constexpr double rounding = 1e-9;
  const double low = in_si(min(in.n_1, in.n_2)), high = in_si(max(in.n_1, in.n_2));
  return in_si(points.front().n) <= low + rounding * high && in_si(points.back().n) >= high * (1.0 - rounding);
}

/// Whether the motor accelerates away from n_2 at the start, against or without the help of its load.
bool drives_away(const Input& in) {
  if (in.motor.empty() || !(in_si(in.n_1) != in_si(in.n_2))) return false;
  const Balance balance(in);
  const double omega = in_si(in.n_1), sense = in.n_2 > in.n_1 ? 1.0 : -1.0;
  return sense * balance.motor_at(omega) < 0.0 && sense * balance.at(omega) < 0.0;
}

}  // namespace

double RunUp::reduced_inertia(const Input& in) {
  double sum = 0.0;
  for (const Part& part : in.parts) sum += in_si(part.inertia) * part.u * part.u;
  return sum;
}

bool RunUp::lines_rise(const Input& in) { return rises(in.motor) && rises(in.load); }
bool RunUp::lines_reach(const Input& in) { return reaches(in, in.motor) && reaches(in, in.load); }

FieldFault RunUp::short_line(const Input& in) {
  const bool is_motor = !reaches(in, in.motor);
  const Points& line = is_motor ? in.motor : in.load;
  return {is_motor ? "motor" : "load",
          say("the line goes from {1} to {2}, and the run from {3} to {4}",
              format_quantity(in_si(line.front().n), "rpm", 4), format_quantity(in_si(line.back().n), "rpm", 4),
              format_quantity(in_si(in.n_1), "rpm", 4), format_quantity(in_si(in.n_2), "rpm", 4)),
          say("add points; a single point is a constant moment")};
}

bool RunUp::signs_agree(const Input& in) { return !rises(in.motor) || !rises(in.load) || !drives_away(in); }

FieldFault RunUp::wrong_sign(const Input& in) {
  const Balance balance(in);
  const std::string torque = format_quantity(balance.motor_at(in_si(in.n_1)), "N*m", 4);
  const std::string from = format_quantity(in_si(in.n_1), "rpm", 4), to = format_quantity(in_si(in.n_2), "rpm", 4);
  if (in.n_2 < in.n_1)
    return {"motor",
            say("n_2 = {1} is below n_1 = {2}, but the motor torque of {3} at n_1 is positive: it accelerates", to,
                from, torque),
            say("give the torque of a brake with a negative sign, or exchange n_1 and n_2")};
  return {
      "motor",
      say("n_2 = {1} is above n_1 = {2}, but the motor torque of {3} at n_1 is negative: it brakes", to, from, torque),
      say("give the torque of a motor with a positive sign, or exchange n_1 and n_2")};
}

template <class Tracer>
RunUp::Result RunUp::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Balance balance(in);
  r.J_red = trace.value("J_red", reduced_inertia(in) * kg_m2, "sum of J u^2: the same kinetic energy, [B37]");
  r.M_start = trace.value("M_start", balance.at(in_si(in.n_1)) * N_m, "motor less load at n_1");
  r.M_end = trace.value("M_end", balance.at(in_si(in.n_2)) * N_m, "motor less load at n_2");
  STEP_TO(r, epsilon_1, r.M_start / r.J_red, "J epsilon = M, [B36]");
  follow(in, balance, speeds_of(in, balance), r);
  trace.value("M_least", r.M_least, "minimum over the speeds at which a line bends");
  if (is_set(r.t)) take_energies(in, r, trace);
  return r;
}

template RunUp::Result RunUp::evaluate(const Input&, NoTrace&);
template RunUp::Result RunUp::evaluate(const Input&, Trace&);

std::vector<figure::Figure> RunUp::figures(const Input& in, const Result&) {
  const Balance balance(in);
  figure::Plot plot;
  plot.x = {"n", "speed", "rpm"};
  plot.y = {"M", "torque at the motor shaft", "N*m"};
  figure::Curve motor{"motor", {}, {}}, load{"load", {}, {}};
  for (const double omega : speeds_of(in, balance)) {
    motor.x.push_back(omega);
    motor.y.push_back(balance.motor_at(omega));
    load.x.push_back(omega);
    load.y.push_back(balance.load_at(omega));
  }
  plot.curves = {std::move(motor), std::move(load)};
  return {{"moment-lines", "Torque curves of motor and load", std::move(plot)}};
}

}  // namespace loadpath::machine

template const loadpath::Calculator& loadpath::erased<loadpath::machine::RunUp>();
