#include "lib/mechanism/equations/kinematics.hpp"

#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

constexpr std::size_t discarded = 0;

template <class Scalar>
BasicVec<Scalar> origin(std::span<const Scalar> q, std::size_t link) {
  return {q[3 * link], q[3 * link + 1]};
}
template <class Scalar>
Scalar angle(std::span<const Scalar> q, std::size_t link) {
  return q[3 * link + 2];
}

/// The joint of a sliding drive.
template <class Scalar>
const BasicJoint<Scalar>* slide_of(const BasicModel<Scalar>& model, const BasicDriver<Scalar>& driver) {
  return driver.kind == DriverKind::linear ? &model.joints[static_cast<std::size_t>(driver.joint)] : nullptr;
}

}  // namespace

double characteristic_length(const Model& model) {
  std::vector<std::optional<Vec>> first_points;
  return characteristic_length(model, first_points);
}

double characteristic_length(const Model& model, std::vector<std::optional<Vec>>& first) {
  double extent = 0.0;
  first.assign(model.links.size() + 1, std::nullopt);
  const auto reach = [&](int link, Vec point) {
    auto& start = first[link == ground ? model.links.size() : static_cast<std::size_t>(link)];
    if (!start) start = point;
    extent = std::max(extent, length(point - *start));
  };
  for (const auto& joint : model.joints) {
    reach(joint.i, joint.point_i);
    reach(joint.j, joint.point_j);
  }
  for (const auto& link : model.links) {
    extent = std::max(extent, std::hypot(link.pose.x - model.links[0].pose.x, link.pose.y - model.links[0].pose.y));
  }
  return extent > 0.0 ? std::ldexp(1.0, std::ilogb(extent)) : 1.0;
}

template <class Scalar>
void change_unit_of_length(BasicModel<Scalar>& model, double unit) {
  const double shrink = 1.0 / unit;
  for (auto& link : model.links) {
    link.inertia *= shrink * shrink;
    link.centre = shrink * link.centre;
    link.pose.x *= shrink;
    link.pose.y *= shrink;
  }
  for (auto& joint : model.joints) {
    joint.point_i = shrink * joint.point_i;
    joint.point_j = shrink * joint.point_j;
    joint.radius_i *= shrink;
    joint.radius_j *= shrink;
    joint.phase *= shrink;
    joint.metre *= shrink;
  }
  for (auto& driver : model.drivers) {
    if (driver.kind == Driver::Kind::linear) driver.offset *= shrink;
  }
  for (auto& load : model.loads) {
    load.point = shrink * load.point;
    load.force = shrink * load.force;
    load.moment *= shrink * shrink;
  }
  for (auto& spring : model.springs) {
    const bool turning = spring.kind == Spring::Kind::turning;
    spring.point_i = shrink * spring.point_i;
    spring.point_j = shrink * spring.point_j;
    spring.free *= turning ? 1.0 : shrink;
    spring.rate *= turning ? shrink * shrink : 1.0;
    spring.damping *= turning ? shrink * shrink : 1.0;
  }
  model.gravity = shrink * model.gravity;
}

Model in_unit_of_length(const Model& model, double unit) {
  Model scaled = model;
  change_unit_of_length(scaled, unit);
  return scaled;
}

template <class Scalar>
BasicConstraints<Scalar>::BasicConstraints(const BasicModel<Scalar>& model)
    : ground_(model.links.size()), joints_(model.joints.size()), placed_(ground_ + 1), pattern_(1), jacobian_(1) {
  pairs_.reserve(joints_ + model.drivers.size());
  for (const auto& joint : model.joints) add(shape_of(joint), joint.i, joint.j);
  for (const auto& driver : model.drivers) {
    const auto* slide = slide_of(model, driver);
    add(shape_of(driver, slide), slide != nullptr ? slide->i : driver.i, slide != nullptr ? slide->j : driver.j);
  }
  residual_.resize(rows_);
}

template <class Scalar>
void BasicConstraints<Scalar>::take_dimensions(const BasicModel<Scalar>& model) {
  for (std::size_t k = 0; k < joints_; ++k) pairs_[k].shape = shape_of(model.joints[k]);
  for (std::size_t k = 0; k < model.drivers.size(); ++k) {
    const auto& driver = model.drivers[k];
    pairs_[joints_ + k].shape = shape_of(driver, slide_of(model, driver));
  }
}

template <class Scalar>
std::size_t BasicConstraints<Scalar>::entry(std::size_t row, std::size_t link, std::size_t component, bool occupied) {
  if (link == ground_ || !occupied) return discarded;
  pattern_.push_back({static_cast<int>(row), static_cast<int>(3 * link + component)});
  jacobian_.push_back(0.0);
  return jacobian_.size() - 1;
}

