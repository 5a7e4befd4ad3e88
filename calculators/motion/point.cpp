#include "calculators/motion/point.hpp"

#include "calculators/motion/path_figures.hpp"
#include "calculators/motion/point_equation.hpp"
#include "calculators/motion/point_path.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace loadpath::motion {

namespace {

constexpr double rounding = 1e-12;  // a part of the acceleration below this share of it is none

PointPath path_of(const Point::Input& in) { return {in.x, in.y, in.z}; }

Length radius_of(const PointState& s) { return s.a_n > rounding * s.acceleration ? 1.0 / s.kappa * m : unset<Length>; }

Point::State state_at(const PointPath& path, double t) {
  const PointState s = path.at(t);
  Point::State state;
  state.t = t * sec;
  state.x = s.r[0] * m, state.y = s.r[1] * m, state.z = s.r[2] * m;
  state.v = s.speed * m_per_s;
  state.a = s.acceleration * m_per_s2, state.a_tau = s.a_tau * m_per_s2, state.a_n = s.a_n * m_per_s2;
  state.rho = radius_of(s);
  return state;
}

/// Position, velocity and acceleration from the laws; a plane motion does not show z.
template <class Tracer>
void take_state(const PointState& s, bool plane, Point::Result& r, Tracer& trace) {
  r.z_M = s.r[2] * m, r.v_z = s.v[2] * m_per_s, r.a_z = s.a[2] * m_per_s2;
  constexpr const char* law = "law of motion at the time t";
  constexpr const char* first = "first derivative of the law of motion, [B26]";
  constexpr const char* second = "second derivative of the law of motion, [B32]";
  r.x_M = trace.value("x_M", s.r[0] * m, law);
  r.y_M = trace.value("y_M", s.r[1] * m, law);
  if (!plane) trace.value("z_M", r.z_M, law);
  r.v_x = trace.value("v_x", s.v[0] * m_per_s, first);
  r.v_y = trace.value("v_y", s.v[1] * m_per_s, first);
  if (!plane) trace.value("v_z", r.v_z, first);
  r.a_x = trace.value("a_x", s.a[0] * m_per_s2, second);
  r.a_y = trace.value("a_y", s.a[1] * m_per_s2, second);
  if (!plane) trace.value("a_z", r.a_z, second);
}

/// Magnitudes, and the parts of the acceleration, of a motion in the plane xy.
template <class Tracer>
void split_in_plane(bool rests, Point::Result& r, Tracer& trace) {
  STEP_TO(r, v, sqrt(r.v_x * r.v_x + r.v_y * r.v_y), "magnitude of the velocity, [B26]");
  STEP_TO(r, a, sqrt(r.a_x * r.a_x + r.a_y * r.a_y), "magnitude of the acceleration");
  if (rests) return;
  STEP_TO(r, a_tau, (r.v_x * r.a_x + r.v_y * r.a_y) / v, "projection of the acceleration on the tangent, dv/dt");
  STEP_TO(r, a_n, abs(r.v_x * r.a_y - r.v_y * r.a_x) / v, "part of the acceleration across the tangent");
}

/// The same of a motion in space.
template <class Tracer>
void split_in_space(bool rests, Point::Result& r, Tracer& trace) {
  STEP_TO(r, v, sqrt(r.v_x * r.v_x + r.v_y * r.v_y + r.v_z * r.v_z), "magnitude of the velocity, [B26]");
  STEP_TO(r, a, sqrt(r.a_x * r.a_x + r.a_y * r.a_y + r.a_z * r.a_z), "magnitude of the acceleration");
  if (rests) return;
  STEP_TO(r, a_tau, (r.v_x * r.a_x + r.v_y * r.a_y + r.v_z * r.a_z) / v,
          "projection of the acceleration on the tangent, dv/dt");
  STEP(c_x, r.v_y * r.a_z - r.v_z * r.a_y, "vector product of velocity and acceleration");
  STEP(c_y, r.v_z * r.a_x - r.v_x * r.a_z, "vector product of velocity and acceleration");
  STEP(c_z, r.v_x * r.a_y - r.v_y * r.a_x, "vector product of velocity and acceleration");
  STEP_TO(r, a_n, sqrt(c_x * c_x + c_y * c_y + c_z * c_z) / v, "part of the acceleration across the tangent");
}

/// The direction of the velocity, which is that of the tangent.
template <class Tracer>
void point_along(bool plane, Point::Result& r, Tracer& trace) {
  STEP_TO(r, cos_x, r.v_x / r.v, "direction cosine of the velocity, [B26]");
  STEP_TO(r, cos_y, r.v_y / r.v, "direction cosine of the velocity, [B26]");
  r.cos_z = 0.0;
  if (plane) return;
  STEP_TO(r, cos_z, r.v_z / r.v, "direction cosine of the velocity, [B26]");
}

/// Curvature and direction in the plane, where there is a tangent.
template <class Tracer>
void bend(Point::Result& r, Tracer& trace) {
  if (in_si(abs(r.v_x)) + in_si(abs(r.v_y)) > 0.0) r.gamma = std::atan2(in_si(r.v_y), in_si(r.v_x));
  STEP_TO(r, kappa, r.a_n / (r.v * r.v), "from a_n = v^2/rho, [B28]");
  if (!(in_si(r.a_n) > rounding * in_si(r.a))) return;
  STEP_TO(r, rho, r.v * r.v / r.a_n, "a_n = v^2/rho, [B28]");
}

Point::Change change_of(bool rests, Acceleration a_tau, Acceleration a) {
  if (rests) return Point::Change::at_rest;
  if (abs(a_tau) <= rounding * a) return Point::Change::steady;
  return in_si(a_tau) > 0.0 ? Point::Change::faster : Point::Change::slower;
}

template <class Tracer>
void take_range(const Point::Input& in, const PointPath& path, Point::Result& r, Tracer& trace) {
  const double from = in_si(in.t_1), to = in_si(in.t_2);
  const PointState first = path.at(from), last = path.at(to);
  const double apart = std::hypot(last.r[0] - first.r[0], last.r[1] - first.r[1], last.r[2] - first.r[2]);
  const Length L = r.L = trace.value("L", path.length(from, to) * m, "integral of the speed over the range");
  const Length Delta_r = r.Delta_r = trace.value("Delta_r", apart * m, "distance of the places at t_2 and t_1");
  STEP_TO(r, v_m, Delta_r / (in.t_2 - in.t_1), "mean velocity, [B26]");
  STEP_TO(r, v_L, L / (in.t_2 - in.t_1), "mean speed along the path");
  constexpr int samples = 257;
  double fastest = 0.0, largest = 0.0;
  for (int i = 0; i < samples; ++i) {
    const PointState s = path.at(from + (to - from) * i / (samples - 1));
    fastest = std::max(fastest, s.speed);
    largest = std::max(largest, s.acceleration);
  }
  r.v_max = fastest * m_per_s, r.a_max = largest * m_per_s2;
}

/// The limits and the equations of the path; an equation longer than the text of a result is left out.
template <class Tracer>
void take_equation(const Point::Input& in, const PointPath& path, Point::Result& r, Tracer& trace) {
  const double from = in_si(in.t_1), to = in_si(in.t_2);
  const PathLimits limits = limits_of(path, from, to);
  r.x_min = limits.low[0] * m, r.x_max = limits.high[0] * m;
  r.y_min = limits.low[1] * m, r.y_max = limits.high[1] * m;
  if (!in.z.empty()) r.z_min = limits.low[2] * m, r.z_max = limits.high[2] * m;
  const PathEquations equations = equations_of(path, from, to);
  constexpr std::size_t longest = decltype(r.path)::capacity;
  double deviation = unset<double>;
  const auto take = [&](const PathEquation& equation, auto& text) {
    const std::string_view found = equation.curve.text;
    if (found.empty() || found.size() > longest) return;
    text = found;
    deviation = std::isnan(deviation) ? equation.deviation : std::max(deviation, equation.deviation);
  };
  take(equations.plane, r.path);
  take(equations.space, r.path_z);
  const bool is_left_out = r.path.empty() && equations.plane.curve.form != PathForm::point;
  r.form = is_left_out ? PathForm::no_equation : equations.plane.curve.form;
  if (std::isnan(deviation)) return;
  r.e_path = trace.value("e_path", deviation, "points of the path put into its equations, the time eliminated, [B26]");
}

void fill_states(const Point::Input& in, const PointPath& path, Point::Result& r) {
  for (const auto& instant : in.times) r.states.push_back(state_at(path, in_si(instant.t)));
  if (!in.times.empty() || !is_set(in.t_1)) return;
  for (int i = 0; i < in.rows; ++i)
    r.states.push_back(state_at(path, in_si(in.t_1 + (in.t_2 - in.t_1) * (i / (in.rows - 1)))));
}

}  // namespace

