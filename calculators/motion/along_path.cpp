#include "calculators/motion/along_path.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::motion {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

std::array<Written, 3> curve_of(const AlongPath::Input& in) { return {{{"x", &in.x}, {"y", &in.y}, {"z", &in.z}}}; }

/// Place and derivatives by q.
struct CurvePoint {
  std::array<double, 3> r{}, first{}, second{};
  double rate = 0.0;  // arc length per q
};

CurvePoint curve_at(const AlongPath::Input& in, double q) {
  CurvePoint point;
  const auto laws = curve_of(in);
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const numerics::Jet jet = motion::at(laws[i], q);
    point.r[i] = jet.value, point.first[i] = jet.first, point.second[i] = jet.second;
  }
  point.rate = std::hypot(point.first[0], point.first[1], point.first[2]);
  return point;
}

double length_between(const AlongPath::Input& in, double from, double to) {
  if (from == to) return 0.0;
  return integral([](const void* of, double q) { return curve_at(*static_cast<const AlongPath::Input*>(of), q).rate; },
                  &in, from, to);
}

/// The first coordinate that leaps, or has no value, between two parameters in either order.
struct CurveGap {
  const char* key = nullptr;
  double q = nowhere;

  explicit operator bool() const { return key != nullptr; }
};
CurveGap gap_of_curve(const AlongPath::Input& in, double from, double to) {
  for (const Written& law : curve_of(in)) {
    if (const Gap found = first_gap(law, std::min(from, to), std::max(from, to))) return {law.key, found.from};
  }
  return {};
}

/// A parameter beyond the place of S, and the arc length up to it; NaN where the curve ends before.
struct Reached {
  double q = nowhere, s = nowhere;
};

Reached beyond(const AlongPath::Input& in, double S) {
  const double rate = curve_at(in, in.q_0).rate;
  if (!(rate > 0.0) || !std::isfinite(S)) return {};
  constexpr int most_steps = 120;
  constexpr double least = 1e-12;
  double step = S / rate, q = in.q_0, s = 0.0, growth = 2.0;
  for (int i = 0; i < most_steps && std::abs(step) > least * (std::abs(q) + std::abs(S / rate)); ++i) {
    if (gap_of_curve(in, q, q + step)) {  // the end of the path, or of what can be followed, is close
      step *= 0.5, growth = 1.0;
      continue;
    }
    s += length_between(in, q, q + step);
    q += step, step *= growth;
    if (std::abs(s) >= std::abs(S)) return {q, s};
  }
  return {};
}

/// The parameter at which the arc length from q_0 is S, by Newton's steps kept within a bracket; NaN if there is none.
double place_of(const AlongPath::Input& in, double S) {
  if (S == 0.0) return in.q_0;
  const Reached end = beyond(in, S);
  if (!std::isfinite(end.q)) return nowhere;
  double near = in.q_0, far = end.q;  // |s| is less than |S| at the one, and not at the other
  double q = end.q, s = end.s;
  constexpr int most_steps = 200;
  constexpr double rounding = 1e-13;
  for (int i = 0; i < most_steps && std::abs(s - S) > rounding * std::abs(S); ++i) {
    (std::abs(s) < std::abs(S) ? near : far) = q;
    const double newton = q + (S - s) / curve_at(in, q).rate;
    const bool inside = (newton - near) * (newton - far) < 0.0;
    const double next = inside ? newton : 0.5 * (near + far);
    if (std::abs(next - q) <= 1e-15 * std::abs(q - in.q_0)) break;
    s += length_between(in, q, next);
    q = next;
  }
  return q;
}

template <class Tracer>
void take_place(const CurvePoint& point, AlongPath::Result& r, Tracer& trace) {
  r.x_M = trace.value("x_M", point.r[0] * m, "path at q_t");
  r.y_M = trace.value("y_M", point.r[1] * m, "path at q_t");
  r.z_M = trace.value("z_M", point.r[2] * m, "path at q_t");
}

/// The curvature of the path, and the velocity and acceleration along the axes.
template <class Tracer>
void take_motion(const CurvePoint& point, AlongPath::Result& r, Tracer& trace) {
  constexpr const char* first = "derivative by q";
  constexpr const char* second = "second derivative by q";
  const Length x_q = trace.value("x_q", point.first[0] * m, first),
               x_qq = trace.value("x_qq", point.second[0] * m, second);
  const Length y_q = trace.value("y_q", point.first[1] * m, first),
               y_qq = trace.value("y_qq", point.second[1] * m, second);
  const Length z_q = trace.value("z_q", point.first[2] * m, first),
               z_qq = trace.value("z_qq", point.second[2] * m, second);
  STEP(s_q, sqrt(x_q * x_q + y_q * y_q + z_q * z_q), "arc length per q");
  STEP(c_x, y_q * z_qq - z_q * y_qq, "vector product of both derivatives");
  STEP(c_y, z_q * x_qq - x_q * z_qq, "vector product of both derivatives");
  STEP(c_z, x_q * y_qq - y_q * x_qq, "vector product of both derivatives");
  STEP_TO(r, kappa, sqrt(c_x * c_x + c_y * c_y + c_z * c_z) / pow<3>(s_q), "curvature of the path");
  const Speed v_tau = r.v_tau;
  const Acceleration a_tau = r.a_tau;
  STEP_TO(r, a_n, v_tau * v_tau * kappa, "a_n = v^2/rho, [B28]");
  STEP_TO(r, a, sqrt(a_tau * a_tau + a_n * a_n), "both components are perpendicular, [B28]");
  if (in_si(kappa * s_q) > 1e-12) {
    STEP_TO(r, rho, 1.0 / kappa, "radius of curvature");
  }
  STEP(s_qq, (x_q * x_qq + y_q * y_qq + z_q * z_qq) / s_q, "second derivative of the arc length by q");
  STEP_TO(r, v_x, v_tau * x_q / s_q, "along the tangent");
  STEP_TO(r, v_y, v_tau * y_q / s_q, "along the tangent");
  STEP_TO(r, v_z, v_tau * z_q / s_q, "along the tangent");
  STEP(w, pow<2>(v_tau / s_q), "square of the velocity of q");
  STEP_TO(r, a_x, a_tau * x_q / s_q + w * (x_qq - s_qq * x_q / s_q), "along tangent and principal normal");
  STEP_TO(r, a_y, a_tau * y_q / s_q + w * (y_qq - s_qq * y_q / s_q), "along tangent and principal normal");
  STEP_TO(r, a_z, a_tau * z_q / s_q + w * (z_qq - s_qq * z_q / s_q), "along tangent and principal normal");
}