template <class Scalar>
void BasicConstraints<Scalar>::add(const BasicPairShape<Scalar>& shape, int i, int j) {
  BasicPair<Scalar> pair{.shape = shape, .i = index(i), .j = index(j), .row = rows_};
  assert(pair.i != pair.j);
  for (std::size_t r = 0; r < shape.rows(); ++r, ++rows_) {
    const auto [x, y, phi] = pattern_of(shape, r);
    pair.entries[r] = {entry(rows_, pair.i, 0, x), entry(rows_, pair.i, 1, y), entry(rows_, pair.i, 2, phi),
                       entry(rows_, pair.j, 0, x), entry(rows_, pair.j, 1, y), entry(rows_, pair.j, 2, phi)};
  }
  prepare(shape, pair.at);
  pairs_.push_back(pair);
}

template <class Scalar>
void BasicConstraints<Scalar>::place(std::span<const Scalar> q, std::span<const Scalar> targets) {
  for (std::size_t link = 0; link < ground_; ++link) {
    placed_[link] = {turn(angle(q, link)), origin(q, link), angle(q, link)};
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    BasicPair<Scalar>& pair = pairs_[k];
    mechanism::place(pair.shape, placed_[pair.i], placed_[pair.j], pair.at);
    open(pair.shape, pair.at, placed_[pair.i], placed_[pair.j], k < joints_ ? Scalar(0.0) : targets[k - joints_],
         std::span(residual_).subspan(pair.row, pair.shape.rows()));
    set_rows(pair);
  }
}

template <class Scalar>
void BasicConstraints<Scalar>::count_turns() {
  for (BasicPair<Scalar>& pair : pairs_) mechanism::count_turns(pair.shape, placed_[pair.i], placed_[pair.j], pair.at);
}

template <class Scalar>
void BasicConstraints<Scalar>::set_rows(const BasicPair<Scalar>& pair) {
  const BasicVec<Scalar> arm_i = pair.at.at - placed_[pair.i].origin, arm_j = pair.at.at_j - placed_[pair.j].origin;
  for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
    const BasicPairRow<Scalar>& row = pair.at.rows[r];
    const auto& entries = pair.entries[r];
    jacobian_[entries[0]] = row.e.x;
    jacobian_[entries[1]] = row.e.y;
    jacobian_[entries[2]] = cross(arm_i, row.e) + row.m;
    jacobian_[entries[3]] = -row.e.x;
    jacobian_[entries[4]] = -row.e.y;
    jacobian_[entries[5]] = -cross(arm_j, row.e) - row.m;
  }
}

template <class Scalar>
Scalar BasicConstraints<Scalar>::coordinate(std::size_t driver) const {
  const BasicPair<Scalar>& drive = drives()[driver];
  Scalar coordinate = 0.0;
  open(drive.shape, drive.at, placed_[drive.i], placed_[drive.j], 0.0, {&coordinate, 1});
  return coordinate;
}

template <class Scalar>
Scalar BasicConstraints<Scalar>::opening(std::size_t joint) const {
  const BasicPair<Scalar>& pair = pairs_[joint];
  Scalar sum = 0.0;
  for (std::size_t r = 0; r < pair.shape.rows(); ++r) sum += residual_[pair.row + r] * residual_[pair.row + r];
  using std::sqrt;
  return sqrt(sum);
}

template <class Scalar>
void BasicConstraints<Scalar>::centripetal(std::span<const Scalar> velocity, std::span<Scalar> right) const {
  for (const BasicPair<Scalar>& pair : pairs_) {
    const std::span<Scalar> along = right.subspan(pair.row, pair.shape.rows());
    const BasicSpeeds<Scalar> i{origin(velocity, pair.i), angle(velocity, pair.i)};
    const BasicSpeeds<Scalar> j{origin(velocity, pair.j), angle(velocity, pair.j)};
    held_acceleration(pair.shape, pair.at, placed_[pair.i], placed_[pair.j], i, j, along);
    const BasicVec<Scalar> inward = i.omega * i.omega * (pair.at.at - placed_[pair.i].origin) -
                                    j.omega * j.omega * (pair.at.at_j - placed_[pair.j].origin);
    for (std::size_t r = 0; r < along.size(); ++r) along[r] += dot(pair.at.rows[r].e, inward);
  }
}

template void change_unit_of_length(BasicModel<double>&, double);
template void change_unit_of_length(BasicModel<Dual>&, double);
template class BasicConstraints<double>;
template class BasicConstraints<Dual>;

}  // namespace loadpath::mechanism
