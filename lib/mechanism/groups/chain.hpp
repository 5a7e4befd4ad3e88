// A mechanism of drives, rigid links and dyads in closed form, with all its numbers ready: the part that can be
// computed for many positions at once (chain_motion.hpp, chain_forces.hpp). Each link has a frame of its own choice:
// its origin is at the pin that carries the link, or at the inner joint of a slider, and its axis is along its bar,
// its guide or its slot, so that a closed dyad gives the rotations of its links directly.
//
// Excluded, and followed by GroupPositions and GroupMotion: groups that are closed by iteration, slides across
// slides, a guide between a rotating and a sliding link, springs, and joints whose reactions induce forces.
#pragma once

#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/model/model.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace loadpath::mechanism {

struct ChainLink {
  Turn own;              // from the model's frame to this one
  Vec base;              // its start, frame of the model
  bool shifted = false;  // it does not start where the model's frame does
  Vec start;             // start of the model's frame, in this one
  Vec centre;            // centre of mass
  double mass = 0.0;
  double inertia = 0.0;
};

/// The joint that connects a link to the previous ones.
struct Hinge {
  std::size_t tree = none;  // tree joint of the plan; none: not a link, but a line of `on`
  std::size_t link = none;
  std::size_t on = 0;
  std::size_t joint = none;  // joint of the model
  bool grounded = false;     // connected to the ground
  bool link_is_i = true;     // whether it is link i of the joint
  Vec seat;                  // frame of `on`: the pin; of a slider where its inner joint is when it has not slid
  Vec along{1.0, 0.0};       // frame of `on`, of a slider
  Vec mount;                 // slider: reference point of its reaction, the joint's point of link i, in i's frame
  bool centred = false;      // slider: that point is the origin of its frame
  double length = 0.0;       // from the pin to the inner joint
  double angle = 0.0;        // angle of a slider's frame in the model against that of `on`
};

/// A unit of computation. The sides of dyads are those of GroupPositions.
struct ChainStep {
  enum class Kind {
    turned,        // by a drive, as the first hinge has it
    slid,          // by a drive
    fixed,         // to the carrying link
    two_arms,      // two pinned bars; the first is link i of the inner joint
    arm_and_line,  // a pinned bar, and a slider or a slot
    slot,          // a pinned link, the second hinge, whose slot takes another link's pin
    guide          // two pinned links that slide in each other
  };
  Kind kind = Kind::turned;
  std::size_t group = 0;  // group of the plan
  Hinge first, second;
  std::size_t cut = none;    // cut joint of the plan
  std::size_t joint = none;  // the inner one
  std::size_t driver = none;
  double sense = 1.0;   // sign of the drive; of the inner joint: its force is that on the first link
  double offset = 0.0;  // offset of the drive's coordinate
  Vec pin;              // slot: in the frame of the link that it belongs to; guide: in that of the first
  double angle = 0.0;   // guide: of the first link against the second
  double aside = 0.0;   // slot, guide: by which the line misses the pivot of the second link
};

struct ChainLoad {
  std::size_t link = 0;
  bool turns_with_link = false;
  bool at_start = false;  // it has no lever
  Vec point;
};

struct Chain {
  std::size_t ground = 0;
  std::vector<ChainLink> links;  // the ground is the last
  std::vector<ChainStep> steps;
  std::vector<ChainLoad> loads;
  std::size_t joints = 0, drivers = 0;
  Vec gravity;

  /// For a model of the same structure, for which the plan has taken the dimensions.
  void take_dimensions(const Model& model, const Plan& plan);
};

/// Whether it has neither springs nor joints whose reactions induce forces.
bool is_chain(const Model& model);
/// Nothing if the mechanism is not such a one.
std::optional<Chain> chain_of(const Model& model, const Plan& plan);

}  // namespace loadpath::mechanism
