// Loads on a shaft over a revolution: the positions with known loads, the rotation at each, and the internal forces
// of its sections there. Constant loads fixed in space have one position.
#pragma once

#include "calculators/shaft/design/model/bending.hpp"

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <vector>

namespace loadpath::shaft {

/// Amplitude and mean of one load.
template <class Quantity>
struct Swing {
  Quantity a{}, m{};
};
/// Stresses of a section over a revolution: bending at a point of the circumference, fixed to the shaft.
struct Swings {
  double theta = unset<double>;  // angle of the point, from X where psi is 0
  Swing<Moment> M, T;
  Swing<Force> N;
};

/// The cosine and the sine of an angle.
struct Heading {
  double c = 1.0, s = 0.0;
  static Heading of(double angle) { return {std::cos(angle), std::sin(angle)}; }
};

/// Internal forces of the nodes of a shaft at all positions. Nothing is allocated for one position.
class Turn {
 public:
  Turn(const DesignInput& in, std::size_t nodes);
  /// In order of the positions; `most`: the largest bending moment of it, N m.
  void take(const Loaded& loaded, double most);

  [[nodiscard]] std::size_t positions() const { return positions_; }
  [[nodiscard]] bool varies() const { return varies_; }
  [[nodiscard]] std::size_t most_bent() const { return most_bent_; }
  [[nodiscard]] const InternalForces& internal_forces(std::size_t node, std::size_t position) const {
    return internal_forces_[position * nodes_ + node];
  }
  /// Unset for a single position.
  [[nodiscard]] double psi(std::size_t position) const { return psi_.empty() ? unset<double> : psi_[position]; }
  /// Bending moment on a point fixed to the shaft in direction theta, N m.
  [[nodiscard]] double moment(std::size_t node, std::size_t position, double theta) const;

  /// The points around a node that no other point exceeds in both amplitude and mean.
  [[nodiscard]] std::vector<Swings> swings(std::size_t node, double r_T) const;

 private:
  [[nodiscard]] Swings along(std::size_t node, double r_T) const;

  std::size_t nodes_, positions_, most_bent_ = 0;
  bool varies_;
  double largest_ = -1.0;
  boost::container::small_vector<InternalForces, beam::most_nodes> internal_forces_;
  std::vector<double> psi_;
  struct Axes {
    Heading x, y;
  };
  std::vector<Axes> axes_;  // of the shaft at each position, the same for every node
};

}  // namespace loadpath::shaft
