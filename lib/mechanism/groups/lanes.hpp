// Numbers and vectors of several positions in parallel. Computations are written for one lane, as a loop over all of
// them that the compiler vectorises: every lane gives the same bits as a single computation.
#pragma once

#include "lib/mechanism/model/vec.hpp"
#include "lib/simd/attributes.hpp"

#include <array>
#include <cstddef>

namespace loadpath::mechanism {

template <std::size_t Count>
using Lanes = std::array<double, Count>;

template <std::size_t Count>
struct VecLanes {
  Lanes<Count> x{}, y{};
  [[nodiscard]] Vec operator[](std::size_t lane) const { return {x[lane], y[lane]}; }
  void set(std::size_t lane, Vec v) {
    x[lane] = v.x;
    y[lane] = v.y;
  }
};

template <std::size_t Count>
struct TurnLanes {
  Lanes<Count> cosine{}, sine{};
  [[nodiscard]] Turn operator[](std::size_t lane) const { return {cosine[lane], sine[lane]}; }
  void set(std::size_t lane, Turn turned) {
    cosine[lane] = turned.cosine;
    sine[lane] = turned.sine;
  }
};

/// Applies a function to each lane. Its stores reach no other lane.
template <std::size_t Count, class OfLane>
inline void each_lane(OfLane of_lane) {
  LOADPATH_LANEWISE
  for (std::size_t lane = 0; lane < Count; ++lane) of_lane(lane);
}

}  // namespace loadpath::mechanism
