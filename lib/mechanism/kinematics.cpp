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

Vec inward(const Pair& pair, std::span<const double> velocity) {
  const double omega_i = angle(velocity, pair.i);
  const double omega_j = angle(velocity, pair.j);
  return omega_i * omega_i * pair.arm_i - omega_j * omega_j * pair.arm_j;
}

// For `apart` projected on a direction that turns with link j: with the Coriolis term of the sliding.
double along_turning(const Pair& pair, Vec direction, std::span<const double> velocity) {
  const double omega = angle(velocity, pair.j);
  const Vec sliding = origin(velocity, pair.i) + angle(velocity, pair.i) * normal(pair.arm_i) -
                      origin(velocity, pair.j) - omega * normal(pair.arm_j);
  return dot(direction, inward(pair, velocity) + omega * omega * pair.apart) -
         2.0 * omega * dot(normal(direction), sliding);
}

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
  }
  for (auto& driver : scaled.drivers) {
    if (driver.kind == Driver::Kind::linear) driver.offset *= shrink;
  }
  for (auto& load : scaled.loads) {
    load.point = shrink * load.point;
    load.force = shrink * load.force;
    load.moment *= shrink * shrink;
  }
  scaled.gravity = shrink * scaled.gravity;
  return scaled;
}

Constraints::Constraints(const Model& model)
    : ground_(model.links.size()), turns_(ground_ + 1), phi_(ground_ + 1), pattern_(1), jacobian_(1) {
  pairs_.reserve(model.joints.size());
  drives_.reserve(model.drivers.size());
  for (const auto& joint : model.joints) add(joint);
  for (const auto& driver : model.drivers) add(driver);
  residual_.resize(rows_);
}

std::size_t Constraints::entry(std::size_t row, std::size_t link, std::size_t component, double value) {
  if (link == ground_) return discarded;
  pattern_.push_back({static_cast<int>(row), static_cast<int>(3 * link + component)});
  jacobian_.push_back(value);
  return jacobian_.size() - 1;
}

std::array<std::size_t, 6> Constraints::line_entries(std::size_t row, std::size_t i, std::size_t j) {
  return {entry(row, i, 0), entry(row, i, 1), entry(row, i, 2), entry(row, j, 0), entry(row, j, 1), entry(row, j, 2)};
}

void Constraints::add(const Joint& joint) {
  Pair pair{.kind = joint.kind,
            .i = index(joint.i),
            .j = index(joint.j),
            .row = rows_,
            .point_i = joint.point_i,
            .point_j = joint.point_j,
            .line = turn(joint.direction)({1.0, 0.0}),
            .angle = joint.angle};
  assert(pair.i != pair.j);
  if (joint.kind == JointKind::revolute) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      entry(rows_ + axis, pair.i, axis, 1.0);
      entry(rows_ + axis, pair.j, axis, -1.0);
      pair.entries[2 * axis] = entry(rows_ + axis, pair.i, 2);
      pair.entries[2 * axis + 1] = entry(rows_ + axis, pair.j, 2);
    }
  } else {
    pair.entries = line_entries(rows_, pair.i, pair.j);
  }
  if (joint.kind == JointKind::prismatic) {
    entry(rows_ + 1, pair.i, 2, 1.0);
    entry(rows_ + 1, pair.j, 2, -1.0);
  }
  rows_ += static_cast<std::size_t>(constraint_count(joint.kind));
  pairs_.push_back(pair);
}

void Constraints::add(const Driver& driver) {
  Drive drive{.kind = driver.kind, .i = 0, .j = 0, .pair = 0, .offset = driver.offset};
  if (driver.kind == Driver::Kind::rotary) {
    drive.i = index(driver.i);
    drive.j = index(driver.j);
    assert(drive.i != drive.j);
    entry(rows_, drive.i, 2, 1.0);
    entry(rows_, drive.j, 2, -1.0);
  } else {
    drive.pair = static_cast<std::size_t>(driver.joint);
    drive.entries = line_entries(rows_, pairs_[drive.pair].i, pairs_[drive.pair].j);
  }
  ++rows_;
  drives_.push_back(drive);
}

