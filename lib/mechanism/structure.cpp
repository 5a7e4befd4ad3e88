#include "lib/mechanism/structure.hpp"

#include "lib/mechanism/kinematics.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of what differs from zero in a matrix whose entries are about 1.
constexpr double rank_threshold = 1e-9;
constexpr double support_threshold = 1e-7;
constexpr double closed = 1e-11;

// A basis of the null space with few entries per vector: each holds one dependent column and the columns it depends on.
MatrixXd kernel(const MatrixXd& a) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(rank_threshold);
  qr.compute(a);
  const Index rank = a.size() == 0 ? 0 : qr.rank();
  const Index left = a.cols() - rank;
  MatrixXd basis = MatrixXd::Zero(a.cols(), left);
  if (left == 0) return basis;
  if (rank > 0) {
    const auto independent = qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
    basis.topRows(rank) = -independent.solve(MatrixXd(qr.matrixR().topRightCorner(rank, left)));
  }
  basis.bottomRows(left).setIdentity();
  if (rank > 0) basis = qr.colsPermutation() * basis;
  return basis;
}

bool in_support(const MatrixXd& basis, Index vector, Index row) {
  return std::abs(basis(row, vector)) > support_threshold * basis.col(vector).cwiseAbs().maxCoeff();
}

// The mechanism at coordinates that may be anywhere, with any number of constraints.
class Assembly {
 public:
  explicit Assembly(const Model& model)
      : constraints_(model),
        targets_(model.drivers.size()),
        q_(VectorXd::Zero(static_cast<Index>(constraints_.columns() + 3))) {
    for (std::size_t k = 0; k < model.links.size(); ++k) {
      const Pose& pose = model.links[k].pose;
      q_.segment<3>(static_cast<Index>(3 * k)) << pose.x, pose.y, pose.phi;
    }
    go_to(q_);
  }

  // Its drivers are then where they should be.
  void go_to(const VectorXd& q) {
    q_ = q;
    place();
    for (std::size_t k = 0; k < targets_.size(); ++k) targets_[k] = constraints_.coordinate(k);
    place();
  }

  // By steps of least norm.
  bool close() {
    constexpr int most_steps = 40;
    constexpr double longest_step = 0.3;
    for (int k = 0; k < most_steps && residual().norm() > rounding(); ++k) {
      Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
      decomposition.setThreshold(rank_threshold);
      decomposition.compute(jacobian());
      const VectorXd step = decomposition.solve(residual());
      shift(-step * std::min(1.0, longest_step / step.cwiseAbs().maxCoeff()));
    }
    return residual().norm() <= closed * (1.0 + q_.norm());
  }

  void shift(const VectorXd& by) {
    q_.head(by.size()) += by;
    place();
  }

  [[nodiscard]] MatrixXd jacobian() const {
    MatrixXd full = MatrixXd::Zero(static_cast<Index>(constraints_.rows()), static_cast<Index>(constraints_.columns()));
    for (std::size_t k = 0; k < constraints_.pattern().size(); ++k) {
      full(constraints_.pattern()[k].row, constraints_.pattern()[k].column) = constraints_.jacobian()[k];
    }
    return full;
  }

  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] const VectorXd& q() const { return q_; }

 private:
  void place() { constraints_.place({q_.data(), static_cast<std::size_t>(q_.size())}, targets_); }
  [[nodiscard]] double rounding() const { return 1e-15 * (1.0 + q_.norm()); }
  [[nodiscard]] Eigen::Map<const VectorXd> residual() const {
    return {constraints_.residual().data(), static_cast<Index>(constraints_.rows())};
  }

  Constraints constraints_;
  std::vector<double> targets_;
  VectorXd q_;
};

// Whether dependent constraints are so at this position only: a little further on they are independent, or the motions
// that they leave lead nowhere.
bool dependent_here_only(Assembly assembly, const MatrixXd& motions) {
  constexpr double little = 1e-2;
  const Index count = motions.cols();
  if (count == 0) return false;
  // Unequal shares, so that no symmetry of the position is kept.
  const VectorXd mixed = motions * VectorXd::LinSpaced(count, 1.0, 1.6180339887);
  const VectorXd start = assembly.q();
  assembly.shift(mixed * (little / mixed.cwiseAbs().maxCoeff()));
  if (!assembly.close() || (assembly.q() - start).cwiseAbs().maxCoeff() < 0.5 * little) return true;
  return kernel(assembly.jacobian().transpose()).cols() == 0;
}

std::vector<std::vector<std::size_t>> joints_of(const MatrixXd& dependencies, std::span<const Pair> pairs) {
  std::vector<std::vector<std::size_t>> sets;
  for (Index v = 0; v < dependencies.cols(); ++v) {
    std::vector<std::size_t> set;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      bool held = false;
      for (std::size_t r = 0; r < pairs[k].shape.rows(); ++r) {
        held = held || in_support(dependencies, v, static_cast<Index>(pairs[k].row + r));
      }
      if (held) set.push_back(k);
    }
    sets.push_back(std::move(set));
  }
  std::ranges::sort(sets);
  return sets;
}

std::vector<std::size_t> links_of(const MatrixXd& motions) {
  std::vector<std::size_t> links;
  for (Index c = 0; c < motions.rows(); c += 3) {
    bool moves = false;
    for (Index v = 0; v < motions.cols(); ++v) {
      for (Index axis = 0; axis < 3; ++axis) moves = moves || in_support(motions, v, c + axis);
    }
    if (moves) links.push_back(static_cast<std::size_t>(c / 3));
  }
  return links;
}

