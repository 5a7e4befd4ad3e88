// Derivatives of positions, motions, reactions and efforts with respect to each dimension and mass of a mechanism:
// exact, from the solver's own equations differentiated forward at a solved position.
//
// With the closing equations Phi(q, p) = 0 and their Jacobian J: J dq = -dPhi; then J dv = -dJ v, J da = dc - dJ a for
// the centripetal terms c, and J^T dlambda = df - dJ^T lambda for the multipliers, with one inverse of J for all.
#pragma once

#include "lib/mechanism/accuracy/parameter.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace loadpath::mechanism {

class Sensitivity {
 public:
  /// Beyond this condition number of the constraint equations, 1-norm, a position is too near a dead point: a
  /// derivative of a force, which goes with its square, has no digit left.
  static constexpr double most_condition = 1e7;

  /// With respect to all `parameters_of(model)`.
  explicit Sensitivity(const Model& model);
  ~Sensitivity();
  Sensitivity(Sensitivity&&) noexcept;

  [[nodiscard]] std::span<const Parameter> parameters() const;

  /// At a solved position, with the drives and the loads of the position kept constant. `singular`: near a change
  /// point, if there are no derivatives; `jams`: as reported by the solver. Where the direction of friction or the
  /// loaded flank changes, the derivative is one-sided, on the side of the position. Does not allocate, apart from
  /// the scratch of an inverse.
  Status find(const Position& at, bool statics = false);

  /// After `find` has closed: every number of the position, per unit of this parameter. The phase of wheels is
  /// that of the altered model in the stated assembly (`take_phases`).
  [[nodiscard]] const Position& by(std::size_t parameter) const;
  /// The number of this parameter in `parameters()`; as many as there are when it is not among them.
  [[nodiscard]] std::size_t find_parameter(const Parameter& parameter) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loadpath::mechanism
