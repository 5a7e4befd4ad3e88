#include "calculators/dynamics/motion.hpp"

#include "calculators/motion/path_figures.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::dynamics {

namespace {

using Ends = Solved::End;

FreeMotion motion_of(const Motion::Input& in) {
  return FreeMotion({in_si(in.mass),
                     in_si(in.t_2),
                     {in_si(in.x_0), in_si(in.y_0), in_si(in.z_0)},
                     {in_si(in.v_x0), in_si(in.v_y0), in_si(in.v_z0)},
                     {&in.F_x, &in.F_y, &in.F_z},
                     &in.until});
}

/// Difference of two solutions at the end, over the largest values of the motion. With `until` the times differ too.
double difference(const MotionState& a, const MotionState& b, const Extremes& extremes) {
  double largest = std::abs(a.t - b.t) / a.t;
  for (std::size_t i = 0; i < 3; ++i) {
    if (extremes.reach() > 0.0) largest = std::max(largest, std::abs(a.r[i] - b.r[i]) / extremes.reach());
    if (extremes.speed > 0.0) largest = std::max(largest, std::abs(a.v[i] - b.v[i]) / extremes.speed);
  }
  return largest;
}

bool is_spatial(const Motion::Input& in) { return !in.F_z.empty() || in_si(in.v_z0) != 0.0 || in_si(in.z_0) != 0.0; }

/// Whether the point may leave the axis x; and above, the plane xy.
bool is_plane(const Motion::Input& in) {
  return !in.F_y.empty() || in_si(in.v_y0) != 0.0 || in_si(in.y_0) != 0.0 || is_spatial(in);
}

void clean(std::array<double, 3>& values, double largest) {
  constexpr double rounding = 1e-12;
  for (double& value : values) value = std::abs(value) <= rounding * largest ? 0.0 : value;
}

/// What is only rounding of the largest values becomes zero.
MotionState cleaned(MotionState state, const Extremes& extremes) {
  clean(state.r, extremes.reach());
  clean(state.v, extremes.speed);
  return state;
}

void take_extremes(const Motion::Input& in, const Extremes& extremes, Motion::Result& r) {
  std::array<double, 3> least = extremes.least, most = extremes.most;
  for (std::array<double, 3>* places : {&least, &most}) clean(*places, extremes.reach());
  r.x_min = least[0] * m, r.x_max = most[0] * m;
  if (is_plane(in)) r.y_min = least[1] * m, r.y_max = most[1] * m;
  if (is_spatial(in)) r.z_min = least[2] * m, r.z_max = most[2] * m;
  r.v_max = extremes.speed * m_per_s;
  r.F_max = extremes.force * N;
}

template <class Tracer>
void take_end(const Motion::Input& in, const FreeMotion::Ended& ended, Motion::Result& r, Tracer& trace) {
  const MotionState& last = ended.state;
  constexpr const char* solution = "m a = F, integrated over the time, [B32]";
  r.end = ended.how == Ends::zero ? Motion::End::until : Motion::End::time;
  r.t_E = trace.value("t_E", last.t * sec, ended.how == Ends::zero ? "zero of `until`" : "time t_2");
  r.x_E = trace.value("x_E", last.r[0] * m, solution);
  r.v_xE = trace.value("v_xE", last.v[0] * m_per_s, solution);
  if (is_plane(in)) {
    r.y_E = trace.value("y_E", last.r[1] * m, solution);
    r.v_yE = trace.value("v_yE", last.v[1] * m_per_s, solution);
  }
  if (is_spatial(in)) {
    r.z_E = trace.value("z_E", last.r[2] * m, solution);
    r.v_zE = trace.value("v_zE", last.v[2] * m_per_s, solution);
  }
  r.v_E = trace.value("v_E", last.speed() * m_per_s, "magnitude of the velocity, [B26]");
  r.L = trace.value("L", last.length * m, "integral of the speed over the time");
}

template <class Tracer>
void take_energies(const Motion::Input& in, double work, Motion::Result& r, Tracer& trace) {
  const Speed v_x0 = in.v_x0, v_y0 = in.v_y0, v_z0 = in.v_z0, v_E = r.v_E;
  const Mass m = in.mass;
  STEP(v_0, sqrt(v_x0 * v_x0 + v_y0 * v_y0 + v_z0 * v_z0), "magnitude of the velocity at the start, [B26]");
  STEP_TO(r, E_1, 0.5 * m * v_0 * v_0, "kinetic energy at the start, [B34]");
  STEP_TO(r, E_2, 0.5 * m * v_E * v_E, "kinetic energy at the end, [B34]");
  r.A = trace.value("A", work * J, "integral of the power of the forces; it equals E_2 - E_1, [B34]");
}

std::vector<double> times_to(double end, int rows) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(rows));
  for (int i = 0; i < rows; ++i) times.push_back(i + 1 == rows ? end : end * i / (rows - 1));
  return times;
}

