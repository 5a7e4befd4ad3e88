#include "lib/mechanism/structure/release.hpp"

#include "lib/mechanism/structure/free_mechanism.hpp"

#include <algorithm>
#include <numbers>

namespace loadpath::mechanism {
namespace {

Model at_poses(const Model& model, std::span<const Pose> poses) {
  Model there = model;
  for (std::size_t k = 0; k < poses.size(); ++k) there.links[k].pose = poses[k];
  return there;
}

/// In its unit of length, so that the entries of its constraints are comparable.
FreeMechanism free_of(Model model, bool driven) {
  if (!driven) model.drivers.clear();
  return FreeMechanism(in_unit_of_length(model, characteristic_length(model)));
}

Joint pin_in_slot(Joint joint, double direction) {
  joint.kind = JointKind::slot;
  joint.direction = direction;
  return joint;
}

Joint of_kind(Joint joint, JointKind kind) {
  joint.kind = kind;
  return joint;
}

Joint held_parallel(Joint joint, double direction) {
  joint.kind = JointKind::prismatic;
  joint.direction = direction;
  return joint;
}

/// The joints that have one constraint less than this one.
std::vector<Joint> loosened(const Joint& joint) {
  constexpr double along = 0.0, across = 0.5 * std::numbers::pi;
  switch (joint.kind) {
    case JointKind::revolute:
      return {pin_in_slot(joint, along), pin_in_slot(joint, across)};
    case JointKind::prismatic:
      return {of_kind(joint, JointKind::slot)};
    case JointKind::rigid:
      return {of_kind(joint, JointKind::revolute), held_parallel(joint, along), held_parallel(joint, across)};
    case JointKind::rolling:
      return {of_kind(joint, JointKind::gear)};
    case JointKind::rolling_on_line:
      return {of_kind(joint, JointKind::rack)};
    case JointKind::slot:
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt:
    case JointKind::cam:
      return {of_kind(joint, JointKind::none)};
    case JointKind::none:
      return {};
  }
  return {};
}

bool is_driven(const Model& model, std::size_t joint) {
  return std::ranges::any_of(model.drivers, [&](const Driver& driver) {
    return driver.kind == DriverKind::linear && driver.joint == static_cast<int>(joint);
  });
}

bool takes_part(const NullSpace& self_stresses, const Pair& pair) {
  for (const auto& stress : self_stresses) {
    for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
      if (in_support(stress, pair.row + r)) return true;
    }
  }
  return false;
}

/// The model with the one constraint less that it misses least; nothing if each is missed.
std::optional<Model> release_one(const Model& model, const FreeMechanism& free, const NullSpace& self_stresses) {
  constexpr double firm = 1e-6;
  const std::size_t rank = free.constraints().rows() - self_stresses.size();
  std::optional<Model> best;
  double most = firm;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (!takes_part(self_stresses, free.constraints().pairs()[k])) continue;
    for (const Joint& joint : loosened(model.joints[k])) {
      if (joint.kind == JointKind::none && is_driven(model, k)) continue;
      Model candidate = model;
      candidate.joints[k] = joint;
      const double hold = free_of(candidate, false).grip(rank);
      if (hold <= 1.001 * most) continue;  // among equals the first, independent of rounding
      most = hold;
      best = std::move(candidate);
    }
  }
  return best;
}

void mark(const NullSpace& self_stresses, const Constraints& constraints, std::vector<Uniqueness>& joints) {
  for (const auto& stress : self_stresses) {
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Pair& pair = constraints.pairs()[k];
      for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
        if (!in_support(stress, pair.row + r)) continue;
        const bool turning = pair.at.rows[r].e.x == 0.0 && pair.at.rows[r].e.y == 0.0;
        (turning ? joints[k].couple : joints[k].force) = false;
      }
    }
  }
}

}  // namespace

std::vector<Uniqueness> uniqueness(const Model& model) {
  // A self-stress may leave a joint out at one position; at several it does so for a reason.
  constexpr int positions = 4;
  constexpr double apart = 0.05;
  std::vector<Uniqueness> joints(model.joints.size());
  FreeMechanism free = free_of(model, false);
  if (!free.close()) return joints;
  mark(free.self_stresses(), free.constraints(), joints);
  for (int k = 1; k < positions && free.move_on(apart); ++k) mark(free.self_stresses(), free.constraints(), joints);
  return joints;
}

std::optional<Model> release(const Model& model, std::span<const Pose> poses) {
  Model released = at_poses(model, poses);
  for (;;) {
    const FreeMechanism free = free_of(released, false);
    const NullSpace self_stresses = free.self_stresses();
    if (self_stresses.empty()) return released;
    auto next = release_one(released, free, self_stresses);
    if (!next) return std::nullopt;
    released = std::move(*next);
  }
}

bool can_release(const Model& model) {
  FreeMechanism free = free_of(model, false);
  return free.close() && release(model, free.poses(characteristic_length(model)));
}

double grip(const Model& model, std::span<const Pose> poses) {
  const FreeMechanism driven = free_of(at_poses(model, poses), true);
  return driven.grip(driven.constraints().rows());
}

}  // namespace loadpath::mechanism
