#include "calculators/motion/plane.hpp"

#include "calculators/motion/laws.hpp"
#include "calculators/motion/path_figures.hpp"
#include "calculators/motion/plane_parts.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::motion {

namespace {

using Input = Plane::Input;
using Result = Plane::Result;

constexpr double rounding = 1e-12;

Plane::Case case_of(const Input& in) {
  using C = Plane::Case;
  if (!uses_B(in)) return C::given;
  if (rests_in_B(in)) return C::meeting;
  if (is_across_AB(in, in.alpha_B)) return C::tips;
  return std::abs(sin(in.alpha_A - in.alpha_B)) <= square_to_AB ? C::inclined : C::meeting;
}

/// From A to B: its length and its direction from x.
struct Span {
  Length AB;
  double beta;
};

template <class Tracer>
Span span_of(const Input& in, Tracer& trace) {
  const Length dx = in.B.x - in.A.x, dy = in.B.y - in.A.y;
  const Length AB = trace.value("AB", sqrt(dx * dx + dy * dy), "distance of A and B");
  const double beta = trace.value("beta", std::atan2(in_si(dy), in_si(dx)), "direction from A to B, from x");
  return {AB, beta};
}

template <class Tracer>
void take_velocity_of_B(const Input& in, const Span& span, Result& r, Tracer& trace) {
  const auto& [AB, beta] = span;
  const auto alpha_B = is_set(in.alpha_B) ? in.alpha_B : 0.0;
  r.v_B = in.v_B;
  if (!is_set(in.alpha_B)) trace.value("alpha_B", alpha_B, "any direction: B rests");
  if (!is_set(in.v_B)) {
    STEP(v_B, in.v_A * cos(in.alpha_A - beta) / cos(alpha_B - beta), "projections on AB are equal, [B29]");
    r.v_B = without_rounding(in_si(v_B), in_si(in.v_A)) * m_per_s;
  }
  if (case_of(in) == Plane::Case::inclined) {
    r.omega = trace.value("omega", 0.0 * rad_per_s, "parallel velocities oblique to AB: translation, [B29]");
    return;
  }
  STEP(v_nA, in.v_A * sin(in.alpha_A - beta), "part of v_A across AB");
  STEP(v_nB, r.v_B * sin(alpha_B - beta), "part of v_B across AB");
  STEP_TO(r, omega, (v_nB - v_nA) / AB, "B turns about A, [B29]");
}

/// Whether a speed at the relevant distance is negligible compared with the velocities.
Plane::Kind kind_of(const Input& in, const Result& r) {
  const double fastest = std::max(std::abs(in_si(in.v_A)), is_set(r.v_B) ? std::abs(in_si(r.v_B)) : 0.0);
  const double turning = std::abs(in_si(r.omega)) * (uses_B(in) ? distance(in) : 1.0);
  if (fastest == 0.0 && turning == 0.0) return Plane::Kind::rest;
  const double negligible = uses_B(in) ? rounding * fastest : 0.0;
  return turning <= negligible ? Plane::Kind::translation : Plane::Kind::rotation;
}

template <class Tracer>
void trace_A(const Input& in, Tracer& trace) {
  trace.value("x_A", in.A.x, "position of A");
  trace.value("y_A", in.A.y, "position of A");
}

template <class Tracer>
void find_pole(const Input& in, Result& r, Tracer& trace) {
  const auto x_A = in.A.x, y_A = in.A.y;
  const Speed v_Ax = without_rounding(in_si(in.v_A) * cos(in.alpha_A), in_si(in.v_A)) * m_per_s;
  const Speed v_Ay = without_rounding(in_si(in.v_A) * sin(in.alpha_A), in_si(in.v_A)) * m_per_s;
  trace_A(in, trace);
  trace.value("v_Ax", v_Ax, "v_A along x");
  trace.value("v_Ay", v_Ay, "v_A along y");
  STEP_TO(r, x_P, x_A - v_Ay / r.omega, "on the perpendicular to the velocity of A, [B29]");
  STEP_TO(r, y_P, y_A + v_Ax / r.omega, "on the perpendicular to the velocity of A, [B29]");
  STEP_TO(r, PA, abs(in.v_A / r.omega), "omega = v_A/PA, [B29]");
}

/// The angular acceleration from the straight guide of B.
template <class Tracer>
void take_guide_of_B(const Input& in, const Span& span, Result& r, Tracer& trace) {
  const auto& [AB, beta] = span;
  STEP_TO(r, a_B, (in.a_A * cos(in.alpha_aA - beta) - r.omega * r.omega * AB) / cos(in.alpha_aB - beta),
          "projections on AB: that of a_B is smaller by the normal acceleration of B about A");
  STEP_TO(r, epsilon, (a_B * sin(in.alpha_aB - beta) - in.a_A * sin(in.alpha_aA - beta)) / AB,
          "parts across AB: tangential acceleration of B about A");
}

template <class Tracer>
void find_pole_of_accelerations(const Input& in, Result& r, Tracer& trace) {
  const auto x_A = in.A.x, y_A = in.A.y;
  STEP(D, pow<4>(r.omega) + r.epsilon * r.epsilon, "square of the acceleration per distance");
  if (in_si(D) == 0.0) return;
  if (r.kind != Plane::Kind::rotation) trace_A(in, trace);
  STEP_TO(r, x_Q, x_A + in.a_A * (r.omega * r.omega * cos(in.alpha_aA) - r.epsilon * sin(in.alpha_aA)) / D,
          "the point without acceleration");
  STEP_TO(r, y_Q, y_A + in.a_A * (r.omega * r.omega * sin(in.alpha_aA) + r.epsilon * cos(in.alpha_aA)) / D,
          "the point without acceleration");
}

Plane::PointState state_at(const Input& in, const Result& r, const Name& name, Length x, Length y) {
  Plane::PointState s;
  s.name = name, s.x = x, s.y = y;
  const double dx = in_si(x - in.A.x), dy = in_si(y - in.A.y), reach = std::hypot(dx, dy);
  const double v_A = in_si(in.v_A), omega = in_si(r.omega);
  const double v_scale = std::abs(v_A) + std::abs(omega) * reach;
  s.v_x = without_rounding(v_A * cos(in.alpha_A) - omega * dy, v_scale) * m_per_s;
  s.v_y = without_rounding(v_A * sin(in.alpha_A) + omega * dx, v_scale) * m_per_s;
  s.v = sqrt(s.v_x * s.v_x + s.v_y * s.v_y);
  if (in_si(s.v) > 0.0) s.gamma = std::atan2(in_si(s.v_y), in_si(s.v_x));
  if (!is_set(in.a_A)) return s;
  const double a_A = in_si(in.a_A), epsilon = in_si(r.epsilon), square = omega * omega;
  const double a_scale = std::abs(a_A) + (std::abs(epsilon) + square) * reach;
  s.a_x = without_rounding(a_A * cos(in.alpha_aA) - epsilon * dy - square * dx, a_scale) * m_per_s2;
  s.a_y = without_rounding(a_A * sin(in.alpha_aA) + epsilon * dx - square * dy, a_scale) * m_per_s2;
  s.a = sqrt(s.a_x * s.a_x + s.a_y * s.a_y);
  return s;
}

}  // namespace

