// What acts on a shaft over a turn: the positions at which its loads are known, how far it has turned at each, and what
// its sections feel there. Of loads that stand in space and stay there is one position.
#pragma once

#include "calculators/shaft/design/bending.hpp"

#include <boost/container/small_vector.hpp>

#include <vector>

namespace loadpath::shaft {

/// Of the loads of seats and their angle any series; null where nothing varies.
const Value* any_series(const Design::Input& in);
/// 1 where nothing varies.
std::size_t positions_of(const Design::Input& in);
bool varies(const Design::Input& in);
bool torque_varies(const Design::Input& in);
/// The share of the turn's time that belongs to a position.
double share_of(const Design::Input& in, std::size_t position);
/// Angle of the shaft; 0 where no seat tells it.
double psi_of(const Design::Input& in, std::size_t position);

/// How often the shaft turns over all positions, signed; 0 where it swings or stands.
double turns_of(const Design::Input& in);

/// What may be wrong with loads over a turn; empty: nothing.
struct TurnFault {
  const char* key = "";
  Message message, hint;
};
TurnFault fault_of_turn(const Design::Input& in);

/// Calls with each of the loads of a seat.
template <class Take>
void for_each_load(const Seat& seat, const Take& take) {
  take("T", seat.T), take("F_x", seat.F_x), take("F_y", seat.F_y), take("F_z", seat.F_z);
}

/// What of one load varies around its middle.
template <class Quantity>
struct Swing {
  Quantity a{}, m{};
};
/// What a section feels between the ends of a turn: of bending at a point of the circumference, fixed to the shaft.
struct Swings {
  double theta = unset<double>;  // of the point, from X where psi is 0
  Swing<Moment> M, T;
  Swing<Force> N;
};

/// What the nodes of a shaft feel at all positions. Nothing is allocated for one position.
class Turn {
 public:
  Turn(const Design::Input& in, std::size_t nodes);
  /// In order of the positions.
  void take(const Loaded& loaded);

  [[nodiscard]] std::size_t positions() const { return positions_; }
  [[nodiscard]] bool varies() const { return varies_; }
  [[nodiscard]] std::size_t most_bent() const { return most_bent_; }
  [[nodiscard]] const Felt& felt(std::size_t node, std::size_t position) const {
    return felt_[position * nodes_ + node];
  }
  /// Of one position none.
  [[nodiscard]] double psi(std::size_t position) const { return psi_.empty() ? unset<double> : psi_[position]; }
  /// What bends a point that is fixed to the shaft in direction theta, N m.
  [[nodiscard]] double moment(std::size_t node, std::size_t position, double theta) const;

  /// Of the points around a node those that no other one exceeds in both amplitude and mean.
  [[nodiscard]] std::vector<Swings> swings(std::size_t node, double r_T) const;

 private:
  [[nodiscard]] Swings along(std::size_t node, double r_T) const;

  std::size_t nodes_, positions_, most_bent_ = 0;
  bool varies_;
  double largest_ = -1.0;
  boost::container::small_vector<Felt, beam::most_nodes> felt_;
  std::vector<double> psi_;
};

}  // namespace loadpath::shaft
