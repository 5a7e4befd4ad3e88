// All assemblies of a mechanism at given drives.
#pragma once

#include "lib/mechanism/model/model.hpp"

#include <string>
#include <vector>

namespace loadpath::mechanism {

/// Sides name an assembly, one for every group that can be on several: of a dyad the side of its inner joint, "B_left",
/// "D_ahead" (`DyadClosing`), which stays the same while the mechanism moves until it passes a change point; of a group
/// without closed form its first link with the number of the assembly, "plate_2", counted by the angle of that link
/// where the mechanism is now.
struct Assembly {
  std::vector<std::string> sides;
  std::vector<Pose> poses;  // poses of the links
  bool followed = false;    // the one of the stated poses

  /// "B_left, D_ahead"; "the only one" without sides.
  [[nodiscard]] std::string name() const;
};

/// `complete`: no other assembly is possible. It is not promised where a group has no closed form: its assemblies (of a
/// class III group of three pinned bars at most six) are sought by iteration from many places; where wheels close it,
/// as it is stated only. Nor where the mechanism has more assemblies than are listed.
struct Assemblies {
  std::vector<Assembly> list;
  bool complete = true;
};

inline constexpr std::size_t most_assemblies = 64;

/// At the drives' coordinates of the assembly nearest to the stated poses; that one comes first. Empty if there is
/// none. The model has passed `diagnose`.
Assemblies assemblies(const Model& model);

}  // namespace loadpath::mechanism