void Constraints::place(std::span<const double> q, std::span<const double> targets) {
  for (std::size_t link = 0; link < ground_; ++link) {
    phi_[link] = angle(q, link);
    turns_[link] = turn(phi_[link]);
  }
  for (auto& pair : pairs_) place(pair, q);
  const std::size_t row = first_driver_row();
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    place(drives_[k]);
    residual_[row + k] = coordinate(k) - targets[k];
  }
}

void Constraints::place(Pair& pair, std::span<const double> q) {
  pair.arm_i = turns_[pair.i](pair.point_i);
  pair.arm_j = turns_[pair.j](pair.point_j);
  pair.apart = (origin(q, pair.i) - origin(q, pair.j)) + (pair.arm_i - pair.arm_j);
  if (pair.kind == JointKind::revolute) {
    residual_[pair.row] = pair.apart.x;
    residual_[pair.row + 1] = pair.apart.y;
    jacobian_[pair.entries[0]] = -pair.arm_i.y;
    jacobian_[pair.entries[1]] = pair.arm_j.y;
    jacobian_[pair.entries[2]] = pair.arm_i.x;
    jacobian_[pair.entries[3]] = -pair.arm_j.x;
    return;
  }
  pair.along = turns_[pair.j](pair.line);
  residual_[pair.row] = dot(normal(pair.along), pair.apart);
  set_line(pair, normal(pair.along), pair.entries);
  if (pair.kind == JointKind::prismatic) residual_[pair.row + 1] = phi_[pair.i] - phi_[pair.j] - pair.angle;
}

void Constraints::place(const Drive& drive) {
  if (drive.kind == Driver::Kind::linear) set_line(pairs_[drive.pair], pairs_[drive.pair].along, drive.entries);
}

// The row of `apart` projected on a direction that turns with link j.
void Constraints::set_line(const Pair& pair, Vec direction, const std::array<std::size_t, 6>& entries) {
  jacobian_[entries[0]] = direction.x;
  jacobian_[entries[1]] = direction.y;
  jacobian_[entries[2]] = cross(pair.arm_i, direction);
  jacobian_[entries[3]] = -direction.x;
  jacobian_[entries[4]] = -direction.y;
  jacobian_[entries[5]] = -cross(pair.arm_j + pair.apart, direction);
}

double Constraints::coordinate(std::size_t driver) const {
  const Drive& drive = drives_[driver];
  if (drive.kind == Driver::Kind::rotary) return phi_[drive.i] - phi_[drive.j] + drive.offset;
  return dot(pairs_[drive.pair].along, pairs_[drive.pair].apart) + drive.offset;
}

double Constraints::opening(std::size_t joint) const {
  const Pair& pair = pairs_[joint];
  if (pair.kind == JointKind::slot) return std::abs(residual_[pair.row]);
  return std::hypot(residual_[pair.row], residual_[pair.row + 1]);
}

void Constraints::centripetal(std::span<const double> velocity, std::span<double> right) const {
  for (const auto& pair : pairs_) {
    if (pair.kind == JointKind::revolute) {
      const Vec in = inward(pair, velocity);
      right[pair.row] = in.x;
      right[pair.row + 1] = in.y;
    } else {
      right[pair.row] = along_turning(pair, normal(pair.along), velocity);
      if (pair.kind == JointKind::prismatic) right[pair.row + 1] = 0.0;
    }
  }
  std::size_t row = first_driver_row();
  for (const auto& drive : drives_) {
    const Pair& pair = pairs_[drive.pair];
    right[row++] = drive.kind == Driver::Kind::linear ? along_turning(pair, pair.along, velocity) : 0.0;
  }
}

}  // namespace loadpath::mechanism
