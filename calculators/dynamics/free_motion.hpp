// The motion of a point mass under forces of position, velocity and time, in SI numbers, for `dynamics.motion`.
#pragma once

#include "calculators/dynamics/initial_value.hpp"
#include "lib/calculator/law_text.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>
#include <functional>
#include <vector>

namespace loadpath::dynamics {

/// What a force may depend on.
inline constexpr std::array motion_variables{
    Law::Variable{"x", m.dimension()},         Law::Variable{"y", m.dimension()},
    Law::Variable{"z", m.dimension()},         Law::Variable{"v_x", m_per_s.dimension()},
    Law::Variable{"v_y", m_per_s.dimension()}, Law::Variable{"v_z", m_per_s.dimension()},
    Law::Variable{"v", m_per_s.dimension()},   Law::Variable{"t", sec.dimension()}};

/// Forces and start of a motion; texts that are empty are zero, or no end.
struct GivenMotion {
  double mass = 1.0, t_2 = 1.0;
  std::array<double, 3> r{}, v{};          // at the start
  std::array<const RelationText*, 3> F{};  // along the axes
  const RelationText* until = nullptr;
};

/// At a time: position, velocity, then what grows along the path.
struct MotionState {
  double t = 0.0;
  std::array<double, 3> r{}, v{};
  double length = 0.0, work = 0.0;  // since the start

  [[nodiscard]] double speed() const;
};

/// Extremes over the states that are taken.
struct Extremes {
  std::array<double, 3> least, most;
  double speed = 0.0, force = 0.0;

  Extremes();
  void take(const MotionState& state, double F);
  /// The largest distance from the origin along an axis.
  [[nodiscard]] double reach() const;
};

double magnitude_of(const std::array<double, 3>& vector);

class FreeMotion {
 public:
  explicit FreeMotion(const GivenMotion& given);

  using Visit = std::function<void(const MotionState&)>;
  struct Ended {
    Solved::End how;
    MotionState state;
  };
  /// From the start to t_2 or the zero of `until`, with this tolerance of a step.
  [[nodiscard]] Ended follow(
      double tolerance, const Visit& visit = [](const MotionState&) {}) const;
  /// The states at these times, which rise and lie within the motion.
  [[nodiscard]] std::vector<MotionState> at(const std::vector<double>& times) const;

  /// NaN where a force has no value.
  [[nodiscard]] std::array<double, 3> force(const MotionState& state) const;

  static constexpr double usual_tolerance = 1e-12, coarse_tolerance = 1e-9;

 private:
  [[nodiscard]] InitialValue problem() const;
  GivenMotion given_;
};

}  // namespace loadpath::dynamics
