// The equations of a mechanism at a position, differentiated with respect to several parameters at once, which are
// seeded in the model (lib/numerics/dual.hpp).
#pragma once

#include "lib/mechanism/accuracy/dual_model.hpp"
#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/forces/induced.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/proof/virtual_motions.hpp"
#include "lib/numerics/dual.hpp"
#include "lib/numerics/small_lu.hpp"

#include <span>
#include <vector>

namespace loadpath::mechanism {

using numerics::Dual;

class Differential {
 public:
  /// The instant must outlive this.
  explicit Differential(const Instant& instant);

  /// The model in SI units, whose numbers are seeded.
  [[nodiscard]] BasicModel<Dual>& model() { return model_; }

  /// After the instant has taken a position: its multipliers and induced forces. False if it jams.
  [[nodiscard]] bool start(bool statics);
  /// All derivatives with respect to the numbers seeded now.
  void find();
  /// Writes those of one lane.
  void store(std::size_t lane, Position& out) const;

 private:
  void find_multipliers(const Induced& modes);
  [[nodiscard]] double mode_power(const InducedMode& mode, std::size_t row) const;
  [[nodiscard]] bool find_induction();
  void take_position();
  void place();
  void find_motion();
  void move_induced();
  void find_forces();
  void find_induced_forces();
  void induce();
  void subtract_solution(std::span<const Dual> right, std::span<Dual> x) const;
  void take_product(std::span<const Dual> x);
  void take_transposed_product();
  void store_motion(std::span<const Dual> x, std::span<BasicPose<Dual>> poses) const;

  const Instant& instant_;
  VirtualMotions motions_;
  BasicModel<Dual> model_, scaled_;
  BasicConstraints<Dual> constraints_;
  bool statics_ = false, has_belt_ = false;

  // In units of length, as the constraints; the ground comes last.
  std::vector<Dual> q_, velocity_, acceleration_;
  std::vector<Dual> right_, multipliers_, no_targets_;
  std::vector<double> powers_;  // powers of external forces in the virtual motions, over the square of the length

  // The forces induced by reactions.
  InducedForces induced_;
  Position held_;
  std::vector<double> multiplier_;
  std::vector<BasicInducedSource<Dual>> sources_;
  std::vector<BasicInducedMode<Dual>> modes_;
  std::vector<Dual> amounts_, induced_amounts_;
  std::vector<double> change_;
  numerics::SmallLu induction_;

  // In SI units.
  std::vector<BasicPose<Dual>> poses_, velocities_, accelerations_;
  std::vector<BasicReaction<Dual>> reactions_;
  std::vector<Dual> effort_;
};

}  // namespace loadpath::mechanism
