#include "calculators/dynamics/throw.hpp"

#include "calculators/motion/laws.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::dynamics {

namespace {

/// How high the landing is, over how high the body gets, both above the throw.
double reached_height(const Throw::Input& in, const Throw::Result& r) {
  return in_si(in.h) < 0.0 ? -in_si(in.h) / in_si(r.H) : 0.0;
}

template <class Tracer>
void land(const Throw::Input& in, Throw::Result& r, Tracer& trace) {
  const auto V_z = r.V_z;
  STEP_TO(r, t_L, (V_z + sqrt(V_z * V_z + 2.0 * in.g * in.h)) / in.g,
          "later time at which z = -h, from the law of motion [B32]");
  STEP_TO(r, L, r.V_x * t_L, "law of motion along x, [B32]");
  STEP_TO(r, V_L, sqrt(r.V_x * r.V_x + V_z * V_z + 2.0 * in.g * in.h), "the speed does not depend on the angle, [B34]");
  r.theta_L = std::atan2(std::sqrt(std::max(0.0, in_si(V_z * V_z + 2.0 * in.g * in.h))), in_si(r.V_x));
}

/// The greatest range: where speed of throw and of landing are perpendicular.
template <class Tracer>
void find_best(const Throw::Input& in, Throw::Result& r, Tracer& trace) {
  const auto V_0 = in.V_0;
  r.theta_H = pi / 2.0;
  if (!(in_si(V_0 * V_0 + 2.0 * in.g * in.h) > 0.0)) return;
  STEP(V_E, sqrt(V_0 * V_0 + 2.0 * in.g * in.h), "speed at the height of the landing, [B34]");
  STEP_TO(r, theta_R, atan(V_0 / V_E), "greatest range: directions of throw and landing are perpendicular");
  STEP_TO(r, L_max, V_0 * V_E / in.g, "range at that angle");
}

/// Both angles that reach the distance: the flight passes (L_req, -h).
template <class Tracer>
void aim(const Throw::Input& in, Throw::Result& r, Tracer& trace) {
  if (!is_set(r.L_max)) return;  // no throw with this speed gets as high as the landing
  if (r.L > 0.0 * m.one) {
    STEP_TO(r, u_L, in.L_req / r.L, "distance over that of the landing");
  }
  STEP(k, in.V_0 * in.V_0 / (in.g * in.L_req), "twice the height of a vertical throw over the distance");
  STEP(D, k * k - 1.0 + 2.0 * k * (in.h / in.L_req), "discriminant of tan(theta) from the law of motion");
  if (!(D >= 0.0)) return;
  STEP_TO(r, theta_flat, atan(k - sqrt(D)), "law of motion through the aim, [B32]");
  STEP_TO(r, theta_steep, atan(k + sqrt(D)), "law of motion through the aim, [B32]");
}

}  // namespace

template <class Tracer>
Throw::Result Throw::evaluate(const Input& given, Tracer& trace) {
  Result r;
  Input in = given;
  in.g = r.g = gravity_of(given, trace);
  const auto& [V_0, theta, h, L_req, g, latitude, altitude] = in;
  r.V_x = motion::without_rounding(in_si(V_0) * cos(theta), in_si(V_0)) * m_per_s;
  trace.value("V_x", r.V_x, "part of the speed along x, constant, [B32]");
  STEP_TO(r, V_z, V_0 * sin(theta), "part of the speed along z at the throw, [B32]");
  STEP_TO(r, t_H, max(V_z, 0.0 * m_per_s) / g, "the vertical speed is zero, [B32]");
  STEP_TO(r, H, 0.5 * g * t_H * t_H, "highest point, [B32]");
  r.u_h = reached_height(in, r);
  if (r.u_h <= 1.0) land(in, r, trace);
  find_best(in, r, trace);
  if (is_set(L_req)) aim(in, r, trace);
  return r;
}

template Throw::Result Throw::evaluate(const Input&, NoTrace&);
template Throw::Result Throw::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Throw::figures(const Input&, const Result& r) {
  if (!is_set(r.t_L)) return {};
  figure::Scheme scheme;
  figure::Scheme::Path way{"", {}};
  const auto at = [&](double t) {
    return figure::Point{in_si(r.V_x) * t, in_si(r.V_z) * t - 0.5 * in_si(r.g) * t * t};
  };
  constexpr int points = 91;
  for (int i = 0; i < points; ++i) way.points.push_back(at(in_si(r.t_L) * i / (points - 1)));
  scheme.paths.push_back(std::move(way));
  scheme.points.push_back({"throw", at(0.0)});
  if (in_si(r.t_H) > 0.0) scheme.points.push_back({"H", at(in_si(r.t_H))});
  scheme.points.push_back({"landing", at(in_si(r.t_L))});
  return {{"flight", "Path of the flight", std::move(scheme)}};
}

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::Throw>();
