// The mechanism reduced to its drive: one inertia with its kinetic energy, one moment with the power of its loads (m
// and F in place of J and M for a linear drive). And a link's mass reduced to points.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/proof/instant.hpp"
#include "lib/mechanism/studies/position_functions.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The motion with only this driver moving and the others at rest.
struct Reduced {
  double inertia = 0.0;     // kg m^2 or kg: twice the kinetic energy over the square of the drive's speed
  double derivative = 0.0;  // derivative of the inertia, by the drive's coordinate: kg m^2/rad or kg/m
  double moment = 0.0;      // N m or N, positive with the coordinate: of loads, weights and springs
  double induced = 0.0;     // likewise: of friction and other forces induced by the position's reactions
  /// The effort of the drive if only it moves: J epsilon + dJ/dphi omega^2 / 2 - M.
  [[nodiscard]] double effort(const Drive& drive) const {
    return inertia * drive.acceleration + 0.5 * derivative * drive.speed * drive.speed - moment - induced;
  }
};

class Reduction {
 public:
  /// The model is referred to: its loads may change between positions.
  explicit Reduction(const Model& model);
  /// At a position, from its poses, and for induced forces its reactions. Nothing if the drive cannot move the
  /// mechanism, at a dead point. Does not allocate.
  [[nodiscard]] std::optional<Reduced> find(const Position& at, std::size_t driver = 0);
  /// The same where it is known how the drive moves the mechanism, as PositionFunctions derives it.
  [[nodiscard]] Reduced find(const Position& at, const Position& derivative);

 private:
  Instant instant_;
  PositionFunctions functions_;
  Position derivative_;  // kept
};

struct PointMass {
  Vec at;             // link frame, m
  double mass = 0.0;  // kg
};

/// Two masses at points on a line with the mass centre, with the mass and the mass centre of the link. The moment of
/// inertia that is missing: `missing_inertia`. Nothing if the points coincide or the line misses the mass centre.
std::optional<std::array<PointMass, 2>> statically_equivalent(const Link& link, Vec a, Vec b);
/// Three masses with the moment of inertia as well, at two points and, the last, in the mass centre between them, on
/// one line; that one can be negative.
std::optional<std::array<PointMass, 3>> dynamically_equivalent(const Link& link, Vec a, Vec b);
/// The link's inertia minus that of the masses, about the mass centre, kg m^2; negative if the masses have more.
double missing_inertia(const Link& link, std::span<const PointMass> masses);

}  // namespace loadpath::mechanism