Written law_of(const AlongPath::Input& in) { return {"S", &in.S}; }

/// Whether the tangents at two places differ by more than a right angle.
bool is_bent(const AlongPath::Input& in, double from, double to) {
  const CurvePoint a = curve_at(in, from), b = curve_at(in, to);
  return a.first[0] * b.first[0] + a.first[1] * b.first[1] + a.first[2] * b.first[2] < 0.0;
}

/// A cusp on the way: there the tangents differ however close the places are. NaN if there is none.
double cusp_before(const AlongPath::Input& in, double q) {
  constexpr int samples = 256, halvings = 40;
  for (int k = 0; k < samples; ++k) {
    double from = in.q_0 + (q - in.q_0) * k / samples, to = in.q_0 + (q - in.q_0) * (k + 1) / samples;
    int i = 0;
    for (; i < halvings && is_bent(in, from, to); ++i) {
      const double middle = 0.5 * (from + to);
      (is_bent(in, from, middle) ? to : from) = middle;
    }
    if (i == halvings) return from;
  }
  return nowhere;
}

FieldFault start_fault(const AlongPath::Input& in) {
  const CurveGap found = gap_of_curve(in, in.q_0, in.q_0);
  if (!found) return {};
  return {found.key, say("the path has no value, or no derivative, at q_0 = {1}", format_number(in.q_0, 4)),
          say("start elsewhere by q_0")};
}

}  // namespace

bool AlongPath::laws_read(const Input& in) { return law_fault(in).message.empty(); }

FieldFault AlongPath::law_fault(const Input& in) {
  const auto [x, y, z] = curve_of(in);
  return reading_fault(std::array{x, y, z, law_of(in)});
}

bool AlongPath::is_on_path(const Input& in) { return gap(in).message.empty(); }

FieldFault AlongPath::gap(const Input& in) {
  if (!laws_read(in)) return {};  // another rule states it
  const double t = in_si(in.t), S = motion::at(law_of(in), t).value;
  if (FieldFault fault = gap_fault(std::array{law_of(in)}, t, t); !fault.message.empty()) return fault;
  if (FieldFault fault = start_fault(in); !fault.message.empty()) return fault;
  const double q = place_of(in, S);
  if (!std::isfinite(q))
    return {"S", say("the path ends, or turns back, before S(t) = {1}", format_quantity(S, "m", 4)),
            say("shorten S, or change the path: its derivatives by q must not all be zero")};
  if (const double cusp = cusp_before(in, q); std::isfinite(cusp))
    return {"x", say("the path turns back at q = {1}", format_number(cusp, 4)),
            say("start after it by q_0, or shorten S")};
  if (curve_at(in, q).rate > 0.0) return {};
  return {"x", say("the path has no tangent at S(t): all derivatives by q are zero"), say("choose another parameter")};
}

template <class Tracer>
AlongPath::Result AlongPath::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const numerics::Jet law = motion::at(law_of(in), in_si(in.t));
  r.S_t = trace.value("S_t", law.value * m, "law of motion along the path at the time t, [B26]");
  const Speed v_tau = r.v_tau = trace.value("v_tau", law.first * m_per_s, "first derivative of S, [B26]");
  r.a_tau = trace.value("a_tau", law.second * m_per_s2, "second derivative of S, [B28]");
  STEP_TO(r, v, abs(v_tau), "speed");
  r.q_t = trace.value("q_t", place_of(in, law.value), "the arc length from q_0 is S_t");
  const CurvePoint point = curve_at(in, r.q_t);
  take_place(point, r, trace);
  take_motion(point, r, trace);
  return r;
}

template AlongPath::Result AlongPath::evaluate(const Input&, NoTrace&);
template AlongPath::Result AlongPath::evaluate(const Input&, Trace&);

std::vector<figure::Figure> AlongPath::figures(const Input& in, const Result& r) {
  if (!is_set(r.q_t) || r.q_t == in.q_0) return {};
  constexpr int points = 181;
  figure::Scheme scheme;
  figure::Scheme::Path way{"", {}};
  const auto place = [&](double q) {
    const CurvePoint point = curve_at(in, q);
    return figure::Point{point.r[0], point.r[1]};
  };
  for (int i = 0; i < points; ++i) way.points.push_back(place(in.q_0 + (r.q_t - in.q_0) * i / (points - 1)));
  scheme.paths.push_back(std::move(way));
  scheme.points.push_back({"M_0", place(in.q_0)});
  scheme.points.push_back({"M", place(r.q_t)});
  return {{"path", "Path in the plane xy from the origin of S to the point M at the time t", std::move(scheme)}};
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::AlongPath>();
