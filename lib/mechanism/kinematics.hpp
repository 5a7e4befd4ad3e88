// The constraint equations of a planar mechanism with their exact Jacobian and their centripetal terms.
//
// Coordinates: x, y, phi of each link's frame, link by link, then three zeros for the ground. Rows: as many as each
// joint has constraints, in the order of the joints; then one for each driver.
#pragma once

#include "lib/mechanism/model.hpp"
#include "lib/mechanism/pair.hpp"
#include "lib/numerics/elimination_order.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The size of the mechanism, as a power of two in m: independent of where the axes are.
double characteristic_length(const Model& model);
/// The same mechanism with lengths in this unit; kg and s stay.
Model in_unit_of_length(const Model& model, double unit);

/// A joint or a drive of the mechanism, at the position held.
struct Pair {
  PairShape shape;
  std::size_t i = 0, j = 0;  // links; the ground comes last
  std::size_t row = 0;       // its first
  PairPlace at = {};
  std::array<std::array<std::size_t, 6>, 3> entries = {};  // of its rows in the Jacobian
};

class Constraints {
 public:
  explicit Constraints(const Model& model);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return 3 * ground_; }
  [[nodiscard]] std::size_t first_driver_row() const { return rows_ - drives().size(); }
  [[nodiscard]] std::span<const MatrixEntry> pattern() const { return std::span(pattern_).subspan(1); }

  /// Goes to these coordinates; `targets`: what the drivers' coordinates should be.
  void place(std::span<const double> q, std::span<const double> targets);
  /// At coordinates that are an assembly: chooses the whole turns of wheels about each other, which coordinates do not
  /// tell.
  void count_turns();
  [[nodiscard]] std::span<const double> residual() const { return residual_; }
  [[nodiscard]] std::span<const double> jacobian() const { return std::span(jacobian_).subspan(1); }
  /// J times the acceleration, as far as it comes from the velocities alone.
  void centripetal(std::span<const double> velocity, std::span<double> right) const;
  [[nodiscard]] double coordinate(std::size_t driver) const;
  /// How far the joint is from being closed.
  [[nodiscard]] double opening(std::size_t joint) const;

  /// The joints.
  [[nodiscard]] std::span<const Pair> pairs() const { return std::span(pairs_).first(joints_); }
  /// Of a link's frame; the ground's comes last.
  [[nodiscard]] const Turn& turned(std::size_t link) const { return placed_[link].turned; }
  [[nodiscard]] const Placed& placed(int link) const { return placed_[index(link)]; }
  [[nodiscard]] std::size_t index(int link) const { return link == ground ? ground_ : static_cast<std::size_t>(link); }

 private:
  [[nodiscard]] std::span<const Pair> drives() const { return std::span(pairs_).subspan(joints_); }
  std::size_t entry(std::size_t row, std::size_t link, std::size_t component, bool occupied);
  void add(const PairShape& shape, int i, int j);
  void set_rows(const Pair& pair);

  std::size_t ground_, joints_;
  std::size_t rows_ = 0;
  std::vector<Pair> pairs_;  // joints, then drives
  std::vector<Placed> placed_;
  std::vector<MatrixEntry> pattern_;  // the first takes what belongs to the ground, and is no entry
  std::vector<double> jacobian_, residual_;
};

}  // namespace loadpath::mechanism
