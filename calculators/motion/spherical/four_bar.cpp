#include "calculators/motion/spherical/four_bar.hpp"

#include "calculators/motion/spherical/loop.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::motion {

namespace {

using Bar = SphericalFourBar;

constexpr double dead = 1e-9;   // distance of |cos(mu)| from 1 that still gives speeds
constexpr double folds = 1e-6;  // degrees: arcs that differ by less are at the change point
constexpr double turn = 2.0 * pi;

SphericalLoop loop_of(const Bar::Input& in) { return {in.alpha_1, in.alpha_2, in.alpha_3, in.alpha_4}; }

double side_of(const Bar::Input& in) { return in.assembly == Bar::Assembly::left ? -1.0 : 1.0; }

Bar::Type type_of(const SphericalLoop& loop, double T_min) {
  if (T_min < folds * pi / 180.0) return Bar::Type::change_point;
  const bool input = loop.input().revolves(), output = loop.output().revolves();
  if (input) return output ? Bar::Type::double_crank : Bar::Type::crank_rocker;
  if (output) return Bar::Type::rocker_crank;
  return loop.coupler_revolves() ? Bar::Type::double_rocker : Bar::Type::triple_rocker;
}

/// Range of the input to be assessed: as given, else the revolution of a crank, else only the position.
struct InUse {
  double from, to;
};
InUse range_in_use(const Bar::Input& in) {
  if (is_set(in.phi_a) && is_set(in.phi_b)) return {in.phi_a, in.phi_b};
  if (loop_of(in).input().revolves()) return {0.0, turn};
  return {in.phi_1, in.phi_1};
}

template <class Tracer>
void classify(const Bar::Input& in, Bar::Result& r, Tracer& trace) {
  const auto& [alpha_1, alpha_2, alpha_3, alpha_4] = std::tie(in.alpha_1, in.alpha_2, in.alpha_3, in.alpha_4);
  STEP(T_1, abs(alpha_1 + alpha_2 - alpha_3 - alpha_4), "zero where the linkage folds into one great circle");
  STEP(T_2, abs(alpha_1 - alpha_2 + alpha_3 - alpha_4), "the same with the arcs in another order");
  STEP(T_3, abs(alpha_1 - alpha_2 - alpha_3 + alpha_4), "the same with the arcs in another order");
  STEP(T_4, abs(2.0 * pi - alpha_1 - alpha_2 - alpha_3 - alpha_4), "zero where the arcs fill the great circle");
  STEP_TO(r, T_min, min(min(T_1, T_2), min(T_3, T_4)), "distance from the change point, [Ruth-McCarthy]");
  r.type = type_of(loop_of(in), T_min);
}

/// Output angle and velocity ratio, from the closure A cos(phi_4) + B sin(phi_4) = C.
template <class Tracer>
void move_output(const Bar::Input& in, Bar::Result& r, Tracer& trace) {
  const auto& [alpha_1, alpha_2, alpha_3, alpha_4] = std::tie(in.alpha_1, in.alpha_2, in.alpha_3, in.alpha_4);
  const auto& [phi_1, n_1, epsilon_1] = std::tie(in.phi_1, in.n_1, in.epsilon_1);
  STEP(c_d, cos(alpha_1) * cos(alpha_4) + sin(alpha_1) * sin(alpha_4) * cos(phi_1),
       "cosine of the diagonal to the output axis, law of cosines of the sphere");
  STEP(c_mu, (c_d - cos(alpha_2) * cos(alpha_3)) / (sin(alpha_2) * sin(alpha_3)),
       "cosine of the transmission angle, law of cosines of the sphere");
  STEP_TO(r, mu, acos(c_mu), "transmission angle");
  STEP(A, sin(alpha_3) * (sin(alpha_1) * cos(phi_1) * cos(alpha_4) - cos(alpha_1) * sin(alpha_4)),
       "closure A cos(phi_4) + B sin(phi_4) = C, [Ruth-McCarthy]");
  STEP(B, sin(alpha_3) * sin(alpha_1) * sin(phi_1), "of the closure");
  STEP(C, cos(alpha_2) - cos(alpha_3) * c_d, "of the closure");
  const double side = side_of(in);
  const double phi_4 = r.phi_4 = trace.angle("phi_4", loop_of(in).output_angle(phi_1, side),
                                             "arctan(B/A) - arccos(C/sqrt(A^2 + B^2)) of the left assembly");
  r.phi_4o = trace.angle("phi_4o", loop_of(in).output_angle(phi_1, -side), "with the other sign");
  STEP(G,
       sin(alpha_1) * (sin(alpha_3) * (cos(phi_1) * sin(phi_4) - cos(alpha_4) * sin(phi_1) * cos(phi_4)) -
                       cos(alpha_3) * sin(alpha_4) * sin(phi_1)),
       "derivative of the closure with respect to phi_1");
  STEP(H, A * sin(phi_4) - B * cos(phi_4), "with respect to phi_4, negative; zero in a dead position");
  STEP_TO(r, i, G / H, "velocity ratio");
  STEP(G_1,
       sin(alpha_1) * (sin(alpha_3) * (-sin(phi_1) * sin(phi_4) - cos(alpha_4) * cos(phi_1) * cos(phi_4)) -
                       cos(alpha_3) * sin(alpha_4) * cos(phi_1)),
       "derivative of G with respect to phi_1");
  STEP(G_4, sin(alpha_1) * sin(alpha_3) * (cos(phi_1) * cos(phi_4) + cos(alpha_4) * sin(phi_1) * sin(phi_4)),
       "derivative of G with respect to phi_4");
  STEP_TO(r, i_phi, (G_1 + 2.0 * G_4 * i - C * i * i) / H, "derivative of the velocity ratio");
  STEP_TO(r, omega_4, i * n_1, "angular velocity of the output");
  STEP_TO(r, epsilon_4, epsilon_1 * i + n_1 * n_1 * i_phi, "its derivative");
}

/// The coupler turns about its joint with the input, and with it about the input axis; the velocity about that joint is
/// the one that leaves no component across output and ground.
template <class Tracer>
void move_coupler(const Bar::Input& in, Bar::Result& r, Tracer& trace) {
  const auto& [alpha_1, alpha_3, alpha_4, phi_1] = std::tie(in.alpha_1, in.alpha_3, in.alpha_4, in.phi_1);
  const auto& [n_1, epsilon_1, phi_4, omega_4] = std::tie(in.n_1, in.epsilon_1, r.phi_4, r.omega_4);
  STEP(x_2, sin(alpha_1) * cos(phi_1), "axis of input and coupler, unit vector");
  STEP(y_2, sin(alpha_1) * sin(phi_1), "along y");
  STEP(z_2, cos(alpha_1), "along z");
  STEP(x_3, cos(alpha_3) * sin(alpha_4) + sin(alpha_3) * cos(alpha_4) * cos(phi_4), "axis of coupler and output");
  STEP(y_3, sin(alpha_3) * sin(phi_4), "along y");
  STEP(z_3, cos(alpha_3) * cos(alpha_4) - sin(alpha_3) * sin(alpha_4) * cos(phi_4), "along z");
  STEP(n_x, y_3 * cos(alpha_4), "normal of the plane of the output: axis 3 x axis 4");
  STEP(n_y, z_3 * sin(alpha_4) - x_3 * cos(alpha_4), "along y");
  STEP(n_z, -y_3 * sin(alpha_4), "along z");
  STEP(V, x_2 * n_x + y_2 * n_y + z_2 * n_z, "triple product of the axes of coupler and output");
  STEP(omega_r, -n_1 * n_z / V, "coupler about its joint with the input: no velocity along the normal");
  STEP_TO(r, omega_x, omega_r * x_2, "angular velocity of the coupler, [B30]");
  STEP_TO(r, omega_y, omega_r * y_2, "along y");
  STEP_TO(r, omega_z, n_1 + omega_r * z_2, "along z");
  STEP_TO(r, omega_2, sqrt(omega_x * omega_x + omega_y * omega_y + omega_z * omega_z), "angular velocity");
  STEP(omega_s, (omega_x - omega_4 * sin(alpha_4)) * x_3 + omega_y * y_3 + (omega_z - omega_4 * cos(alpha_4)) * z_3,
       "coupler about its joint with the output");
  STEP(epsilon_r,
       (-omega_s * omega_4 * sin(alpha_3) * sin(alpha_3) - epsilon_1 * n_z - omega_r * n_1 * (x_2 * n_y - y_2 * n_x)) /
           V,
       "derivative of omega_r: accelerations along the normal are equal");
  STEP_TO(r, epsilon_x, epsilon_r * x_2 - omega_r * n_1 * y_2, "angular acceleration of the coupler, [B30]");
  STEP_TO(r, epsilon_y, epsilon_r * y_2 + omega_r * n_1 * x_2, "along y");
  STEP_TO(r, epsilon_z, epsilon_1 + epsilon_r * z_2, "along z");
  STEP_TO(r, epsilon_2, sqrt(epsilon_x * epsilon_x + epsilon_y * epsilon_y + epsilon_z * epsilon_z),
          "angular acceleration");
}

template <class Tracer>
void bound_motion(const Bar::Input& in, Bar::Result& r, Tracer& trace) {
  const SphericalLoop loop = loop_of(in);
  const double side = side_of(in);
  const JointRange input = loop.input(), output = loop.output();
  if (!input.revolves()) {
    r.phi_1min = trace.angle("phi_1min", input.low, "diagonal = |alpha_2 - alpha_3|");
    r.phi_1max = trace.angle("phi_1max", input.high, "diagonal = alpha_2 + alpha_3");
  }
  const DeadCentre s = stretched(loop, side), f = folded(loop, side);
  if (is_set(s.phi_1)) {
    r.phi_1s = trace.angle("phi_1s", s.phi_1, "arc alpha_1 + alpha_2 from the input axis, law of cosines");
    r.phi_4s = trace.angle("phi_4s", s.phi_4, "the output reverses there");
  }
  if (is_set(f.phi_1)) {
    r.phi_1f = trace.angle("phi_1f", f.phi_1, "arc alpha_1 - alpha_2 from the input axis, law of cosines");
    r.phi_4f = trace.angle("phi_4f", f.phi_4, "the output reverses there");
  }
  if (output.revolves()) return;
  const double phi_4min = r.phi_4min = trace.angle("phi_4min", pi - output.high, "limit of the output");
  const double phi_4max = r.phi_4max = trace.angle("phi_4max", pi - output.low, "limit of the output");
  const double swing = phi_4min > 0.0 && phi_4max < pi ? phi_4max - phi_4min
                       : phi_4min > 0.0                ? 2.0 * (pi - phi_4min)
                                                       : 2.0 * phi_4max;
  r.theta_4 = trace.angle("theta_4", swing, "between the limits, through 0 or 180° where these are reached");
  if (r.type != Bar::Type::crank_rocker) return;
  const double stroke = s.phi_1 < f.phi_1 ? f.phi_1 - s.phi_1 : f.phi_1 - s.phi_1 + turn;
  r.Q = trace.value("Q", std::max(stroke, turn - stroke) / std::min(stroke, turn - stroke),
                    "input angles of the two strokes");
}

template <class Tracer>
void assess_range(const Bar::Input& in, Bar::Result& r, Tracer& trace) {
  const SphericalLoop loop = loop_of(in);
  const InUse range = range_in_use(in);
  const WorstTransmission worst = worst_transmission(loop, range.from, range.to);
  const double c_max = trace.value("c_max", worst.cosine, "maximum of |cos(mu)| over the input range");
  STEP_TO(r, u_c, c_max / 1.0, "the linkage closes up to 1");
  r.phi_mu = trace.angle("phi_mu", worst.phi_1, "input angle there");
  const double mu_min = r.mu_min = trace.angle("mu_min", std::acos(std::min(1.0, worst.cosine)), "arccos(c_max)");
  if (is_set(in.mu_req)) {
    const double mu_req = in.mu_req;
    STEP_TO(r, u_mu, (pi / 2.0 - mu_min) / (pi / 2.0 - mu_req), "deviation from 90° over the allowable one");
  }
  const auto M_4 = in.M_4;
  const double i = r.i;
  if (is_set(M_4)) {
    STEP_TO(r, M_1, M_4 * i, "equal power of input and output");
  }
  if (worst.cosine > 1.0 - dead || range.from == range.to) return;
  const Ratios ratios = extreme_ratios(loop, side_of(in), range.from, range.to);
  const double i_min = r.i_min = trace.value("i_min", ratios.low, "search over the input range");
  const double i_max = r.i_max = trace.value("i_max", ratios.high, "search over the input range");
  if (is_set(M_4)) {
    STEP_TO(r, M_1max, abs(M_4) * max(abs(i_min), abs(i_max)), "equal power of input and output");
  }
}

/// A curve that breaks where the linkage does not close.
template <class Function>
figure::Curve over_input(const Bar::Input& in, const char* label, const Function& value) {
  const SphericalLoop loop = loop_of(in);
  InUse range = range_in_use(in);
  if (range.from == range.to) range = {loop.input().low == 0.0 ? -pi : 0.0, loop.input().low == 0.0 ? pi : turn};
  constexpr int points = 361;
  figure::Curve curve{label, {}, {}};
  for (int k = 0; k < points; ++k) {
    const double phi = range.from + (range.to - range.from) * k / (points - 1);
    curve.x.push_back(phi);
    curve.y.push_back(std::abs(loop.cos_transmission(phi)) < 1.0 ? value(phi) : unset<double>);
  }
  return curve;
}

}  // namespace

