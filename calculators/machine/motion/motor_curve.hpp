// The torque of a motor over its speed: by points, a straight line or the formula of Kloss. SI numbers.
#pragma once

#include "calculators/machine/moment_line.hpp"
#include "lib/calculator/list.hpp"

namespace loadpath::machine {

struct MotorCurve {
  enum class Kind { points, straight, kloss };
  static constexpr std::size_t most_points = 48;

  Kind kind = Kind::straight;
  List<LinePoint, most_points> line;
  double M_A = 0.0;             // straight: at standstill
  double omega_0 = 0.0;         // straight, Kloss: without load
  double M_K = 0.0, s_K = 1.0;  // Kloss: breakdown torque and its slip

  [[nodiscard]] double at(double omega) const;
  [[nodiscard]] double slip(double omega) const { return 1.0 - omega / omega_0; }
  /// The speed of the maximum torque: below it the torque of the motor falls with the speed.
  [[nodiscard]] double breakdown_speed() const;
  /// The speed above which the curve says nothing; infinite for a formula.
  [[nodiscard]] double last_speed() const;
  /// A speed that no run reaches: there the run is given up.
  [[nodiscard]] double far_speed() const;
};

}  // namespace loadpath::machine
