// Stresses of a path of plane stress on the planes through its point, and the critical plane.
#pragma once

#include "calculators/fatigue/multiaxial/path.hpp"
#include "lib/numerics/smallest_ball.hpp"

#include <array>

namespace loadpath::fatigue {

/// A plane by its normal: theta from the normal of the surface, phi along the surface from x to y, rad.
struct Normal {
  double theta = 0.0, phi = 0.0;
};

/// How the stresses of a plane follow from sigma_x, sigma_y and tau_xy.
class PlaneView {
 public:
  explicit PlaneView(const Normal& normal);

  [[nodiscard]] double sigma(const PlaneStress& s) const { return of(sigma_, s); }
  /// Shear in two directions of the plane: down towards the surface's inside, and along the surface.
  [[nodiscard]] std::array<double, 2> shear(const PlaneStress& s) const { return {of(down_, s), of(along_, s)}; }

 private:
  using Row = std::array<double, 3>;
  static double of(const Row& row, const PlaneStress& s) { return row[0] * s.x + row[1] * s.y + row[2] * s.xy; }
  Row sigma_{}, down_{}, along_{};
};

struct OnPlane {
  Normal normal;
  double tau_a = 0.0;    // radius of the smallest circle around the path of the shear stress
  double sigma_n = 0.0;  // largest normal stress, not below 0
};
OnPlane on_plane(const StressPath& path, const Normal& normal);
numerics::Ball<2> shear_circle(const StressPath& path, const PlaneView& view);

/// The plane on which tau_a + k sigma_n is largest, of all in space; by symmetry to the surface half of them are
/// searched. Two searches from grids that share no plane, each followed from its highest places until the angles
/// converge to 1e-4 deg: `apart` is their difference over the larger one.
struct WorstPlane {
  OnPlane plane;
  double apart = 0.0;
};
WorstPlane worst_plane(const StressPath& path, double k);

/// The plane of the largest tau_a; of those where it is the same, but for 0.2 % that samples of a path make of it, the
/// one of the largest sigma_n.
WorstPlane plane_of_most_shear(const StressPath& path, double mu);

}  // namespace loadpath::fatigue