bool Point::laws_read(const Input& in) { return law_fault(in).message.empty(); }
FieldFault Point::law_fault(const Input& in) { return path_of(in).reading_fault(); }

bool Point::laws_are_smooth(const Input& in) { return gap(in).message.empty(); }

FieldFault Point::gap(const Input& in) {
  const PointPath path = path_of(in);
  FieldFault fault = path.gap_fault(in_si(in.t), in_si(in.t));
  for (const Instant& instant : in.times) {
    if (fault.message.empty()) fault = path.gap_fault(in_si(instant.t), in_si(instant.t));
  }
  if (fault.message.empty() && is_set(in.t_1) && is_set(in.t_2)) fault = path.gap_fault(in_si(in.t_1), in_si(in.t_2));
  return fault;
}

template <class Tracer>
Point::Result Point::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const PointPath path = path_of(in);
  const PointState now = path.at(in_si(in.t));
  const bool rests = now.speed == 0.0;
  const bool plane = in.z.empty();
  take_state(now, plane, r, trace);
  if (plane) {
    split_in_plane(rests, r, trace);
  } else {
    split_in_space(rests, r, trace);
  }
  if (!rests) point_along(plane, r, trace);
  if (!rests) bend(r, trace);
  r.change = change_of(rests, r.a_tau, r.a);
  if (is_set(in.t_1)) take_range(in, path, r, trace);
  if (is_set(in.t_1)) take_equation(in, path, r, trace);
  fill_states(in, path, r);
  return r;
}

