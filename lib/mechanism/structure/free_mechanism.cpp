#include "lib/mechanism/structure/free_mechanism.hpp"

#include "lib/mechanism/structure/row_factors.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <functional>

namespace loadpath::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Relative threshold of nonzero values in a matrix whose entries are about 1.
constexpr double rank_threshold = 1e-9;
constexpr double support_threshold = 1e-7;
constexpr double closed = 1e-11;

MatrixXd jacobian_of(const Constraints& constraints) {
  MatrixXd full = MatrixXd::Zero(static_cast<Index>(constraints.rows()), static_cast<Index>(constraints.columns()));
  for (std::size_t k = 0; k < constraints.pattern().size(); ++k) {
    full(constraints.pattern()[k].row, constraints.pattern()[k].column) = constraints.jacobian()[k];
  }
  return full;
}

VectorXd residual_without(const Constraints& constraints, std::span<const std::size_t> rows) {
  VectorXd residual = Eigen::Map<const VectorXd>(constraints.residual().data(), static_cast<Index>(constraints.rows()));
  for (const std::size_t row : rows) residual(static_cast<Index>(row)) = 0.0;
  return residual;
}

constexpr double reluctance = 1e-6;  // far above the threshold of the rank, its square below measurable values

/// The least step that closes the constraints to the first order, as if these rows were not there.
VectorXd least_step(const Constraints& constraints, const VectorXd& residual, std::span<const std::size_t> rows,
                    std::span<const std::size_t> reluctant) {
  if (rows.empty() && reluctant.empty() && is_large(constraints)) {
    VectorXd step = VectorXd::Zero(static_cast<Index>(constraints.columns()));
    if (const RowFactors factors(constraints); factors.independent()) {
      factors.find_step({residual.data(), constraints.rows()}, {step.data(), constraints.columns()});
      return step;
    }
  }
  MatrixXd jacobian = jacobian_of(constraints);
  for (const std::size_t row : rows) jacobian.row(static_cast<Index>(row)).setZero();
  for (const std::size_t column : reluctant) jacobian.col(static_cast<Index>(column)) *= reluctance;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(rank_threshold);
  decomposition.compute(jacobian);
  VectorXd step = decomposition.solve(residual);
  for (const std::size_t column : reluctant) step(static_cast<Index>(column)) *= reluctance;
  return step;
}

// Each vector holds one dependent column and the columns it depends on.
NullSpace kernel(const MatrixXd& a) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(rank_threshold);
  qr.compute(a);
  const Index rank = a.size() == 0 ? 0 : qr.rank();
  const Index left = a.cols() - rank;
  if (left == 0) return {};
  MatrixXd basis = MatrixXd::Zero(a.cols(), left);
  if (rank > 0) {
    const auto independent = qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
    basis.topRows(rank) = -independent.solve(MatrixXd(qr.matrixR().topRightCorner(rank, left)));
  }
  basis.bottomRows(left).setIdentity();
  if (rank > 0) basis = qr.colsPermutation() * basis;
  NullSpace vectors;
  for (Index v = 0; v < left; ++v) vectors.emplace_back(basis.col(v).begin(), basis.col(v).end());
  return vectors;
}

}  // namespace

bool in_support(const std::vector<double>& vector, std::size_t entry) {
  double most = 0.0;
  for (const double x : vector) most = std::max(most, std::abs(x));
  return std::abs(vector[entry]) > support_threshold * most;
}

FreeMechanism::FreeMechanism(const Model& model)
    : constraints_(model), targets_(model.drivers.size()), q_(constraints_.columns() + 3, 0.0) {
  std::vector<double> stated;
  for (const Link& link : model.links) stated.insert(stated.end(), {link.pose.x, link.pose.y, link.pose.phi});
  go_to(stated);
}

void FreeMechanism::go_to(std::span<const double> q) {
  std::ranges::copy(q, q_.begin());
  place();
  constraints_.count_turns();
  for (std::size_t k = 0; k < targets_.size(); ++k) targets_[k] = constraints_.coordinate(k);
  place();
}

void FreeMechanism::shift(std::span<const double> by) {
  std::ranges::transform(by, q_, q_.begin(), std::plus<>());
  place();
}

bool FreeMechanism::close_without(std::span<const std::size_t> rows, std::span<const std::size_t> reluctant) {
  constexpr int most_steps = 40;
  constexpr double longest_step = 0.3;
  const Eigen::Map<const VectorXd> q(q_.data(), static_cast<Index>(q_.size()));
  VectorXd residual = residual_without(constraints_, rows);
  const auto rounding = [&] { return 1e-15 * (1.0 + q.norm()); };
  for (int k = 0; k < most_steps && residual.norm() > rounding(); ++k) {
    VectorXd step = least_step(constraints_, residual, rows, reluctant);
    step *= -std::min(1.0, longest_step / step.cwiseAbs().maxCoeff());
    shift({step.data(), static_cast<std::size_t>(step.size())});
    residual = residual_without(constraints_, rows);
  }
  return residual.norm() <= closed * (1.0 + q.norm());
}

bool FreeMechanism::move_on(double by) {
  const NullSpace ways = motions();
  if (ways.empty()) return false;
  std::vector<double> step(constraints_.columns(), 0.0);
  for (std::size_t v = 0; v < ways.size(); ++v) {
    const double share =
        ways.size() == 1 ? 1.0 : 1.0 + 0.6180339887 * static_cast<double>(v) / static_cast<double>(ways.size() - 1);
    for (std::size_t c = 0; c < step.size(); ++c) step[c] += share * ways[v][c];
  }
  const std::vector<double> start(q().begin(), q().end());
  double most = 0.0;
  for (const double x : step) most = std::max(most, std::abs(x));
  for (double& x : step) x *= by / most;
  shift(step);
  if (!close()) return false;
  double way = 0.0;
  for (std::size_t c = 0; c < start.size(); ++c) way = std::max(way, std::abs(q_[c] - start[c]));
  return way >= 0.5 * std::abs(by);
}

std::vector<Pose> FreeMechanism::poses(double unit) const {
  std::vector<Pose> poses;
  for (std::size_t c = 0; c < constraints_.columns(); c += 3)
    poses.push_back({unit * q_[c], unit * q_[c + 1], q_[c + 2]});
  return poses;
}

NullSpace FreeMechanism::motions() const {
  if (constraints_.rows() == constraints_.columns() && clearly_independent()) return {};
  return kernel(jacobian_of(constraints_));
}

NullSpace FreeMechanism::self_stresses() const {
  return clearly_independent() ? NullSpace{} : kernel(jacobian_of(constraints_).transpose());
}

bool FreeMechanism::clearly_independent() const {
  return is_large(constraints_) && RowFactors(constraints_).independent();
}

double FreeMechanism::grip(std::size_t rank) const {
  if (rank == 0) return 1.0;
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(jacobian_of(constraints_));
  const auto pivot = [&](std::size_t k) {
    return std::abs(qr.matrixR()(static_cast<Index>(k), static_cast<Index>(k)));
  };
  const double largest = pivot(0);
  return largest > 0.0 && rank <= std::min(constraints_.rows(), constraints_.columns()) ? pivot(rank - 1) / largest
                                                                                        : 0.0;
}

}  // namespace loadpath::mechanism
