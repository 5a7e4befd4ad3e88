#include "lib/mechanism/structure/row_factors.hpp"

#include "lib/numerics/dense_inverse.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::mechanism {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Rank = Eigen::Index;

SparseMatrix transposed_jacobian(const Constraints& constraints) {
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(constraints.pattern().size());
  for (std::size_t k = 0; k < constraints.pattern().size(); ++k) {
    const auto& place = constraints.pattern()[k];
    entries.emplace_back(static_cast<int>(place.column), static_cast<int>(place.row), constraints.jacobian()[k]);
  }
  SparseMatrix transposed(static_cast<Rank>(constraints.columns()), static_cast<Rank>(constraints.rows()));
  transposed.setFromTriplets(entries.begin(), entries.end());
  transposed.makeCompressed();
  return transposed;
}

double largest_column_sum(const SparseMatrix& matrix) {
  double most = 0.0;
  for (Rank c = 0; c < matrix.outerSize(); ++c) most = std::max(most, matrix.col(c).cwiseAbs().sum());
  return most;
}

}  // namespace

// L D L^T of J J^T, whose condition number is the square of that of J.
struct RowFactors::Factors {
  SparseMatrix transposed;
  Eigen::SimplicialLDLT<SparseMatrix> products;
  bool independent = false;

  void factor(const Constraints& constraints);
  [[nodiscard]] double norm_of_inverse() const;
};

void RowFactors::Factors::factor(const Constraints& constraints) {
  constexpr double most_condition = 1e10;  // of J 1e5; its rows count as dependent from 1e9
  if (constraints.rows() > constraints.columns()) return;
  transposed = transposed_jacobian(constraints);
  const SparseMatrix product = transposed.transpose() * transposed;
  products.compute(product);
  if (products.info() != Eigen::Success || !(products.vectorD().minCoeff() > 0.0)) return;
  independent = largest_column_sum(product) * norm_of_inverse() < most_condition;  // not if NaN
}

double RowFactors::Factors::norm_of_inverse() const {
  std::vector<double> probe(static_cast<std::size_t>(transposed.cols()));
  const auto solve = [this](std::span<double> x) {
    Eigen::Map<Vector> at(x.data(), static_cast<Rank>(x.size()));
    at = products.solve(Vector(at));
  };
  return numerics::estimated_inverse_norm(probe, solve, solve);
}

RowFactors::RowFactors(const Constraints& constraints) : factors_(std::make_unique<Factors>()) {
  factors_->factor(constraints);
}

RowFactors::~RowFactors() = default;

bool RowFactors::independent() const { return factors_->independent; }

// Refined once, for the rounding of the products.
void RowFactors::find_step(std::span<const double> residual, std::span<double> step) const {
  const Eigen::Map<const Vector> given(residual.data(), static_cast<Rank>(residual.size()));
  const SparseMatrix& transposed = factors_->transposed;
  Vector found = transposed * factors_->products.solve(given);
  const Vector left = given - transposed.transpose() * found;
  found += transposed * factors_->products.solve(left);
  std::ranges::copy(found, step.begin());
}

}  // namespace loadpath::mechanism
