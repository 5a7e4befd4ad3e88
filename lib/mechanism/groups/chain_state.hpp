// A chain of dyads (chain.hpp) where it is, at one position or at several side by side.
#pragma once

#include "lib/mechanism/groups/chain.hpp"
#include "lib/mechanism/groups/lanes.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace loadpath::mechanism {

/// Position and motion of a link's own frame, and the forces that its joints have to supply for it, about its origin.
template <std::size_t Count>
struct ChainMotion {
  VecLanes<Count> origin;
  TurnLanes<Count> turned;
  VecLanes<Count> velocity, acceleration;
  Lanes<Count> omega{}, epsilon{};
  VecLanes<Count> force;
  Lanes<Count> moment{};
};

/// The quantities of a step's motion needed for its forces.
template <std::size_t Count>
struct StepMotion {
  VecLanes<Count> along;    // direction of a slider
  Lanes<Count> inverse{};   // inverse of the determinant
  Lanes<Count> distance{};  // arm and line: of the arm's pin from the line
};

/// The state of a drive, in the counting direction of its joint.
template <std::size_t Count>
struct DriveLanes {
  Lanes<Count> value{}, speed{}, acceleration{};
  TurnLanes<Count> turned;  // rotary: by the value
};

template <std::size_t Count>
struct ReactionLanes {
  VecLanes<Count> force;
  Lanes<Count> couple{};
};

template <std::size_t Count>
struct LoadLanes {
  VecLanes<Count> force;
  Lanes<Count> moment{};
};

template <std::size_t Count>
struct ChainState {
  explicit ChainState(const Chain& chain)
      : links(chain.links.size()),
        steps(chain.steps.size()),
        drives(chain.steps.size()),
        loads(chain.loads.size()),
        reactions(chain.joints),
        effort(chain.drivers),
        sides(chain.steps.size(), 1.0) {
    links[chain.ground].turned.cosine.fill(1.0);
  }

  std::vector<ChainMotion<Count>> links;
  std::vector<StepMotion<Count>> steps;
  std::vector<DriveLanes<Count>> drives;  // drives of the driven steps
  std::vector<LoadLanes<Count>> loads;
  std::vector<ReactionLanes<Count>> reactions;  // on link i of the joint, about its pin
  std::vector<Lanes<Count>> effort;
  std::vector<double> sides;  // sides of the steps, +1 or -1
  ChainMotion<Count> spare;   // the virtual slider of a slot
  Lanes<Count> least_sine{};  // below it a dyad is near its change point
  Lanes<Count> clear{};       // 1, or 0
};

/// With the connections to the ground known at compile time: most of its arithmetic is with zeros.
template <class Do>
void on_ground(const Hinge& hinge, Do what) {
  hinge.grounded ? what(std::true_type{}) : what(std::false_type{});
}
template <class Do>
void on_grounds(const ChainStep& step, Do what) {
  on_ground(step.first, [&](auto first) { on_ground(step.second, [&](auto second) { what(first, second); }); });
}

}  // namespace loadpath::mechanism
