// The path of plane stress that a point goes through, and what its invariants make of it. Stresses in Pa, without any
// factor.
#pragma once

#include "lib/calculator/varying.hpp"
#include "lib/numerics/smallest_ball.hpp"

#include <cstddef>

namespace loadpath::fatigue {

struct PlaneStress {
  double x = 0.0, y = 0.0, xy = 0.0;
};

/// Three stresses in step, some of which may be constant. The path refers to the arrays of its caller.
class StressPath {
 public:
  StressPath(const Varying<Stress>& x, const Varying<Stress>& y, const Varying<Stress>& xy);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] PlaneStress at(std::size_t i) const { return {x_.at(i), y_.at(i), xy_.at(i)}; }

 private:
  struct Component {
    const double* series = nullptr;
    double one = 0.0;
    [[nodiscard]] double at(std::size_t i) const { return series != nullptr ? series[i] : one; }
  };
  static Component of(const Varying<Stress>& q);

  Component x_, y_, xy_;
  std::size_t size_;
};

/// The largest of von Mises.
double largest_mises(const StressPath& path);
/// The stress of von Mises of the amplitudes, each signed against the others as if all were in phase.
double mises_in_phase(const StressPath& path);
/// A third of the sum of the normal stresses, its largest value; 0 under compression all the time.
double largest_hydrostatic(const StressPath& path);

/// The smallest ball around the deviators, in coordinates in which the distance of two is the square root of the J_2 of
/// their difference: a turn of a part is a curve in there, of which pure bending and pure torsion are straight lines.
using DeviatorBall = numerics::Ball<3>;
DeviatorBall deviator_ball(const StressPath& path);

/// Largest of tau + a sigma_H over the path, tau the largest shear stress of the deviator from the centre of the ball
/// (to which residual stresses of grains shake down), sigma_H not below 0.
double largest_mesoscopic(const StressPath& path, const DeviatorBall& ball, double a);

}  // namespace loadpath::fatigue
