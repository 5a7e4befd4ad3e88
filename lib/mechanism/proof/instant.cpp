#include "lib/mechanism/proof/instant.hpp"

#include <Eigen/LU>

namespace loadpath::mechanism {

Instant::Instant(const Model& model)
    : model_(&model),
      length_(characteristic_length(model)),
      constraints_(in_unit_of_length(model, length_)),
      q_(3 * (model.links.size() + 1)),  // the ground's stay zero
      no_targets_(model.drivers.size()),
      jacobian_(constraints_.rows() * constraints_.columns()),
      motions_(jacobian_.size()) {}

void Instant::take(const Position& at, bool statics) {
  at_ = &at;
  statics_ = statics;
  for (std::size_t k = 0; k < at.pose.size(); ++k) {
    q_[3 * k] = at.pose[k].x / length_;
    q_[3 * k + 1] = at.pose[k].y / length_;
    q_[3 * k + 2] = at.pose[k].phi;
  }
  constraints_.place(q_, no_targets_);
  find_active_forces(*model_, at, statics, active_);
  find_motions();
}

void Instant::find_motions() {
  const auto size = static_cast<Eigen::Index>(constraints_.rows());
  Eigen::Map<Eigen::MatrixXd> jacobian(jacobian_.data(), size, size);
  Eigen::Map<Eigen::MatrixXd> motions(motions_.data(), size, size);
  jacobian.setZero();
  const auto pattern = constraints_.pattern();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    jacobian(pattern[n].row, pattern[n].column) = constraints_.jacobian()[n];
  }
  motions = jacobian.partialPivLu().inverse();
  condition_ = size == 0 ? 1.0
                         : jacobian.cwiseAbs().colwise().sum().maxCoeff() *
                               motions.cwiseAbs().colwise().sum().maxCoeff<Eigen::PropagateNaN>();
}

double Instant::effort_arm(std::size_t driver) const {
  return model_->drivers[driver].kind == Driver::Kind::rotary ? length_ : 1.0;
}

double Instant::virtual_power(std::size_t row) const {
  double sum = 0.0;
  for (const ActiveForce& active : active_) sum += power(active, virtual_velocity(row, active.link));
  return sum;
}

}  // namespace loadpath::mechanism
