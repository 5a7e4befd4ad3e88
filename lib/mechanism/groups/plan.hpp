// The computation plan for the groups of a mechanism. Tree joints with one coordinate each connect the links of a
// group to earlier ones; the remaining joints and drives cut the loops open, and closing them gives as many equations
// as there are unknown coordinates: two for every dyad.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/pair.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace loadpath::mechanism {

inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// The sine below which a group is near its change point; increased by the change of the drives, rad or parts of the
/// mechanism's size. A change of `longest_way` is followed in small steps.
inline constexpr double near_change = 0.1;
inline constexpr double longest_way = 1.0;

/// The model's links keep their numbers, the ground comes next, then massless ones: a link that neither a revolute
/// nor a sliding joint connects is carried by two crossed slides.
struct TreeJoint {
  enum class Kind { turn, slide, fixed };
  Kind kind = Kind::turn;
  std::size_t link = 0, on = 0;
  bool based = false;         // `on` was there before the group
  std::size_t joint = none;   // joint of the model
  bool link_is_i = true;      // whether the link is i of that joint
  std::size_t driver = none;  // driver of the coordinate
  double sense = 1.0;         // coordinate = sense * (the drive's coordinate - offset)
  double offset = 0.0;
  std::size_t unknown = none;  // its number among the unknown coordinates of the group
  Vec pin = {}, seat = {};     // frames of link and of `on`; the pin lies at the seat, or slides from there
  Vec along{1.0, 0.0};         // slide: unit vector in the frame of `on`, in which the coordinate counts
  double angle = 0.0;          // slide, fixed: of link against `on`
  Turn turned = {};            // the same
};

/// An unknown coordinate that moves one side of a cut: +1 the side of link i, -1 that of link j.
struct Mover {
  std::size_t tree = 0;
  double side = 1.0;
};

/// A joint, or a drive, that closes a loop.
struct Cut {
  PairShape shape;
  std::size_t i = 0, j = 0;
  std::size_t joint = none, driver = none;
  std::size_t row = 0, rows = 0;  // its first in the group, and how many
  std::vector<Mover> movers = {};
};

/// The closing of a group's loops: in closed form if a dyad, or one link with a slot, gives one.
enum class Closing {
  nothing,
  two_paths,
  slot_along_slide,
  slot_about_pin,
  slide_of_two_turns,
  slide_of_turn,
  by_newton
};

struct GroupPlan {
  std::size_t first_tree = 0, last_tree = 0;  // in the order of attachment
  std::size_t first_cut = 0, last_cut = 0;
  std::vector<std::size_t> unknowns;  // tree joints
  Closing closing = Closing::nothing;
  bool on_cam = false;                         // some cut is a follower on its cam
  std::size_t mover_i = none, mover_j = none;  // closed forms: the tree joints that move the two sides of the cut
};

struct Plan {
  std::size_t ground = 0;   // the number of the ground
  std::size_t links = 0;    // with the ground and the massless ones
  std::size_t drivers = 0;  // number of drivers of the model
  std::vector<TreeJoint> tree;
  std::vector<Cut> cuts;
  std::vector<GroupPlan> groups;  // in order of attachment
};

/// The lowest-numbered link of a group, which identifies the group in messages.
std::size_t first_link(const Plan& plan, const GroupPlan& group);

/// The model has passed `diagnose`.
Plan plan_of(const Model& model);
/// For a model of the same structure, for which the plan was made.
void take_dimensions(const Model& model, Plan& plan);

}  // namespace loadpath::mechanism
