// Buckling of bars by finite elements: cubic Hermite beams under their axial force, and the eigenvalues of Eigen.
// Shares nothing with the exact stiffnesses of the calculators.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace loadpath::tests {

using Matrix = Eigen::MatrixXd;

/// A bar of elements along x: stiffness in bending of each, and its compressive force at both of its nodes. Nodes have
/// a deflection, at 2 i, and a slope, at 2 i + 1.
struct Elements {
  std::vector<double> x{0.0};
  std::vector<double> stiffness;
  std::vector<std::pair<double, double>> force;

  int freedoms() const { return static_cast<int>(2 * x.size()); }
  void add(double length, double bending, double at_start, double at_end, int count) {
    for (int i = 0; i < count; ++i) {
      const auto share = [&](int node) { return at_start + (at_end - at_start) * node / count; };
      x.push_back(x.back() + length / count);
      stiffness.push_back(bending);
      force.emplace_back(share(i), share(i + 1));
    }
  }
};

/// Of E I v''^2.
Matrix bending_matrix(const Elements& bar);

/// Of N v'^2, N the compressive force.
Matrix force_matrix(const Elements& bar);

/// The factor of the forces at which a mode begins, 1 the lowest: stiffness v = factor x forces v.
double critical_factor(const Matrix& stiffness, const Matrix& forces, const std::vector<bool>& is_held, int mode = 1);

/// v of stiffness v = load.
Eigen::VectorXd deflected(const Matrix& stiffness, const Eigen::VectorXd& load);

/// From a mesh and one in which each element is halved: the error falls with the fourth power of their length. The
/// factor takes by how much a mesh is refined.
template <class Factor>
double extrapolated(const Factor& factor_of) {
  const double coarse = factor_of(1), fine = factor_of(2);
  return fine + (fine - coarse) / 15.0;
}

}  // namespace loadpath::tests