bool SphericalFourBar::arcs_close(const Input& in) { return loop_of(in).closes(); }

bool SphericalFourBar::closes_at_phi(const Input& in) {
  return !arcs_close(in) || std::abs(loop_of(in).cos_transmission(in.phi_1)) < 1.0 - dead;
}

FieldFault SphericalFourBar::open_at_phi(const Input& in) {
  const JointRange range = loop_of(in).input();
  return {
      "phi_1",
      say("the linkage does not close at phi_1 = {1}, or is in a dead position", format_quantity(in.phi_1, "deg", 6)),
      say("give an angle between {1} and {2}, or between these with a minus sign", format_quantity(range.low, "deg", 6),
          format_quantity(range.high, "deg", 6))};
}

/// Of an angle and a range, whatever turns they include.
bool SphericalFourBar::position_is_in_use(const Input& in) {
  if (!is_set(in.phi_1) || !is_set(in.phi_a) || !is_set(in.phi_b)) return true;
  constexpr double rounding = 1e-9;
  const double after_start = in.phi_1 - in.phi_a - turn * std::floor((in.phi_1 - in.phi_a + rounding) / turn);
  return after_start <= in.phi_b - in.phi_a + rounding;
}

FieldFault SphericalFourBar::position_out_of_use(const Input& in) {
  return {"phi_1",
          say("phi_1 = {1} is outside the range in use, {2} to {3}: the results at phi_1 are those of a position that "
              "closure and transmission angle are not assessed at",
              format_quantity(in.phi_1, "deg", 6), format_quantity(in.phi_a, "deg", 6),
              format_quantity(in.phi_b, "deg", 6)),
          say("give a range phi_a to phi_b that includes phi_1, or a phi_1 within it")};
}

