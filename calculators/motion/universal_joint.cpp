#include "calculators/motion/universal_joint.hpp"

#include "calculators/motion/path_figures.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::motion {

namespace {

/// tan(phi_2) = tan(phi_1)/q: q is the cosine of the angle of one joint. Two joints multiply, or divide, theirs.
double transmission(const UniversalJoint::Input& in) {
  const double first = std::cos(in.beta), second = std::cos(in.beta_2);
  return in.forks == UniversalJoint::Forks::aligned ? first / second : first * second;
}

/// The angle whose tangent is tan(phi)/q, in the half turn of phi.
double driven_angle(double phi, double q) {
  const double half_turns = std::round(phi / pi);
  const double rest = phi - half_turns * pi;
  return half_turns * pi + std::atan2(std::sin(rest), q * std::cos(rest));
}

double speed_ratio(double phi, double q) {
  const double c = std::cos(phi), s = std::sin(phi);
  return q / (q * q * c * c + s * s);
}

/// The angle below a quarter turn at which the driven shaft is accelerated most: the root c of k c^2 + c - 2 k, with
/// c = cos(2 phi).
double angle_of_largest(double q) {
  const double k = (1.0 - q * q) / (1.0 + q * q);  // the ratio is 2 q/(1 + q^2)/(1 - k cos(2 phi))
  return 0.5 * std::acos(4.0 * k / (std::sqrt(1.0 + 8.0 * k * k) + 1.0));
}

}  // namespace

template <class Tracer>
UniversalJoint::Result UniversalJoint::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto& [n_1, beta, beta_2, forks, phi_1, epsilon_1, J_2, M_2] = in;
  const double q =
      trace.value("q", transmission(in),
                  "cos(beta); of two joints cos(beta)/cos(beta_2) with aligned forks, else cos(beta) cos(beta_2)");
  r.phi_2 = trace.value("phi_2", driven_angle(phi_1, q), "tan(phi_2) = tan(phi_1)/q");
  STEP_TO(r, i, q / (q * q * cos(phi_1) * cos(phi_1) + sin(phi_1) * sin(phi_1)),
          "ratio of the speeds, [MechanicalData-2.4.3]");
  STEP_TO(r, n_2, i * n_1, "speed of the driven shaft");
  STEP_TO(r, epsilon_2, epsilon_1 * i - n_1 * n_1 * (1.0 - q * q) * sin(2.0 * phi_1) * i * i / q,
          "derivative of the speed");
  STEP(i_0, max(q, 1.0 / q), "largest ratio of the speeds, where a fork lies in the plane of the shafts");
  STEP_TO(r, n_2max, i_0 * n_1, "maximum over a revolution, [MechanicalData-2.4.3]");
  STEP_TO(r, n_2min, n_1 / i_0, "minimum over a revolution, [MechanicalData-2.4.3]");
  STEP_TO(r, U, i_0 - 1.0 / i_0, "fluctuation");
  if (U > 0.0) {
    r.phi_equal = trace.value("phi_equal", std::atan(std::sqrt(q)), "i = 1, [MechanicalData-2.4.3]");
    const double phi = r.phi_max = trace.value("phi_max", angle_of_largest(q), "derivative of epsilon_2 is zero");
    const double ratio_there = speed_ratio(phi, q);
    r.epsilon_max =
        trace.value("epsilon_max",
                    n_1 * n_1 * std::abs(1.0 - q * q) * std::abs(std::sin(2.0 * phi)) * ratio_there * ratio_there / q,
                    "epsilon_2 there, at constant speed of the driving shaft");
  } else {
    r.epsilon_max = 0.0 * rad_per_s2;
  }
  if (is_set(J_2)) {
    const auto epsilon_max = r.epsilon_max;
    STEP_TO(r, M_J, J_2 * epsilon_max, "inertia torque");
  }
  if (is_set(M_2)) {
    const Moment inertia = is_set(J_2) ? J_2 * epsilon_2 : 0.0 * N_m;
    r.M_1 = trace.value("M_1", (M_2 + inertia) * i, "equal power of both shafts");
    r.M_1max = trace.value("M_1max", M_2 * i_0, "equal power where the driven shaft is fastest");
  }
  return r;
}

template UniversalJoint::Result UniversalJoint::evaluate(const Input&, NoTrace&);
template UniversalJoint::Result UniversalJoint::evaluate(const Input&, Trace&);

std::vector<figure::Figure> UniversalJoint::figures(const Input& in, const Result&) {
  const double q = transmission(in);
  figure::Plot plot;
  plot.x = {"phi_1", "angle of the driving shaft", "deg"};
  plot.y = {"i", "speed of the driven over that of the driving shaft", ""};
  figure::Curve curve{"i", {}, {}};
  constexpr int points = 181;
  for (int k = 0; k < points; ++k) {
    curve.x.push_back(2.0 * pi * k / (points - 1));
    curve.y.push_back(speed_ratio(curve.x.back(), q));
  }
  plot.curves.push_back(std::move(curve));
  return {{"ratio", "Ratio of the speeds over a revolution", std::move(plot)}};
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::UniversalJoint>();
