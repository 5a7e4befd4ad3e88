#include "lib/mechanism/structure/structure.hpp"

#include "lib/mechanism/structure/free_mechanism.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

// Whether dependent constraints are so at this position only: a little further on they are independent, or the motions
// that they leave lead nowhere.
bool dependent_here_only(FreeMechanism mechanism) {
  constexpr double little = 1e-2;
  if (mechanism.motions().empty()) return false;
  return !mechanism.move_on(little) || mechanism.self_stresses().empty();
}

std::vector<std::vector<std::size_t>> joints_of(const NullSpace& self_stresses, std::span<const Pair> pairs) {
  std::vector<std::vector<std::size_t>> sets;
  for (const auto& stress : self_stresses) {
    std::vector<std::size_t> set;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      bool held = false;
      for (std::size_t r = 0; r < pairs[k].shape.rows(); ++r) held = held || in_support(stress, pairs[k].row + r);
      if (held) set.push_back(k);
    }
    sets.push_back(std::move(set));
  }
  std::ranges::sort(sets);
  return sets;
}

std::vector<std::size_t> links_of(const NullSpace& motions, std::size_t links) {
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < links; ++k) {
    const auto moves = [&](const auto& motion) {
      return in_support(motion, 3 * k) || in_support(motion, 3 * k + 1) || in_support(motion, 3 * k + 2);
    };
    if (std::ranges::any_of(motions, moves)) moving.push_back(k);
  }
  return moving;
}

int count_mobility(const Model& model) {
  int mobility = 3 * static_cast<int>(model.links.size());
  for (const auto& joint : model.joints) mobility -= constraint_count(joint.kind);
  return mobility;
}

std::vector<CentreDistanceError> misfits_of(const Constraints& constraints, double length) {
  constexpr double tolerance = 0.01;  // pitch circles that are a little apart only change the working radii
  std::vector<CentreDistanceError> misfits;
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

bool needs_distance(const Joint& joint) {
  return joint.kind == JointKind::gear || joint.kind == JointKind::belt || joint.kind == JointKind::rack;
}

/// The centre distance that other joints must maintain for this one; 0 for other kinds.
double centre_distance(const Constraints& constraints, const Joint& joint) {
  if (!needs_distance(joint)) return 0.0;
  const bool two = joint.kind != JointKind::rack;
  const Placed& j = constraints.placed(joint.j);
  const Vec apart = constraints.placed(joint.i).point(joint.point_i) - j.point(joint.point_j);
  return two ? length(apart) : std::abs(dot(apart, normal(j.turned(turn(joint.direction)({1.0, 0.0})))));
}

// A little further on in every motion at once, so that a distance that is extreme here is seen to change too.
std::vector<std::size_t> parting_joints(FreeMechanism mechanism, const std::vector<Joint>& joints) {
  constexpr double little = 1e-2, negligible = 1e-7;
  if (std::ranges::none_of(joints, needs_distance)) return {};
  std::vector<double> before;
  before.reserve(joints.size());
  for (const Joint& joint : joints) before.push_back(centre_distance(mechanism.constraints(), joint));
  std::vector<std::size_t> parting;
  if (mechanism.motions().empty() || !mechanism.move_on(little)) return parting;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double now = centre_distance(mechanism.constraints(), joints[k]);
    if (std::abs(now - before[k]) > negligible * before[k]) parting.push_back(k);
  }
  return parting;
}

// The equation of a belt assumes a constant centre distance, and does not close otherwise: the motion of the centres
// shows without that equation.
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
  FreeMechanism mechanism(without);
  if (belts.empty() || !mechanism.close()) return {};
  std::vector<std::size_t> parting = parting_joints(mechanism, model.joints);
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
  FreeMechanism driven(scaled);
  scaled.drivers.clear();
  FreeMechanism free(scaled);

  structure.parting = parting_belts(scaled);
  structure.closes = free.close();
  if (!structure.closes) {
    find_widest(free.constraints(), length, structure);
    return structure;
  }
  structure.misfits = misfits_of(free.constraints(), length);
  if (!driven.close()) {
    const FreeMechanism as_far_as_possible = driven;
    driven.go_to(free.q());
    // With dependent constraints, the drivers contradict each other, not the lengths.
    structure.closes = !driven.self_stresses().empty();
    if (!structure.closes) find_widest(as_far_as_possible.constraints(), length, structure);
  }
  structure.loose = links_of(driven.motions(), model.links.size());
  if (structure.parting.empty()) structure.parting = parting_joints(free, scaled.joints);
  const NullSpace self_stresses = free.self_stresses();
  structure.mobility = self_stresses.empty()
                           ? static_cast<int>(free.constraints().columns() - free.constraints().rows())
                           : static_cast<int>(free.motions().size());
  structure.singular = !self_stresses.empty() && dependent_here_only(free);
  if (!structure.singular) structure.redundant = joints_of(self_stresses, free.constraints().pairs());
  return structure;
}

}  // namespace loadpath::mechanism