template <class Tracer>
Plane::Result Plane::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.found = case_of(in);
  r.omega = in.omega;
  const Span span = has_B(in) ? span_of(in, trace) : Span{};
  if (has_B(in)) r.AB = span.AB, r.beta = span.beta;
  if (uses_B(in)) take_velocity_of_B(in, span, r, trace);
  r.kind = kind_of(in, r);
  if (r.kind != Kind::rotation) r.omega = 0.0 * rad_per_s;
  if (r.kind == Kind::rotation) find_pole(in, r, trace);
  r.epsilon = in.epsilon;
  if (is_set(in.alpha_aB)) take_guide_of_B(in, span, r, trace);
  if (is_set(in.a_A)) find_pole_of_accelerations(in, r, trace);
  r.states.push_back(state_at(in, r, "A", in.A.x, in.A.y));
  if (has_B(in)) r.states.push_back(state_at(in, r, "B", in.B.x, in.B.y));
  for (const Point& p : in.points) r.states.push_back(state_at(in, r, p.name, p.x, p.y));
  return r;
}

template Plane::Result Plane::evaluate(const Input&, NoTrace&);
template Plane::Result Plane::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Plane::figures(const Input&, const Result& r) {
  figure::Scheme scheme;
  figure::Scheme::Body body{"", {}};
  Vectors velocities{"Velocities", "m/s", {}}, accelerations{"Accelerations", "m/s^2", {}};
  for (const PointState& s : r.states) {
    const std::string name(s.name.view());
    body.points.push_back({in_si(s.x), in_si(s.y)});
    scheme.points.push_back({name, body.points.back()});
    velocities.of.push_back({"v_" + name, {in_si(s.v_x), in_si(s.v_y)}});
    if (is_set(s.a)) accelerations.of.push_back({"a_" + name, {in_si(s.a_x), in_si(s.a_y)}});
  }
  scheme.bodies.push_back(std::move(body));
  if (is_set(r.x_P)) scheme.points.push_back({"P", {in_si(r.x_P), in_si(r.y_P)}});
  std::vector<figure::Figure> all{{"body", "The body with the pole P of its velocities", std::move(scheme)}};
  auto plan = plan_figure({velocities, accelerations});
  if (!std::get<figure::Plans>(plan.content).panels.empty()) all.push_back(std::move(plan));
  return all;
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Plane>();
