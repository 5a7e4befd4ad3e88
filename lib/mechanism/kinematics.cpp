#include "lib/mechanism/kinematics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace loadpath::mechanism {
namespace {

constexpr std::size_t discarded = 0;

Vec origin(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }
double angle(std::span<const double> q, std::size_t link) { return q[3 * link + 2]; }

}  // namespace

double characteristic_length(const Model& model) {
  double extent = 0.0;
  std::vector<std::optional<Vec>> first(model.links.size() + 1);
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

Model in_unit_of_length(const Model& model, double unit) {
  Model scaled = model;
  const double shrink = 1.0 / unit;
  for (auto& link : scaled.links) {
    link.inertia *= shrink * shrink;
    link.centre = shrink * link.centre;
    link.pose.x *= shrink;
    link.pose.y *= shrink;
  }
  for (auto& joint : scaled.joints) {
    joint.point_i = shrink * joint.point_i;
    joint.point_j = shrink * joint.point_j;
    joint.radius_i *= shrink;
    joint.radius_j *= shrink;
    joint.phase *= shrink;
  }
  for (auto& driver : scaled.drivers) {
    if (driver.kind == Driver::Kind::linear) driver.offset *= shrink;
  }
  for (auto& load : scaled.loads) {
    load.point = shrink * load.point;
    load.force = shrink * load.force;
    load.moment *= shrink * shrink;
  }
  for (auto& spring : scaled.springs) {
    const bool turning = spring.kind == Spring::Kind::turning;
    spring.point_i = shrink * spring.point_i;
    spring.point_j = shrink * spring.point_j;
    spring.free *= turning ? 1.0 : shrink;
    spring.rate *= turning ? shrink * shrink : 1.0;
    spring.damping *= turning ? shrink * shrink : 1.0;
  }
  scaled.gravity = shrink * scaled.gravity;
  return scaled;
}

Constraints::Constraints(const Model& model)
    : ground_(model.links.size()), joints_(model.joints.size()), placed_(ground_ + 1), pattern_(1), jacobian_(1) {
  pairs_.reserve(joints_ + model.drivers.size());
  for (const Joint& joint : model.joints) add(shape_of(joint), joint.i, joint.j);
  for (const Driver& driver : model.drivers) {
    const bool linear = driver.kind == Driver::Kind::linear;
    const Joint* slide = linear ? &model.joints[static_cast<std::size_t>(driver.joint)] : nullptr;
    add(shape_of(driver, slide), linear ? slide->i : driver.i, linear ? slide->j : driver.j);
  }
  residual_.resize(rows_);
}

std::size_t Constraints::entry(std::size_t row, std::size_t link, std::size_t component, bool occupied) {
  if (link == ground_ || !occupied) return discarded;
  pattern_.push_back({static_cast<int>(row), static_cast<int>(3 * link + component)});
  jacobian_.push_back(0.0);
  return jacobian_.size() - 1;
}

void Constraints::add(const PairShape& shape, int i, int j) {
  Pair pair{.shape = shape, .i = index(i), .j = index(j), .row = rows_};
  assert(pair.i != pair.j);
  for (std::size_t r = 0; r < shape.rows(); ++r, ++rows_) {
    const auto [x, y, phi] = pattern_of(shape, r);
    pair.entries[r] = {entry(rows_, pair.i, 0, x), entry(rows_, pair.i, 1, y), entry(rows_, pair.i, 2, phi),
                       entry(rows_, pair.j, 0, x), entry(rows_, pair.j, 1, y), entry(rows_, pair.j, 2, phi)};
  }
  prepare(shape, pair.at);
  pairs_.push_back(pair);
}

void Constraints::place(std::span<const double> q, std::span<const double> targets) {
  for (std::size_t link = 0; link < ground_; ++link) {
    placed_[link] = {turn(angle(q, link)), origin(q, link), angle(q, link)};
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    Pair& pair = pairs_[k];
    mechanism::place(pair.shape, placed_[pair.i], placed_[pair.j], pair.at);
    open(pair.shape, pair.at, placed_[pair.i], placed_[pair.j], k < joints_ ? 0.0 : targets[k - joints_],
         std::span(residual_).subspan(pair.row, pair.shape.rows()));
    set_rows(pair);
  }
}

void Constraints::count_turns() {
  for (Pair& pair : pairs_) mechanism::count_turns(pair.shape, placed_[pair.i], placed_[pair.j], pair.at);
}

void Constraints::set_rows(const Pair& pair) {
  const Vec arm_i = pair.at.at - placed_[pair.i].origin, arm_j = pair.at.at_j - placed_[pair.j].origin;
  for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
    const PairRow& row = pair.at.rows[r];
    const auto& entries = pair.entries[r];
    jacobian_[entries[0]] = row.e.x;
    jacobian_[entries[1]] = row.e.y;
    jacobian_[entries[2]] = cross(arm_i, row.e) + row.m;
    jacobian_[entries[3]] = -row.e.x;
    jacobian_[entries[4]] = -row.e.y;
    jacobian_[entries[5]] = -cross(arm_j, row.e) - row.m;
  }
}

double Constraints::coordinate(std::size_t driver) const {
  const Pair& drive = drives()[driver];
  double coordinate = 0.0;
  open(drive.shape, drive.at, placed_[drive.i], placed_[drive.j], 0.0, {&coordinate, 1});
  return coordinate;
}

double Constraints::opening(std::size_t joint) const {
  const Pair& pair = pairs_[joint];
  double sum = 0.0;
  for (std::size_t r = 0; r < pair.shape.rows(); ++r) sum += residual_[pair.row + r] * residual_[pair.row + r];
  return std::sqrt(sum);
}

void Constraints::centripetal(std::span<const double> velocity, std::span<double> right) const {
  for (const Pair& pair : pairs_) {
    const std::span<double> along = right.subspan(pair.row, pair.shape.rows());
    const Speeds i{origin(velocity, pair.i), angle(velocity, pair.i)};
    const Speeds j{origin(velocity, pair.j), angle(velocity, pair.j)};
    held_acceleration(pair.shape, pair.at, placed_[pair.i], placed_[pair.j], i, j, along);
    const Vec inward = i.omega * i.omega * (pair.at.at - placed_[pair.i].origin) -
                       j.omega * j.omega * (pair.at.at_j - placed_[pair.j].origin);
    for (std::size_t r = 0; r < along.size(); ++r) along[r] += dot(pair.at.rows[r].e, inward);
  }
}

}  // namespace loadpath::mechanism
