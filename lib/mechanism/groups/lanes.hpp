// Numbers and vectors of several positions side by side. What is computed with them is written for one lane, as a loop
// over all of them that the compiler turns into wide instructions: every lane gives the bits that it gives alone.
#pragma once

#include "lib/mechanism/model/vec.hpp"

#include <array>
#include <cstddef>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__)
/// A loop over lanes: inlined whole, and compiled for wide registers too; the machine chooses when it starts.
#define LOADPATH_LANES __attribute__((flatten, target_clones("default", "arch=x86-64-v3")))
#else
#define LOADPATH_LANES
#endif

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

/// Of each lane by itself. Its stores reach no other lane; unrolled first it would not be widened.
template <std::size_t Count, class OfLane>
inline void each_lane(OfLane of_lane) {
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#pragma GCC unroll 1
#endif
  for (std::size_t lane = 0; lane < Count; ++lane) of_lane(lane);
}

}  // namespace loadpath::mechanism
