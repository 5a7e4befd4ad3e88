// The constraint equations of a planar mechanism with their exact Jacobian and their centripetal terms.
//
// Coordinates: x, y, phi of each link's frame, link by link, then three zeros for the ground. Rows: two for a revolute
// or prismatic joint, one for a slot, in the order of the joints; then one for each driver.
#pragma once

#include "lib/mechanism/model.hpp"
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

/// A joint with its vectors at the position held, global axes.
struct Pair {
  JointKind kind;
  std::size_t i, j;            // links; the ground comes last
  std::size_t row;             // its first
  Vec point_i, point_j, line;  // frames of i, j, j
  double angle;
  std::array<std::size_t, 6> entries{};  // of its Jacobian entries that change
  Vec arm_i{}, arm_j{};                  // from the frames' origins to point_i, point_j
  Vec apart{};                           // from point_j to point_i
  Vec along{};                           // the line
};

class Constraints {
 public:
  explicit Constraints(const Model& model);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return 3 * ground_; }
  [[nodiscard]] std::size_t first_driver_row() const { return rows_ - drives_.size(); }
  [[nodiscard]] std::span<const MatrixEntry> pattern() const { return std::span(pattern_).subspan(1); }

  /// Goes to these coordinates; `targets`: what the drivers' coordinates should be.
  void place(std::span<const double> q, std::span<const double> targets);
  [[nodiscard]] std::span<const double> residual() const { return residual_; }
  [[nodiscard]] std::span<const double> jacobian() const { return std::span(jacobian_).subspan(1); }
  /// J times the acceleration, as far as it comes from the velocities alone.
  void centripetal(std::span<const double> velocity, std::span<double> right) const;
  [[nodiscard]] double coordinate(std::size_t driver) const;
  /// How far the joint is from being closed.
  [[nodiscard]] double opening(std::size_t joint) const;

  [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
  /// Of a link's frame; the ground's comes last.
  [[nodiscard]] const Turn& turned(std::size_t link) const { return turns_[link]; }

 private:
  struct Drive {
    Driver::Kind kind;
    std::size_t i, j;  // rotary
    std::size_t pair;  // linear
    double offset;
    std::array<std::size_t, 6> entries{};  // linear
  };

  [[nodiscard]] std::size_t index(int link) const { return link == ground ? ground_ : static_cast<std::size_t>(link); }
  std::size_t entry(std::size_t row, std::size_t link, std::size_t component, double value = 0.0);
  std::array<std::size_t, 6> line_entries(std::size_t row, std::size_t i, std::size_t j);
  void add(const Joint& joint);
  void add(const Driver& driver);
  void place(Pair& pair, std::span<const double> q);
  void place(const Drive& drive);
  void set_line(const Pair& pair, Vec direction, const std::array<std::size_t, 6>& entries);

  std::size_t ground_;
  std::size_t rows_ = 0;
  std::vector<Pair> pairs_;
  std::vector<Drive> drives_;
  std::vector<Turn> turns_;
  std::vector<double> phi_;
  std::vector<MatrixEntry> pattern_;  // the first takes what belongs to the ground, and is no entry
  std::vector<double> jacobian_, residual_;
};

}  // namespace loadpath::mechanism