template <class Tracer>
SphericalFourBar::Result SphericalFourBar::evaluate(const Input& in, Tracer& trace) {
  Result r;
  classify(in, r, trace);
  move_output(in, r, trace);
  move_coupler(in, r, trace);
  bound_motion(in, r, trace);
  assess_range(in, r, trace);
  return r;
}

template SphericalFourBar::Result SphericalFourBar::evaluate(const Input&, NoTrace&);
template SphericalFourBar::Result SphericalFourBar::evaluate(const Input&, Trace&);

std::vector<figure::Figure> SphericalFourBar::figures(const Input& in, const Result&) {
  const SphericalLoop loop = loop_of(in);
  const double side = side_of(in);
  figure::Plot angles, speeds;
  angles.x = speeds.x = {"phi_1", "input angle", "deg"};
  angles.y = {"phi_4", "output angle and transmission angle", "deg"};
  double before = loop.output_angle(in.phi_1, side);
  angles.curves.push_back(over_input(in, "phi_4", [&](double phi) {
    const double now = loop.output_angle(phi, side);
    return before = before + std::remainder(now - before, turn);  // without jumps of a revolution
  }));
  angles.curves.push_back(over_input(in, "mu", [&](double phi) { return std::acos(loop.cos_transmission(phi)); }));
  speeds.y = {"i", "velocity ratio", ""};
  speeds.curves.push_back(over_input(in, "i", [&](double phi) { return loop.ratio(phi, side); }));
  return {{"angles", "Output angle and transmission angle over the input angle", std::move(angles)},
          {"ratio", "Velocity ratio over the input angle", std::move(speeds)}};
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::SphericalFourBar>();
