#include "calculators/motion/spatial.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::motion {

namespace {

std::array<Written, 6> laws_of(const Spatial::Input& in) {
  return {Written{"psi", &in.psi}, {"theta", &in.theta}, {"phi", &in.phi}, {"x", &in.x}, {"y", &in.y}, {"z", &in.z}};
}

/// Angle between two directions whose cosine may exceed 1 by rounding.
double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

/// The derivatives of the angles, and of what they turn the axes by.
template <class Tracer>
void turn(const Spatial::Input& in, Spatial::Result& r, Tracer& trace) {
  const auto [psi, theta, phi, x, y, z] = laws_of(in);
  const double t = in_si(in.t);
  const numerics::Jet precession = at(psi, t), nutation = at(theta, t), spin = at(phi, t);
  const double psi_t = r.psi_t = trace.value("psi_t", precession.value, "law of precession at the time t");
  const double theta_t = r.theta_t = trace.value("theta_t", nutation.value, "law of nutation at the time t");
  r.phi_t = trace.value("phi_t", spin.value, "law of spin at the time t");
  const auto omega_psi = r.omega_psi = trace.value("omega_psi", precession.first * rad_per_s, "its first derivative");
  const auto omega_theta = r.omega_theta =
      trace.value("omega_theta", nutation.first * rad_per_s, "its first derivative");
  const auto omega_phi = r.omega_phi = trace.value("omega_phi", spin.first * rad_per_s, "its first derivative");
  const auto epsilon_psi = trace.value("epsilon_psi", precession.second * rad_per_s2, "its second derivative");
  const auto epsilon_theta = trace.value("epsilon_theta", nutation.second * rad_per_s2, "its second derivative");
  const auto epsilon_phi = trace.value("epsilon_phi", spin.second * rad_per_s2, "its second derivative");
  const double c_psi = trace.value("c_psi", without_rounding(std::cos(psi_t), 1.0), "cos(psi)");
  const double s_psi = trace.value("s_psi", without_rounding(std::sin(psi_t), 1.0), "sin(psi)");
  const double c_theta = trace.value("c_theta", without_rounding(std::cos(theta_t), 1.0), "cos(theta)");
  const double s_theta = trace.value("s_theta", without_rounding(std::sin(theta_t), 1.0), "sin(theta)");
  STEP_TO(r, omega_x, omega_theta * c_psi + omega_phi * s_theta * s_psi, "sum of the three rotations, [B30]");
  STEP_TO(r, omega_y, omega_theta * s_psi - omega_phi * s_theta * c_psi, "along y");
  STEP_TO(r, omega_z, omega_psi + omega_phi * c_theta, "along z");
  STEP_TO(r, omega, sqrt(omega_x * omega_x + omega_y * omega_y + omega_z * omega_z), "angular velocity");
  STEP_TO(r, epsilon_x,
          epsilon_theta * c_psi - omega_theta * omega_psi * s_psi + epsilon_phi * s_theta * s_psi +
              omega_phi * omega_theta * c_theta * s_psi + omega_phi * omega_psi * s_theta * c_psi,
          "derivative of omega_x");
  STEP_TO(r, epsilon_y,
          epsilon_theta * s_psi + omega_theta * omega_psi * c_psi - epsilon_phi * s_theta * c_psi -
              omega_phi * omega_theta * c_theta * c_psi + omega_phi * omega_psi * s_theta * s_psi,
          "derivative of omega_y");
  STEP_TO(r, epsilon_z, epsilon_psi + epsilon_phi * c_theta - omega_phi * omega_theta * s_theta,
          "derivative of omega_z");
  STEP_TO(r, epsilon, sqrt(epsilon_x * epsilon_x + epsilon_y * epsilon_y + epsilon_z * epsilon_z),
          "angular acceleration");
  if (!(in_si(omega) > 0.0)) return;
  r.alpha = trace.value("alpha", angle_of(omega_x / omega), "direction of the instantaneous axis");
  r.beta = trace.value("beta", angle_of(omega_y / omega), "with y");
  r.gamma = trace.value("gamma", angle_of(omega_z / omega), "with z, the axis of the precession");
  const auto along = omega_phi + omega_psi * c_theta;
  r.delta = trace.value("delta", angle_of(along / omega), "with zeta, the axis of the spin");
}

template <class Tracer>
void move_point(const Spatial::Input& in, Spatial::Result& r, Tracer& trace) {
  const auto [psi, theta, phi, x, y, z] = laws_of(in);
  const auto& [omega_x, omega_y, omega_z, omega] = std::tie(r.omega_x, r.omega_y, r.omega_z, r.omega);
  const auto& [epsilon_x, epsilon_y, epsilon_z] = std::tie(r.epsilon_x, r.epsilon_y, r.epsilon_z);
  const double t = in_si(in.t);
  const numerics::Jet along_x = at(x, t), along_y = at(y, t), along_z = at(z, t);
  const auto c = [](double angle) { return without_rounding(std::cos(angle), 1.0); };
  const auto s = [](double angle) { return without_rounding(std::sin(angle), 1.0); };
  const double cp = c(r.psi_t), sp = s(r.psi_t), ct = c(r.theta_t), st = s(r.theta_t), cf = c(r.phi_t), sf = s(r.phi_t);
  const auto& [xi, eta, zeta] = std::tie(in.xi, in.eta, in.zeta);
  const Length r_x = trace.value(
      "r_x", (cp * cf - sp * ct * sf) * xi + (-cp * sf - sp * ct * cf) * eta + sp * st * zeta, "point from the pole");
  const Length r_y =
      trace.value("r_y", (sp * cf + cp * ct * sf) * xi + (-sp * sf + cp * ct * cf) * eta - cp * st * zeta, "along y");
  const Length r_z = trace.value("r_z", st * sf * xi + st * cf * eta + ct * zeta, "along z");
  const auto x_O = trace.value("x_O", along_x.value * m, "law of the pole at the time t");
  const auto y_O = trace.value("y_O", along_y.value * m, "along y");
  const auto z_O = trace.value("z_O", along_z.value * m, "along z");
  STEP_TO(r, x_M, x_O + r_x, "coordinates of the point");
  STEP_TO(r, y_M, y_O + r_y, "along y");
  STEP_TO(r, z_M, z_O + r_z, "along z");
  const auto v_Ox = trace.value("v_Ox", along_x.first * m_per_s, "velocity of the pole");
  const auto v_Oy = trace.value("v_Oy", along_y.first * m_per_s, "along y");
  const auto v_Oz = trace.value("v_Oz", along_z.first * m_per_s, "along z");
  STEP(u_x, omega_y * r_z - omega_z * r_y, "velocity about the pole, omega x r");
  STEP(u_y, omega_z * r_x - omega_x * r_z, "along y");
  STEP(u_z, omega_x * r_y - omega_y * r_x, "along z");
  STEP_TO(r, v_x, v_Ox + u_x, "velocity of the point, [B30]");
  STEP_TO(r, v_y, v_Oy + u_y, "along y");
  STEP_TO(r, v_z, v_Oz + u_z, "along z");
  STEP_TO(r, v, sqrt(v_x * v_x + v_y * v_y + v_z * v_z), "speed");
  const auto a_Ox = trace.value("a_Ox", along_x.second * m_per_s2, "acceleration of the pole");
  const auto a_Oy = trace.value("a_Oy", along_y.second * m_per_s2, "along y");
  const auto a_Oz = trace.value("a_Oz", along_z.second * m_per_s2, "along z");
  STEP_TO(r, a_x, a_Ox + epsilon_y * r_z - epsilon_z * r_y + omega_y * u_z - omega_z * u_y,
          "of the pole, epsilon x r, omega x (omega x r)");
  STEP_TO(r, a_y, a_Oy + epsilon_z * r_x - epsilon_x * r_z + omega_z * u_x - omega_x * u_z, "along y");
  STEP_TO(r, a_z, a_Oz + epsilon_x * r_y - epsilon_y * r_x + omega_x * u_y - omega_y * u_x, "along z");
  STEP_TO(r, a, sqrt(a_x * a_x + a_y * a_y + a_z * a_z), "acceleration of the point");
  if (!(in_si(omega) > 0.0)) return;
  STEP_TO(r, v_k, (v_Ox * omega_x + v_Oy * omega_y + v_Oz * omega_z) / omega,
          "along the axis, the same for all points");
  const double around = std::max(0.0, in_si(v) * in_si(v) - in_si(v_k) * in_si(v_k));
  r.h = trace.value("h", std::sqrt(around) * m_per_s / omega, "speed about the axis over omega");
}

}  // namespace

bool Spatial::laws_read(const Input& in) {
  const auto laws = laws_of(in);
  return std::all_of(laws.begin(), laws.end(), [](const Written& law) { return reads(law); });
}
FieldFault Spatial::law_fault(const Input& in) { return reading_fault(laws_of(in)); }
bool Spatial::some_law(const Input& in) { return !in.psi.empty() || !in.theta.empty() || !in.phi.empty(); }
FieldFault Spatial::gap(const Input& in) { return gap_fault(laws_of(in), in_si(in.t), in_si(in.t)); }
bool Spatial::laws_are_smooth(const Input& in) { return gap(in).message.empty(); }

template <class Tracer>
Spatial::Result Spatial::evaluate(const Input& in, Tracer& trace) {
  Result r;
  turn(in, r, trace);
  move_point(in, r, trace);
  return r;
}

template Spatial::Result Spatial::evaluate(const Input&, NoTrace&);
template Spatial::Result Spatial::evaluate(const Input&, Trace&);

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Spatial>();