void fill_states(const Motion::Input& in, const FreeMotion& motion, double end, const Extremes& extremes,
                 Motion::Result& r) {
  for (const MotionState& exact : motion.at(times_to(end, static_cast<int>(in.rows)))) {
    const MotionState s = cleaned(exact, extremes);
    Motion::State state;
    state.t = s.t * sec, state.x = s.r[0] * m, state.v_x = s.v[0] * m_per_s;
    if (is_plane(in)) state.y = s.r[1] * m, state.v_y = s.v[1] * m_per_s;
    if (is_spatial(in)) state.z = s.r[2] * m, state.v_z = s.v[2] * m_per_s;
    state.v = s.speed() * m_per_s, state.F = magnitude_of(motion.force(s)) * N;
    r.states.push_back(state);
  }
}

bool reads(const Motion::Input& in) {
  return in.F_x.read() != nullptr && in.F_y.fault() == nullptr && in.F_z.fault() == nullptr &&
         in.until.fault() == nullptr;
}

}  // namespace

bool Motion::forces_read(const Input& in) { return force_fault(in).message.empty(); }

FieldFault Motion::force_fault(const Input& in) {
  const auto fault_at = [](const char* key, const RelationText& text) -> FieldFault {
    if (const Fault* const fault = text.fault()) return {key, fault->message, fault->hint};
    return {};
  };
  for (FieldFault fault :
       {fault_at("F_x", in.F_x), fault_at("F_y", in.F_y), fault_at("F_z", in.F_z), fault_at("until", in.until)}) {
    if (!fault.message.empty()) return fault;
  }
  return {};
}

bool Motion::is_solved(const Input& in) { return gap(in).message.empty(); }

FieldFault Motion::gap(const Input& in) {
  if (!reads(in)) return {};
  const FreeMotion motion = motion_of(in);
  const auto [how, last] = motion.follow(FreeMotion::coarse_tolerance);
  const std::string place = "t = " + format_number(last.t, 4) + " s, x = " + format_number(last.r[0], 4) + " m";
  if (how == Ends::too_many_steps)
    return {"t_2", say("the forces change too fast to be followed beyond {1}", place),
            say("end the motion earlier, or check the units of the forces")};
  if (how != Ends::no_slopes) return {};
  const std::array<double, 3> F = motion.force(last);
  const auto missing = std::ranges::find_if(F, [](double value) { return !std::isfinite(value); });
  constexpr std::array keys{"F_x", "F_y", "F_z"};
  return {missing == F.end() ? keys[0] : keys[static_cast<std::size_t>(missing - F.begin())],
          say("the force has no value, or a pole, at {1}", place), say("end the motion earlier, by t_2 or `until`")};
}

template <class Tracer>
Motion::Result Motion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const FreeMotion motion = motion_of(in);
  Extremes extremes;
  FreeMotion::Ended ended = motion.follow(FreeMotion::usual_tolerance, [&](const MotionState& state) {
    extremes.take(state, magnitude_of(motion.force(state)));
  });
  ended.state = cleaned(ended.state, extremes);
  take_end(in, ended, r, trace);
  const Force F_E = trace.value("F_E", magnitude_of(motion.force(ended.state)) * N, "resultant at the end");
  const Mass m = in.mass;
  STEP_TO(r, a_E, F_E / m, "acceleration at the end, [B32]");
  take_extremes(in, extremes, r);
  take_energies(in, ended.state.work, r, trace);
  r.delta = difference(ended.state, motion.follow(FreeMotion::coarse_tolerance).state, extremes);
  fill_states(in, motion, ended.state.t, extremes, r);
  return r;
}

template Motion::Result Motion::evaluate(const Input&, NoTrace&);
template Motion::Result Motion::evaluate(const Input&, Trace&);

namespace {

constexpr int drawn = 181;  // points of a curve

figure::Figure path_of(const std::vector<MotionState>& states) {
  figure::Scheme scheme;
  figure::Scheme::Path path{"", {}};
  for (const MotionState& s : states) path.points.push_back({s.r[0], s.r[1]});
  scheme.paths.push_back(std::move(path));
  scheme.points.push_back({"start", {states.front().r[0], states.front().r[1]}});
  scheme.points.push_back({"end", {states.back().r[0], states.back().r[1]}});
  return {"path", "Path of the motion", std::move(scheme)};
}

template <class Of>
figure::Figure over_time(const std::vector<MotionState>& states, const char* id, const char* title, figure::Plot plot,
                         const char* name, const Of& of) {
  figure::Curve curve{name, {}, {}};
  for (const MotionState& s : states) {
    curve.x.push_back(s.t);
    curve.y.push_back(of(s));
  }
  plot.curves.push_back(std::move(curve));
  return {id, title, std::move(plot)};
}

}  // namespace

std::vector<figure::Figure> Motion::figures(const Input& in, const Result& r) {
  if (!is_set(r.t_E)) return {};
  const std::vector<MotionState> states = motion_of(in).at(times_to(in_si(r.t_E), drawn));
  std::vector<figure::Figure> figures;
  if (is_set(r.y_max) && r.y_max > r.y_min) figures.push_back(path_of(states));
  figures.push_back(over_time(states, "position", "Coordinate x over the time",
                              motion::over_time("x", "coordinate x", "m"), "x",
                              [](const MotionState& s) { return s.r[0]; }));
  figures.push_back(over_time(states, "speed", "Speed over the time", motion::over_time("v", "speed", "m/s"), "v",
                              [](const MotionState& s) { return s.speed(); }));
  return figures;
}

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::Motion>();
