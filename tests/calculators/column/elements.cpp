#include "tests/calculators/column/elements.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace loadpath::tests {

namespace {

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

/// Rows and columns of the freedoms that are not held.
Matrix of_free(const Matrix& whole, const std::vector<bool>& is_held) {
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

}  // namespace

Matrix bending_matrix(const Elements& bar) {
  const auto curvature = [](double t, double h) {
    return Eigen::Vector4d((12 * t - 6) / (h * h), (6 * t - 4) / h, (6 - 12 * t) / (h * h), (6 * t - 2) / h);
  };
  return integrated(bar, curvature, [&](std::size_t e, double) { return bar.stiffness[e]; });
}

Matrix force_matrix(const Elements& bar) {
  const auto slope = [](double t, double h) {
    return Eigen::Vector4d((6 * t * t - 6 * t) / h, 1 - 4 * t + 3 * t * t, (6 * t - 6 * t * t) / h, 3 * t * t - 2 * t);
  };
  return integrated(bar, slope, [&](std::size_t e, double t) {
    return bar.force[e].first + t * (bar.force[e].second - bar.force[e].first);
  });
}

double critical_factor(const Matrix& stiffness, const Matrix& forces, const std::vector<bool>& is_held, int mode) {
  // The stiffness is positive definite, the forces need not be: the reciprocals are found.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(of_free(forces, is_held), of_free(stiffness, is_held),
                                                                Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  return 1.0 / solver.eigenvalues()(solver.eigenvalues().size() - mode);
}

Eigen::VectorXd deflected(const Matrix& stiffness, const Eigen::VectorXd& load) {
  return stiffness.partialPivLu().solve(load);
}

}  // namespace loadpath::tests
