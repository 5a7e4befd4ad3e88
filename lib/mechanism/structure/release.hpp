// An overconstrained mechanism: which of its reactions are unique, and how redundant constraints are released so that
// the rest can be solved. A self-stress of the joints, a set of forces in equilibrium by themselves, may be added to
// any solution; reactions that it does not affect are unique (M. Wojtyra, Multibody System Dynamics 13 (2005)).
#pragma once

#include "lib/mechanism/model/model.hpp"

#include <optional>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// Whether the equilibrium of rigid links determines a joint's force and couple.
struct Uniqueness {
  bool force = true;
  bool couple = true;
};

/// For every joint, near the stated poses and over the motion from there on. The model closes and is not singular.
std::vector<Uniqueness> uniqueness(const Model& model);

/// The same mechanism, without self-stress: one constraint of one joint in each redundant set is released, such that
/// the rest is as independent as possible at these poses. It moves as the given one does; the reactions that are
/// unique are those of the given one. The joints keep their places in the model. Nothing if every choice would leave
/// it mobile.
std::optional<Model> release(const Model& model, std::span<const Pose> poses);

/// Whether `release` has something to give at the assembly nearest to the stated poses.
bool can_release(const Model& model);

/// The independence of a model's constraints at these poses, 0 (mobile) to 1.
double grip(const Model& model, std::span<const Pose> poses);

}  // namespace loadpath::mechanism