int count_mobility(const Model& model) {
  int mobility = 3 * static_cast<int>(model.links.size());
  for (const auto& joint : model.joints) mobility -= constraint_count(joint.kind);
  return mobility;
}

std::vector<Misfit> misfits_of(const Constraints& constraints, double length) {
  constexpr double tolerance = 0.01;  // pitch circles that are a little apart only change the working radii
  std::vector<Misfit> misfits;
  for (std::size_t k = 0; k < constraints.pairs().size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    const double apart = mechanism::length(pair.at.apart);
    const double sum = std::abs(pair.shape.radius_i + pair.shape.radius_j);
    const double least = std::abs(pair.shape.radius_i) + std::abs(pair.shape.radius_j);
    const bool gear = pair.shape.joint == JointKind::gear && std::abs(apart - sum) > tolerance * sum;
    const bool belt = pair.shape.joint == JointKind::belt && apart <= least;
    if (gear || belt) misfits.push_back({k, length * apart, length * (gear ? sum : least)});
    const double height = std::abs(dot(pair.at.apart, normal(pair.at.along))), radius = std::abs(pair.shape.radius_i);
    if (pair.shape.joint == JointKind::rack && std::abs(height - radius) > tolerance * radius)
      misfits.push_back({k, length * height, length * radius});
  }
  return misfits;
}

/// The distance that other joints must hold for this one; of other kinds 0.
double centre_distance(const Constraints& constraints, const Joint& joint) {
  const bool two = joint.kind == JointKind::gear || joint.kind == JointKind::belt;
  if (!two && joint.kind != JointKind::rack) return 0.0;
  const Placed& j = constraints.placed(joint.j);
  const Vec apart = constraints.placed(joint.i).point(joint.point_i) - j.point(joint.point_j);
  return two ? length(apart) : std::abs(dot(apart, normal(j.turned(turn(joint.direction)({1.0, 0.0})))));
}

// A little further on in every motion at once, so that a distance that is extreme here is seen to change too.
std::vector<std::size_t> parting_joints(Assembly assembly, const std::vector<Joint>& joints) {
  constexpr double little = 1e-2, negligible = 1e-7;
  std::vector<double> before;
  before.reserve(joints.size());
  for (const Joint& joint : joints) before.push_back(centre_distance(assembly.constraints(), joint));
  std::vector<std::size_t> parting;
  const MatrixXd motions = kernel(assembly.jacobian());
  if (motions.cols() == 0) return parting;
  const VectorXd mixed = motions * VectorXd::LinSpaced(motions.cols(), 1.0, 1.6180339887);
  assembly.shift(mixed * (little / mixed.cwiseAbs().maxCoeff()));
  if (!assembly.close()) return parting;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double now = centre_distance(assembly.constraints(), joints[k]);
    if (std::abs(now - before[k]) > negligible * before[k]) parting.push_back(k);
  }
  return parting;
}

// The equation of a belt is that of a constant distance, and does not close without it: what its centres do is seen
// where it is left out.
std::vector<std::size_t> parting_belts(const Model& model) {
  std::vector<std::size_t> belts;
  Model without = model;
  without.joints.clear();
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (model.joints[k].kind == JointKind::belt) {
      belts.push_back(k);
    } else {
      without.joints.push_back(model.joints[k]);
    }
  }
  Assembly assembly(without);
  if (belts.empty() || !assembly.close()) return {};
  std::vector<std::size_t> parting = parting_joints(assembly, model.joints);
  std::erase_if(parting, [&](std::size_t k) { return model.joints[k].kind != JointKind::belt; });
  return parting;
}

void find_widest(const Constraints& constraints, double length, Structure& structure) {
  for (std::size_t k = 0; k < constraints.pairs().size(); ++k) {
    const double gap = length * constraints.opening(k);
    if (gap <= structure.gap) continue;
    structure.gap = gap;
    structure.open_joint = k;
  }
}

}  // namespace

Structure analyse(const Model& model) {
  Structure structure;
  structure.mobility_by_count = count_mobility(model);
  const double length = characteristic_length(model);
  Model scaled = in_unit_of_length(model, length);
  Assembly driven(scaled);
  scaled.drivers.clear();
  Assembly free(scaled);

  structure.parting = parting_belts(scaled);
  structure.closes = free.close();
  if (!structure.closes) {
    find_widest(free.constraints(), length, structure);
    return structure;
  }
  structure.misfits = misfits_of(free.constraints(), length);
  if (!driven.close()) {
    const Assembly as_far_as_possible = driven;
    driven.go_to(free.q());
    // With dependent constraints it is the drivers that contradict each other, not the lengths.
    structure.closes = kernel(driven.jacobian().transpose()).cols() > 0;
    if (!structure.closes) find_widest(as_far_as_possible.constraints(), length, structure);
  }
  structure.loose = links_of(kernel(driven.jacobian()));
  const MatrixXd motions = kernel(free.jacobian());
  if (structure.parting.empty()) structure.parting = parting_joints(free, scaled.joints);
  const MatrixXd dependencies = kernel(free.jacobian().transpose());
  structure.mobility = static_cast<int>(motions.cols());
  structure.singular = dependencies.cols() > 0 && dependent_here_only(free, motions);
  if (!structure.singular) structure.redundant = joints_of(dependencies, free.constraints().pairs());
  return structure;
}

}  // namespace loadpath::mechanism
