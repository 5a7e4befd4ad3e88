// The closed loop of a spherical four-bar linkage: where it closes, and extremes over a range of the input angle.
//
// The diagonal from the joint of input and coupler to the output axis closes a triangle with coupler and output, and
// one with input and ground; the law of cosines gives the rest. Angles as in motion.spherical_four_bar.
#pragma once

namespace loadpath::motion {

/// Interior angles that a joint reaches, 0 to pi and mirrored; low is more than high where the arcs do not close.
struct JointRange {
  double low = 0.0, high = 0.0;

  [[nodiscard]] bool revolves() const;
};

struct SphericalLoop {
  double alpha_1, alpha_2, alpha_3, alpha_4;  // input, coupler, output, ground

  [[nodiscard]] bool closes() const;
  [[nodiscard]] JointRange input() const;
  [[nodiscard]] JointRange output() const;
  /// Whether the coupler revolves relative to the input or to the output.
  [[nodiscard]] bool coupler_revolves() const;

  /// Cosine of the transmission angle; beyond 1 in magnitude the linkage does not close there.
  [[nodiscard]] double cos_transmission(double phi_1) const;
  /// Output angle within half a turn of zero; side: -1 for the left assembly, 1 for the right one.
  [[nodiscard]] double output_angle(double phi_1, double side) const;
  /// Angular velocity of the output over that of the input.
  [[nodiscard]] double ratio(double phi_1, double side) const;
};

/// Input and output angle where input and coupler lie on one great circle; unset if they never do.
struct DeadCentre {
  double phi_1, phi_4;
};
DeadCentre stretched(const SphericalLoop& loop, double side);
DeadCentre folded(const SphericalLoop& loop, double side);

/// The input angle with the transmission angle furthest from 90 deg, and the cosine there, without its sign.
struct WorstTransmission {
  double phi_1, cosine;
};
WorstTransmission worst_transmission(const SphericalLoop& loop, double phi_a, double phi_b);

/// Smallest and largest ratio over a range in which the linkage closes.
struct Ratios {
  double low, high;
};
Ratios extreme_ratios(const SphericalLoop& loop, double side, double phi_a, double phi_b);

}  // namespace loadpath::motion
