// Buckling of bars by finite elements: cubic Hermite beams under their axial force, and the eigenvalues of Eigen.
// Shares nothing with the exact stiffnesses of the calculators.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

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

/// Integral of weight(element, t) times the products of the derivatives of the shape functions, t from 0 to 1.
template <class Derivative, class Weight>
Matrix integrated(const Elements& bar, const Derivative& derivative, const Weight& weight) {
  constexpr double points[] = {0.1127016653792583, 0.5, 0.8872983346207417};  // Gauss: exact up to the fifth power
  constexpr double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  Matrix sum = Matrix::Zero(bar.freedoms(), bar.freedoms());
  for (std::size_t e = 0; e + 1 < bar.x.size(); ++e) {
    const double h = bar.x[e + 1] - bar.x[e];
    for (int p = 0; p < 3; ++p) {
      const Eigen::Vector4d d = derivative(points[p], h);
      const auto at = static_cast<Eigen::Index>(2 * e);
      sum.block<4, 4>(at, at) += weights[p] * h * weight(e, points[p]) * d * d.transpose();
    }
  }
  return sum;
}

/// Of E I v''^2.
inline Matrix bending_matrix(const Elements& bar) {
  const auto curvature = [](double t, double h) {
    return Eigen::Vector4d((12 * t - 6) / (h * h), (6 * t - 4) / h, (6 - 12 * t) / (h * h), (6 * t - 2) / h);
  };
  return integrated(bar, curvature, [&](std::size_t e, double) { return bar.stiffness[e]; });
}

/// Of N v'^2, N the compressive force.
inline Matrix force_matrix(const Elements& bar) {
  const auto slope = [](double t, double h) {
    return Eigen::Vector4d((6 * t * t - 6 * t) / h, 1 - 4 * t + 3 * t * t, (6 * t - 6 * t * t) / h, 3 * t * t - 2 * t);
  };
  return integrated(bar, slope, [&](std::size_t e, double t) {
    return bar.force[e].first + t * (bar.force[e].second - bar.force[e].first);
  });
}

/// Rows and columns of the freedoms that are not held.
inline Matrix of_free(const Matrix& whole, const std::vector<bool>& is_held) {
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < is_held.size(); ++i) {
    if (!is_held[i]) free.push_back(static_cast<Eigen::Index>(i));
  }
  const auto size = static_cast<Eigen::Index>(free.size());
  Matrix part(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j)
      part(i, j) = whole(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
  }
  return part;
}

/// The factor of the forces at which a mode begins, 1 the lowest: stiffness v = factor x forces v.
inline double critical_factor(const Matrix& stiffness, const Matrix& forces, const std::vector<bool>& is_held,
                              int mode = 1) {
  // The stiffness is positive definite, the forces need not be: the reciprocals are found.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(of_free(forces, is_held), of_free(stiffness, is_held),
                                                                Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  return 1.0 / solver.eigenvalues()(solver.eigenvalues().size() - mode);
}

/// From a mesh and one in which each element is halved: the error falls with the fourth power of their length. The
/// factor takes by how much a mesh is refined.
template <class Factor>
double extrapolated(const Factor& factor_of) {
  const double coarse = factor_of(1), fine = factor_of(2);
  return fine + (fine - coarse) / 15.0;
}

}  // namespace loadpath::tests