template Point::Result Point::evaluate(const Input&, NoTrace&);
template Point::Result Point::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Point::figures(const Input& in, const Result& r) {
  const PointPath path = path_of(in);
  std::vector<figure::Figure> all;
  const double t = in_si(in.t);
  if (is_set(in.t_1)) {
    all.push_back(path_figure(path, t, in_si(in.t_1), in_si(in.t_2)));
    all.push_back(speed_figure(path, t, in_si(in.t_1), in_si(in.t_2)));
    all.push_back(acceleration_figure(path, t, in_si(in.t_1), in_si(in.t_2)));
  }
  const figure::Point v{in_si(r.v_x), in_si(r.v_y)}, a{in_si(r.a_x), in_si(r.a_y)};
  std::vector<std::pair<std::string, figure::Point>> parts{{"a", a}};
  if (is_set(r.a_tau) && is_set(r.v) && in.z.empty()) {
    const double along = in_si(r.a_tau) / in_si(r.v);
    const figure::Point tangential{along * v.x, along * v.y};
    parts.push_back({"a_tau", tangential});
    parts.push_back({"a_n", {a.x - tangential.x, a.y - tangential.y}});
  }
  auto plan = plan_figure({{"Velocity", "m/s", {{"v", v}}}, {"Acceleration", "m/s^2", parts}});
  if (!std::get<figure::Plans>(plan.content).panels.empty()) all.push_back(std::move(plan));
  return all;
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Point>();
