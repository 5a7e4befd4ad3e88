// The constraint equations of a planar mechanism with their exact Jacobian and their centripetal terms.
//
// Coordinates: x, y, phi of each link's frame, link by link, then three zeros for the ground. Rows: as many as each
// joint has constraints, in the order of the joints; then one for each driver.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/pair.hpp"
#include "lib/numerics/elimination_order.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The size of the mechanism, as a power of two in m: independent of where the axes are.
double characteristic_length(const Model& model);
/// With memory to use again.
double characteristic_length(const Model& model, std::vector<std::optional<Vec>>& first_points);
/// Lengths in this unit, m, from now on; kg and s stay.
template <class Scalar>
void change_unit_of_length(BasicModel<Scalar>& model, double unit);
/// The same mechanism so.
Model in_unit_of_length(const Model& model, double unit);

/// A joint or a drive of the mechanism, at the position held.
template <class Scalar>
struct BasicPair {
  BasicPairShape<Scalar> shape;
  std::size_t i = 0, j = 0;  // links; the ground comes last
  std::size_t row = 0;       // its first
  BasicPairPlace<Scalar> at = {};
  std::array<std::array<std::size_t, 6>, 3> entries = {};  // indices of its rows in the Jacobian
};
using Pair = BasicPair<double>;

template <class Scalar>
class BasicConstraints {
 public:
  explicit BasicConstraints(const BasicModel<Scalar>& model);
  /// Takes over the dimensions of a model of the same structure.
  void take_dimensions(const BasicModel<Scalar>& model);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return 3 * ground_; }
  [[nodiscard]] std::size_t first_driver_row() const { return rows_ - drives().size(); }
  [[nodiscard]] std::span<const numerics::MatrixEntry> pattern() const { return std::span(pattern_).subspan(1); }

  /// Goes to these coordinates; `targets`: required coordinates of the drivers.
  void place(std::span<const Scalar> q, std::span<const Scalar> targets);
  /// At coordinates that are an assembly: chooses the full revolutions of wheels about each other, which coordinates
  /// do not determine.
  void count_turns();
  [[nodiscard]] std::span<const Scalar> residual() const { return residual_; }
  [[nodiscard]] std::span<const Scalar> jacobian() const { return std::span(jacobian_).subspan(1); }
  /// The part of J times the acceleration that depends only on the velocities.
  void centripetal(std::span<const Scalar> velocity, std::span<Scalar> right) const;
  [[nodiscard]] Scalar coordinate(std::size_t driver) const;
  /// The residual of the joint's constraints.
  [[nodiscard]] Scalar opening(std::size_t joint) const;

  /// The joints.
  [[nodiscard]] std::span<const BasicPair<Scalar>> pairs() const { return std::span(pairs_).first(joints_); }
  /// Rotation of a link's frame; the ground's comes last.
  [[nodiscard]] const BasicTurn<Scalar>& turned(std::size_t link) const { return placed_[link].turned; }
  [[nodiscard]] const BasicPlaced<Scalar>& placed(int link) const { return placed_[index(link)]; }
  [[nodiscard]] std::size_t index(int link) const { return link == ground ? ground_ : static_cast<std::size_t>(link); }

 private:
  [[nodiscard]] std::span<const BasicPair<Scalar>> drives() const { return std::span(pairs_).subspan(joints_); }
  std::size_t entry(std::size_t row, std::size_t link, std::size_t component, bool occupied);
  void add(const BasicPairShape<Scalar>& shape, int i, int j);
  void set_rows(const BasicPair<Scalar>& pair);

  std::size_t ground_, joints_;
  std::size_t rows_ = 0;
  std::vector<BasicPair<Scalar>> pairs_;  // joints, then drives
  std::vector<BasicPlaced<Scalar>> placed_;
  std::vector<numerics::MatrixEntry> pattern_;  // the first takes the ground's values, and is not an entry
  std::vector<Scalar> jacobian_, residual_;
};
using Constraints = BasicConstraints<double>;

}  // namespace loadpath::mechanism
